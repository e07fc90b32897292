// SPDX-License-Identifier: Apache-2.0
#include "record/recording_wires.h"

#include "record/recording_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace hawser::record {
namespace {

/// Size of a piece: two indices and two points.
constexpr std::size_t kPieceBytes = 2 * (4 + 24);

}  // namespace

WireFollower::WireFollower(const World& world) {
    // Cables of a layout contain no wheels. If the world has wheels, frames describe the wires from
    // the first frame on.
    for (const WireId wire : world.wires().ids())
        for (const InteractionId id : world.wires().elements(wire))
            if (world.alive(id) && kind_info(world.interaction_def(id).kind).is(kRouted)) return;
    (void)changed(world);
}

bool WireFollower::changed(const World& world) {
    const auto wires = world.wires().ids();
    bool other = elements_.size() != wires.size();
    elements_.resize(wires.size());
    for (std::size_t w = 0; w < wires.size(); ++w) {
        const auto all = world.wires().elements(wires[w]);
        std::vector<InteractionId>& known = elements_[w];
        std::size_t k = 0;
        for (const InteractionId id : all) {
            if (!world.alive(id)) continue;
            other = other || k >= known.size() || known[k] != id;
            if (k >= known.size()) known.push_back(id);
            known[k++] = id;
        }
        other = other || k != known.size();
        known.resize(k);
    }
    return other;
}

void write_piece(ByteWriter& out, const World& world, InteractionId element,
                 std::span<const BodyId> bodies) {
    const InteractionDef& d = world.interaction_def(element);
    const std::array<Vec3, 2> ends = world.wires().ends(element);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto place = std::lower_bound(bodies.begin(), bodies.end(), d.body[k]);
        out.put(static_cast<std::int32_t>(place - bodies.begin()));
        const Pose pose = world.pose(d.body[k]);
        const Vec3 held = pose.orientation.conjugate() * (ends[k] - pose.position);
        for (int c = 0; c < 3; ++c) out.put(std::isfinite(held[c]) ? held[c] : 0.0);
    }
}

void write_pull(ByteWriter& out, const World& world, InteractionId element) {
    constexpr double kMaximum = std::numeric_limits<float>::max();
    const double pull = world.intact(element) ? std::max(0.0, -world.force(element)[0]) : -1.0;
    out.put(static_cast<float>(std::isnan(pull) ? 0.0 : std::min<double>(pull, kMaximum)));
}

void WireFollower::put_wires(ByteWriter& out, const World& world,
                             std::span<const BodyId> bodies) const {
    const auto wires = world.wires().ids();
    out.put(static_cast<std::uint32_t>(wires.size()));
    for (std::size_t w = 0; w < wires.size(); ++w) {
        out.put_text(world.wires().name(wires[w]));
        out.put(static_cast<std::uint32_t>(elements_[w].size()));
        for (const InteractionId id : elements_[w]) write_piece(out, world, id, bodies);
    }
}

void WireFollower::write_pulls(ByteWriter& out, const World& world) const {
    for (const auto& wire : elements_)
        for (const InteractionId id : wire) write_pull(out, world, id);
}

std::vector<RecordedWire> get_wires(ByteReader& in, std::span<const std::int32_t> bodies,
                                    std::size_t& pieces) {
    std::vector<RecordedWire> out(in.get_count(8));
    pieces = 0;
    for (RecordedWire& wire : out) {
        wire.name = in.get_text();
        wire.first_piece = pieces;
        wire.pieces.resize(in.get_count(kPieceBytes));
        pieces += wire.pieces.size();
        for (RecordedPiece& piece : wire.pieces)
            for (std::size_t k = 0; k < 2; ++k) {
                const auto place = in.get<std::int32_t>();
                if (place < 0 || static_cast<std::size_t>(place) >= bodies.size())
                    throw BadBytes("an index is out of range");
                piece.body[k] = bodies[static_cast<std::size_t>(place)];
                piece.point[k] = get_vector(in);
            }
    }
    return out;
}

/// Read the wires that apply from the next frame on. @param joints  True if the removed joints of
/// the start follow.
void Recording::read_wires(ByteReader in, WireTables& tables, bool joints_follow) {
    auto next = std::make_unique<Wires>();
    next->first_frame = frames_.size();
    next->wires = get_wires(in, layouts_.back().bodies, next->pieces);
    if (joints_follow) {
        next->gone.resize(in.get_count(4));
        for (std::int32_t& joint : next->gone) {
            joint = in.get<std::int32_t>();
            if (joint < 0 || static_cast<std::size_t>(joint) >= joints.size())
                throw BadBytes("an index is out of range");
        }
    }
    in.expect_end();
    tables.push_back(std::move(next));
}

void Recording::read_pulls(std::span<const std::byte> payload, const WireTables& tables) {
    if (tables.empty() ||
        frames_.size() != tables.back()->first_frame + tables.back()->pulls.size() + 1 ||
        payload.size() != 4 * tables.back()->pieces)
        throw BadBytes("tensions of wires that are not there");
    ByteReader in(payload);
    for (std::size_t k = 0; k < tables.back()->pieces; ++k) (void)get_finite<float>(in);
    tables.back()->pulls.push_back(payload);
}

std::vector<bool> Recording::wire_lumps() const {
    std::vector<bool> out(bodies.size(), false);
    for (const auto& table : wires_)
        for (const RecordedWire& wire : table->wires)
            for (const RecordedPiece& piece : wire.pieces)
                for (const std::int32_t body : piece.body) {
                    const auto b = static_cast<std::size_t>(body);
                    out[b] = out[b] || bodies[b].kind == BodyKind::lump;
                }
    return out;
}

/// Find the elements of wires that apply at a frame, and read their tensions. @return null: no
/// elements are stored for this frame, or the recording ends before they are complete.
const Recording::Wires* Recording::find_wires(std::size_t index, const WireTables& tables,
                                              std::vector<float>& pulls) {
    const auto behind =
        std::upper_bound(tables.begin(), tables.end(), index,
                         [](std::size_t f, const auto& w) { return f < w->first_frame; });
    if (behind == tables.begin()) return nullptr;
    const Wires& wires = **std::prev(behind);
    if (index - wires.first_frame >= wires.pulls.size()) return nullptr;
    ByteReader in(wires.pulls[index - wires.first_frame]);
    pulls.resize(wires.pieces);
    for (float& pull : pulls) pull = in.get<float>();
    return &wires;
}

void Recording::find_wires(std::size_t index, Frame& frame) const {
    if (const Wires* wires = find_wires(index, wires_, frame.pulls)) frame.wires = &wires->wires;
    if (const Wires* lines = find_wires(index, lines_, frame.line_pulls)) {
        frame.lines = &lines->wires;
        frame.gone_joints = &lines->gone;
    }
}

}  // namespace hawser::record
