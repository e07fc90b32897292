// SPDX-License-Identifier: Apache-2.0
#include "edit/nodes.h"

#include "base/index.h"
#include "context/asleep.h"
#include "context/context.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"

#include <algorithm>
#include <array>
#include <span>

namespace hawser::edit {
namespace {

/// Elements near a node, each listed once, and the bodies at their ends.
struct NearbyParts {
    std::array<std::int32_t, 2 * kNodeReach + 2> element{};
    std::array<std::int32_t, 2 * kNodeReach + 3> lump{};
    std::size_t elements = 0, lumps = 0;
};

NearbyParts nearby_parts(const context::StepContext& ctx, const NodeSurroundings& place) noexcept {
    NearbyParts out;
    const auto add_lump = [&](std::int32_t body) {
        const auto end = out.lump.begin() + static_cast<std::ptrdiff_t>(out.lumps);
        if (is_free_node(ctx, body) && std::find(out.lump.begin(), end, body) == end)
            out.lump[out.lumps++] = body;
    };
    const auto add = [&](std::int32_t id) {
        if (id < 0) return;
        out.element[out.elements++] = id;
        for (std::size_t slot = 0; slot < 2; ++slot) add_lump(end_of(ctx, id, slot));
    };
    add(place.first);
    add(place.second);
    for (const std::int32_t id : place.before) add(id);
    for (const std::int32_t id : place.after) add(id);
    return out;
}

/// Return the kinetic, gravity and elastic energy near a node [J].
context::Edited nearby_energy(const context::StepContext& ctx,
                              const NodeSurroundings& place) noexcept {
    const NearbyParts all = nearby_parts(ctx, place);
    context::Edited sum;
    for (std::size_t k = 0; k < all.lumps; ++k) sum.given += energy_of_body(ctx, all.lump[k]);
    for (std::size_t k = 0; k < all.elements; ++k) sum += energy_of_element(ctx, all.element[k]);
    const std::span<const std::int32_t> lumps(all.lump.data(), all.lumps);
    for (std::int32_t id = -1; (id = next_bend(ctx, lumps, id)) >= 0;)
        sum.strained += energy_of_interaction(ctx, id);
    return sum;
}

}  // namespace

bool complete_surroundings(const context::StepContext& ctx, NodeSurroundings& place) noexcept {
    if (place.first < 0) {
        const NodeLinks links = adjacent_elements(ctx, place.node);
        place.first = links.before;
        place.second = links.after;
        if (place.first < 0 || place.second < 0 || !links.has_only_bends) return false;
    }
    const std::int32_t last = place.second < 0 ? place.first : place.second;
    const std::int32_t a = end_of(ctx, place.first, 0), b = end_of(ctx, last, 1);
    const auto walk = [&](std::int32_t from, std::size_t far, std::int32_t(&out)[kNodeReach]) {
        for (std::int32_t& id : out) {
            const NodeLinks links =
                is_free_node(ctx, from) ? adjacent_elements(ctx, from) : NodeLinks{};
            const std::int32_t next = far == 0 ? links.before : links.after;
            // A ring that is no longer than the reach returns to its start.
            const auto known = {place.first, last};
            if (next < 0 || !links.has_only_bends ||
                std::find(known.begin(), known.end(), next) != known.end() ||
                std::find(place.before, place.before + kNodeReach, next) !=
                    place.before + kNodeReach)
                return;
            id = next;
            from = end_of(ctx, id, far);
        }
    };
    walk(a, 0, place.before);
    walk(b, 1, place.after);
    place.bend[0] = bend_at(ctx, a, end_of(ctx, place.first, 1), 2);
    if (place.node >= 0) place.bend[1] = bend_at(ctx, place.node, b, 2);
    place.bend[2] = bend_at(ctx, b, end_of(ctx, last, 0), 0);
    return a != b;
}

NodeDef node_on(const context::StepContext& ctx, std::int32_t element, double share,
                double mass) noexcept {
    NodeDef out;
    const Vec3 a = point_of(ctx, element, 0), b = point_of(ctx, element, 1);
    const bool wound = is_at_drum(ctx, element);
    const std::size_t drum = wound ? drum_side(ctx, element) : 0;
    // fraction of the piece that a drum gives away
    const double own = drum == 0 ? 1.0 - share : share;
    const double where = straight_fraction(ctx, element, share);
    out.mass = 0.5 * mass * (wound ? own : 1.0);
    out.velocity = (1.0 - where) * speed_of(ctx, element, 0, ctx.model.bodies.v) +
                   where * speed_of(ctx, element, 1, ctx.model.bodies.v);
    if (wound) out.velocity += inflow_velocity(ctx, element, own, ctx.model.bodies.v);
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const std::int32_t body = end_of(ctx, element, slot);
        if (!is_free_node(ctx, body)) continue;
        const double part = wound ? out.mass : 0.5 * mass * (slot == 0 ? 1.0 - share : share);
        out.of_end[slot] = part / ctx.model.bodies.mass[at(body)];
        out.damping += out.of_end[slot] * damping_of(ctx, body);
    }
    out.position = (1.0 - where) * a + where * b +
                   sag_below_chord(b - a, where, weight_of(ctx, element, 0.5 * mass),
                                   tension_of(ctx, element));
    return out;
}

NodeEnergies begin_node_edit(const context::StepContext& ctx,
                             const NodeSurroundings& place) noexcept {
    return {nearby_energy(ctx, place), ctx.state.ledger.edited};
}

void end_node_edit(context::StepContext& ctx, const NodeSurroundings& place,
                   const NodeEnergies& was) noexcept {
    ctx.state.ledger.edited = was.edited + nearby_energy(ctx, place) - was.local;
    const NearbyParts all = nearby_parts(ctx, place);
    for (std::size_t k = 0; k < all.lumps; ++k) context::wake_island(ctx.model, all.lump[k]);
}

void finish_node_insertion(context::StepContext& ctx, const NodeSurroundings& place,
                           std::int32_t old, double share, double mass) noexcept {
    model::Interactions& in = ctx.model.interactions;
    model::Bodies& bodies = ctx.model.bodies;
    const std::int32_t e = place.first, f = place.second, n = place.node;
    const bool wound = is_at_drum(ctx, old);
    const double stiffness = stiffness_of(ctx, old);
    const double tension = wound ? force_of(ctx, old) : tension_of(ctx, old);
    const double rest = in.rest_length[at(old)];
    const Vec3 u = (point_of(ctx, old, 1) - point_of(ctx, old, 0)).normalized();
    const double along = weight_of(ctx, old, 0.5 * mass).dot(u);
    const std::size_t drum = wound ? drum_side(ctx, old) : 0;
    const double own_of_piece = drum == 0 ? 1.0 - share : share;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const std::int32_t body = end_of(ctx, old, slot);
        if (!is_free_node(ctx, body)) continue;
        const double more =
            wound ? 0.5 * mass * own_of_piece : -0.5 * mass * (slot == 0 ? 1.0 - share : share);
        add_mass(ctx, body, more, more / bodies.mass[at(body)] * damping_of(ctx, body));
    }
    const double where = straight_fraction(ctx, old, share);
    Vec3 ahead = (1.0 - where) * speed_of(ctx, old, 0, bodies.v_start) +
                 where * speed_of(ctx, old, 1, bodies.v_start);
    if (wound) ahead += inflow_velocity(ctx, old, own_of_piece, bodies.v_start);
    for (std::size_t k = 0; k < 3; ++k)
        bodies.v_start[at(bodies.dof_begin[at(n)]) + k] = ahead[static_cast<int>(k)];
    in.rewire(old, old == e ? 1 : 0, bodies.id(n), bodies);
    const bool pulls = tension > 0.0;
    const double pull[2] = {tension + (pulls ? along * (1.0 - share) : 0.0),
                            tension - (pulls ? along * share : 0.0)};
    const std::int32_t part[2] = {e, f};
    for (std::size_t k = 0; k < 2; ++k) {
        const double own = k == 0 ? share : 1.0 - share;
        const double length = length_of(ctx, part[k]);
        const double taut = wound ? rest_length_for_force(ctx, part[k], pull[k], stiffness)
                                  : length / (1.0 + pull[k] / stiffness);
        set_element(ctx, part[k], pulls ? taut : own * rest, own * mass, pull[k]);
    }
    const std::int32_t other = old == e ? f : e;
    in.active[at(other)] = in.active[at(old)];
    in.flagged[at(other)] = in.flagged[at(old)];
    if (place.bend[0] >= 0) in.rewire(place.bend[0], 2, bodies.id(n), bodies);
    if (place.bend[2] >= 0) in.rewire(place.bend[2], 0, bodies.id(n), bodies);
    set_bend(ctx, place.bend[0], place.before[0], e);
    set_bend(ctx, place.bend[1], e, f);
    set_bend(ctx, place.bend[2], f, place.after[0]);
    update_for_masses(ctx, place);
}

}  // namespace hawser::edit
