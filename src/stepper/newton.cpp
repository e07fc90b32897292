// SPDX-License-Identifier: Apache-2.0
#include "stepper/newton.h"

#include "stepper/contact.h"
#include "stepper/iterate.h"
#include "stepper/krylov.h"
#include "stepper/lines.h"
#include "stepper/stages.h"
#include "stepper/sweeps.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

using assembly::Contacts;
using nonsmooth::Cone;
using nonsmooth::Coupling;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

constexpr int kHalvings = 2;    ///< More make the iterates creep; some steps then never end.
constexpr int kPatience = 8;    ///< Iterations before slow ones ask for a factorisation.
constexpr double kSlow = 0.25;  ///< Merit left after an iteration that asks for a factorisation.
constexpr int kKrylovFrom = 2;  ///< First iteration that may do without a factorisation.

/// Linear laws of all contacts about the iterate. @return contacts whose status changed.
std::int32_t linearise(StepContext& ctx) noexcept {
    Contacts& contacts = ctx.system.contacts;
    std::int32_t flips = 0;
    for (std::size_t k = 0; k < contacts.count(); ++k) {
        Cone& c = contacts.cones[k];
        const nonsmooth::Touch before = c.touch;
        ctx.newton.laws[k] = nonsmooth::linearise(c, nonsmooth::Scaling::by_mobility, c.touch);
        flips += c.touch != before ? 1 : 0;
    }
    return flips;
}

/// Σ (W + Σ) ‖λ − P‖² over contacts, a share t of the way: an energy [J].
double merit(const StepContext& ctx, double t) noexcept {
    double sum = lines_merit(ctx, t);
    const base::Array<Cone>& cones = ctx.system.contacts.cones;
    for (std::size_t k = 0; k < cones.size(); ++k) {
        const Cone& c = cones[k];
        const double* before = &ctx.newton.contact[6 * k];
        double u[3], lambda[3], e[3];
        for (int i = 0; i < 3; ++i) {
            u[i] = before[i] + t * (c.u[i] - before[i]);
            lambda[i] = before[3 + i] + t * (c.lambda[i] - before[3 + i]);
        }
        nonsmooth::residual(c, u, lambda, e);
        sum += (c.mobility + c.sigma_n) * e[0] * e[0] +
               (c.mobility + c.sigma_t) * (e[1] * e[1] + e[2] * e[2]);
    }
    return sum;
}

/// How far to go from an iterate, and what its merit is there.
struct Way {
    double share = 1.0, merit = 0.0;
};

/// Choose how far to go from the iterate kept, whose merit was `before`.
Way search(StepContext& ctx, double before) noexcept {
    double now = merit(ctx, 1.0), best = now, best_t = 1.0, t = 1.0;
    for (int k = 0; k < kHalvings && !(now <= before * (1.0 - 1e-4 * t)); ++k) {
        t *= 0.5;
        now = merit(ctx, t);
        if (!(now < best)) continue;
        best = now;
        best_t = t;
    }
    if (best_t < 1.0) shorten(ctx, best_t);
    return {best_t, best};
}

/// Newton iterations from the iterate at hand. @param coupling  Of all contacts.
Status iterate(StepContext& ctx, Coupling coupling) noexcept {
    for (Cone& c : ctx.system.contacts.cones) c.coupling = coupling;
    bool again = false, slow = false;
    double before = 0.0;
    for (int it = 0;; ++it) {
        ++ctx.newton.iterations;
        if (it < kKrylovFrom || again || slow || !find_impulses(ctx)) {
            if (it > 0) adopt_laws(ctx, false);
            if (const Status s = newton_solve(ctx, it == 0, it == 0 || again); s != Status::ok)
                return s;
        } else {
            continue_with_factor(ctx);
        }
        take_lines(ctx);
        const Way way = it > 0 ? search(ctx, before) : Way{};
        if (!std::isfinite(way.merit)) return Status::not_finite;
        slow = it > kPatience && way.merit > kSlow * before;
        keep_iterate(ctx);
        keep_lines(ctx, way.share);
        again = switch_lines(ctx) > 0;
        ctx.stats.natural_map = worst(ctx);
        if (!std::isfinite(ctx.stats.natural_map)) return Status::not_finite;
        const bool solved = ctx.stats.natural_map <= ctx.def.contact_tolerance && !again;
        if (solved) ctx.stats.flips_left = 0;
        if (solved || it + 1 >= ctx.def.contact_iterations) return Status::ok;
        ctx.stats.flips_left = linearise(ctx);
        before = merit(ctx, 0.0);
    }
}

}  // namespace

void reserve_newton(StepContext& ctx, std::size_t contacts) {
    Newton& n = ctx.newton;
    n.laws.resize(contacts);
    n.x.resize(3 * contacts);
    n.u.resize(3 * contacts);
    n.contact.resize(6 * contacts);
    n.gmres.reserve(3 * contacts, kKrylovLimit);
    n.v.resize(at(ctx.bodies.dofs));
    n.lambda.resize(at(ctx.interactions.row_count));
    n.bounds.resize(3 * contacts);
    n.limit.resize(contacts);
    n.touch.resize(contacts);
    reserve_lines(ctx);
}

void begin_newton(StepContext& ctx) noexcept {
    for (Cone& c : ctx.system.contacts.cones) c.coupling = Coupling::exact;
    (void)linearise(ctx);
    adopt_laws(ctx, true);
}

Status solve_newton(StepContext& ctx) noexcept {
    ctx.newton.iterations = 0;
    Status status = iterate(ctx, Coupling::exact);
    const bool unsolved = status == Status::ok && ctx.stats.natural_map > ctx.def.contact_tolerance;
    if (unsolved || status == Status::not_finite || status == Status::wrong_pivot) {
        // From rest, symmetric.
        for (std::size_t k = 0; k < ctx.system.contacts.count(); ++k) {
            Cone& c = ctx.system.contacts.cones[k];
            c.coupling = Coupling::lagged;
            std::fill_n(c.u, 3, 0.0);
            ctx.system.contacts.recall_lambda(k);
        }
        (void)linearise(ctx);
        adopt_laws(ctx, true);
        update_contacts(ctx, nullptr);
        ctx.rhs_ready = false;
        status = iterate(ctx, Coupling::lagged);
    }
    if (status == Status::ok) status = refine(ctx);
    if (status == Status::ok) ctx.stats.natural_map = worst(ctx);  // of what the step ends with
    return status;
}

}  // namespace hawser::stepper
