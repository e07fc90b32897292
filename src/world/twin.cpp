// SPDX-License-Identifier: Apache-2.0
/// A world with the same definitions at the same indices.
#include <hawser/world.h>

#include "world/impl.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace hawser {

World World::twin(std::optional<Coupling> coupling) const {
    const world::Using use(impl_->use, "twin");
    const Impl& m = *impl_;
    WorldDef def = m.ctx.model.def;
    def.coupling = coupling.value_or(def.coupling);
    World out(def);
    Structure made_of = m.structure();
    if (coupling) made_of.coupling.clear();
    out.impl_->make(out, made_of);
    for (std::size_t i = 0; i < m.systems.count(); ++i) {
        std::unique_ptr<System> copy = m.systems.at(i).clone();
        if (!copy)
            throw DefError("twin: system '" + std::string(m.systems.at(i).name()) +
                           "' cannot be copied; let its clone() make another one");
        out.add_system(std::move(copy));
    }
    out.impl_->outputs = m.outputs;
    out.impl_->outputs.bind(out.impl_->systems.signals());
    out.state().copy_from(*this);
    return out;
}

}  // namespace hawser
