// SPDX-License-Identifier: Apache-2.0
/// Pelican hooks of wires (hawser/wire.h).
#include <hawser/world.h>

#include "context/asleep.h"
#include "context/push_event.h"
#include "context/wire_alerts.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"
#include "edit/wire_ends.h"
#include "split/split.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/parts.h"

#include <algorithm>
#include <string>

namespace hawser {

void WorldWires::release(InteractionId hook) {
    const world::Using use(impl().use, "release");
    WorldImpl& m = impl();
    model::Interactions& in = m.ctx.model.interactions;
    const std::size_t i = m.index_of(hook);
    const auto found =
        std::find_if(m.gear.begin(), m.gear.end(), [&](const auto& g) { return g.id == hook; });
    const std::string where = world::label("interaction", in.def[i].name);
    if (found == m.gear.end() || found->kind != Gear::pelican_hook)
        world::throw_def_error(where, "it is no pelican hook; detach() opens other gear");
    if (in.parted[i] != 0) world::throw_def_error(where, "it is open already");
    m.update_wire_of(hook);
    const double tension = edit::tension_of(m.ctx, hook.index);
    context::begin_recoil(m.ctx.model, hook.index, false);
    m.ctx.state.ledger.edited.given -= edit::energy_of_interaction(m.ctx, hook.index);
    edit::begin_edit(m.ctx);
    for (std::size_t b = 0; b < 2; ++b)
        context::wake_island(m.ctx.model, edit::end_of(m.ctx, hook.index, b));
    split::part_all(m.ctx.model, hook.index);
    context::push_event(m.ctx, EventKind::release, hook.index, tension);
    if (m.listener != nullptr) m.listener->released(hook);
}

}  // namespace hawser
