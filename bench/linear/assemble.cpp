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

/// V: as many lanes as the block has rows, or more.
template <int Columns, class V>
HAWSER_BENCH_INLINE void run(const BlockOp& op, const AssembleView& v) {
    V sum[Columns];
    constexpr int kLikely = sizeof(V) == sizeof(V4) ? 3 : 6;
    const int rows = op.row_size;
    if (op.base < 0) {
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) sum[c] = V{};
    } else if (!op.by_rows) {
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) load(sum[c], v.values + op.base + c * rows);
    } else {
        double turned[Columns][8] = {};  // a vector with a lane written by number lives in memory
        for (int i = 0; i < rows; ++i) HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) turned[c][i] = v.values[op.base + i * Columns + c];
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) load(sum[c], turned[c]);
    }
    for (std::int32_t k = op.begin; k < op.end; ++k) {
        const Contribution& t = v.contributions[k];
        const double* col = v.values + t.g[!op.turned];
        V g;
        load(g, v.values + t.g[op.turned]);
        g *= v.inverse[t.sigma];
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) sum[c] += g * col[c];
    }
    double* to = v.target + op.to;
    // A diagonal block among longer columns may have its upper triangle written too.
    const bool diagonal = op.row == op.col, close = op.step == 1 && !(diagonal && op.shrink);
    HAWSER_BENCH_UNROLL
    for (int c = 0; c < Columns; ++c) {
        if (close && rows == kLikely) {
            store<kLikely>(to, sum[c]);
        } else {
            double column[8];
            std::memcpy(column, &sum[c], sizeof(V));
            for (int i = diagonal ? c : 0; i < rows; ++i) to[i * op.step] = column[i];
        }
        to += op.stride - (op.shrink ? c : 0);
    }
}

HAWSER_BENCH_CLONES void run_ops(const BlockOp* ops, std::int64_t count, const AssembleView& v) {
    for (std::int64_t k = 0; k < count; ++k) {
        const BlockOp& op = ops[k];
        const bool low = op.row_size <= 4;
        switch (op.col_size) {
            case 1:
                low ? run<1, V4>(op, v) : run<1, V8>(op, v);
                break;
            case 2:
                low ? run<2, V4>(op, v) : run<2, V8>(op, v);
                break;
            case 3:
                low ? run<3, V4>(op, v) : run<3, V8>(op, v);
                break;
            case 4:
                low ? run<4, V4>(op, v) : run<4, V8>(op, v);
                break;
            case 5:
                low ? run<5, V4>(op, v) : run<5, V8>(op, v);
                break;
            default:
                low ? run<6, V4>(op, v) : run<6, V8>(op, v);
                break;
        }
    }
}

HAWSER_BENCH_CLONES void invert_rows(const SweepTables::Row* rows, std::int64_t count,
                                     const double* values, double* inverse) {
    for (std::int64_t k = 0; k < count; ++k) {
        const SweepTables::Row& row = rows[k];
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
                  invert_rows(rows + begin, end - begin, s.values.data(), inverse.data());
              });
}

void assemble(const BlockSystem& system, std::span<const BlockOp> ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target) noexcept {
    const AssembleView view{system.values.data(), inverse.data(), contributions.data(), target};
    run_ops(ops.data(), static_cast<std::int64_t>(ops.size()), view);
}

void assemble(const BlockSystem& system, const std::vector<BlockOp>& ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target, base::Executor& executor) {
    in_pieces(static_cast<std::int64_t>(ops.size()), executor,
              [&](std::int64_t begin, std::int64_t end) {
                  assemble(system, std::span(ops).subspan(at(begin), at(end - begin)),
                           contributions, inverse, target);
              });
}

}  // namespace hawser::bench
