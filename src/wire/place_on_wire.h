// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file place_on_wire.h
/// The point of any wire that is nearest to a given point, for stoppers and chasers.

#include <hawser/world.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace hawser::wire {

struct PointOnWire {
    WireId wire{};
    InteractionId element{};
    double fraction = 0.0;    ///< Fraction along the element, from its first body.
    double distance = 1e300;  ///< Distance from the point [m].
    Vec3 at{0, 0, 0};         ///< World frame [m].
};

/// Find the nearest point on intact elements that are at no drum or guide.
/// @param from_end  Fraction of an element at its ends that is excluded.
/// @param takes_wire  True for wires to search.
/// @param takes_element  True for definitions of elements to search.
template <class TakesWire, class TakesElement>
[[nodiscard]] PointOnWire nearest_on_wire(const World& world, const Vec3& point, double from_end,
                                          const TakesWire& takes_wire,
                                          const TakesElement& takes_element) {
    PointOnWire out;
    for (const WireId wire : world.wires().ids()) {
        if (!takes_wire(wire)) continue;
        for (const InteractionId id : world.wires().elements(wire)) {
            if (!world.alive(id) || !world.intact(id)) continue;
            const InteractionDef& d = world.interaction_def(id);
            if (kind_info(d.kind).is(kWoundUp) || !takes_element(d)) continue;
            const std::array<Vec3, 2> ends = world.wires().ends(id);
            const Vec3 along = ends[1] - ends[0];
            const double fraction =
                std::clamp((point - ends[0]).dot(along) / std::max(along.squaredNorm(), 1e-300),
                           from_end, 1.0 - from_end);
            const Vec3 at = ends[0] + fraction * along;
            const double distance = (at - point).norm();
            if (distance < out.distance) out = {wire, id, fraction, distance, at};
        }
    }
    return out;
}

/// Return the number by which outputs identify a wire: 1 for the first of WorldWires::ids(), 0:
/// none.
[[nodiscard]] inline double wire_number(const World& world, WireId wire) noexcept {
    const auto wires = world.wires().ids();
    const auto found = std::find(wires.begin(), wires.end(), wire);
    return found == wires.end() ? 0.0 : 1.0 + static_cast<double>(found - wires.begin());
}

}  // namespace hawser::wire
