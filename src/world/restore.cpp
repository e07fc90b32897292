// SPDX-License-Identifier: Apache-2.0
/// Restoration of a state, all or nothing.
#include <hawser/world.h>

#include "state/undo.h"
#include "step/ready.h"
#include "world/impl.h"

namespace hawser {

void WorldState::restore(std::span<const std::byte> bytes) {
    const world::Using use(impl().use, "restore");
    impl().restore_saved(*world_, bytes, false);
    if (impl().listener != nullptr) impl().listener->restored(bytes);
}

void WorldState::restore_variant(std::span<const std::byte> bytes) {
    const world::Using use(impl().use, "restore_variant");
    impl().restore_saved(*world_, bytes, true);
    if (impl().listener == nullptr) return;
    std::vector<std::byte> own;  // for a replay of this world
    impl().write_saved(own, true);
    impl().listener->restored(own);
}

void WorldImpl::restore_saved(World& self, std::span<const std::byte> bytes, bool variant) {
    std::vector<double> values = input_values;
    step::Transaction all(ctx);
    state::save_state(ctx, context::Undo::Depth::all);
    try {
        restore_saved_bytes(self, bytes, variant);
    } catch (...) {
        input_values.swap(values);
        throw;
    }
    all.done();
    systems.discard_actions();
    outputs.forget_figures();
}

}  // namespace hawser
