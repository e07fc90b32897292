// SPDX-License-Identifier: Apache-2.0
#include "stepper/krylov.h"

#include "stepper/stages.h"
#include "stepper/timer.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

using nonsmooth::Cone;

/// Share of the defect that may stay: the next iteration takes up the rest.
constexpr double kTolerance = 0.1;

void times(const double* s, const double* u, double* out) noexcept {
    for (int i = 0; i < 3; ++i)
        out[i] = s[3 * i] * u[0] + s[3 * i + 1] * u[1] + s[3 * i + 2] * u[2];
}

/// Makes impulses on light and on heavy bodies comparable: λ² (W + Σ) is an energy.
double scale_of(const Cone& c) noexcept { return std::sqrt(c.mobility + c.sigma_n); }

}  // namespace

bool find_impulses(StepContext& ctx) noexcept {
    assembly::Contacts& contacts = ctx.system.contacts;
    const assembly::View v = view(ctx);
    const std::size_t count = contacts.count();
    double* w = ctx.newton.x.data();
    double* u = ctx.newton.u.data();
    for (std::size_t k = 0; k < count; ++k) {
        const Cone& c = contacts.cones[k];
        const nonsmooth::Law& law = ctx.newton.laws[k];
        double su[3];
        times(law.s, c.u, su);
        for (std::size_t i = 0; i < 3; ++i)
            w[3 * k + i] = scale_of(c) * (law.p[i] - su[i] - c.lambda[i]);
    }
    nonsmooth::Gmres& gmres = ctx.newton.gmres;
    gmres.start(3 * count, w);
    if (gmres.start_norm() == 0.0) return true;
    for (double left = 1.0; left > kTolerance;) {
        if (gmres.count() == kKrylovLimit) return false;
        const double* x = gmres.direction();
        double* y = gmres.image();
        for (std::size_t k = 0; k < count; ++k) {
            const double inverse = 1.0 / scale_of(contacts.cones[k]);
            for (std::size_t i = 0; i < 3; ++i) w[3 * k + i] = inverse * x[3 * k + i];
        }
        std::fill_n(v.solution, ctx.system.symbolic.scalars, 0.0);
        contacts.scatter(w, v.solution, v.body_offset);
        timed(ctx, Stage::factor, [&](StepContext& c) {
            c.system.numeric.solve(c.system.symbolic, v.solution, c.pool);
        });
        contacts.collect(v.solution, v.body_offset, u);
        for (std::size_t k = 0; k < count; ++k) {
            const Cone& c = contacts.cones[k];
            double after[3], before[3];
            times(ctx.newton.laws[k].s, u + 3 * k, after);
            times(c.s, u + 3 * k, before);
            for (std::size_t i = 0; i < 3; ++i)
                y[3 * k + i] = x[3 * k + i] + scale_of(c) * (after[i] - before[i]);
        }
        left = gmres.take();
        // Two flops an entry of L, forward and backward.
        ctx.step_flops += 4 * ctx.system.symbolic.factor_nnz;
    }
    gmres.solution(w);
    for (std::size_t k = 0; k < count; ++k) {
        Cone& c = contacts.cones[k];
        const double inverse = 1.0 / scale_of(c);
        for (std::size_t i = 0; i < 3; ++i) c.p[i] += inverse * w[3 * k + i];
    }
    return true;
}

}  // namespace hawser::stepper
