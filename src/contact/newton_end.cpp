// SPDX-License-Identifier: Apache-2.0
#include "contact/newton_end.h"

#include "base/index.h"
#include "contact/iterate.h"
#include "contact/newton_laws.h"
#include "context/newton_data.h"
#include "context/view.h"
#include "solve/contact_rows.h"
#include "solve/solve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hawser::contact {
namespace {

using assembly::Contacts;
using nonsmooth::Cone;

/// Return to the best stored iterate. Its rows are satisfied to rounding, like those of the current
/// one.
void restore_best_iterate(context::Model& model, context::Work& work,
                          runtime::Pool& pool) noexcept {
    const assembly::View v = context::row_view(model);
    const context::Newton& n = work.newton;
    std::copy_n(n.best_v.begin(), v.dof_count, v.v_new);
    std::copy_n(n.best_lambda.begin(), model.interactions.row_count, v.lambda);
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        Cone& c = model.system.contacts.cones[k];
        std::copy_n(&n.best_contact[6 * k], 3, c.u);
        std::copy_n(&n.best_contact[6 * k + 3], 3, c.lambda);
    }
    const double* from = n.best_contact.data() + 6 * model.system.contacts.count();
    for (nonsmooth::Resistance& a : model.system.contacts.resistances.laws) {
        std::copy_n(from, 3, a.u);
        std::copy_n(from + 3, 3, a.lambda);
        from += 6;
    }
    work.stats.natural_map = largest_residual(model, work.solve, pool);
}

}  // namespace

void project_all(context::Model& model) noexcept {
    for (Cone& c : model.system.contacts.cones) {
        nonsmooth::project(c.friction, c.lambda);
        for (int i = 0; i < 3; ++i)  // the law in the matrix goes through it
            c.p[i] = c.lambda[i] + c.s[3 * i] * c.u[0] + c.s[3 * i + 1] * c.u[1] +
                     c.s[3 * i + 2] * c.u[2];
    }
    assembly::Resistances& resistances = model.system.contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        const Cone& c = model.system.contacts.cones[at(resistances.rows[k].contact)];
        nonsmooth::limit(resistances.laws[k], c.lambda[0], resistances.laws[k].lambda);
        nonsmooth::set_law_offset(resistances.laws[k], c.u[0]);
    }
}

void forget_best(context::Newton& newton) noexcept {
    newton.best = std::numeric_limits<double>::infinity();
}

void save_if_best(context::Newton& n, double merit) noexcept {
    n.best = merit;
    n.best_v.swap(n.v);
    n.best_lambda.swap(n.lambda);
    n.best_contact.swap(n.contact);
}

void restore_last_step(context::Model& model, base::Array<double>& contact_speed) noexcept {
    Contacts& contacts = model.system.contacts;
    const double* speed = contact_speed.data();
    for (std::size_t k = 0; k < contacts.count(); ++k, speed += 3) {
        std::copy_n(speed, 3, contacts.cones[k].u);
        contacts.recall_lambda(k);
    }
    for (nonsmooth::Resistance& a : contacts.resistances.laws) {
        std::copy_n(speed, 3, a.u);
        speed += 3;
    }
    contacts.resistances.recall(contacts.rows);
}

Status end_with_lagged_laws(context::StepContext& ctx) noexcept {
    Contacts& contacts = ctx.model.system.contacts;
    if (ctx.work.newton.best < merit(ctx.model, ctx.work.newton, 0.0))
        restore_best_iterate(ctx.model, ctx.work, ctx.pool);
    constexpr double kPoor = 0.1;  // an iterate above this is worse than the end of the last step
    for (Cone& c : contacts.cones) c.coupling = nonsmooth::Coupling::lagged;
    if (ctx.work.stats.natural_map > kPoor) restore_last_step(ctx.model, ctx.work.contact_speed);
    ctx.work.stats.flips_left = linearise(ctx.model, ctx.work, ctx.pool, LastLaws::none);
    adopt_laws(ctx.model, ctx.work.newton, ctx.pool, false);
    if (const Status s = solve::newton_solve(ctx, false, true); s != Status::ok) return s;
    project_all(ctx.model);
    solve::update_contacts(ctx.model, ctx.pool, context::row_view(ctx.model).v_new);
    return Status::ok;
}

void end_at_best_iterate(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept {
    // After a single iteration there is no better iterate, which happens when time is short.
    if (std::isfinite(work.newton.best) && work.newton.best < merit(model, work.newton, 0.0))
        restore_best_iterate(model, work, pool);
    project_all(model);
    solve::update_contacts(model, pool, context::row_view(model).v_new);
}

}  // namespace hawser::contact
