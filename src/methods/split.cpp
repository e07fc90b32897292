// SPDX-License-Identifier: Apache-2.0
/// Method split, the default of commercial engines: joints and normals are solved directly,
/// tangents by sweeps.
///
/// The normal problem with given tangential impulses is a linear complementarity problem. An active
/// set of load-bearing contacts solves it. Then WorldDef::nonsmooth_sweeps sweeps relax the
/// tangents on the disk of radius μ λ_n, with bodies that respond as if free. Finally the normal
/// problem is solved once more with the new tangential impulses.
///
/// Limits: sticking rows are not solved exactly. The response of joints and normals to friction
/// takes effect one step later. Long chains are therefore viscous and stiff stacks creep.
#include "contact/iterate.h"
#include "context/context.h"
#include "context/view.h"
#include "methods/gauss_seidel.h"
#include "nonsmooth/relax.h"
#include "solve/active_set.h"
#include "solve/solve.h"

#include <algorithm>
#include <cmath>

namespace hawser::methods {
namespace {

using nonsmooth::Cone;
using nonsmooth::Touch;

/// Most iterations of the active set; one to three are usual.
constexpr int kMaxSplitRounds = 20;

/// Write the linear law of a contact with constant tangential impulses. @param bears  True: the
/// normal row is in the matrix.
void make_law(context::Model& model, context::Newton& newton, std::size_t k, bool bears) noexcept {
    Cone& c = model.system.contacts.cones[k];
    nonsmooth::Law& law = newton.laws[k];
    law = {};
    if (bears) {
        law.s[0] = 1.0 / c.sigma_n;
        law.p[0] = c.b[0] / c.sigma_n;
    }
    law.p[1] = c.lambda[1];
    law.p[2] = c.lambda[2];
    // Sliding is determined at the end; here the status marks a law with nonzero entries.
    const bool pushed = law.p[1] != 0.0 || law.p[2] != 0.0;
    c.touch = bears || pushed ? Touch::stick : Touch::open;
}

bool presses(const Cone& c) noexcept {
    const double r = c.u[0] + c.sigma_n * c.lambda[0] - c.b[0];
    return c.lambda[0] - r / (c.mobility + c.sigma_n) > 0.0;
}

/// Solve for joints and normal impulses, with constant friction. @param first  True: start from v₊
/// = 0.
Status solve_normals(context::StepContext& ctx, bool first) noexcept {
    bool again = false;
    for (int round = 0;; ++round) {
        bool changed = false;
        for (const std::uint8_t c : ctx.model.system.contacts.changed) changed = changed || c != 0;
        if (first || changed) {
            if (const Status s = solve::newton_solve(ctx, first, first || again); s != Status::ok)
                return s;
        } else {
            solve::continue_with_factor(ctx);
        }
        first = false;
        ++ctx.work.newton.iterations;
        again = solve::update_active_set(ctx.model, ctx.work, round);
        std::int32_t flips = 0;
        for (std::size_t k = 0; k < ctx.model.system.contacts.count(); ++k) {
            const Cone& c = ctx.model.system.contacts.cones[k];
            const bool now = presses(c);
            flips += now != (c.s[0] != 0.0) ? 1 : 0;
            make_law(ctx.model, ctx.work.newton, k, now);
        }
        ctx.work.stats.flips_left = flips;
        if ((flips == 0 && !again) || round + 1 >= kMaxSplitRounds) return Status::ok;
        // A switched row changes the matrix even if no contact changes.
        contact::adopt_laws(ctx.model, ctx.work.newton, ctx.pool, again);
    }
}

/// Relax the tangential impulses at the current normal impulses.
Status sweep_tangents(context::Model& model, context::Newton& newton,
                      runtime::Pool& pool) noexcept {
    const assembly::View v = context::row_view(model);
    if (!invert_masses(model, newton, v)) return Status::wrong_pivot;
    for (int i = 0; i < model.def.nonsmooth_sweeps && !pool.stopping(); ++i)
        for (std::size_t k = 0; k < model.system.contacts.count(); ++k)
            relax_tangents(model, newton, v, k);
    // The radius changes slightly afterwards, but sliding is determined here.
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k)
        newton.touch[k] = nonsmooth::touch_by_impulse(model.system.contacts.cones[k]);
    return Status::ok;
}

}  // namespace

void begin_split(context::Model& model, context::Newton& newton, runtime::Pool& pool) noexcept {
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        const Cone& c = model.system.contacts.cones[k];
        make_law(model, newton, k, c.u[0] - c.b[0] < 0.0);
    }
    contact::adopt_laws(model, newton, pool, true);
}

Status solve_split(context::StepContext& ctx) noexcept {
    ctx.work.newton.iterations = 0;
    if (const Status s = solve_normals(ctx, true); s != Status::ok) return s;
    if (const Status s = sweep_tangents(ctx.model, ctx.work.newton, ctx.pool); s != Status::ok)
        return s;
    // The sweeps changed v₊ without the normals; the solver restores it from the momentum balance.
    for (std::size_t k = 0; k < ctx.model.system.contacts.count(); ++k)
        make_law(ctx.model, ctx.work.newton, k, ctx.model.system.contacts.cones[k].s[0] != 0.0);
    contact::adopt_laws(ctx.model, ctx.work.newton, ctx.pool, false);
    if (const Status s = solve_normals(ctx, false); s != Status::ok) return s;
    ctx.work.stats.natural_map = contact::largest_residual(ctx.model, ctx.work.solve, ctx.pool);
    if (!std::isfinite(ctx.work.stats.natural_map)) return Status::not_finite;
    const Status status = solve::refine(ctx);
    for (std::size_t k = 0; k < ctx.model.system.contacts.count(); ++k) {
        Cone& c = ctx.model.system.contacts.cones[k];
        c.touch = c.lambda[0] > 0.0 ? ctx.work.newton.touch[k] : Touch::open;
    }
    return status;
}

}  // namespace hawser::methods
