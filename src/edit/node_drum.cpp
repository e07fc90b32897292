// SPDX-License-Identifier: Apache-2.0
/// Removal of the node next to a drum, see nodes.h: the element at the drum takes over the piece f
/// beyond.
///
/// ```
///     fairlead ── e ── n ──── f ──── b        fairlead ────── e ────── b
/// ```
/// The tension of the whole is the mean of both, weighted by rest lengths, because the law is
/// linear in the strain. The rest length is chosen so that the element has this tension at the
/// length of its chord, dampers included. Material that moves onto the drum takes its stretch with
/// it; dampers treat this as a rate. The
/// half of f at b is transferred to the winch, like all material of e. Velocities of other nodes do
/// not change. The energy of the motion of n across the chord goes into the foundation of the drum,
/// and counts as driven.
///
/// The node before a free end is not removed, because the node at the end has only its half of f.
/// If a drum or a guide also loads the next element, b keeps 1 % of that half, because a body needs
/// a mass.

#include "edit/nodes.h"

#include "base/index.h"
#include "edit/node_pieces.h"

#include <cmath>

namespace hawser::edit {

bool release_drum_node(context::StepContext& ctx, const NodeSurroundings& place,
                       double bend) noexcept {
    model::Interactions& in = ctx.model.interactions;
    model::Bodies& bodies = ctx.model.bodies;
    const bool at_first = is_at_drum(ctx, place.first);
    const std::int32_t e = at_first ? place.first : place.second;
    const std::int32_t f = at_first ? place.second : place.first;
    const std::size_t far = at_first ? 1 : 0;  // slot of b in f, and of n in e
    const Vec3 first = point_of(ctx, place.first, 1) - point_of(ctx, place.first, 0);
    const Vec3 second = point_of(ctx, place.second, 1) - point_of(ctx, place.second, 0);
    if (std::atan2(first.cross(second).norm(), first.dot(second)) > bend) return false;
    double half = 0.5 * mass_of_element(ctx, f);
    const std::int32_t b = end_of(ctx, f, far);
    // A free end would have no mass of its own.
    if (is_free_node(ctx, b) && !exceeds_half(bodies.mass[at(b)], half)) {
        const std::int32_t beyond = at_first ? place.after[0] : place.before[0];
        if (beyond < 0 || !is_at_drum(ctx, beyond)) return false;
        half = std::min(half, bodies.mass[at(b)]) - kKeptMass * half;
    }
    const double rest[2] = {in.rest_length[at(e)], in.rest_length[at(f)]};
    const double whole = rest[0] + rest[1];
    const double pull = (rest[0] * force_of(ctx, e) + rest[1] * force_of(ctx, f)) / whole;
    const double stiffness =
        whole / (rest[0] / stiffness_of(ctx, e) + rest[1] / stiffness_of(ctx, f));
    if (is_free_node(ctx, b))
        add_mass(ctx, b, -half, -half / bodies.mass[at(b)] * damping_of(ctx, b));
    in.def[at(e)].point[far] = in.def[at(f)].point[far];
    in.rewire(e, far, bodies.id(b), bodies);
    const double length = length_of(ctx, e);
    set_element(
        ctx, e,
        pull > 0.0 ? rest_length_for_force(ctx, e, pull, stiffness) : std::max(whole, length), 0.0,
        pull);
    // The neighbour of the bend at b is then the fairlead.
    const std::int32_t beyond = place.bend[at_first ? 2 : 0];
    if (beyond >= 0) {
        const std::size_t slot = at_first ? 0 : 2;
        in.def[at(beyond)].point[slot] = attachment_point(ctx, e, 1 - far);
        in.rewire(beyond, slot, bodies.id(end_of(ctx, e, 1 - far)), bodies);
    }
    const std::int32_t next = at_first ? place.after[0] : place.before[0];
    set_bend(ctx, beyond, e, next);
    NodeSurroundings after = place;
    after.first = e;
    after.second = after.node = after.bend[1] = -1;
    update_for_masses(ctx, after);
    return true;
}

}  // namespace hawser::edit
