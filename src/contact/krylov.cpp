// SPDX-License-Identifier: Apache-2.0
#include "contact/krylov.h"

#include "base/index.h"
#include "context/timer.h"
#include "context/view.h"

#include <algorithm>
#include <cmath>

namespace hawser::contact {
namespace {

using nonsmooth::Cone;
using nonsmooth::Resistance;

/// Fraction of the defect that may remain; the next iteration treats it.
constexpr double kTolerance = 0.1;

void multiply_scaled(const double* s, const double* u, double* out) noexcept {
    for (int i = 0; i < 3; ++i)
        out[i] = s[3 * i] * u[0] + s[3 * i + 1] * u[1] + s[3 * i + 2] * u[2];
}

/// Return the scale that makes impulses on light and heavy bodies comparable: λ² (W + Σ) is an
/// energy.
double scale_of(const Cone& c) noexcept { return std::sqrt(c.mobility + c.sigma_n); }
double scale_of(const Resistance& a) noexcept { return std::sqrt(a.mobility + a.sigma); }

/// Compute the scaled p' − S' u − λ of all rows.
void find_defects(const context::Model& model, const context::Newton& newton, double* w) noexcept {
    const assembly::Contacts& contacts = model.system.contacts;
    for (std::size_t k = 0; k < contacts.count(); ++k, w += 3) {
        const Cone& c = contacts.cones[k];
        const nonsmooth::Law& law = newton.laws[k];
        double su[3];
        multiply_scaled(law.s, c.u, su);
        for (int i = 0; i < 3; ++i) w[i] = scale_of(c) * (law.p[i] - su[i] - c.lambda[i]);
    }
    const assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k, w += 3) {
        const Resistance& a = resistances.laws[k];
        const nonsmooth::ResistanceLaw& law = newton.turns[k];
        const double u_n = contacts.cones[at(resistances.rows[k].contact)].u[0];
        double su[3];
        multiply_scaled(law.s, a.u, su);
        for (int i = 0; i < 3; ++i)
            w[i] = scale_of(a) * (law.p[i] - su[i] - law.column[i] * u_n - a.lambda[i]);
    }
}

/// Call f(scale) for every row in turn.
template <class F>
void each_scale(const assembly::Contacts& contacts, F&& f) noexcept {
    for (const Cone& c : contacts.cones)
        for (int i = 0; i < 3; ++i) f(scale_of(c));
    for (const Resistance& a : contacts.resistances.laws)
        for (int i = 0; i < 3; ++i) f(scale_of(a));
}

/// Compute y = x + scaled (S' − S) u.
void add_changes(const context::Model& model, const context::Newton& newton, const double* u,
                 const double* x, double* y) noexcept {
    const assembly::Contacts& contacts = model.system.contacts;
    const double* at_contacts = u;
    for (std::size_t k = 0; k < contacts.count(); ++k, u += 3, x += 3, y += 3) {
        const Cone& c = contacts.cones[k];
        double after[3], before[3];
        multiply_scaled(newton.laws[k].s, u, after);
        multiply_scaled(c.s, u, before);
        for (int i = 0; i < 3; ++i) y[i] = x[i] + scale_of(c) * (after[i] - before[i]);
    }
    const assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k, u += 3, x += 3, y += 3) {
        const Resistance& a = resistances.laws[k];
        const nonsmooth::ResistanceLaw& law = newton.turns[k];
        const double u_n = at_contacts[3 * at(resistances.rows[k].contact)];
        double after[3], before[3];
        multiply_scaled(law.s, u, after);
        multiply_scaled(a.s, u, before);
        for (int i = 0; i < 3; ++i)
            y[i] =
                x[i] + scale_of(a) * (after[i] - before[i] + (law.column[i] - a.column[i]) * u_n);
    }
}

}  // namespace

bool find_impulses(context::StepContext& ctx) noexcept {
    assembly::Contacts& contacts = ctx.model.system.contacts;
    const assembly::View v = context::view(ctx);
    double* w = ctx.work.newton.x.data();
    double* u = ctx.work.newton.u.data();
    find_defects(ctx.model, ctx.work.newton, w);
    nonsmooth::Gmres& gmres = ctx.work.newton.gmres;
    gmres.start(3 * contacts.triples(), w);
    if (gmres.start_norm() == 0.0) return true;
    for (double left = 1.0; left > kTolerance;) {
        if (gmres.count() == kKrylovLimit) return false;
        const double* x = gmres.direction();
        std::size_t i = 0;
        each_scale(contacts, [&](double scale) {
            const double inverse = 1.0 / scale;
            w[i] = inverse * x[i];
            ++i;
        });
        std::fill_n(v.solution, ctx.model.system.symbolic.scalars, 0.0);
        contacts.scatter(w, v.solution, v.body_offset);
        context::timed(ctx, Stage::factor, [&](context::StepContext& c) {
            c.model.system.numeric.solve(c.model.system.symbolic, v.solution, c.pool);
        });
        contacts.collect(v.solution, v.body_offset, u);
        add_changes(ctx.model, ctx.work.newton, u, x, gmres.image());
        left = gmres.take();
        // Two flops per entry of L, forward and backward.
        ctx.work.solve.step_flops += 4 * ctx.model.system.symbolic.factor_nnz;
    }
    gmres.solution(w);
    std::size_t i = 0;
    each_scale(contacts, [&](double scale) { w[i++] *= 1.0 / scale; });
    for (Cone& c : contacts.cones)
        for (double& p : c.p) p += *w++;
    for (Resistance& a : contacts.resistances.laws)
        for (double& p : a.p) p += *w++;
    return true;
}

}  // namespace hawser::contact
