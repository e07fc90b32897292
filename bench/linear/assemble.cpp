// SPDX-License-Identifier: Apache-2.0
#include "index.h"
#include "linear/form.h"
#include "linear/kernels.h"
#include "linear/pieces.h"

#include <algorithm>

namespace hawser::bench {
namespace {

struct AssembleView {
    const double* values;
    const double* inverse;
    const Contribution* contributions;
    double* target;
};

/// Add contributions [k, k + count) of Rows rows each to a block of `rows` rows.
template <int Rows, int Columns, class V>
HAWSER_BENCH_INLINE void add_rows(const BlockWrite& op, const AssembleView& v, int rows,
                                  std::int32_t& k, V (&sum)[Columns]) {
    for (const std::int32_t end = k + op.count[Rows - 1]; k < end; ++k) {
        const Contribution& t = v.contributions[k];
        const double *row = v.values + t.g[op.turned], *col = v.values + t.g[!op.turned];
        HAWSER_BENCH_UNROLL
        for (int r = 0; r < Rows; ++r) {
            V g;
            load(g, row + r * rows);
            g *= v.inverse[t.sigma + r];
            HAWSER_BENCH_UNROLL
            for (int c = 0; c < Columns; ++c) sum[c] += g * col[r * Columns + c];
        }
    }
}

/// Write one block. @tparam Rows  Number of rows of the block; 0: not known at compile time.
/// @tparam V  Vector with at least as many lanes.
template <int Rows, int Columns, class V>
HAWSER_BENCH_INLINE void run(const BlockWrite& op, const AssembleView& v) {
    V sum[Columns] = {};
    const int rows = Rows > 0 ? Rows : op.row_size;
    if (op.base < 0) {
        // Start from zero.
    } else if (!op.by_rows) {
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) load(sum[c], v.values + op.base + c * rows);
    } else if constexpr (Rows == 1) {  // a single row: one number per column
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) sum[c] = V4{v.values[op.base + c], 0.0, 0.0, 0.0};
    } else if constexpr (Rows == 3) {  // by entries: a vector load after stores of entries is late
        const double* from = v.values + op.base;
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c)
            sum[c] = V4{from[c], from[Columns + c], from[2 * Columns + c], 0.0};
    } else {
        double turned[Columns][8] = {};  // a vector with a lane written by index is in memory
        for (int i = 0; i < rows; ++i) HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) turned[c][i] = v.values[op.base + i * Columns + c];
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) load(sum[c], turned[c]);
    }
    std::int32_t k = op.begin;
    add_rows<1>(op, v, rows, k, sum);
    add_rows<2>(op, v, rows, k, sum);
    add_rows<3>(op, v, rows, k, sum);
    double* to = v.target + op.to;
    // The upper triangle of a diagonal block among longer columns may be written too.
    const bool diagonal = op.diagonal, close = op.step == 1 && !(diagonal && op.shrink);
    HAWSER_BENCH_UNROLL
    for (int c = 0; c < Columns; ++c) {
        if (Rows > 0 && close) {
            store<Rows>(to, sum[c]);
        } else {
            double column[8];
            std::memcpy(column, &sum[c], sizeof(V));
            for (int i = diagonal ? c : 0; i < rows; ++i) to[i * op.step] = column[i];
        }
        to += op.stride - (op.shrink ? c : 0);
    }
}

HAWSER_BENCH_INLINE void run_any(const BlockWrite& op, const AssembleView& v) {
    switch (op.col_size) {
        case 1:
            run<0, 1, V8>(op, v);
            break;
        case 2:
            run<0, 2, V8>(op, v);
            break;
        case 3:
            run<0, 3, V8>(op, v);
            break;
        case 4:
            run<0, 4, V8>(op, v);
            break;
        case 5:
            run<0, 5, V8>(op, v);
            break;
        default:
            run<0, 6, V8>(op, v);
            break;
    }
}

// Blocks are in the sequence of the target, their contributions in that of the system.
constexpr std::int64_t kFar = 12, kNear = 4;  // blocks ahead

HAWSER_BENCH_INLINE void fetch_tables(const BlockWrite& op, const AssembleView& v) {
    __builtin_prefetch(v.contributions + op.begin);
    __builtin_prefetch(v.contributions + op.begin + 5);
    if (op.base >= 0) fetch(v.values + op.base, 1);
}

/// Prefetch for diagonal blocks, which come first and read all data of the others.
HAWSER_BENCH_INLINE void fetch_values(const BlockWrite& op, const AssembleView& v) {
    constexpr int kMaximum = 16;  // blocks with more contributions take long anyway
    const int count = op.count[0] + op.count[1] + op.count[2];
    if (!op.diagonal || count >= kMaximum) return;
    const int lines = op.row_size > 3 ? 3 : 2;
    for (int i = 0; i < count; ++i) fetch(v.values + v.contributions[op.begin + i].g[0], lines);
}

HAWSER_BENCH_CLONES void run_ops(const BlockWrite* ops, std::int64_t count, const AssembleView& v) {
    for (std::int64_t k = 0; k < count; ++k) {
        const BlockWrite& op = ops[k];
        if (k + kFar < count) fetch_tables(ops[k + kFar], v);
        if (k + kNear < count) fetch_values(ops[k + kNear], v);
        switch (op.row_size * 8 + op.col_size) {
            case 1 * 8 + 1:
                run<1, 1, V4>(op, v);
                break;
            case 1 * 8 + 3:
                run<1, 3, V4>(op, v);
                break;
            case 3 * 8 + 1:
                run<3, 1, V4>(op, v);
                break;
            case 1 * 8 + 6:
                run<1, 6, V4>(op, v);
                break;
            case 6 * 8 + 1:
                run<6, 1, V8>(op, v);
                break;
            case 3 * 8 + 3:
                run<3, 3, V4>(op, v);
                break;
            case 3 * 8 + 6:
                run<3, 6, V4>(op, v);
                break;
            case 6 * 8 + 3:
                run<6, 3, V8>(op, v);
                break;
            case 6 * 8 + 6:
                run<6, 6, V8>(op, v);
                break;
            default:
                run_any(op, v);
        }
    }
}

/// Invert rows. @param asked  Rows to prefetch: all, or none.
HAWSER_BENCH_CLONES void invert_rows(const SweepTables::Row* rows, std::int64_t count,
                                     std::int64_t asked, const double* values, double* inverse) {
    constexpr std::int64_t kAhead = 16;
    for (std::int64_t k = 0; k < count; ++k) {
        const SweepTables::Row& row = rows[k];
        if (k + kAhead < asked) fetch(values + rows[k + kAhead].sigma, 1);
        for (int i = 0; i < row.rows; ++i)
            inverse[row.scalar + i] = -1.0 / values[row.sigma + i * (row.rows + 1)];
    }
}

}  // namespace

void invert_sigma(const BlockSystem& s, const BlockForm& f, std::vector<double>& inverse,
                  base::Executor& executor) {
    if (!f.condensed) return;
    const SweepTables::Row* rows = f.tables.rows.data();
    in_pieces(static_cast<std::int64_t>(f.tables.rows.size()), executor,
              [&](std::int64_t begin, std::int64_t end) {
                  const bool distant = s.values.size() > kNearScattered;
                  invert_rows(rows + begin, end - begin, distant ? end - begin : 0, s.values.data(),
                              inverse.data());
              });
}

void assemble(const BlockSystem& system, std::span<const BlockWrite> ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target) noexcept {
    const AssembleView view{system.values.data(), inverse.data(), contributions.data(), target};
    run_ops(ops.data(), static_cast<std::int64_t>(ops.size()), view);
}

void assemble(const BlockSystem& system, const std::vector<BlockWrite>& ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target, base::Executor& executor) {
    in_pieces(static_cast<std::int64_t>(ops.size()), executor,
              [&](std::int64_t begin, std::int64_t end) {
                  assemble(system, std::span(ops).subspan(at(begin), at(end - begin)),
                           contributions, inverse, target);
              });
}

}  // namespace hawser::bench
