// SPDX-License-Identifier: Apache-2.0
#include "collide/placing.h"

#include "base/index.h"
#include "base/small.h"

#include <algorithm>
#include <cmath>

namespace hawser::collide {
namespace {

using generic::load3;
using generic::store3;
using generic::V3;
/// Half of the bound of a plane's box.
constexpr double kUnbounded = 0.5e30;

void multiply(const double* a, const double* b, double* out) noexcept {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
}

/// Compute a rotation whose z is the unit vector `axis`. x and y depend on `axis` alone. They jump
/// where its smallest component changes, which does not affect a capsule.
void frame_with_axis(const V3& axis, double* r) noexcept {
    const double ax = std::abs(axis.x), ay = std::abs(axis.y), az = std::abs(axis.z);
    V3 other{0.0, 0.0, 0.0};
    (ax <= ay && ax <= az ? other.x : ay <= az ? other.y : other.z) = 1.0;
    V3 x = generic::cross(other, axis);
    x = (1.0 / generic::norm(x)) * x;
    const V3 y = generic::cross(axis, x);
    const V3 columns[3] = {x, y, axis};
    for (int j = 0; j < 3; ++j) {
        r[j] = columns[j].x;
        r[3 + j] = columns[j].y;
        r[6 + j] = columns[j].z;
    }
}

/// True if the element along a segment still exists. Edits happen before the next preparation.
bool has_line(const Shape& s, const model::Interactions* lines) noexcept {
    if (lines == nullptr || s.line < 0 || s.line >= lines->count() || lines->gone(s.line))
        return false;
    const std::int32_t* body = &lines->body[kMaxInteractionBodies * at(s.line)];
    return body[0] == s.body[0] && body[1] == s.body[1] &&
           kind_info(lines->kinds[at(s.line)]).is(kWireElement);
}

/// Return the point at which a body holds an end of a segment. This is a fixed point of the body,
/// or the point at which a routed element leaves its wheel.
V3 held_point(const Shape& s, const model::Bodies& bodies,
              const model::Interactions* lines) noexcept {
    const std::int32_t body = s.body[at(s.held)];
    V3 point = load3(s.local.x);
    if (has_line(s, lines)) {
        if (kind_info(lines->kinds[at(s.line)]).is(kRouted)) {
            const Vec3 leaves = lines->line_shape(s.line, bodies).at[at(s.held)];
            return load3(leaves.data());
        }
        point = load3(lines->def[at(s.line)].point[at(s.held)].data());
    }
    return load3(&bodies.x[3 * at(body)]) + generic::load9(&bodies.r[9 * at(body)]) * point;
}

void place_segment(const Shape& s, const model::Bodies& bodies, const model::Interactions* lines,
                   Placed& p) noexcept {
    V3 a = load3(&bodies.x[3 * at(s.body[0])]), b = load3(&bodies.x[3 * at(s.body[1])]);
    if (s.held >= 0) {
        const V3 held = held_point(s, bodies, lines);
        (s.held == 0 ? a : b) = held;
        store3(p.held, held);
    }
    const V3 along = b - a;
    const double length = generic::norm(along);
    p.geometry.half_length = 0.5 * length;
    frame_with_axis(length > 1e-12 ? (1.0 / length) * along : V3{0.0, 0.0, 1.0}, p.at.r);
    store3(p.at.x, 0.5 * (a + b));
    store3(p.origin, 0.5 * (a + b));
    const Motion ma = motion_of(bodies, s.body[0]), mb = motion_of(bodies, s.body[1]);
    V3 va = load3(ma.v), vb = load3(mb.v);
    if (s.held >= 0) {
        const Motion& m = s.held == 0 ? ma : mb;
        V3& v = s.held == 0 ? va : vb;
        const V3 arm = load3(p.held) - load3(&bodies.x[3 * at(s.body[at(s.held)])]);
        v = v + generic::cross(load3(m.w), arm);
    }
    store3(p.motion.v, 0.5 * (va + vb));
    store3(p.motion.w, {0.0, 0.0, 0.0});
    store3(p.stretch, 0.5 * (vb - va));
    p.spread = 0.5 * generic::norm(vb - va);
}

void place_on_body(const Shape& s, const model::Bodies& bodies, Placed& p) noexcept {
    const double* x = &bodies.x[3 * at(s.body[0])];
    const double* r = &bodies.r[9 * at(s.body[0])];
    multiply(r, s.local.r, p.at.r);
    store3(p.at.x, load3(x) + generic::load9(r) * load3(s.local.x));
    store3(p.origin, load3(x));
    p.motion = motion_of(bodies, s.body[0]);
    store3(p.stretch, {0.0, 0.0, 0.0});
    p.spread = 0.0;
}

void enclose(Placed& p) noexcept {
    p.box = bounds(p.geometry, p.at);
    p.unbounded = false;
    double square = 0.0;
    for (int i = 0; i < 3; ++i) {
        p.unbounded = p.unbounded || p.box.high[i] > kUnbounded || p.box.low[i] < -kUnbounded;
        p.centre[i] = 0.5 * (p.box.low[i] + p.box.high[i]);
        const double half = 0.5 * (p.box.high[i] - p.box.low[i]);
        square += half * half;
    }
    p.radius = std::sqrt(square);
    if (!p.unbounded) return;
    p.radius = 0.0;
    std::copy_n(p.at.x, 3, p.centre);
}

}  // namespace

Motion motion_of(const model::Bodies& bodies, std::int32_t body) noexcept {
    Motion m{};
    const int dof = bodies.dof(body);
    const double* v =
        dof == 0 ? &bodies.v_fixed[6 * at(body)] : &bodies.v[at(bodies.dof_begin[at(body)])];
    std::copy_n(v, 3, m.v);
    if (dof != 3) std::copy_n(v + 3, 3, m.w);
    return m;
}

std::int32_t held_segment_end(const Shape& shape, const model::Bodies& bodies) noexcept {
    if (!shape.segment()) return -1;
    const bool centre =
        shape.local.x[0] == 0.0 && shape.local.x[1] == 0.0 && shape.local.x[2] == 0.0;
    for (std::int32_t end = 0; end < 2; ++end) {
        const BodyKind kind = bodies.kind[at(shape.body[at(end)])];
        if (kind != BodyKind::lump && !(kind == BodyKind::fixed && centre)) return end;
    }
    return -1;
}

void place(const Shape& shape, const model::Bodies& bodies, const model::Interactions* lines,
           double h, double margin, Placed& placed) noexcept {
    const Placement before = placed.at;
    const double length = placed.geometry.half_length;
    if (shape.segment())
        place_segment(shape, bodies, lines, placed);
    else
        place_on_body(shape, bodies, placed);
    const bool same =
        std::ranges::equal(before.x, placed.at.x) && std::ranges::equal(before.r, placed.at.r);
    if (!same || length != placed.geometry.half_length) enclose(placed);
    const Motion& m = placed.motion;
    const V3 arm = load3(placed.centre) - load3(placed.origin);
    const double turning =
        generic::norm(load3(m.w)) * (generic::norm(arm) + placed.radius) + placed.spread;
    const double around = std::max(0.5 * margin, shape.margin) + h * turning;
    for (int i = 0; i < 3; ++i) {
        placed.swept.low[i] = placed.box.low[i] + std::min(0.0, h * m.v[i]) - around;
        placed.swept.high[i] = placed.box.high[i] + std::max(0.0, h * m.v[i]) + around;
    }
}

double relative_speed(const Placed& a, const Placed& b) noexcept {
    const bool first = b.unbounded || (!a.unbounded && a.radius <= b.radius);
    const Placed& small = first ? a : b;
    const V3 c = load3(small.centre);
    const V3 wa = load3(a.motion.w), wb = load3(b.motion.w);
    const V3 va = load3(a.motion.v) + generic::cross(wa, c - load3(a.origin));
    const V3 vb = load3(b.motion.v) + generic::cross(wb, c - load3(b.origin));
    return generic::norm(va - vb) + generic::norm(wa - wb) * small.radius + a.spread + b.spread;
}

}  // namespace hawser::collide
