// SPDX-License-Identifier: Apache-2.0
#include "stepper/lines.h"

#include "stepper/stages.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

using assembly::View;

/// 0: the row has no say (parted, or inside its range); 1: it pulls, λ ≤ 0; −1: λ ≥ 0.
double direction(const View& v, std::int32_t id) noexcept {
    if (v.parted[id]) return 0.0;
    if (!(v.flags[id] & model::kRange)) return 1.0;
    const double g = v.g[v.row_begin[id]];
    return g == 0.0 ? 0.0 : (g < 0.0 ? -1.0 : 1.0);
}

double stiffness_scale(const StepContext& ctx, const View& v, std::size_t i) noexcept {
    return ctx.system.one_sided_mobility[i] + v.sigma[v.row_begin[ctx.system.one_sided[i]]];
}

struct Point {
    double lambda, r;
};
Point along(const Newton& n, std::size_t i, double t) noexcept {
    return {n.line[2 * i] + t * (n.line_end[2 * i] - n.line[2 * i]),
            n.line[2 * i + 1] + t * (n.line_end[2 * i + 1] - n.line[2 * i + 1])};
}

}  // namespace

void reserve_lines(StepContext& ctx) {
    ctx.newton.line.resize(2 * ctx.system.one_sided.size());
    ctx.newton.line_end.resize(2 * ctx.system.one_sided.size());
}

void take_lines(StepContext& ctx) noexcept {
    const View v = view(ctx);
    for (std::size_t i = 0; i < ctx.system.one_sided.size(); ++i) {
        const std::int32_t id = ctx.system.one_sided[i], row = v.row_begin[id];
        ctx.newton.line_end[2 * i] = v.lambda[row];
        ctx.newton.line_end[2 * i + 1] = v.c[row] - row_speed(v, id) - v.sigma[row] * v.lambda[row];
    }
}

void keep_lines(StepContext& ctx, double t) noexcept {
    Newton& n = ctx.newton;
    if (t == 1.0) return n.line.swap(n.line_end);
    for (std::size_t i = 0; i < ctx.system.one_sided.size(); ++i) {
        const Point p = along(n, i, t);
        n.line[2 * i] = p.lambda;
        n.line[2 * i + 1] = p.r;
    }
}

double lines_merit(const StepContext& ctx, double t) noexcept {
    const View v = view(const_cast<StepContext&>(ctx));
    double sum = 0.0;
    for (std::size_t i = 0; i < ctx.system.one_sided.size(); ++i) {
        const double d = direction(v, ctx.system.one_sided[i]);
        if (d == 0.0) continue;
        const double scale = stiffness_scale(ctx, v, i);
        const Point p = along(ctx.newton, i, t);
        const double y = p.lambda + p.r / scale;
        const double e = p.lambda - (d > 0.0 ? std::min(0.0, y) : std::max(0.0, y));
        sum += scale * e * e;
    }
    return sum;
}

std::int32_t switch_lines(StepContext& ctx) noexcept {
    const View v = view(ctx);
    std::int32_t switched = 0;
    for (std::size_t i = 0; i < ctx.system.one_sided.size(); ++i) {
        const std::int32_t id = ctx.system.one_sided[i];
        const double d = direction(v, id);
        if (d == 0.0) continue;
        const Point p{ctx.newton.line[2 * i], ctx.newton.line[2 * i + 1]};
        const double y = d * (p.lambda + p.r / stiffness_scale(ctx, v, i));
        const double on = y < 0.0 ? 1.0 : 0.0;
        // Lines that lie about are slack and taut by rounding: that decides nothing.
        const double error = on != 0.0 ? y - d * p.lambda : d * p.lambda;
        if (on == v.active[id] || std::fabs(error) <= ctx.contact_floor) continue;
        v.active[id] = on;
        if (on == 0.0) v.lambda[v.row_begin[id]] = 0.0;
        ++switched;
    }
    return switched;
}

}  // namespace hawser::stepper
