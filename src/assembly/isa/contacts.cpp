// SPDX-License-Identifier: Apache-2.0
/// Velocities, impulses and matrix blocks of contact points.
#include "assembly/contact_rows.h"
#include "base/simd.h"
#include "base/small.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::ContactBlock;
using assembly::ContactRow;
using assembly::ContactSlot;
using assembly::ContactTerm;
using assembly::kContactBlock;
using assembly::ResistanceRow;

/// Return Eᵀ S E: the linearised law in the world frame.
M3 world_law(const ContactRow& row, const double* s) {
    const M3 e = load9(row.axis);
    const M3 transposed{{e.a[0], e.a[3], e.a[6], e.a[1], e.a[4], e.a[7], e.a[2], e.a[5], e.a[8]}};
    return congruence(transposed, s);
}

/// Add w [1; r̂_a] S [1, −r̂_b], 6×6 column-major, to out, for the parts that the slots have. (Aᵀ =
/// [1; r̂].)
void add_block(const M3& s, const ContactSlot& a, const ContactSlot& b, double* out) {
    const double w = a.weight * b.weight;
    const V3 ra = load3(a.arm), rb = load3(b.arm);
    V3 column[6];
    for (int j = 0; j < 3; ++j) column[j] = w * V3{s.a[j], s.a[3 + j], s.a[6 + j]};
    if (b.dof == 6) {  // −r̂ e_j = e_j × r: combinations of the columns of S
        column[3] = rb.y * column[2] - rb.z * column[1];
        column[4] = rb.z * column[0] - rb.x * column[2];
        column[5] = rb.x * column[1] - rb.y * column[0];
    }
    for (int j = 0; j < b.dof; ++j) {
        double* o = out + 6 * j;
        add3(o, column[j]);
        if (a.dof == 6) add3(o + 3, cross(ra, column[j]));
    }
}

/// Add J_aᵀ S J_b of the resistance of the contact to out. J of a slot is w E [0, 1]; for the
/// coupling to the normal velocity it is w n [1, −r̂].
void add_resistance(const ContactRow& row, const nonsmooth::Resistance& law, const ContactSlot& a,
                    const ContactSlot& b, double* out) {
    const double w = a.weight * b.weight;
    const M3 e = load9(row.axis);
    const M3 transposed{{e.a[0], e.a[3], e.a[6], e.a[1], e.a[4], e.a[7], e.a[2], e.a[5], e.a[8]}};
    const M3 s = congruence(transposed, law.s);
    const V3 n = load3(row.axis), lever = cross(load3(b.arm), n);
    const V3 column = w * tmul(e, load3(law.column));
    const double normal[6] = {n.x, n.y, n.z, lever.x, lever.y, lever.z};
    for (int j = 0; j < 6; ++j) add3(out + 6 * j + 3, normal[j] * column);
    for (int j = 0; j < 3; ++j) add3(out + 6 * (3 + j) + 3, w * V3{s.a[j], s.a[3 + j], s.a[6 + j]});
}

}  // namespace

void update_contacts(const ContactRow* rows, nonsmooth::Cone* cones, std::int32_t begin,
                     std::int32_t end, const double* v, double* slot_impulse) noexcept {
    for (std::int32_t k = begin; k < end; ++k) {
        const ContactRow& row = rows[k];
        nonsmooth::Cone& c = cones[k];
        V3 u{0, 0, 0};
        if (v != nullptr) {
            for (int i = 0; i < row.slots; ++i) {
                const ContactSlot& s = row.slot[i];
                if (s.dof == 0) continue;
                V3 at = load3(v + s.dof_begin);
                if (s.dof == 6) at = at + cross(load3(v + s.dof_begin + 3), load3(s.arm));
                u = u + s.weight * at;
            }
        }
        const M3 e = load9(row.axis);
        store3(c.u, load3(row.carried) + e * u);
        const V3 lambda = load3(c.p) - load9(c.s) * load3(c.u);
        store3(c.lambda, lambda);
        const V3 force = tmul(e, lambda);
        double* out = slot_impulse + 24L * k;
        for (int i = 0; i < row.slots; ++i) {
            const ContactSlot& s = row.slot[i];
            const V3 f = s.weight * force;
            store3(out + 6 * i, f);
            store3(out + 6 * i + 3, cross(load3(s.arm), f));
        }
    }
}

void turn_contacts(const ContactRow* rows, const nonsmooth::Cone* cones,
                   const ResistanceRow* resistance_rows, nonsmooth::Resistance* resistances,
                   std::int32_t begin, std::int32_t end, const double* v,
                   double* slot_impulse) noexcept {
    for (std::int32_t k = begin; k < end; ++k) {
        const ResistanceRow& at = resistance_rows[k];
        const ContactRow& row = rows[at.contact];
        nonsmooth::Resistance& a = resistances[k];
        V3 u{0, 0, 0};
        if (v != nullptr) {
            for (int i = 0; i < 2; ++i) {
                const ContactSlot& s = row.slot[i];
                if (s.dof == 6) u = u + s.weight * load3(v + s.dof_begin + 3);
            }
        }
        const M3 e = load9(row.axis);
        store3(a.u, load3(at.carried) + e * u);
        const double normal = cones[at.contact].u[0];
        store3(a.lambda, load3(a.p) - load9(a.s) * load3(a.u) - normal * load3(a.column));
        const V3 torque = tmul(e, load3(a.lambda));
        double* out = slot_impulse + 24L * at.contact;
        for (int i = 0; i < 2; ++i) add3(out + 6 * i + 3, row.slot[i].weight * torque);
    }
}

void contact_blocks(const ContactRow* rows, const nonsmooth::Cone* cones,
                    const nonsmooth::Resistance* resistances, const ContactBlock* blocks,
                    const std::uint8_t* changed, const ContactTerm* terms, std::int32_t begin,
                    std::int32_t end, double* out) noexcept {
    for (std::int32_t k = begin; k < end; ++k) {
        if (changed[k] == 0) continue;
        const ContactBlock& block = blocks[k];
        double* sum = out + static_cast<long>(kContactBlock) * k;
        for (int i = 0; i < kContactBlock; ++i) sum[i] = 0.0;
        for (std::int32_t t = block.begin; t < block.end; ++t) {
            const ContactTerm& term = terms[t];
            const nonsmooth::Cone& c = cones[term.contact];
            if (c.touch == nonsmooth::Touch::open) continue;
            const ContactRow& row = rows[term.contact];
            const M3 s = world_law(row, c.s);
            const ContactSlot &a = row.slot[term.i], &b = row.slot[term.j];
            add_block(s, a, b, sum);
            if (block.a != block.b) add_block(s, b, a, sum + 36);
            if (row.resistance < 0) continue;
            const nonsmooth::Resistance& law = resistances[row.resistance];
            add_resistance(row, law, a, b, sum);
            if (block.a != block.b) add_resistance(row, law, b, a, sum + 36);
        }
    }
}

extern const assembly::ContactKernels kContactKernels;
const assembly::ContactKernels kContactKernels = {update_contacts, turn_contacts, contact_blocks};

}  // namespace hawser::HAWSER_ISA
