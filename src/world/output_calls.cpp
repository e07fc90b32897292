// SPDX-License-Identifier: Apache-2.0
/// Outputs of a world.
#include <hawser/world.h>

#include "world/impl.h"
#include "world/lookup.h"
#include "world/outputs.h"

#include <string>
#include <utility>

namespace hawser {

using world::lookup;

OutputId World::add_output(const OutputDef& def) {
    const world::Using use(impl_->use, "add_output");
    OutputDef kept = def;
    const int component =
        world::check_output(kept, impl_->ctx, impl_->wires, body_count(), interaction_count());
    return impl_->outputs.add(std::move(kept), component);
}

void World::remove_output(OutputId id) {
    const world::Using use(impl_->use, "remove_output");
    const std::size_t place = impl_->outputs.index_of(id);
    const OutputDef& def = impl_->outputs.defs()[place];
    if (def.kind == OutputKind::signal)
        throw DefError("remove_output: '" + def.name + "' is a signal of system '" + def.group +
                       "', which owns it; remove the system");
    impl_->outputs.remove(place);
}

bool World::alive(OutputId id) const noexcept { return impl_->outputs.alive(id); }
int World::output_count() const noexcept { return static_cast<int>(impl_->outputs.defs().size()); }
const OutputDef& World::output_def(OutputId id) const {
    return impl_->outputs.defs()[impl_->outputs.index_of(id)];
}
std::span<const OutputId> World::output_ids() const noexcept { return impl_->outputs.ids(); }
OutputId World::find_output(std::string_view name) const noexcept {
    return impl_->outputs.id(lookup(impl_->outputs.names(), name));
}
double World::output(OutputId id) const { return outputs()[impl_->outputs.index_of(id)]; }

std::span<const double> World::outputs() const noexcept {
    Impl& m = *impl_;
    if (m.use.changed()) {
        const world::OptionalUse use(m.use);
        if (use.is_granted()) evaluate_outputs();
    }
    return m.outputs.values();
}

void World::evaluate_outputs() const noexcept {
    Impl& m = *impl_;
    if (!m.outputs.values().empty())
        m.outputs.evaluate(*this, m.ctx, m.wires, m.systems,
                           m.outputs.needs_energy() ? energy() : Energy{});
    m.use.unchanged();
}

}  // namespace hawser
