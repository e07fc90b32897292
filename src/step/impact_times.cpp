// SPDX-License-Identifier: Apache-2.0
#include "step/impact_times.h"

#include "base/index.h"
#include "contact/newton.h"
#include "context/guarded.h"
#include "context/view.h"
#include "solve/contact_rows.h"
#include "state/remember.h"
#include "step/assemble_rows.h"
#include "step/contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::step {
namespace {

constexpr double kNone = -1.0;  ///< Time of a body without an impact.

/// Resize the scratch for the contacts of this step, and count one growth if memory grows.
void reserve_impacts(context::StepContext& ctx) {
    context::ImpactWork& w = ctx.work.impact;
    const std::size_t held = w.hits.capacity() + w.before.capacity() + w.parent.capacity();
    const std::size_t bodies = at(ctx.model.bodies.count()), dofs = at(ctx.model.bodies.dofs);
    w.hits.resize(ctx.model.system.contacts.count());
    w.before.resize(dofs);
    w.change.resize(dofs);
    w.time.resize(bodies);
    w.parent.resize(bodies);
    if (w.hits.capacity() + w.before.capacity() + w.parent.capacity() > held)
        ++ctx.work.stats.growths;
}

/// Compute the change of velocity of the step without impacts. It is 0 if the trial fails.
Status try_without_impacts(context::StepContext& ctx) noexcept {
    context::ImpactWork& w = ctx.work.impact;
    if (const Status s = start_contacts(ctx, Phase::regular); s != Status::ok) return s;
    for (std::size_t k = 0; k < w.hits.size(); ++k)
        if (w.hits[k] != 0) ctx.model.system.contacts.cones[k].b[0] = -1e30;
    assemble_rows(ctx);
    contact::begin_newton(ctx.model, ctx.work, ctx.pool);
    solve::update_contacts(ctx.model, ctx.pool, nullptr);
    ctx.work.solve.rhs_ready = false;
    const Status status = contact::solve_newton(ctx);
    const assembly::View v = context::view(ctx);
    for (std::size_t j = 0; j < w.change.size(); ++j)
        w.change[j] = status == Status::ok ? v.v_new[j] - v.v[j] : 0.0;
    // Lines and multipliers continue from the last step.
    state::restore_solved_state(ctx);
    const bool ends = status == Status::out_of_memory || status == Status::over_bound ||
                      status == Status::cancelled;
    return ends ? status : Status::ok;
}

/// Return the time at which a contact closes [s], or kNone if it does not close within the step
/// faster than the threshold. @param before, change  Normal speed before the step, and its change.
double closing_time(double gap, double before, double change, double h, double threshold) noexcept {
    const double speed = before + 0.5 * change, half = 0.5 * change / h;
    if (!(speed < 0.0)) return kNone;
    double time = 0.0;
    if (gap > 0.0) {
        const double root = speed * speed - 4.0 * half * gap;
        if (!(root >= 0.0)) return kNone;
        time = 2.0 * gap / (std::sqrt(root) - speed);
    }
    return time <= h && speed + 2.0 * half * time < -threshold ? time : kNone;
}

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t body) noexcept {
    while (parent[at(body)] != body) {
        parent[at(body)] = parent[at(parent[at(body)])];
        body = parent[at(body)];
    }
    return body;
}

/// Connect bodies with degrees of freedom. @param first  −1, or a body already seen.
void connect(const context::Model& model, std::vector<std::int32_t>& parent, std::int32_t body,
             std::int32_t& first) noexcept {
    if (body < 0 || model.bodies.dof(body) == 0) return;
    const std::int32_t root = root_of(parent, body);
    if (first >= 0) parent[at(std::max(root, first))] = std::min(root, first);
    first = root_of(parent, body);
}

/// Join the bodies that joints and closed contacts connect, in the union-find forest `parent`.
void connect_bodies(context::StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    std::vector<std::int32_t>& parent = ctx.work.impact.parent;
    std::iota(parent.begin(), parent.end(), 0);
    for (std::int32_t id = 0; id < in.count(); ++id) {
        std::int32_t first = -1;
        for (int b = 0; b < in.bodies[at(id)] && in.parted[at(id)] == 0; ++b)
            connect(ctx.model, parent, in.body[at(kMaxInteractionBodies * id + b)], first);
    }
    for (std::size_t k = 0; k < ctx.work.impact.hits.size(); ++k) {
        const collide::Contact& c = ctx.state.contacts.contacts[k];
        if (c.gap > 0.0 && ctx.work.impact.hits[k] == 0) continue;
        std::int32_t first = -1;
        for (int i = 0; i < c.slots; ++i) connect(ctx.model, parent, c.body[i], first);
    }
}

/// Return the first body of a contact that has degrees of freedom; −1: none.
std::int32_t moving_body(const context::Model& model, const collide::Contact& c) noexcept {
    for (int i = 0; i < c.slots; ++i)
        if (model.bodies.dof(c.body[i]) > 0) return c.body[i];
    return -1;
}

}  // namespace

double impact_threshold(const context::Model& model) noexcept {
    return std::max(1e-3, 2.0 * model.def.gravity.norm() * model.def.step);
}

double restitution(const context::State& state, std::size_t contact) noexcept {
    const collide::ContactSet& set = state.contacts;
    return set.surfaces[at(set.contacts[contact].surface)].restitution;
}

bool mark_candidates(context::StepContext& ctx, Status& status) noexcept {
    const std::size_t count = ctx.model.system.contacts.count();
    bool bouncy = false;
    for (std::size_t k = 0; k < count && !bouncy; ++k) bouncy = restitution(ctx.state, k) > 0.0;
    if (!bouncy) return false;
    status = context::guarded(ctx, [&] { reserve_impacts(ctx); });
    if (status != Status::ok) return false;
    const double h = ctx.model.def.step, threshold = impact_threshold(ctx.model);
    bool any = false;
    for (std::size_t k = 0; k < count; ++k) {
        // Within a step gravity adds at most three quarters of the threshold to the speed u.
        const double u = ctx.work.contact_speed[3 * k];
        const bool may = restitution(ctx.state, k) > 0.0 && u < -0.25 * threshold &&
                         ctx.state.contacts.contacts[k].gap + h * (1.5 * u - threshold) < 0.0;
        ctx.work.impact.hits[k] = may ? 1 : 0;
        any |= may;
    }
    return any;
}

bool find_times(context::StepContext& ctx, Status& status) noexcept {
    context::ImpactWork& w = ctx.work.impact;
    status = try_without_impacts(ctx);
    if (status != Status::ok) return false;
    const double h = ctx.model.def.step, threshold = impact_threshold(ctx.model);
    std::vector<double>& closing = ctx.work.newton.x;  // scratch, three values a contact
    solve::update_contacts(ctx.model, ctx.pool, w.change.data());
    bool any = false;
    for (std::size_t k = 0; k < w.hits.size(); ++k) {
        closing[k] = kNone;
        if (w.hits[k] == 0) continue;
        const assembly::Contacts& c = ctx.model.system.contacts;
        closing[k] = closing_time(ctx.state.contacts.contacts[k].gap, ctx.work.contact_speed[3 * k],
                                  c.cones[k].u[0] - c.rows[k].carried[0], h, threshold);
        w.hits[k] = closing[k] >= 0.0 ? 1 : 0;
        any |= w.hits[k] != 0;
    }
    if (!any) return false;
    connect_bodies(ctx);
    std::fill(w.time.begin(), w.time.end(), kNone);
    for (std::size_t k = 0; k < w.hits.size(); ++k) {
        const std::int32_t body = moving_body(ctx.model, ctx.state.contacts.contacts[k]);
        if (w.hits[k] == 0 || body < 0) continue;
        double& time = w.time[at(root_of(w.parent, body))];
        if (time < 0.0 || closing[k] < time) time = closing[k];
    }
    for (std::int32_t body = 0; body < ctx.model.bodies.count(); ++body)
        w.time[at(body)] = w.time[at(root_of(w.parent, body))];
    return true;
}

}  // namespace hawser::step
