// SPDX-License-Identifier: Apache-2.0
/// The node next to a drum that goes, see nodes.h: the element at the drum takes over the piece f
/// beyond.
///
/// ```
///     fairlead ── e ── n ──── f ──── b        fairlead ────── e ────── b
/// ```
/// The tension of the whole is the mean of both by their lengths at rest, as the law is linear in
/// the strain, and the rest length is the one that has it at the chord, dampers included: what
/// leaves by the drum takes its stretch along, which they see as a rate. The half of f that b held
/// becomes the winch's, as all the material of e is; velocities of others stay. What the motion of
/// n across the chord held goes into the drum's foundation, and counts as driven. The node before a
/// free end stays: the lump there has but its half of f. Where the next element is one that a drum
/// or a guide loads, too, b keeps a hundredth of that half: a body needs some mass of its own.

#include "step/nodes.h"

#include "base/index.h"
#include "step/node_pieces.h"

#include <cmath>

namespace hawser::stepper {

bool release_drum_node(StepContext& ctx, const NodePlace& place, double bend) noexcept {
    model::Interactions& in = ctx.model.interactions;
    model::Bodies& bodies = ctx.model.bodies;
    const bool at_first = is_wound(ctx, place.first);
    const std::int32_t e = at_first ? place.first : place.second;
    const std::int32_t f = at_first ? place.second : place.first;
    const std::size_t far = at_first ? 1 : 0;  // slot of b in f, and of n in e
    const Vec3 first = point_of(ctx, place.first, 1) - point_of(ctx, place.first, 0);
    const Vec3 second = point_of(ctx, place.second, 1) - point_of(ctx, place.second, 0);
    if (std::atan2(first.cross(second).norm(), first.dot(second)) > bend) return false;
    double half = 0.5 * mass_of_element(ctx, f);
    const std::int32_t b = end_of(ctx, f, far);
    // A free end would be left without any mass of its own.
    if (is_lump(ctx, b) && !has_more_than(bodies.mass[at(b)], half)) {
        const std::int32_t beyond = at_first ? place.after[0] : place.before[0];
        if (beyond < 0 || !is_wound(ctx, beyond)) return false;
        half = std::min(half, bodies.mass[at(b)]) - kKeptMass * half;
    }
    const double rest[2] = {in.rest_length[at(e)], in.rest_length[at(f)]};
    const double whole = rest[0] + rest[1];
    const double pull = (rest[0] * force_of(ctx, e) + rest[1] * force_of(ctx, f)) / whole;
    const double stiffness =
        whole / (rest[0] / stiffness_of(ctx, e) + rest[1] / stiffness_of(ctx, f));
    if (is_lump(ctx, b)) add_mass(ctx, b, -half, -half / bodies.mass[at(b)] * damping_of(ctx, b));
    in.def[at(e)].point[far] = in.def[at(f)].point[far];
    in.rewire(e, far, bodies.id(b), bodies);
    const double length = length_of(ctx, e);
    set_element(ctx, e, pull > 0.0 ? rest_for(ctx, e, pull, stiffness) : std::max(whole, length),
                0.0, pull);
    // The bend at b has the fairlead for its neighbour.
    const std::int32_t beyond = place.bend[at_first ? 2 : 0];
    if (beyond >= 0) {
        const std::size_t slot = at_first ? 0 : 2;
        in.def[at(beyond)].point[slot] = held_at(ctx, e, 1 - far);
        in.rewire(beyond, slot, bodies.id(end_of(ctx, e, 1 - far)), bodies);
    }
    const std::int32_t next = at_first ? place.after[0] : place.before[0];
    set_bend(ctx, beyond, e, next);
    NodePlace after = place;
    after.first = e;
    after.second = after.node = after.bend[1] = -1;
    follow_masses(ctx, after);
    return true;
}

}  // namespace hawser::stepper
