// SPDX-License-Identifier: Apache-2.0
#include "state/state_hash.h"

#include <hawser/world.h>

#include "base/hash.h"
#include "context/copies.h"

#include <cstring>

namespace hawser::state {

std::uint64_t state_hash(const context::Model& model, const context::State& state) noexcept {
    const char* isa = instruction_set();
    std::uint64_t hash = base::fnv1a(isa, std::strlen(isa));
    auto add = [&](const auto& array) {
        hash = base::fnv1a(array.data(), array.size() * sizeof(array[0]), hash);
    };
    // Ghost bodies (cuts.h) follow from the others and are left out.
    const auto bodies = at(context::body_count(model));
    auto front = [&](const base::Array<double>& array, std::size_t each) {
        hash = base::fnv1a(array.data(), each * bodies * sizeof(double), hash);
    };
    front(model.bodies.x, 3);
    front(model.bodies.q, 4);
    add(model.bodies.v);
    front(model.bodies.spin_change, 3);
    front(model.bodies.v_fixed, 6);
    front(model.bodies.force, 6);
    add(model.interactions.lambda);
    add(model.interactions.active);
    add(model.interactions.parted);
    add(model.interactions.coarse);
    add(model.interactions.repeats);
    add(model.interactions.anchor);
    // Skip wires without memory: before the first preparation there are no arrays.
    for (std::size_t k = 0; k < model.wires.count(); ++k) {
        const bool recoils = model.wires.recoil[k] != 0;
        if (model.wires.energy_allowance[k] == 0.0 && model.wires.flag_steps[k] == 0 && !recoils)
            continue;
        hash = base::fnv1a(&k, sizeof k, hash);
        if (recoils) hash = base::fnv1a(&model.wires.recoil[k], sizeof(std::int32_t), hash);
        hash = base::fnv1a(&model.wires.energy_allowance[k], sizeof(double), hash);
        hash = base::fnv1a(&model.wires.flag_steps[k], sizeof(std::int32_t), hash);
    }
    add(model.collider.last_contacts());
    add(model.bodies.asleep);
    add(model.bodies.quiet);
    return base::fnv1a(&state.step, sizeof state.step, hash);
}

}  // namespace hawser::state
