// SPDX-License-Identifier: Apache-2.0
/// Sliding of a wire along the axis of its guide (sideways.h).
#include <hawser/world.h>

#include "wire/guide_system.h"
#include "wire/lift.h"
#include "wire/sideways.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {

GuideSystem::Sideways GuideSystem::slide_sideways(NodeEdits& nodes,
                                                  const std::array<double, 2>& room) noexcept {
    const World& world = nodes.world;
    if (!parts_intact(world) || !(tension_[0] > 0.0 && tension_[1] > 0.0)) return {};
    const InteractionDef& before = world.interaction_def(ids_.before);
    const Vec3 axis = world.pose(def_.body).orientation * (before.frame[1] * Vec3::UnitZ());
    const Vec3 centre = world.world_point(def_.body, def_.point);
    constexpr double kMinPartLength = 1e-3;  // A node on the wheel itself [m].
    Crossing c{};
    Parts parts{};
    for (const std::size_t side : {0U, 1U}) {
        const InteractionId id = side == 0 ? ids_.before : ids_.behind;
        const InteractionDef& d = world.interaction_def(id);
        const std::size_t node = side == 0 ? 0 : 1;
        const Vec3 to = world.world_point(d.body[node], d.point[node]) - centre;
        c.along[side] = to.dot(axis);
        const double flat = (to - c.along[side] * axis).squaredNorm() - def_.radius * def_.radius;
        c.across[side] = std::sqrt(std::max(flat, kMinPartLength * kMinPartLength));
        parts.rest[side] = rest_length(world, id);
        parts.longer[side] = world.violation(id)[0];
    }
    const double by = sideways_displacement(c, def_.friction * std::max(0.0, angle_));
    if (by == 0.0) return {};
    if (by < room[0] || by > room[1]) return {.by = 0.0, .reached_end = true};
    for (const std::size_t side : {0U, 1U})
        parts.changes[side] = std::hypot(c.across[side], c.along[side] - by) -
                              std::hypot(c.across[side], c.along[side]);
    const double fed = length_to_feed(parts);
    if (!nodes.move_along(ids_, by, fed)) return {};
    def_.point = before.point[1];
    material_[0] += fed;
    material_[1] -= fed;
    return {.by = by, .reached_end = false};
}

}  // namespace hawser::wire
