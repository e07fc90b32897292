// SPDX-License-Identifier: Apache-2.0
#include "record/recording_lines.h"

#include "record/recording_wires.h"
#include "record/scene_info.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hawser::record {
namespace {

/// Return all interactions in ascending order.
std::vector<InteractionId> all_interactions(const World& world) {
    return {world.interactions().begin(), world.interactions().end()};
}

bool is_line(const World& world, InteractionId id) {
    const KindInfo& kind = kind_info(world.interaction_def(id).kind);
    return kind.is(kPulls) && kind.uses_points && !world.wires().of(id).valid();
}

}  // namespace

LineFollower::LineFollower(const World& world, std::vector<InteractionId> joints)
    : joints_(std::move(joints)), at_start_(all_interactions(world)), all_(at_start_) {}

bool LineFollower::changed(const World& world) {
    const auto now = world.interactions();
    if (std::equal(now.begin(), now.end(), all_.begin(), all_.end())) return false;
    all_.assign(now.begin(), now.end());
    std::vector<InteractionId> lines;
    for (const InteractionId id : all_)
        if (!std::binary_search(at_start_.begin(), at_start_.end(), id) && is_line(world, id))
            lines.push_back(id);
    std::vector<std::int32_t> gone;
    for (std::size_t j = 0; j < joints_.size(); ++j)
        if (!world.alive(joints_[j])) gone.push_back(static_cast<std::int32_t>(j));
    const bool other = lines != lines_ || gone != removed_joints_;
    lines_ = std::move(lines);
    removed_joints_ = std::move(gone);
    return other;
}

void LineFollower::write_lines(ByteWriter& out, const World& world,
                               std::span<const BodyId> bodies) const {
    out.put(static_cast<std::uint32_t>(lines_.size()));
    for (const InteractionId id : lines_) {
        out.put_text(interaction_label(world, id));
        out.put(std::uint32_t{1});
        write_piece(out, world, id, bodies);
    }
    out.put(static_cast<std::uint32_t>(removed_joints_.size()));
    for (const std::int32_t joint : removed_joints_) out.put(joint);
}

void LineFollower::write_pulls(ByteWriter& out, const World& world) const {
    for (const InteractionId id : lines_) write_pull(out, world, id);
}

}  // namespace hawser::record
