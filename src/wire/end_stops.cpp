// SPDX-License-Identifier: Apache-2.0
#include "wire/end_stops.h"

#include <hawser/world.h>

#include <algorithm>

namespace hawser::wire {

void EndStops::prestep(Prestep& now, Loads& loads) noexcept {
    constexpr double kMinLengthFraction = 0.01, kMaxCreepSpeed = 1e-6;  // of the length, [m/s]
    const World& world = now.world;
    for (const InteractionId id : parts_) {
        if (!world.alive(id) || !world.intact(id)) continue;
        const InteractionDef& part = world.interaction_def(id);
        const BodyId slide = part.body[2];
        const double radius = part.get("radius"), whole = part.get("length");
        const double rest =
            whole + radius * (world.pose(slide).position.x() - part.get("drum_zero"));
        const double rate = radius * world.velocity(slide).linear.x();
        const double least = kMinLengthFraction * whole;
        if (rate >= 0.0 || std::min(rest, rest + rate * now.step - least) > least) continue;
        // The largest expected tension stretches a part by 1 %.
        const double tension = std::max(-world.force(id)[0], kMinLengthFraction * part.get("EA"));
        const double damping = tension / kMaxCreepSpeed;
        loads.add_damping(slide, Eigen::Matrix<double, 1, 1>(damping));
        const double before = rest - rate * now.step;
        if (std::min(before, before + rate * now.step - least) > least)
            now.tell(EventKind::hauled_in, slide, std::max(0.0, -world.force(id)[0]));
    }
}

}  // namespace hawser::wire
