// SPDX-License-Identifier: Apache-2.0
/// The element at a winch's drum: loads on its ends, and insertion and removal of nodes.
#include "wire/feed.h"
#include "wire/winch_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>

namespace hawser::wire {
/// Return the slot of the first node in the element. A splice may have reversed the wire since the
/// winch was added.
std::size_t WinchSystem::node_slot(const World& world) const noexcept {
    return wire::node_slot(world, ids_.line, def_.end == 0 ? 1 : 0);
}

/// Return the vector from the fairlead to the first node.
Vec3 WinchSystem::element_chord(const World& world) const noexcept {
    return wire::element_chord(world, ids_.line, node_slot(world));
}

/// Return true if the element at the drum ends at a rigid body, not at a node or a free end.
bool WinchSystem::carries_body(const World& world) const noexcept {
    const InteractionDef& line = world.interaction_def(ids_.line);
    return world.body_def(line.body[node_slot(world)]).kind == BodyKind::rigid;
}

Vec3 WinchSystem::weight_of_half(const World& world) const noexcept {
    return weight_at(world, ids_.line, node_slot(world),
                     0.5 * def_.mass_per_length * std::max(at_drum_, 0.0));
}

/// Load both ends with the mass of the element at the drum that no node carries.
void WinchSystem::weigh_element(const World& world, Loads& loads) const noexcept {
    if (!makes_nodes() || parted_ != 0) return;
    load_element(world, loads,
                 {ids_.line, paying_out_body(), radius_, def_.mass_per_length, at_drum_},
                 node_slot(world));
}

void WinchSystem::before_step(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    insertion_failed_ = false;
    if (!makes_nodes() || parted_ != 0 || !world.intact(ids_.line)) return;
    const double angle = world.pose(paying_out_body()).position.x();
    const double drum_side_length = at_drum_ + radius_ * (angle - angle_);
    const std::size_t node = node_slot(world);
    // Ahead: the wire begins at the drum.
    const Feed feed{ids_.line, node == 1, def_.element, def_.mass_per_length};
    if (drum_side_length > kInsertRatio * def_.element) {
        const bool put = insert_feed_node(nodes, feed, drum_side_length, at_drum_);
        // Each step retries; only the first failure is reported.
        insertion_failed_ = !put && at_drum_ <= kInsertRatio * def_.element;
    } else if (drum_side_length < kRemoveRatio * def_.element) {
        (void)feed_in_node(nodes, feed, node, at_drum_);
    }
}

}  // namespace hawser::wire
