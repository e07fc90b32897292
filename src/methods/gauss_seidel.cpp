// SPDX-License-Identifier: Apache-2.0
#include "methods/gauss_seidel.h"

#include "base/index.h"
#include "base/small.h"
#include "nonsmooth/relax.h"

#include <algorithm>
#include <cmath>

namespace hawser::methods {
namespace {

using namespace hawser::generic;
using assembly::ContactRow;
using assembly::ContactSlot;
using nonsmooth::Cone;

/// Multiply a symmetric 3×3 matrix, stored as xx, xy, xz, yy, yz, zz, by a vector.
V3 mul6(const double* s, const V3& v) noexcept {
    return {s[0] * v.x + s[1] * v.y + s[2] * v.z, s[1] * v.x + s[3] * v.y + s[4] * v.z,
            s[2] * v.x + s[4] * v.y + s[5] * v.z};
}

/// Invert a symmetric 3×3 matrix; both are stored as xx, xy, xz, yy, yz, zz. @return false if the
/// determinant is not positive.
bool invert6(const double* m, double* out) noexcept {
    const double a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5],
                 c = m[1] * m[4] - m[2] * m[3];
    const double det = m[0] * a + m[1] * b + m[2] * c;
    if (!(det > 0.0)) return false;
    const double s = 1.0 / det;
    out[0] = s * a;
    out[1] = s * b;
    out[2] = s * c;
    out[3] = s * (m[0] * m[5] - m[2] * m[2]);
    out[4] = s * (m[1] * m[2] - m[0] * m[4]);
    out[5] = s * (m[0] * m[3] - m[1] * m[1]);
    return true;
}

const double* inverse_mass_block(const context::Newton& newton, std::int32_t body) noexcept {
    return &newton.inverse_mass[at(body) * assembly::kBodyBlock];
}

/// Compute the diagonal 3×3 block of J M⁻¹ Jᵀ of contact k, row-major [1/kg].
void contact_mobility(const context::Model& model, context::Newton& newton, std::size_t k,
                      double out[9]) noexcept {
    const ContactRow& row = model.system.contacts.rows[k];
    const M3 e = load9(row.axis);
    for (int j = 0; j < 3; ++j) {
        const V3 axis = load3(row.axis + 3 * j);
        V3 sum{0, 0, 0};
        for (int i = 0; i < row.slots; ++i) {
            const ContactSlot& s = row.slot[i];
            if (s.dof == 0) continue;
            const double* inverse = inverse_mass_block(newton, s.body);
            V3 u = mul6(inverse, axis);
            if (s.dof == 6)
                u = u + cross(mul6(inverse + 6, cross(load3(s.arm), axis)), load3(s.arm));
            sum = sum + (s.weight * s.weight) * u;
        }
        const V3 column = e * sum;
        out[j] = column.x;
        out[3 + j] = column.y;
        out[6 + j] = column.z;
    }
}

}  // namespace

void reserve_gauss_seidel(const context::Model& model, context::Newton& newton,
                          std::size_t contacts) {
    newton.inverse_mass.resize(at(model.bodies.count()) * assembly::kBodyBlock);
    newton.row_mobility.resize(at(model.interactions.row_count));
    newton.mobility.resize(9 * contacts);
}

bool invert_masses(const context::Model& model, context::Newton& newton,
                   const assembly::View& v) noexcept {
    for (std::int32_t b = 0; b < v.body_count; ++b) {
        const double* block = v.body_block + assembly::block_offset(v.dof_begin[b]);
        double* out = &newton.inverse_mass[at(b) * assembly::kBodyBlock];
        bool good = true;
        if (v.dof[b] == 1) out[0] = 1.0 / block[0];
        if (v.dof[b] >= 3) good = invert6(block, out);
        if (v.dof[b] == 6) good = good && invert6(block + 6, out + 6);
        if (!good) return false;
    }
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k)
        contact_mobility(model, newton, k, &newton.mobility[9 * k]);
    return true;
}

void velocity_after_impulse(const context::Newton& newton, std::int32_t body, int dof,
                            const double* p, double* out) noexcept {
    const double* inverse = inverse_mass_block(newton, body);
    if (dof == 1) out[0] = inverse[0] * p[0];
    if (dof >= 3) store3(out, mul6(inverse, load3(p)));
    if (dof == 6) store3(out + 3, mul6(inverse + 6, load3(p + 3)));
}

void push_contact(const context::Model& model, const context::Newton& newton,
                  const assembly::View& v, std::size_t k, const double x[3]) noexcept {
    const ContactRow& row = model.system.contacts.rows[k];
    const V3 force = tmul(load9(row.axis), load3(x));
    for (int i = 0; i < row.slots; ++i) {
        const ContactSlot& s = row.slot[i];
        if (s.dof == 0) continue;
        const double* inverse = inverse_mass_block(newton, s.body);
        const V3 f = s.weight * force;
        add3(v.v_new + s.dof_begin, mul6(inverse, f));
        if (s.dof == 6) add3(v.v_new + s.dof_begin + 3, mul6(inverse + 6, cross(load3(s.arm), f)));
    }
}

void read_contact(context::Model& model, const assembly::View& v, std::size_t k) noexcept {
    const ContactRow& row = model.system.contacts.rows[k];
    V3 sum{0, 0, 0};
    for (int i = 0; i < row.slots; ++i) {
        const ContactSlot& s = row.slot[i];
        if (s.dof == 0) continue;
        V3 u = load3(v.v_new + s.dof_begin);
        if (s.dof == 6) u = u + cross(load3(v.v_new + s.dof_begin + 3), load3(s.arm));
        sum = sum + s.weight * u;
    }
    store3(model.system.contacts.cones[k].u, load3(row.carried) + load9(row.axis) * sum);
}

void relax_tangents(context::Model& model, const context::Newton& newton, const assembly::View& v,
                    std::size_t k) noexcept {
    const double* block = &newton.mobility[9 * k];
    read_contact(model, v, k);
    Cone& c = model.system.contacts.cones[k];
    // Largest eigenvalue of the 2×2 block of the tangents.
    const double mean = 0.5 * (block[4] + block[8]), half = 0.5 * (block[4] - block[8]);
    const double largest = mean + std::sqrt(half * half + block[5] * block[5]);
    double now[2];
    nonsmooth::relax_tangents(c, largest, now);
    const double change[3] = {0.0, now[0] - c.lambda[1], now[1] - c.lambda[2]};
    c.lambda[1] = now[0];
    c.lambda[2] = now[1];
    if (change[1] != 0.0 || change[2] != 0.0) push_contact(model, newton, v, k, change);
}

void relax_normal(context::Model& model, const context::Newton& newton, const assembly::View& v,
                  std::size_t k) noexcept {
    const double* block = &newton.mobility[9 * k];
    read_contact(model, v, k);
    Cone& c = model.system.contacts.cones[k];
    const double now = nonsmooth::relax_normal(c, block[0]);
    const double change[3] = {now - c.lambda[0], 0.0, 0.0};
    c.lambda[0] = now;
    if (change[0] != 0.0) push_contact(model, newton, v, k, change);
}

void freeze_impulses(context::Model& model) noexcept {
    for (Cone& c : model.system.contacts.cones) {
        std::fill_n(c.s, 9, 0.0);
        std::copy_n(c.lambda, 3, c.p);
        c.touch = nonsmooth::touch_by_impulse(c);
    }
}

}  // namespace hawser::methods
