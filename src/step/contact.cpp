// SPDX-License-Identifier: Apache-2.0
#include "step/contact.h"

#include "base/index.h"
#include "contact/newton.h"
#include "context/guarded.h"
#include "context/sweeps.h"
#include "context/timer.h"
#include "context/undo_data.h"
#include "methods/gauss_seidel.h"
#include "methods/nonsmooth.h"
#include "solve/contact_rows.h"
#include "solve/factor.h"
#include "split/split.h"
#include "state/undo.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace hawser::step {
namespace {

using assembly::Contacts;
using nonsmooth::Cone;

/// Resize the arrays for the contacts of this step, and count one growth if memory grows.
void reserve_more(context::StepContext& ctx) {
    Contacts& c = ctx.model.system.contacts;
    const std::size_t held = c.bytes();
    const std::size_t all = ctx.state.contacts.contacts.size(), n = ctx.state.contacts.awake;
    c.begin(n, all - n);
    ctx.work.solve.partial.resize(at(context::StepContext::chunks(static_cast<std::int32_t>(n))));
    if (ctx.model.def.nonsmooth == Nonsmooth::split)
        methods::reserve_gauss_seidel(ctx.model, ctx.work.newton, n);
    ctx.state.contact_impulse.resize(3 * all);
    ctx.state.contact_sliding.resize(all);
    if (c.bytes() > held) ++ctx.work.stats.growths;
}

/// Prepare the resistances of this step's contacts, and arrays for their rows.
void make_resistances(context::StepContext& ctx) {
    Contacts& c = ctx.model.system.contacts;
    const std::size_t held = c.resistances.bytes();
    c.resistances.begin(ctx.state.contacts, c.rows, ctx.model.bodies, ctx.model.def.step);
    contact::reserve_newton(ctx.model, ctx.work.newton);
    ctx.work.contact_speed.resize(3 * c.triples());
    if (c.resistances.bytes() > held) ++ctx.work.stats.growths;
}

/// Set the targets of a contact in the trial step at the start. Approaching points keep
/// approaching, and sliding points keep sliding.
void ask_for_acceleration(Cone& c, double gap) noexcept {
    constexpr double kSlow = 0.05;   // [m/s]
    constexpr double kClose = 1e-6;  // [m]
    const bool slides = std::hypot(c.u[1], c.u[2]) > kSlow;
    c.b[0] = gap > kClose || c.u[0] > kSlow ? -1e30 : c.u[0];
    c.b[1] = slides ? 0.0 : c.u[1];
    c.b[2] = slides ? 0.0 : c.u[2];
}

/// Set the targets of a resistance in the trial step at the start. Rolling and spinning continue.
void ask_for_acceleration(nonsmooth::Resistance& a) noexcept {
    constexpr double kSlow = 0.05;  // [rad/s]
    a.b[0] = std::fabs(a.u[0]) > kSlow ? 0.0 : a.u[0];
    const bool rolls = std::hypot(a.u[1], a.u[2]) > kSlow;
    a.b[1] = rolls ? 0.0 : a.u[1];
    a.b[2] = rolls ? 0.0 : a.u[2];
}

}  // namespace

Contacts::Blocks prepare_contacts(context::Model& model, context::Work& work) {
    std::vector<std::uint8_t>& touches = work.sleep.mark;  // scratch, as in sleep
    touches.assign(at(model.bodies.count()), 0);
    for (const collide::Shape& s : model.collider.shapes())
        for (const std::int32_t b : s.body)
            if (b >= 0) touches[at(b)] = 1;
    std::vector<std::int32_t>& touching = work.solve.columns;  // also scratch
    touching.clear();
    for (std::int32_t b = 0; b < model.bodies.count(); ++b)
        if (touches[at(b)] != 0) touching.push_back(b);
    return model.system.contacts.set_bodies(touching, model.bodies);
}

Status start_contacts(context::StepContext& ctx, Phase phase) noexcept {
    const context::StageTimer timer(ctx, Stage::assemble);
    Contacts& c = ctx.model.system.contacts;
    const collide::ContactSet& set = ctx.state.contacts;
    Status status = context::guarded(ctx, [&] {
        state::save_link_steps(ctx.model, ctx.work.undo);
        reserve_more(ctx);
        context::over(ctx.pool, static_cast<std::int32_t>(set.awake),
                      [&](std::int32_t a, std::int32_t b) {
                          for (std::size_t k = at(a); k < at(b); ++k)
                              c.set(k, set.contacts[k], set.surfaces[at(set.contacts[k].surface)],
                                    ctx.model.bodies, ctx.model.def.step);
                      });
        for (std::size_t k = set.awake; k < set.contacts.size(); ++k)
            c.set_asleep(k, set.contacts[k].previous);
        make_resistances(ctx);
        if (!c.connect(ctx.state.step)) {
            const context::StageTimer again(ctx, Stage::analyse);
            state::save_state(ctx, context::Undo::Depth::system);
            c.relink(ctx.state.step);
            // save_link_steps() of a later step must not allocate.
            ctx.work.undo.link_used.reserve(c.link_used.capacity());
            split::relink(ctx);
            if (!c.connect(ctx.state.step)) throw std::bad_alloc();
        }
        ctx.work.solve.columns.reserve(solve::max_columns(ctx.model));
    });
    if (status != Status::ok) c.forget_rows();
    if (status == Status::ok && ctx.pool.stopping()) status = Status::cancelled;
    if (status != Status::ok) return status;
    // u at the velocities of the last step; λ is that of the last step.
    solve::update_slots(ctx.model, ctx.pool, ctx.model.bodies.v.data());
    c.resistances.recall(c.rows);
    context::over(ctx.pool, static_cast<std::int32_t>(c.count()),
                  [&](std::int32_t a, std::int32_t b) {
                      for (std::size_t k = at(a); k < at(b); ++k) {
                          std::copy_n(c.cones[k].u, 3, &ctx.work.contact_speed[3 * k]);
                          c.recall_lambda(k);
                          if (phase == Phase::stagger)
                              ask_for_acceleration(c.cones[k], set.contacts[k].gap);
                      }
                  });
    double* speed = ctx.work.contact_speed.data() + 3 * c.count();
    for (nonsmooth::Resistance& a : c.resistances.laws) {
        speed = std::copy_n(a.u, 3, speed);
        if (phase == Phase::stagger) ask_for_acceleration(a);
    }
    split::sum_contact_impulses(ctx.model, ctx.work.newton.x);
    if (phase == Phase::impact) return Status::ok;
    if (c.count() > 0) methods::begin_contacts(ctx.model, ctx.work, ctx.pool);
    solve::update_contacts(ctx.model, ctx.pool, nullptr);
    return Status::ok;
}

// Compute the work of contacts. λ·J(v + v₊)/2 is exactly the work of a contact on the kinetic
// energy of moving bodies. It equals λ·(u + u₊)/2 less the work of bodies with a prescribed
// velocity.
void count_contact_work(context::StepContext& ctx) noexcept {
    const Contacts& contacts = ctx.model.system.contacts;
    for (std::size_t k = 0; k < contacts.count(); ++k) {
        const Cone& c = contacts.cones[k];
        const double* before = &ctx.work.contact_speed[3 * k];
        double absorbed[3];
        for (int i = 0; i < 3; ++i) {
            absorbed[i] = -0.5 * c.lambda[i] * (before[i] + c.u[i]);
            ctx.state.ledger.drive -= c.lambda[i] * contacts.rows[k].carried[i];
        }
        ctx.state.ledger.contact += absorbed[0];
        ctx.state.ledger.friction += absorbed[1] + absorbed[2];
    }
    const assembly::Resistances& resistances = contacts.resistances;
    const double* before = ctx.work.contact_speed.data() + 3 * contacts.count();
    for (std::size_t k = 0; k < resistances.count(); ++k, before += 3) {
        const nonsmooth::Resistance& a = resistances.laws[k];
        for (int i = 0; i < 3; ++i) {
            ctx.state.ledger.friction -= 0.5 * a.lambda[i] * (before[i] + a.u[i]);
            ctx.state.ledger.drive -= a.lambda[i] * resistances.rows[k].carried[i];
        }
    }
}

void remember_contacts(context::Model& model, context::State& state, runtime::Pool& pool) noexcept {
    Contacts& c = model.system.contacts;
    context::over(pool, static_cast<std::int32_t>(c.count()), [&](std::int32_t a, std::int32_t b) {
        c.remember(model.bodies, model.def.step, a, b);
    });
    c.keep(model.def.step);
    for (std::size_t k = 0; k < state.contacts.contacts.size(); ++k) {
        std::copy_n(c.memory[k].lambda, 3, &state.contact_impulse[3 * k]);
        const bool slides = k < c.count() && c.cones[k].touch == nonsmooth::Touch::slip;
        state.contact_sliding[k] = slides ? 1 : 0;
    }
}

}  // namespace hawser::step
