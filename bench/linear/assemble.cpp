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

template <int Columns>
HAWSER_BENCH_INLINE void run(const BlockOp& op, const AssembleView& v) {
    V8 sum[Columns];
    const int rows = op.row_size;
    if (op.base < 0) {
        HAWSER_BENCH_UNROLL
        for (int c = 0; c < Columns; ++c) sum[c] = V8{};
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
        const double* row = v.values + t.row_g;
        const double* col = v.values + t.col_g;
        for (int r = 0; r < t.rows; ++r) {
            V8 g;
            load(g, row + r * rows);
            g *= v.inverse[t.sigma + r];
            HAWSER_BENCH_UNROLL
            for (int c = 0; c < Columns; ++c) sum[c] += g * col[r * Columns + c];
        }
    }
    double* to = v.target + op.to;
    const bool diagonal = op.row == op.col, close = op.step == 1 && !diagonal;
    HAWSER_BENCH_UNROLL
    for (int c = 0; c < Columns; ++c) {
        if (close && rows == 6) {
            store<6>(to, sum[c]);
        } else if (close && rows == 3) {
            store<3>(to, sum[c]);
        } else {
            double column[8];
            std::memcpy(column, &sum[c], sizeof column);
            for (int i = diagonal ? c : 0; i < rows; ++i) to[i * op.step] = column[i];
        }
        to += op.stride - (op.shrink ? c : 0);
    }
}

HAWSER_BENCH_CLONES void run_ops(const BlockOp* ops, std::int64_t count, const AssembleView& v) {
    for (std::int64_t k = 0; k < count; ++k) {
        const BlockOp& op = ops[k];
        switch (op.col_size) {
            case 1:
                run<1>(op, v);
                break;
            case 2:
                run<2>(op, v);
                break;
            case 3:
                run<3>(op, v);
                break;
            case 4:
                run<4>(op, v);
                break;
            case 5:
                run<5>(op, v);
                break;
            default:
                run<6>(op, v);
                break;
        }
    }
}

}  // namespace

void invert_sigma(const BlockSystem& s, const BlockForm& f, std::vector<double>& inverse,
                  base::Executor& executor) {
    if (!f.condensed) return;
    in_pieces(s.pattern.nodes(), executor, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t e = begin; e < end; ++e) {
            const auto node = static_cast<std::size_t>(e);
            if (f.index[node] >= 0) continue;
            const int n = s.size(static_cast<int>(e));
            for (int i = 0; i < n; ++i)
                inverse[at(s.offset[node] + i)] =
                    -1.0 /
                    s.values[static_cast<std::size_t>(s.diagonal[node]) +
                             static_cast<std::size_t>(i) * (static_cast<std::size_t>(n) + 1)];
        }
    });
}

void assemble(const BlockSystem& system, const std::vector<BlockOp>& ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target, base::Executor& executor) {
    const AssembleView view{system.values.data(), inverse.data(), contributions.data(), target};
    in_pieces(static_cast<std::int64_t>(ops.size()), executor,
              [&](std::int64_t begin, std::int64_t end) {
                  run_ops(ops.data() + begin, end - begin, view);
              });
}

}  // namespace hawser::bench
