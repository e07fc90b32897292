// SPDX-License-Identifier: Apache-2.0
/// Motion of a place that a wire runs over, along the axis of its wheel (hawser/guide.h, post.h).
#include <hawser/world.h>

#include "base/number.h"
#include "context/asleep.h"
#include "context/context.h"
#include "edit/edits.h"
#include "edit/wire_ends.h"
#include "world/checks.h"
#include "world/impl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hawser {
namespace {

/// A part at the place, and the bend about the node at its other end.
struct Part {
    std::int32_t id = -1, bend = -1;
    std::size_t place = 0, slot = 0;  ///< Indices of the point in the part and in the bend.
};

Part part_at(const context::StepContext& ctx, InteractionId id, std::size_t place) noexcept {
    const InteractionDef& d = ctx.model.interactions.def[at(id.index)];
    Part out{id.index, edit::bend_at_body(ctx, d.body[1 - place].index, d.body[place].index),
             place};
    if (out.bend >= 0)
        out.slot = ctx.model.interactions.def[at(out.bend)].body[0] == d.body[place] ? 0 : 2;
    return out;
}

/// Check that two interactions are the parts of an element at a guide and have enough length.
/// @throws DefError
void check_move(const World& world, const model::Interactions& in, InteractionId before,
                InteractionId behind, double along, double fed) {
    const InteractionDef &a = world.interaction_def(before), &b = world.interaction_def(behind);
    const world::Where where("interaction", a.name);
    if (!kind_info(a.kind).is(kAtGuide) || b.kind != a.kind || a.body[2] != b.body[2] ||
        a.body[1] != b.body[0] || !(a.get("radius") < 0.0 && b.get("radius") > 0.0))
        world::throw_def_error(
            where, "only the turning point of two parts with one slide can move along an axis");
    if (a.get("wheel") == 0.0) world::throw_def_error(where, "an eye has no axis to move along");
    if (!std::isfinite(along) || !std::isfinite(fed))
        world::throw_def_error(where, "along = " + world::number(along) + " m, fed = " +
                                          world::number(fed) + " m: give finite numbers");
    const double rest[2] = {in.rest_length[at(before.index)], in.rest_length[at(behind.index)]};
    if (!(rest[0] + fed > 0.0 && rest[1] - fed > 0.0))
        world::throw_def_error(where, "fed = " + world::number(fed) + " m: its parts have " +
                                          world::number(rest[0]) + " m and " +
                                          world::number(rest[1]) + " m without tension");
}

}  // namespace

bool WorldWires::move_along(InteractionId before, InteractionId behind, double along, double fed) {
    const world::Using use(impl().use, "move_along");
    WorldImpl& m = impl();
    context::StepContext& c = m.ctx;
    model::Interactions& in = c.model.interactions;
    check_move(*world_, in, before, behind, along, fed);
    if (!world_->intact(before) || !world_->intact(behind)) return false;
    const std::array<Part, 2> parts{part_at(c, before, 1), part_at(c, behind, 0)};
    // The energy account has its energies half a step before the poses. The energy added by a move
    // must also be found if a part becomes much longer, which elastic() leaves out.
    struct Held {
        double ledger = 0.0, posed = 0.0;  ///< [J]
    };
    const auto held = [&] {
        Held sum;
        for (const Part& part : parts) {
            sum.ledger += edit::energy_of_interaction(c, part.id);
            const double longer = std::max(0.0, in.row_state(part.id, c.model.bodies).g[0]);
            sum.posed += 0.5 * longer * longer / in.epsilon[at(in.row_begin[at(part.id)])];
            if (part.bend < 0) continue;
            const double bent = edit::energy_of_interaction(c, part.bend);
            sum.ledger += bent;
            sum.posed += bent;
        }
        return sum;
    };
    struct Place {
        Vec3 point, bend;
        double zero;
    };
    const auto position_of = [&](const Part& part) {
        const InteractionDef& d = in.def[at(part.id)];
        return Place{d.point[part.place],
                     part.bend < 0 ? Vec3::Zero() : in.def[at(part.bend)].point[part.slot],
                     d.get("drum_zero")};
    };
    const auto put = [&](const Part& part, const Place& to) {
        in.def[at(part.id)].point[part.place] = to.point;
        in.def[at(part.id)].set("drum_zero", to.zero);
        in.refresh(part.id, c.model.bodies, c.model.def.step);
        if (part.bend < 0) return;
        in.def[at(part.bend)].point[part.slot] = to.bend;
        in.refresh(part.bend, c.model.bodies, c.model.def.step);
    };
    const std::array<Place, 2> was{position_of(parts[0]), position_of(parts[1])};
    const Held had = held();
    for (const std::size_t k : {0U, 1U}) {
        const InteractionDef& d = in.def[at(parts[k].id)];
        const Vec3 by = along * (d.frame[parts[k].place] * Vec3::UnitZ());
        // One part gets longer with its slide, the other shorter, both by `fed`.
        put(parts[k], {was[k].point + by, was[k].bend + by, was[k].zero + fed});
    }
    const Held has = held();
    if (has.ledger > had.ledger || has.posed > had.posed) {
        for (const std::size_t k : {0U, 1U}) put(parts[k], was[k]);
        return false;
    }
    c.state.ledger.friction += had.ledger - has.ledger;
    for (const Part& part : parts)
        for (std::size_t b = 0; b < in.bodies[at(part.id)]; ++b)
            context::wake_island(c.model, in.body[kMaxInteractionBodies * at(part.id) + b]);
    m.follow_inputs(before.index);
    m.follow_inputs(behind.index);
    // Damping fractions in an analysis depend on the directions of lines, so it must be repeated.
    edit::begin_shape_edit(c);
    if (m.listener != nullptr) m.listener->moved_along(before, behind, along, fed);
    return true;
}

}  // namespace hawser
