// SPDX-License-Identifier: Apache-2.0
/// Restoration of a state, all or nothing.
#include <hawser/world.h>

#include "state/undo.h"
#include "step/ready.h"
#include "world/impl.h"

namespace hawser {

void World::restore(std::span<const std::byte> bytes) {
    const world::Using use(impl_->use, "restore");
    restore_saved(bytes, false);
    if (impl_->listener != nullptr) impl_->listener->restored(bytes);
}

void World::restore_variant(std::span<const std::byte> bytes) {
    const world::Using use(impl_->use, "restore_variant");
    restore_saved(bytes, true);
    if (impl_->listener == nullptr) return;
    std::vector<std::byte> own;  // for a replay of this world
    write_saved(own, true);
    impl_->listener->restored(own);
}

void World::restore_saved(std::span<const std::byte> bytes, bool variant) {
    stepper::StepContext& ctx = impl_->ctx;
    std::vector<double> inputs = impl_->input_values;
    stepper::Transaction all(ctx);
    stepper::keep_state(ctx, stepper::Undo::Depth::all);
    try {
        take_saved(bytes, variant);
    } catch (...) {
        impl_->input_values.swap(inputs);
        throw;
    }
    all.done();
    impl_->systems.forget();
    impl_->outputs.forget_figures();
}

}  // namespace hawser
