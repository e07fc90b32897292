// SPDX-License-Identifier: Apache-2.0
/// The element at a winch's drum: what acts on its ends, and nodes that come and go there.
#include "wire/winch_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>

namespace hawser::wire {
namespace {

constexpr double kGrown = 1.5, kShrunk = 0.25;  ///< Of `element`, where a node comes and goes.
constexpr double kAnyBend = 1.6;                ///< A node at a drum goes unless the wire folds.
constexpr double kOtherLine =
    0.2;  ///< By which mass a length differs where no stretch explains it.

}  // namespace

/// Slot of the element that the first node has. A splice may have turned the wire round since the
/// winch was made.
std::size_t WinchSystem::node_slot(const World& world) const noexcept {
    const InteractionDef& line = world.interaction_def(ids_.line);
    for (std::size_t slot = 0; slot < 2; ++slot)
        if (world.body_def(line.body[slot]).kind == BodyKind::lump) return slot;
    return def_.end == 0 ? 1 : 0;
}

/// From the fairlead to the first node.
Vec3 WinchSystem::along_element(const World& world) const noexcept {
    const InteractionDef& line = world.interaction_def(ids_.line);
    const std::size_t node = node_slot(world);
    return world.world_point(line.body[node], line.point[node]) -
           world.world_point(line.body[1 - node], line.point[1 - node]);
}

/// Of the element at the drum, by what acts on its first node beside forces of interactions.
Vec3 WinchSystem::weight_of_half(const World& world) const noexcept {
    const BodyDef& node = world.body_def(world.interaction_def(ids_.line).body[node_slot(world)]);
    Vec3 each = node.gravity ? world.settings().gravity : Vec3::Zero().eval();
    if (node.kind == BodyKind::lump) each += node.force / node.mass;
    return 0.5 * def_.mass_per_length * std::max(at_drum_, 0.0) * each;
}

/// What no lump has of the element at the drum acts on both of its ends.
void WinchSystem::weigh_element(const World& world, Loads& loads) const noexcept {
    if (!feeds() || parted_ != 0) return;
    const InteractionDef& line = world.interaction_def(ids_.line);
    const double half = 0.5 * def_.mass_per_length * std::max(at_drum_, 0.0);
    const Vec3 weight = weight_of_half(world), u = along_element(world).normalized();
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const BodyId body = line.body[slot];
        const BodyDef& def = world.body_def(body);
        if (def.kind != BodyKind::lump && def.kind != BodyKind::rigid) continue;
        const Pose pose = world.pose(body);
        const Vec3 arm = pose.orientation * line.point[slot];
        loads.add_force(
            body, weight,
            def.kind == BodyKind::rigid ? arm.cross(weight).eval() : Vec3::Zero().eval());
        if (def.kind != BodyKind::lump) continue;
        loads.add_mass(body, (half * Mat3::Identity()).eval());
        loads.add_damping(body,
                          (half / def.mass * def.linear_damping).asDiagonal().toDenseMatrix());
    }
    loads.add_force(wound(), {radius_ * weight.dot(u), 0.0, 0.0});
    loads.add_mass(wound(), Eigen::Matrix<double, 1, 1>(half * radius_ * radius_));
}

void WinchSystem::before_step(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    crowded_ = false;
    if (!feeds() || parted_ != 0 || !world.intact(ids_.line)) return;
    const double angle = world.pose(wound()).position.x();
    const double there = at_drum_ + radius_ * (angle - angle_);
    const bool ahead = node_slot(world) == 1;  // the wire begins at the drum
    if (there > kGrown * def_.element) {
        const double beyond = def_.element / there, share = ahead ? 1.0 - beyond : beyond;
        const double mass = def_.mass_per_length * there;
        // By the bits that the world takes.
        const double taken = ahead ? 1.0 - share : share;
        const bool put = nodes.insert_node(ids_.line, share, mass).valid();
        if (put) at_drum_ -= taken * there;
        // Each step tries again; the first one tells of it.
        crowded_ = !put && at_drum_ <= kGrown * def_.element;
    } else if (there < kShrunk * def_.element) {
        const BodyId node = world.interaction_def(ids_.line).body[node_slot(world)];
        if (world.body_def(node).kind != BodyKind::lump) return;
        const auto elements = world.elements(world.wire_of(ids_.line));
        if (elements.size() < 2) return;
        const InteractionId next = ahead ? elements[1] : elements[elements.size() - 2];
        if (!world.alive(next) || !world.intact(next)) return;
        const InteractionDef& beyond = world.interaction_def(next);
        const double mass = beyond.get("mass");
        // Wire of another line type stays outboard: this one's diameter and mass are known here.
        const double line = mass / beyond.get("length");
        if (beyond.get("EA") != world.interaction_def(ids_.line).get("EA") ||
            std::abs(line - def_.mass_per_length) > kOtherLine * def_.mass_per_length)
            return;
        if (mass > 0.0 && nodes.remove_node(node, kAnyBend))
            at_drum_ += mass / def_.mass_per_length;
    }
}

}  // namespace hawser::wire
