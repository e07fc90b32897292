// SPDX-License-Identifier: Apache-2.0
/// Norms over bodies: momentum residual, work of forces and drag. Consecutive rigid bodies are
/// processed eight at a time.
#include "assembly/geo.h"
#include "assembly/isa/coupled.h"
#include "assembly/isa/links.h"
#include "assembly/isa/rows.h"
#include "assembly/isa/spin.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::kBodyBlock;
using assembly::Norms;
using assembly::View;

/// Return h (θ v₊ + (1 − θ) v)ᵀ D (v + v₊)/2 [J], the work of drag (model/damping.h) along the path
/// between half steps.
double drag_work(const View& view, std::int32_t body, const double* v, const double* u,
                 const double* mean) {
    const double *d = view.drag_after + 6 * body, *e = view.drag_before + 6 * body;
    const int dof = view.dof[body];
    if (dof == 1) return view.h * (d[0] * u[0] + e[0] * v[0]) * mean[0];
    double work = 0.0;
    if (dof == 3) {  // the axes of a point mass are the world axes
        for (int i = 0; i < 3; ++i) work += (d[i] * u[i] + e[i] * v[i]) * mean[i];
        return view.h * work;
    }
    const M3 r = load9(view.r + 9 * body);
    for (int part = 0; part < dof; part += 3) {
        if (!any3(d + part)) continue;
        const V3 a = tmul(r, load3(u + part)), b = tmul(r, load3(mean + part));
        const V3 c = tmul(r, load3(v + part));
        work += (d[part] * a.x + e[part] * c.x) * b.x +
                (d[part + 1] * a.y + e[part + 1] * c.y) * b.y +
                (d[part + 2] * a.z + e[part + 2] * c.z) * b.z;
    }
    return view.h * work;
}

/// Return pᵀ M⁻¹ p for an impulse p on a body. For a scalar body M includes the terms of systems.
/// Reason: the slide of a guide has a millionth of the mass of a point mass. Without the mass of
/// the wire that it moves, it would determine all norms.
double inverse_mass_norm(const View& view, std::int32_t body, const double* p) {
    const int dof = view.dof[body];
    if (dof == 1)
        return p[0] * p[0] / view.body_block[assembly::block_offset(view.dof_begin[body])];
    const double inverse = 1.0 / view.mass[body];
    double norm = inverse * dot(load3(p), load3(p));
    if (dof == 6) {
        const V3 w = tmul(load9(view.r + 9 * body), load3(p + 3));
        norm += dot(w, load9(view.inv_inertia + 9 * body) * w);
    }
    return norm;
}

/// Add the contribution of one body to the residual norms and the work of the step. @param residual
/// Momentum residual of the body.
void one_body(const View& view, std::int32_t body, const double* residual, Norms& n) {
    const int dof = view.dof[body];
    const std::int32_t begin = view.dof_begin[body];
    const double *v = view.v + begin, *u = view.v_new + begin, *f = view.force + 6 * body;
    double mean[6], mv[6], diff[6];
    for (int j = 0; j < dof; ++j) {
        mean[j] = 0.5 * (v[j] + u[j]);
        n.work += view.h * f[j] * mean[j];
        n.finite += u[j];
    }
    n.drag += drag_work(view, body, v, u, mean);
    block_times(view.body_block + assembly::block_offset(view.dof_begin[body]), dof, v, mv);
    for (int j = 0; j < dof; ++j) diff[j] = view.a[begin + j] - mv[j];
    if (const double* b = coupled_block(view, body)) subtract_coupled(b, v, diff);
    n.momentum += inverse_mass_norm(view, body, residual);
    n.impulse += inverse_mass_norm(view, body, diff);
}

/// Compute the momentum residuals of eight rigid bodies in lanes; if requested, also store them.
void eight_residuals(const View& view, std::int32_t body, V8 (&p)[kLanes]) {
    double* kept = view.momentum ? view.momentum + view.dof_begin[body] : nullptr;
    if (!eight_links(view, body)) {
        double buffer[6 * kLanes + 2] = {};  // vectors end behind the last
        double* out = kept ? kept : buffer;
        for (int l = 0; l < kLanes; ++l) momentum_residual(view, body + l, out + 6 * l);
        load_bodies(out, 6, p);
        return;
    }
    eight_rhs<false>(view, body, view.lambda, p);
    if (!kept) return;
    V8 t[kLanes];
    for (int l = 0; l < kLanes; ++l) t[l] = p[l];
    store_bodies(kept, 6, 6, t);
}

void eight_bodies(const View& view, std::int32_t body, Norms& n) {
    const std::int32_t begin = view.dof_begin[body];
    V8 v[kLanes], u[kLanes], a[kLanes], p[kLanes];
    eight_residuals(view, body, p);
    load_bodies(view.v + begin, 6, v);
    load_bodies(view.v_new + begin, 6, u);
    load_bodies(view.a + begin, 6, a);
    V8 low[kLanes], high[kLanes];  // entries 0-7 and 4-11
    load_bodies(view.body_block + assembly::block_offset(view.dof_begin[body]), kBodyBlock, low);
    load_bodies(view.body_block + assembly::block_offset(view.dof_begin[body]) + 4, kBodyBlock,
                high);
    const WM3 r = load_bodies9(view.r + 9L * body);
    const V8 per_mass = 1.0 / load(view.mass + body);

    V8 work{}, drag{}, finite{};
    const double* force = view.force + 6L * body;
    for (int k = 0; k < 6 * kLanes; k += kLanes) {  // in memory order
        const V8 next = load(view.v_new + begin + k);
        work += load(force + k) * (0.5 * (load(view.v + begin + k) + next));
        finite += next;
    }
    const double* damping = view.drag_after + 6L * body;
    if (any_of_six(damping)) {
        V8 d[kLanes], e[kLanes];
        load_bodies(damping, 6, d);
        load_bodies(view.drag_before + 6L * body, 6, e);
        for (int part = 0; part < 6; part += 3) {
            const W3 last{v[part], v[part + 1], v[part + 2]};
            const W3 next{u[part], u[part + 1], u[part + 2]};
            const W3 x = tmul(r, next), w = tmul(r, last), y = w + x;  // y: twice the mean
            drag += (d[part] * x.x + e[part] * w.x) * y.x +
                    (d[part + 1] * x.y + e[part + 1] * w.y) * y.y +
                    (d[part + 2] * x.z + e[part + 2] * w.z) * y.z;
        }
    }
    const W3 linear = W3{a[0], a[1], a[2]} - mul6(low, W3{v[0], v[1], v[2]});
    const W3 turn = W3{a[3], a[4], a[5]} - mul6(high + 2, W3{v[3], v[4], v[5]});
    n.work += view.h * sum(work);
    n.drag += 0.5 * view.h * sum(drag);
    n.finite += sum(finite);
    auto add_norms = [&](const auto& inverse) {
        auto norm = [&](const W3& some, const W3& around) {
            const W3 w = tmul(r, around);
            return per_mass * dot(some, some) + dot(w, inverse * w);
        };
        n.momentum += sum(norm({p[0], p[1], p[2]}, {p[3], p[4], p[5]}));
        n.impulse += sum(norm(linear, turn));
    };
    V8 own[kLanes];
    load_bodies(view.principal + 6L * body, 6, own);
    if (all_principal(own[0]))
        add_norms(Principal<W8>{{own[3], own[4], own[5]}});
    else
        add_norms(load_bodies9(view.inv_inertia + 9L * body));
}

}  // namespace

void body_norms(const View& view, std::int32_t begin, std::int32_t end, Norms* norms) noexcept {
    Norms n = *norms;
    for (std::int32_t body = begin; body < end; ++body) {
        if (body + kLanes <= end && eight_rigid(view, body) && !before_links(view, body, end) &&
            !any_coupled(view, body, kLanes)) {
            eight_bodies(view, body, n);
            body += kLanes - 1;
        } else if (view.dof[body] > 0) {
            double buffer[6];
            double* residual = view.momentum ? view.momentum + view.dof_begin[body] : buffer;
            momentum_residual(view, body, residual);
            one_body(view, body, residual, n);
        }
    }
    *norms = n;
}

}  // namespace hawser::HAWSER_ISA
