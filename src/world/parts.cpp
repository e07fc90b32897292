// SPDX-License-Identifier: Apache-2.0
/// Addition of several interactions at once, all or none.
#include "world/parts.h"

#include <hawser/world.h>

#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <string>
#include <utility>
#include <vector>

namespace hawser {
namespace world {

void fill_in(InteractionDef& def, const context::StepContext& ctx) {
    const KindInfo& info = kind_info(def.kind);
    Vec3 position[kMaxInteractionBodies], point[kMaxInteractionBodies];
    for (std::size_t b = 0; b < at(info.bodies); ++b) {
        const std::size_t i = at(def.body[b].index);
        const double *x = &ctx.model.bodies.x[3 * i], *q = &ctx.model.bodies.q[4 * i];
        position[b] = Vec3(x[0], x[1], x[2]);
        point[b] = position[b] + Quat(q[0], q[1], q[2], q[3]) * def.point[b];
    }
    const double distance = info.bodies > 1 ? (point[1] - point[0]).norm() : 0.0;
    model::complete(def, position, distance);
    check_params(def);
}

}  // namespace world

void World::add_interactions(std::span<const InteractionDef> defs, std::span<InteractionId> ids) {
    const world::Using use(impl_->use, "add_interactions");
    Impl& m = *impl_;
    const model::Interactions& all = m.ctx.model.interactions;
    if (ids.size() != defs.size())
        throw DefError("add_interactions: give as many ids as definitions");
    if (m.interaction_ids.size() + defs.size() > at(m.ctx.model.def.max_interactions))
        throw DefError("too many interactions; raise max_interactions = " +
                       std::to_string(m.ctx.model.def.max_interactions));
    // All checks come before the first addition.
    world::Names names;
    for (const InteractionDef& d : defs) {
        world::check(d, m.ctx.model.bodies, body_count(),
                     std::span(all.def).first(at(interaction_count())), all.slots);
        for (const FrictionLoad& load : d.load)
            if (!load.interaction.valid() && load.factor != 0.0)
                world::check_load(d, load, defs.front());
        InteractionDef whole = d;
        world::fill_in(whole, m.ctx);
        world::claim_name(names, d.name, 0, "interaction");
        if (find_interaction(d.name).valid())
            throw DefError("interaction '" + d.name +
                           "': the name is in use; names must be unique");
    }
    std::size_t added = 0;
    try {
        for (; added < defs.size(); ++added) {
            InteractionDef d = defs[added];
            for (FrictionLoad& load : d.load)
                if (!load.interaction.valid() && load.factor != 0.0) load.interaction = ids[0];
            ids[added] = add_interaction(d);
        }
    } catch (...) {  // allocation failure
        m.forget_removal();
        while (added-- > 0) {
            m.remove(ids[added]);
            if (m.listener != nullptr) m.listener->removed(ids[added]);
        }
        throw;
    }
}

}  // namespace hawser
