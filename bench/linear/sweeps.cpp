// SPDX-License-Identifier: Apache-2.0
#include "linear/sweeps.h"

#include "linear/kernels.h"
#include "linear/pieces.h"

#include <algorithm>

namespace hawser::bench {
namespace {

/// Ones in the first n of eight places.
constexpr double kMask[7][8] = {{0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0},
                                {1, 1, 0, 0, 0, 0, 0, 0}, {1, 1, 1, 0, 0, 0, 0, 0},
                                {1, 1, 1, 1, 0, 0, 0, 0}, {1, 1, 1, 1, 1, 0, 0, 0},
                                {1, 1, 1, 1, 1, 1, 0, 0}};

struct SweepView {
    const double* values;
    const std::int32_t *start, *adjacent, *offset;
    const std::int64_t *edge, *diagonal;
    const std::int8_t* size;
};

SweepView view_of(const BlockSystem& s) {
    return {s.values.data(), s.pattern.start.data(), s.pattern.adjacent.data(), s.offset.data(),
            s.edge.data(),   s.diagonal.data(),      s.pattern.size.data()};
}

/// A block stored by the rows of the own node: row i adds to sums[i], lane by lane.
HAWSER_BENCH_INLINE void add_by_rows(V8* sums, int rows, const double* block, int columns,
                                     const double* x) {
    V8 mask, v;
    load(mask, kMask[columns]);
    load(v, x);
    v *= mask;
    for (int i = 0; i < rows; ++i) {
        V8 b;
        load(b, block + i * columns);
        sums[i] += b * v;
    }
}

/// A block stored by the rows of the other node.
HAWSER_BENCH_INLINE void add_by_columns(V8& sum, int rows, const double* block, int columns,
                                        const double* x) {
    for (int j = 0; j < columns; ++j) {
        V8 b;
        load(b, block + j * rows);
        sum += b * x[j];
    }
}

HAWSER_BENCH_INLINE double total(const V8& v) {
    return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

/// Product of a node's block row with x, over the wanted neighbours and maybe the node itself.
template <bool Diagonal, class Wanted>
HAWSER_BENCH_INLINE void product(const SweepView& v, std::int64_t a, const double* x, double* y,
                                 Wanted wanted) {
    const int n = v.size[a];
    V8 rows[6] = {}, sum = {};
    if constexpr (Diagonal) add_by_columns(sum, n, v.values + v.diagonal[a], n, x + v.offset[a]);
    bool any = false;
    for (std::int32_t k = v.start[a]; k < v.start[a + 1]; ++k) {
        const std::int32_t b = v.adjacent[k];
        if (!wanted(b)) continue;
        if (b < a) {
            add_by_rows(rows, n, v.values + v.edge[k], v.size[b], x + v.offset[b]);
            any = true;
        } else {
            add_by_columns(sum, n, v.values + v.edge[k], v.size[b], x + v.offset[b]);
        }
    }
    for (int i = 0; i < n; ++i) y[i] = sum[i] + (any ? total(rows[i]) : 0.0);
}

HAWSER_BENCH_CLONES void residual_nodes(const SweepView& v, std::int64_t begin, std::int64_t end,
                                        const double* b, const double* x, double* r) {
    for (std::int64_t a = begin; a < end; ++a) {
        double y[8];
        product<true>(v, a, x, y, [](std::int32_t) { return true; });
        for (int i = 0; i < v.size[a]; ++i) r[v.offset[a] + i] = b[v.offset[a] + i] - y[i];
    }
}

HAWSER_BENCH_CLONES void fold_nodes(const SweepView& v, const std::int32_t* index,
                                    const std::int32_t* to, std::int64_t begin, std::int64_t end,
                                    const double* r, const double* scaled, double* folded) {
    for (std::int64_t a = begin; a < end; ++a) {
        if (index[a] < 0) continue;
        double y[8];
        product<false>(v, a, scaled, y, [&](std::int32_t e) { return index[e] < 0; });
        for (int i = 0; i < v.size[a]; ++i) folded[to[index[a]] + i] = r[v.offset[a] + i] + y[i];
    }
}

HAWSER_BENCH_CLONES void unfold_nodes(const SweepView& v, const std::int32_t* index,
                                      std::int64_t begin, std::int64_t end, const double* inverse,
                                      const double* r, double* x) {
    for (std::int64_t a = begin; a < end; ++a) {
        if (index[a] >= 0) continue;
        double y[8];
        product<false>(v, a, x, y, [](std::int32_t) { return true; });
        for (int i = v.offset[a]; i < v.offset[a + 1]; ++i)
            x[i] = inverse[i] * (y[i - v.offset[a]] - r[i]);
    }
}

}  // namespace

void residual(const BlockSystem& s, const std::vector<double>& b, const std::vector<double>& x,
              std::vector<double>& r, base::Executor& executor) {
    const SweepView v = view_of(s);
    in_pieces(s.pattern.nodes(), executor, [&](std::int64_t begin, std::int64_t end) {
        residual_nodes(v, begin, end, b.data(), x.data(), r.data());
    });
}

void fold(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
          const std::vector<double>& r, std::vector<double>& scratch, std::vector<double>& folded,
          base::Executor& executor) {
    const SweepView v = view_of(s);
    if (!f.condensed) {
        std::copy(r.begin(), r.end(), folded.begin());
        return;
    }
    // Scalars of kept nodes are scaled by what happens to be there and never read.
    in_pieces(s.scalars(), executor, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            scratch[static_cast<std::size_t>(i)] =
                inverse[static_cast<std::size_t>(i)] * r[static_cast<std::size_t>(i)];
    });
    in_pieces(s.pattern.nodes(), executor, [&](std::int64_t begin, std::int64_t end) {
        fold_nodes(v, f.index.data(), f.offset.data(), begin, end, r.data(), scratch.data(),
                   folded.data());
    });
}

void unfold(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
            const std::vector<double>& r, const std::vector<double>& solved, std::vector<double>& x,
            base::Executor& executor) {
    const SweepView v = view_of(s);
    if (!f.condensed) {
        std::copy(solved.begin(), solved.end(), x.begin());
        return;
    }
    for (std::size_t k = 0; k < f.kept.size(); ++k)
        std::copy(solved.begin() + f.offset[k], solved.begin() + f.offset[k + 1],
                  x.begin() + s.offset[static_cast<std::size_t>(f.kept[k])]);
    in_pieces(s.pattern.nodes(), executor, [&](std::int64_t begin, std::int64_t end) {
        unfold_nodes(v, f.index.data(), begin, end, inverse.data(), r.data(), x.data());
    });
}

}  // namespace hawser::bench
