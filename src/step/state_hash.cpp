// SPDX-License-Identifier: Apache-2.0
#include "step/state_hash.h"

#include <hawser/world.h>

#include "access/copies.h"
#include "base/hash.h"

#include <cstring>

namespace hawser::stepper {

std::uint64_t state_hash(const StepContext& ctx) noexcept {
    const char* isa = instruction_set();
    std::uint64_t hash = base::fnv1a(isa, std::strlen(isa));
    auto add = [&](const auto& array) {
        hash = base::fnv1a(array.data(), array.size() * sizeof(array[0]), hash);
    };
    // Images of bodies (cuts.h) follow from them.
    const auto bodies = at(body_count(ctx.model));
    auto front = [&](const base::Array<double>& array, std::size_t each) {
        hash = base::fnv1a(array.data(), each * bodies * sizeof(double), hash);
    };
    front(ctx.model.bodies.x, 3);
    front(ctx.model.bodies.q, 4);
    add(ctx.model.bodies.v);
    front(ctx.model.bodies.spin_change, 3);
    front(ctx.model.bodies.v_fixed, 6);
    front(ctx.model.bodies.force, 6);
    add(ctx.model.interactions.lambda);
    add(ctx.model.interactions.active);
    add(ctx.model.interactions.parted);
    add(ctx.model.interactions.coarse);
    add(ctx.model.interactions.repeats);
    add(ctx.model.interactions.anchor);
    // Not where there is nothing: there is no room for it before the first step is prepared.
    for (std::size_t k = 0; k < ctx.model.wires.count(); ++k) {
        if (ctx.model.wires.credit[k] == 0.0 && ctx.model.wires.alert[k] == 0) continue;
        hash = base::fnv1a(&k, sizeof k, hash);
        hash = base::fnv1a(&ctx.model.wires.credit[k], sizeof(double), hash);
        hash = base::fnv1a(&ctx.model.wires.alert[k], sizeof(std::int32_t), hash);
    }
    add(ctx.model.collider.kept());
    add(ctx.model.bodies.asleep);
    add(ctx.model.bodies.quiet);
    return base::fnv1a(&ctx.state.step, sizeof ctx.state.step, hash);
}

}  // namespace hawser::stepper
