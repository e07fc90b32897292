// SPDX-License-Identifier: Apache-2.0
#include "base/index.h"
#include "stepper/cuts.h"
#include "stepper/rows.h"
#include "stepper/stages.h"
#include "stepper/step.h"

#include <hawser/world.h>

#include "base/hash.h"

#include <algorithm>
#include <cstring>

namespace hawser::stepper {
namespace {

double quadratic(const double* s, const double* v) {
    return v[0] * (s[0] * v[0] + s[1] * v[1] + s[2] * v[2]) +
           v[1] * (s[3] * v[0] + s[4] * v[1] + s[5] * v[2]) +
           v[2] * (s[6] * v[0] + s[7] * v[1] + s[8] * v[2]);
}

/// Take carriers with a prescribed velocity back by half a step; what they were goes to scratch.
void carriers_back(StepContext& ctx) noexcept {
    model::Bodies& b = ctx.bodies;
    const double t = -0.5 * ctx.def.step;
    double* kept = ctx.carriers_before.data();
    for (std::int32_t body : b.driven) {
        const auto i = at(body);
        const double* v = &b.v_fixed[6 * i];
        kept = std::copy_n(&b.x[3 * i], 3, kept);
        kept = std::copy_n(&b.q[4 * i], 4, kept);
        kept = std::copy_n(&b.r[9 * i], 9, kept);
        b.drift(body, v, v + 3, t);
    }
}

void carriers_forth(StepContext& ctx) noexcept {
    model::Bodies& b = ctx.bodies;
    const double* kept = ctx.carriers_before.data();
    for (std::int32_t body : b.driven) {
        const auto i = at(body);
        std::copy_n(kept, 3, &b.x[3 * i]);
        std::copy_n(kept + 3, 4, &b.q[4 * i]);
        std::copy_n(kept + 7, 9, &b.r[9 * i]);
        kept += 16;
    }
}

}  // namespace

double kinetic_energy_of(const model::Bodies& b, std::int32_t body,
                         const double* velocity) noexcept {
    const auto i = at(body);
    const double* v = velocity + b.dof_begin[i];
    const int dof = b.dof(body);
    double sum = 0.0;
    for (int k = 0; k < std::min(dof, 3); ++k) sum += 0.5 * b.mass[i] * v[k] * v[k];
    if (dof < 6) return sum;
    const double* r = &b.r[9 * i];
    double w[3];
    for (int k = 0; k < 3; ++k) w[k] = r[k] * v[3] + r[3 + k] * v[4] + r[6 + k] * v[5];
    return sum + 0.5 * quadratic(&b.inertia[9 * i], w);
}

double kinetic_energy(const model::Bodies& b, const double* velocity) noexcept {
    double sum = 0.0;
    for (std::int32_t body : b.moving) sum += kinetic_energy_of(b, body, velocity);
    return sum;
}

Energy energy(StepContext& ctx) noexcept {
    Energy e;
    const model::Bodies& b = ctx.bodies;
    const double half = 0.5 * ctx.def.step;
    e.kinetic = kinetic_energy(b, b.v.data());
    for (std::int32_t body : b.moving) {
        const auto i = at(body);
        if (!b.weight[i] || b.dof(body) == 1) continue;
        const double* v = &b.v[at(b.dof_begin[i])];
        for (int k = 0; k < 3; ++k)
            e.gravity -= b.mass[i] * ctx.def.gravity[k] * (b.x[3 * i + at(k)] - half * v[k]);
    }
    const assembly::View v = view(ctx);
    const KeptRanges kept(ctx.active_before, ctx.interactions.active.data(), ctx.system.bounded);
    // The rows' own bodies go back by −(h/2) G v below.
    carriers_back(ctx);
    evaluate_rows(ctx);
    carriers_forth(ctx);
    for (std::int32_t id = 0; id < interaction_count(ctx); ++id) {
        // What a line holds follows from its length, not from whether the last step found it taut.
        const bool line = (v.flags[id] & model::kOneSided) != 0;
        if (v.flags[id] & model::kFriction) continue;  // counted as driven
        if (line ? v.parted[id] != 0 : v.active[id] == 0.0) continue;
        if (ctx.wires.wire_of[at(id)] >= 0 && !ctx.system.rests(id) &&
            (v.flags[id] & model::kCarried) == 0) {
            if (model::holds_energy(v.epsilon[v.row_begin[id]], v.rest_length[id]))
                e.elastic += held_by_element(v, id);
            continue;
        }
        double room[model::kArmRoom];
        const double* jac = packed_rows(v, id, room);
        const bool rests = ctx.system.rests(id);  // and has not been evaluated
        const model::RowState s = rests ? ctx.interactions.row_state(id, b) : model::RowState{};
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            double speed = rests ? s.rate[r] + s.carried[r] : 0.0;
            if (!rests) speed = along_row(v, id, jac, v.v, v.dof_begin, speed);
            if ((v.row_flags[row] & model::kRowVelocity) ||
                !model::holds_energy(v.epsilon[row], v.rest_length[id]))
                continue;
            const double g = (rests ? s.g[r] : v.g[row]) - half * speed;
            if (!line || g > 0.0) e.elastic += 0.5 * g * g / v.epsilon[row];
        }
    }
    e.added = ctx.loads.added;
    e.system = ctx.loads.work;
    e.applied = ctx.work;
    e.driven = ctx.drive;
    e.dissipated = ctx.drag;
    e.friction = ctx.friction;
    e.contact = ctx.contact;
    e.damped = ctx.damped;
    return e;
}

std::uint64_t state_hash(const StepContext& ctx) noexcept {
    const char* isa = instruction_set();
    std::uint64_t hash = base::fnv1a(isa, std::strlen(isa));
    auto add = [&](const auto& array) {
        hash = base::fnv1a(array.data(), array.size() * sizeof(array[0]), hash);
    };
    // Images of bodies (cuts.h) follow from them.
    const auto bodies = at(body_count(ctx));
    auto front = [&](const base::Array<double>& array, std::size_t each) {
        hash = base::fnv1a(array.data(), each * bodies * sizeof(double), hash);
    };
    front(ctx.bodies.x, 3);
    front(ctx.bodies.q, 4);
    add(ctx.bodies.v);
    front(ctx.bodies.spin_change, 3);
    front(ctx.bodies.v_fixed, 6);
    front(ctx.bodies.force, 6);
    add(ctx.interactions.lambda);
    add(ctx.interactions.active);
    add(ctx.interactions.parted);
    add(ctx.interactions.coarse);
    add(ctx.interactions.repeats);
    add(ctx.interactions.anchor);
    // Not where there is nothing: there is no room for it before the first step is prepared.
    for (std::size_t k = 0; k < ctx.wires.count(); ++k) {
        if (ctx.wires.credit[k] == 0.0 && ctx.wires.alert[k] == 0) continue;
        hash = base::fnv1a(&k, sizeof k, hash);
        hash = base::fnv1a(&ctx.wires.credit[k], sizeof(double), hash);
        hash = base::fnv1a(&ctx.wires.alert[k], sizeof(std::int32_t), hash);
    }
    add(ctx.collider.kept());
    add(ctx.bodies.asleep);
    add(ctx.bodies.quiet);
    return base::fnv1a(&ctx.step, sizeof ctx.step, hash);
}

}  // namespace hawser::stepper
