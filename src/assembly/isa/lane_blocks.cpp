// SPDX-License-Identifier: Apache-2.0
/// Writes blocks of several chains at once into the lanes of a batch step, with the terms of
/// blocks.cpp.
#include "assembly/geo.h"
#include "assembly/isa/arms.h"
#include "assembly/isa/coupled.h"
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/transpose.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::LaneOp;
using assembly::Op;
using assembly::View;

/// A block of eight lanes in the panels.
struct LaneTarget {
    double* first;
    long step;
    void add(int i, int j, const V8& v) const {
        double* p = first + i * step + 8 * j;
        store(p, load(p) + v);
    }
};

inline V8 used_lanes(const LaneOp& op) { return bit_lanes(op.used); }

/// Gather one value of the interaction or row of each lane.
inline V8 pick(const double* values, const std::int32_t* index, int offset = 0) {
    return gather_range(values + offset, index, 0, kLanes);
}

/// First row of the interaction of each lane.
struct LaneRow {
    std::int32_t first[kLanes];

    LaneRow(const View& view, const LaneOp& op) {
        for (int l = 0; l < kLanes; ++l) first[l] = view.row_begin[op.id[l]];
    }
    [[nodiscard]] V8 pick(const double* values, int r) const {
        return gather_range(values + r, first, 0, kLanes);
    }
};

/// Add rows [r, r + N) of Σ_r w_r ja_rᵀ jb_r; on the diagonal only the lower triangle.
template <bool kDiagonal, int DA, int DB, int N>
inline void outer_rows(const View& view, const LaneOp& op, int r, LaneTarget out) {
    V8 a[N][kLanes], b[N][kLanes];
    const V8 on = used_lanes(op) * pick(view.active, op.id);
    const LaneRow rows(view, op);
    for (int k = 0; k < N; ++k) {
        const double* row = view.jacobian + (r + k) * op.width;
        load_lanes(row, op.from, a[k]);
        if constexpr (kDiagonal)
            for (int j = 0; j < kLanes; ++j) b[k][j] = a[k][j];
        else
            load_lanes(row + op.to_b, op.from, b[k]);
        const V8 w = on * rows.pick(view.inv_sigma, r + k);
        for (int j = 0; j < DB; ++j) b[k][j] = b[k][j] * w;
    }
    for (int j = 0; j < DB; ++j)
        for (int i = kDiagonal ? j : 0; i < DA; ++i) {
            V8 sum = a[0][i] * b[0][j];
            for (int k = 1; k < N; ++k) sum += a[k][i] * b[k][j];
            out.add(i, j, sum);
        }
}

template <bool kDiagonal, int DA, int DB>
inline void outer_side(const View& view, const LaneOp& op, LaneTarget out) {
    if (op.rows == 3) return outer_rows<kDiagonal, DA, DB, 3>(view, op, 0, out);
    int r = 0;
    for (; r + 2 <= op.rows; r += 2) outer_rows<kDiagonal, DA, DB, 2>(view, op, r, out);
    if (r < op.rows) outer_rows<kDiagonal, DA, DB, 1>(view, op, r, out);
}

template <int DA, int DB>
inline void outer(const View& view, const LaneOp& op, LaneTarget out) {
    if constexpr (DA == DB)
        if (op.a == op.b) return outer_side<true, DA, DB>(view, op, out);
    outer_side<false, DA, DB>(view, op, out);
}

/// Apply condense() to compact joints with their damping. Most of G is constant.
void condense_arms(const View& view, const LaneOp& op, LaneTarget out) {
    const ArmsT<W8> arms = lane_arms(view.jacobian, op.from);
    const V8 used = used_lanes(op), on = used * pick(view.active, op.id);
    const V8 damping = used * arms.damping;
    V8 w[3], a[3][3], b[3][3];
    const LaneRow rows(view, op);
    for (int r = 0; r < 3; ++r) w[r] = on * rows.pick(view.inv_sigma, r);
    const V8 turned = bit_lanes(op.turned), none{};
    auto arm_of = [&](int slot) {
        const V3T<W8>&own = slot == 0 ? arms.r0 : arms.r1, &other = slot == 0 ? arms.r1 : arms.r0;
        return op.turned == 0 ? own : select_greater(W8(turned), W8(none), other, own);
    };
    arm_rows<W8>(arm_of(op.a), a);
    if (op.a == op.b) {
        for (int i = 0; i < 3; ++i) {
            out.add(i, i, w[i]);
            for (int j = 0; j < 3; ++j)
                if (j != i) out.add(3 + j, i, w[i] * a[i][j]);
        }
        for (int k = 0; k < 3; ++k)
            for (int j = k; j < 3; ++j) {
                V8 sum = j == k ? damping : V8{};
                for (int i = 0; i < 3; ++i)
                    if (i != j && i != k) sum += w[i] * a[i][j] * a[i][k];
                out.add(3 + j, 3 + k, sum);
            }
        return;
    }
    arm_rows<W8>(arm_of(op.b), b);
    for (int i = 0; i < 3; ++i) {
        out.add(i, i, -w[i]);
        for (int j = 0; j < 3; ++j) {
            if (j == i) continue;
            out.add(3 + j, i, -w[i] * a[i][j]);
            out.add(i, 3 + j, -w[i] * b[i][j]);
        }
    }
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            V8 sum = j == k ? damping : V8{};
            for (int i = 0; i < 3; ++i)
                if (i != j && i != k) sum += w[i] * a[i][j] * b[i][k];
            out.add(3 + j, 3 + k, -sum);
        }
}

void condense(const View& view, const LaneOp& op, LaneTarget out) {
    if (op.width == 0) return condense_arms(view, op, out);
    switch (8 * op.dof_a + op.dof_b) {
        case 8 * 3 + 3:
            outer<3, 3>(view, op, out);
            break;
        case 8 * 6 + 6:
            outer<6, 6>(view, op, out);
            break;
        case 8 * 3 + 6:
            outer<3, 6>(view, op, out);
            break;
        case 8 * 6 + 3:
            outer<6, 3>(view, op, out);
            break;
        case 8 * 1 + 3:
            outer<1, 3>(view, op, out);
            break;
        case 8 * 1 + 6:
            outer<1, 6>(view, op, out);
            break;
        default:
            break;
    }
}

/// Add the blocks of geometric stiffness and damping (geo.h) in lanes, like geometric() in
/// blocks.cpp.
void geometric(const View& view, const LaneOp& op, LaneTarget out) {
    const bool rigid_a = op.dof_a == 6, rigid_b = op.dof_b == 6;
    const bool diagonal = op.a == op.b;
    const V8 sign = used_lanes(op) * (diagonal ? 1.0 : -1.0);
    if (op.width == 0) {
        const V8 damping = sign * pick(view.jacobian, op.from, model::kArmsDamping);
        for (int i = 3; i < 6; ++i) out.add(i, i, damping);
        return;
    }
    if (view.pair_mass != nullptr && op.dof_a == 3 && op.dof_b == 3) {
        double masses[kLanes];
        for (int l = 0; l < kLanes; ++l) masses[l] = pair_mass_of(view, op.id[l]);
        const V8 pair = sign * load(masses);
        for (int i = 0; i < 3; ++i) out.add(i, i, V8{} - pair);
    }
    V8 head[kLanes];  // w, u, r0, first of r1
    load_lanes(view.geo_record, op.from, head);
    if (any(head[0])) {
        const V8 w = sign * head[0];
        V8 k[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j <= i; ++j) {
                k[i][j] = V8{} - w * head[1 + i] * head[1 + j];
                if (i == j) k[i][j] += w;
                k[j][i] = k[i][j];
            }
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) out.add(i, j, k[i][j]);
        V8 r1[kLanes];
        if (rigid_a || rigid_b) load_lanes(view.geo_record + 7, op.from, r1);
        const V8* ra = op.a == 0 ? head + 4 : r1;
        const V8* rb = op.b == 0 ? head + 4 : r1;
        V8 kr[3][3];  // k r̂_b
        if (rigid_b)
            for (int i = 0; i < 3; ++i) {
                kr[i][0] = k[i][1] * rb[2] - k[i][2] * rb[1];
                kr[i][1] = k[i][2] * rb[0] - k[i][0] * rb[2];
                kr[i][2] = k[i][0] * rb[1] - k[i][1] * rb[0];
                for (int j = 0; j < 3; ++j) out.add(i, 3 + j, V8{} - kr[i][j]);
            }
        if (rigid_a)
            for (int j = 0; j < 3; ++j) {  // r̂_a k
                out.add(3, j, ra[1] * k[2][j] - ra[2] * k[1][j]);
                out.add(4, j, ra[2] * k[0][j] - ra[0] * k[2][j]);
                out.add(5, j, ra[0] * k[1][j] - ra[1] * k[0][j]);
                if (!rigid_b) continue;
                out.add(3, 3 + j, ra[2] * kr[1][j] - ra[1] * kr[2][j]);
                out.add(4, 3 + j, ra[0] * kr[2][j] - ra[2] * kr[0][j]);
                out.add(5, 3 + j, ra[1] * kr[0][j] - ra[0] * kr[1][j]);
            }
    }
    if (rigid_a && rigid_b) {
        const V8 damping = sign * pick(view.geo_record, op.from, 22);
        for (int i = 3; i < 6; ++i) out.add(i, i, damping);
    }
}

void body_block(const View& view, const LaneOp& op, LaneTarget out) {
    constexpr int kLower[6][2] = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}, {2, 2}};
    const V8 used = used_lanes(op);
    V8 block[kLanes];
    load_lanes(view.body_block, op.from, block);
    if (op.dof_a == 1) {
        out.add(0, 0, used * block[0]);
        return;
    }
    for (int k = 0; k < 6; ++k) out.add(kLower[k][0], kLower[k][1], used * block[k]);
    if (op.dof_a < 6) return;
    // Load the last eight of twelve entries: a vector must not end behind the array.
    load_lanes(view.body_block + 4, op.from, block);
    for (int k = 0; k < 6; ++k) out.add(3 + kLower[k][0], 3 + kLower[k][1], used * block[2 + k]);
    if (view.coupled == nullptr) return;
    for (int l = 0; l < kLanes; ++l) {
        const double* b = (op.used >> l & 1) != 0 ? coupled_block(view, op.id[l]) : nullptr;
        if (b == nullptr) continue;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                out.first[(3 + i) * out.step + 8 * j + l] += coupled_entry(b, i, j);
    }
}

void kept(const View& view, const LaneOp& op, LaneTarget out) {
    if (op.kind == Op::kept_sigma) {
        const LaneRow rows(view, op);
        for (int r = 0; r < op.rows; ++r)
            out.add(r, r, V8{} - used_lanes(op) * rows.pick(view.sigma, r));
        return;
    }
    const bool below = op.kind == Op::kept_rows;
    const V8 on = used_lanes(op) * pick(view.active, op.id);
    const int dof = below ? op.dof_b : op.dof_a;
    if (op.width == 0) {
        const int slot = below ? op.b : op.a;
        const ArmsT<W8> arms = lane_arms(view.jacobian, op.from);
        const V8 sign = slot == 0 ? -on : on;
        V8 arm[3][3];
        arm_rows<W8>(slot == 0 ? arms.r0 : arms.r1, arm);
        auto add = [&](int r, int j, const V8& v) { out.add(below ? r : j, below ? j : r, v); };
        for (int r = 0; r < 3; ++r) {
            add(r, r, sign);
            for (int j = 0; j < 3; ++j)
                if (j != r) add(r, 3 + j, sign * arm[r][j]);
        }
        return;
    }
    for (int r = 0; r < op.rows; ++r) {
        V8 row[kLanes];
        load_lanes(view.jacobian + r * op.width + (below ? op.to_b : 0), op.from, row);
        for (int j = 0; j < dof; ++j) out.add(below ? r : j, below ? j : r, on * row[j]);
    }
}

}  // namespace

void gather_lane_blocks(const View& view, const LaneOp* ops, std::int64_t begin, std::int64_t end,
                        double* panel) noexcept {
    for (std::int64_t k = begin; k < end; ++k) {
        const LaneOp& op = ops[k];
        const LaneTarget out{panel + op.address, op.step};
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
            default:
                kept(view, op, out);
                break;
        }
    }
}

}  // namespace hawser::HAWSER_ISA
