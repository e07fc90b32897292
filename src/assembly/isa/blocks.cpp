// SPDX-License-Identifier: Apache-2.0
/// Writes the blocks of the matrix of a step into the panels of the solver.
///
/// Contributions are listed by column of the matrix (see assembly/system.h). One thread can thus
/// write a range of columns independently of the others, and every block is summed in a fixed
/// order. Sizes are dispatched to unrolled code.
#include "assembly/contact_rows.h"
#include "assembly/geo.h"
#include "assembly/isa/coupled.h"
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::Op;
using assembly::View;

/// A block in the panels: rows `step` apart, columns `ld`.
struct Place {
    double* first;
    long step, ld;
    double& operator()(int i, int j) const { return first[i * step + j * ld]; }
    [[nodiscard]] Place at(int i, int j) const { return {&(*this)(i, j), step, ld}; }
};

/// Add Σ_r w_r ja_rᵀ jb_r to out (DA × DB).
template <int DA, int DB>
inline void outer(const double* ja, const double* jb, int width, const double* w, int rows,
                  Place out) {
    V8 acc[DB] = {};  // lanes from DA on contain the columns of the next slot and are dropped
    for (int r = 0; r < rows; ++r) {
        const V8 a = load(ja + r * width);
        for (int j = 0; j < DB; ++j) acc[j] += (w[r] * jb[r * width + j]) * a;
    }
    if (out.step == 1) {
        for (int j = 0; j < DB; ++j) add_lanes<DA>(&out(0, j), acc[j]);
        return;
    }
    for (int j = 0; j < DB; ++j) {
        double entries[kLanes];
        store(entries, acc[j]);
        for (int i = 0; i < DA; ++i) out(i, j) += entries[i];
    }
}

/// Add the damping of a compact joint, which has no Op::geometric.
void damp_arms(const View& view, const Op& op, Place out) {
    const double damping = view.jacobian[op.jac_a + model::kArmsDamping];
    for (int i = 3; i < 6; ++i) out(i, i) += op.a == op.b ? damping : -damping;
}

/// Apply condense() to a compact joint, with its damping.
void condense_arms(const View& view, const Op& op, Place out) {
    double buffer[model::kArmBufferSize], w[model::kArmRows];
    model::unpack_arms(view.jacobian + op.jac_a, buffer);
    for (int r = 0; r < model::kArmRows; ++r)
        w[r] = view.active[op.id] * view.inv_sigma[view.row_begin[op.id] + r];
    outer<6, 6>(buffer + 6 * op.a, buffer + 6 * op.b, model::kArmWidth, w, model::kArmRows, out);
    damp_arms(view, op, out);
}

void condense(const View& view, const Op& op, Place out) {
    const double *ja = view.jacobian + op.jac_a, *jb = view.jacobian + op.jac_b;
    const int rows = view.rows[op.id];
    if (op.width == 0) return condense_arms(view, op, out);
    double w[kMaxInteractionRows];
    for (int r = 0; r < rows; ++r)
        w[r] = view.active[op.id] * view.inv_sigma[view.row_begin[op.id] + r];
    switch (8 * op.dof_a + op.dof_b) {
        case 8 * 3 + 3:
            outer<3, 3>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 6 + 6:
            outer<6, 6>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 3 + 6:
            outer<3, 6>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 6 + 3:
            outer<6, 3>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 1 + 1:
            outer<1, 1>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 1 + 3:
            outer<1, 3>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 3 + 1:
            outer<3, 1>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 1 + 6:
            outer<1, 6>(ja, jb, op.width, w, rows, out);
            break;
        case 8 * 6 + 1:
            outer<6, 1>(ja, jb, op.width, w, rows, out);
            break;
        default:
            break;
    }
}

inline void add_matrix(Place out, const M3& m, double s) {
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) out(i, j) += s * m.a[3 * i + j];
}

inline M3 skew(V3 r) { return {{0, -r.z, r.y, r.z, 0, -r.x, -r.y, r.x, 0}}; }

inline M3 product(const M3& p, const M3& q) {
    M3 o{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            o.a[3 * i + j] =
                p.a[3 * i] * q.a[j] + p.a[3 * i + 1] * q.a[3 + j] + p.a[3 * i + 2] * q.a[6 + j];
    return o;
}

/// Add the geometric stiffness of an interaction (geo.h) to the block of its bodies a and b. The
/// line part is ±A_aᵀ k A_b with A = [E, −r̂] for the arm r (+: a = b). Add the rotational damping.
void geometric(const View& view, const Op& op, Place out) {
    if (op.width == 0) return damp_arms(view, op, out);
    const double* rec = view.geo_record + view.geo[op.id].record;
    const bool rigid_a = op.dof_a == 6, rigid_b = op.dof_b == 6;
    const bool diagonal = op.a == op.b;
    const double sign = diagonal ? 1.0 : -1.0;
    if (const double pair = pair_mass_of(view, op.id); pair != 0.0)
        for (int i = 0; i < 3; ++i) out(i, i) -= sign * pair;
    if (rec[0] != 0.0) {
        const V3 u = load3(rec + 1);
        const double w = rec[0];
        const M3 k{{w - w * u.x * u.x, -w * u.x * u.y, -w * u.x * u.z, -w * u.x * u.y,
                    w - w * u.y * u.y, -w * u.y * u.z, -w * u.x * u.z, -w * u.y * u.z,
                    w - w * u.z * u.z}};
        add_matrix(out, k, sign);
        if (!rigid_a && !rigid_b) return;
        const M3 ra = skew(load3(rec + (op.a == 0 ? 4 : 7)));
        const M3 rb = skew(load3(rec + (op.b == 0 ? 4 : 7)));
        const M3 krb = product(k, rb);  // point velocity v − r̂ω: columns −k r̂
        if (rigid_b) add_matrix(out.at(0, 3), krb, -sign);
        if (rigid_a) add_matrix(out.at(3, 0), product(ra, k), sign);
        if (rigid_a && rigid_b) add_matrix(out.at(3, 3), product(ra, krb), -sign);
    }
    if (rigid_a && rigid_b)
        for (int i = 3; i < 6; ++i) out(i, i) += sign * rec[22];
}

void body_block(const View& view, const Op& op, Place out) {
    const double* block = view.body_block + assembly::block_offset(view.dof_begin[op.id]);
    const int dof = view.dof[op.id];
    if (dof == 1) {
        out(0, 0) += block[0];
        return;
    }
    add_matrix(out, full6(block), 1.0);
    if (dof == 6) add_matrix(out.at(3, 3), full6(block + 6), 1.0);
    if (const double* b = coupled_block(view, op.id))
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) out(3 + i, j) += coupled_entry(b, i, j);
}

void kept(const View& view, const Op& op, Place out) {
    const std::int32_t row = view.row_begin[op.id];
    const int rows = view.rows[op.id];
    if (op.kind == Op::kept_sigma) {
        for (int r = 0; r < rows; ++r) out(r, r) -= view.sigma[row + r];
        return;
    }
    const bool below = op.kind == Op::kept_rows;  // rows of G below the columns of the body
    const double* jac = view.jacobian + (below ? op.jac_b : op.jac_a);
    const int dof = below ? op.dof_b : op.dof_a;
    int width = op.width;
    double buffer[model::kArmBufferSize];
    if (width == 0) {
        model::unpack_arms(jac, buffer);
        jac = buffer + 6 * (below ? op.b : op.a);
        width = model::kArmWidth;
    }
    const double on = view.active[op.id];
    const Place g = below ? out : Place{out.first, out.ld, out.step};
    for (int r = 0; r < rows; ++r)
        for (int j = 0; j < dof; ++j) g(r, j) += on * jac[r * width + j];
}

/// Add the block K_ab, or K_ba, of the contact stiffness between two bodies a and b.
void contact(const View& view, const Op& op, Place out) {
    if (view.contact_block_used[op.id] == 0) return;
    const double* block =
        view.contact_block + static_cast<long>(assembly::kContactBlock) * op.id + (op.a ? 36 : 0);
    for (int j = 0; j < op.dof_b; ++j)
        for (int i = 0; i < op.dof_a; ++i) out(i, j) += block[6 * j + i];
}

}  // namespace

void gather_blocks(const View& view, const Op* ops, std::int64_t begin, std::int64_t end,
                   double* panel) noexcept {
    for (std::int64_t k = begin; k < end; ++k) {
        const Op& op = ops[k];
        const Place out{panel + op.address, op.step, op.ld};
        switch (op.kind) {
            case Op::condensed:
                condense(view, op, out);
                break;
            case Op::geometric:
                geometric(view, op, out);
                break;
            case Op::body_block:
                body_block(view, op, out);
                break;
            case Op::contact:
                contact(view, op, out);
                break;
            default:
                kept(view, op, out);
                break;
        }
    }
}

}  // namespace hawser::HAWSER_ISA
