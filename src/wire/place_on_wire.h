// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file place_on_wire.h
/// The place on any wire that is nearest to a point: what a stopper and a chaser take.

#include <hawser/world.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace hawser::wire {

struct PlaceOnWire {
    WireId wire{};
    InteractionId element{};
    double share = 0.0;  ///< Of the element, from its first body.
    double far = 1e300;  ///< From the point [m].
    Vec3 at{0, 0, 0};    ///< World frame [m].
};

/// Of all elements that hold and that no drum or guide has. @param from_end  Of an element: nearer
/// to its ends no place is looked for. @param takes  Of a wire, and of an element's definition:
/// whether they are looked at.
template <class TakesWire, class TakesElement>
[[nodiscard]] PlaceOnWire nearest_place(const World& world, const Vec3& point, double from_end,
                                        const TakesWire& takes_wire,
                                        const TakesElement& takes_element) {
    PlaceOnWire out;
    for (const WireId wire : world.wires()) {
        if (!takes_wire(wire)) continue;
        for (const InteractionId id : world.elements(wire)) {
            if (!world.alive(id) || !world.intact(id)) continue;
            const InteractionDef& d = world.interaction_def(id);
            if (kind_info(d.kind).is(kWoundUp) || !takes_element(d)) continue;
            const std::array<Vec3, 2> ends = world.ends(id);
            const Vec3 along = ends[1] - ends[0];
            const double share =
                std::clamp((point - ends[0]).dot(along) / std::max(along.squaredNorm(), 1e-300),
                           from_end, 1.0 - from_end);
            const Vec3 at = ends[0] + share * along;
            const double far = (at - point).norm();
            if (far < out.far) out = {wire, id, share, far, at};
        }
    }
    return out;
}

/// As outputs of gear tell a wire: 1 the first of World::wires(), 0: none.
[[nodiscard]] inline double number_of(const World& world, WireId wire) noexcept {
    const auto wires = world.wires();
    const auto found = std::find(wires.begin(), wires.end(), wire);
    return found == wires.end() ? 0.0 : 1.0 + static_cast<double>(found - wires.begin());
}

}  // namespace hawser::wire
