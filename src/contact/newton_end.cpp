// SPDX-License-Identifier: Apache-2.0
#include "contact/newton_end.h"

#include "access/view.h"
#include "base/index.h"
#include "contact/iterate.h"
#include "contact/newton_laws.h"
#include "context/newton_data.h"
#include "solve/contact_rows.h"
#include "solve/solve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hawser::stepper {
namespace {

using assembly::Contacts;
using nonsmooth::Cone;

/// Impulses onto their cones.
void project_all(StepContext& ctx) noexcept {
    for (Cone& c : ctx.model.system.contacts.cones) {
        nonsmooth::project(c.friction, c.lambda);
        for (int i = 0; i < 3; ++i)  // the law in the matrix goes through it
            c.p[i] = c.lambda[i] + c.s[3 * i] * c.u[0] + c.s[3 * i + 1] * c.u[1] +
                     c.s[3 * i + 2] * c.u[2];
    }
    assembly::Resistances& resistances = ctx.model.system.contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        const Cone& c = ctx.model.system.contacts.cones[at(resistances.rows[k].contact)];
        nonsmooth::limit(resistances.laws[k], c.lambda[0], resistances.laws[k].lambda);
        nonsmooth::take_impulse(resistances.laws[k], c.u[0]);
    }
}

/// Back to the iterate set aside. Its rows hold as those at hand do: to round-off.
void take_best(StepContext& ctx) noexcept {
    const assembly::View v = view(ctx);
    const Newton& n = ctx.work.newton;
    std::copy_n(n.best_v.begin(), v.dof_count, v.v_new);
    std::copy_n(n.best_lambda.begin(), ctx.model.interactions.row_count, v.lambda);
    for (std::size_t k = 0; k < ctx.model.system.contacts.count(); ++k) {
        Cone& c = ctx.model.system.contacts.cones[k];
        std::copy_n(&n.best_contact[6 * k], 3, c.u);
        std::copy_n(&n.best_contact[6 * k + 3], 3, c.lambda);
    }
    const double* from = n.best_contact.data() + 6 * ctx.model.system.contacts.count();
    for (nonsmooth::Resistance& a : ctx.model.system.contacts.resistances.laws) {
        std::copy_n(from, 3, a.u);
        std::copy_n(from + 3, 3, a.lambda);
        from += 6;
    }
    ctx.work.stats.natural_map = worst(ctx);
}

}  // namespace

void forget_best(StepContext& ctx) noexcept {
    ctx.work.newton.best = std::numeric_limits<double>::infinity();
}

void set_best_aside(Newton& n, double merit) noexcept {
    n.best = merit;
    n.best_v.swap(n.v);
    n.best_lambda.swap(n.lambda);
    n.best_contact.swap(n.contact);
}

void go_back_to_last(StepContext& ctx) noexcept {
    Contacts& contacts = ctx.model.system.contacts;
    const double* speed = ctx.work.contact_speed.data();
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

Status end_early(StepContext& ctx) noexcept {
    Contacts& contacts = ctx.model.system.contacts;
    if (ctx.work.newton.best < merit(ctx, 0.0)) take_best(ctx);
    constexpr double kPoor = 0.1;  // Worse tells less than how the last step ended.
    for (Cone& c : contacts.cones) c.coupling = nonsmooth::Coupling::lagged;
    if (ctx.work.stats.natural_map > kPoor) go_back_to_last(ctx);
    ctx.work.stats.flips_left = linearise(ctx);
    adopt_laws(ctx, false);
    if (const Status s = newton_solve(ctx, false, true); s != Status::ok) return s;
    project_all(ctx);
    update_contacts(ctx, view(ctx).v_new);
    return Status::ok;
}

void end_hastily(StepContext& ctx) noexcept {
    // After one iteration there is no other: that is when time is short.
    if (std::isfinite(ctx.work.newton.best) && ctx.work.newton.best < merit(ctx, 0.0))
        take_best(ctx);
    project_all(ctx);
    update_contacts(ctx, view(ctx).v_new);
}

}  // namespace hawser::stepper
