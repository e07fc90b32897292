// SPDX-License-Identifier: Apache-2.0
#include "linear/sweeps.h"

#include "linear/kernels.h"
#include "linear/pieces.h"

#include <algorithm>

namespace hawser::bench {
namespace {

struct SweepView {
    const double* values;
    const std::int32_t *start, *adjacent, *offset, *index, *to;
    const std::int64_t *edge, *diagonal;
    const std::int8_t* size;
    const double *inverse, *b;
    double *x, *r, *s, *folded;
};

SweepView view_of(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
                  SweepVectors& v) {
    return {s.values.data(),
            s.pattern.start.data(),
            s.pattern.adjacent.data(),
            s.offset.data(),
            f.index.data(),
            f.offset.data(),
            s.edge.data(),
            s.diagonal.data(),
            s.pattern.size.data(),
            inverse.data(),
            s.rhs.data(),
            v.x.data(),
            v.r.data(),
            v.s.data(),
            v.folded.data()};
}

/// Block row of a node times a vector, over all neighbours. N scalars.
template <int N>
HAWSER_BENCH_INLINE void product(const SweepView& v, std::int64_t a, const double* x, double* y) {
    V8 rows[N] = {}, sum = {};
    for (std::int32_t k = v.start[a]; k < v.start[a + 1]; ++k) {
        const std::int32_t b = v.adjacent[k];
        const int m = v.size[b];
        const double* block = v.values + v.edge[k];
        const double* xb = x + v.offset[b];
        if (b < a) {  // stored by rows of this node
            V8 mask, other;
            load(mask, kMask[m]);
            load(other, xb);
            other *= mask;
            HAWSER_BENCH_UNROLL
            for (int i = 0; i < N; ++i) {
                V8 g;
                load(g, block + i * m);
                rows[i] += g * other;
            }
        } else {
            for (int j = 0; j < m; ++j) {
                V8 g;
                load(g, block + j * N);
                sum += g * xb[j];
            }
        }
    }
    double out[8];
    std::memcpy(out, &sum, sizeof sum);
    HAWSER_BENCH_UNROLL
    for (int i = 0; i < N; ++i) y[i] = out[i] + total(rows[i]);
}

/// The same for nodes whose neighbours all come after them in number: what bodies have.
template <int N>
HAWSER_BENCH_INLINE void product_of_columns(const SweepView& v, std::int64_t a, const double* x,
                                            V8& sum) {
    for (std::int32_t k = v.start[a]; k < v.start[a + 1]; ++k) {
        const std::int32_t b = v.adjacent[k];
        if (v.index[b] >= 0) continue;
        const double* block = v.values + v.edge[k];
        const double* xb = x + v.offset[b];
        for (int j = 0; j < v.size[b]; ++j) {
            V8 g;
            load(g, block + j * N);
            sum += g * xb[j];
        }
    }
}

/// Diagonal block and neighbours that are kept.
template <int N>
HAWSER_BENCH_INLINE void product_of_kept(const SweepView& v, std::int64_t a, const double* x,
                                         V8& sum) {
    for (int j = 0; j < N; ++j) {
        V8 g;
        load(g, v.values + v.diagonal[a] + j * N);
        sum += g * x[v.offset[a] + j];
    }
    double other[8] = {};
    bool any = false;
    for (std::int32_t k = v.start[a]; k < v.start[a + 1]; ++k) {
        const std::int32_t b = v.adjacent[k];
        if (v.index[b] < 0) continue;
        const int m = v.size[b];
        const double* block = v.values + v.edge[k];
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < m; ++j)
                other[i] += (b < a ? block[i * m + j] : block[j * N + i]) * x[v.offset[b] + j];
        any = true;
    }
    if (!any) return;
    V8 more;
    load(more, other);
    sum += more;
}

template <int N>
HAWSER_BENCH_INLINE void fold_node(const SweepView& v, std::int64_t a, bool of_residual) {
    V8 sum;
    load(sum, v.b + v.offset[a]);
    if (of_residual) {
        V8 kept = {};
        product_of_kept<N>(v, a, v.x, kept);
        sum -= kept;
    }
    product_of_columns<N>(v, a, v.s, sum);
    store<N>(v.folded + v.to[v.index[a]], sum);
}

template <int N>
HAWSER_BENCH_INLINE void unfold_node(const SweepView& v, std::int64_t a) {
    double y[N];
    product<N>(v, a, v.x, y);
    for (int i = 0; i < N; ++i) {
        const std::int32_t k = v.offset[a] + i;
        const double lambda = v.inverse[k] * (y[i] - v.b[k]);
        const double r = v.b[k] - y[i] - v.values[v.diagonal[a] + i * (N + 1)] * lambda;
        v.x[k] = lambda;
        v.r[k] = r;
        v.s[k] = v.inverse[k] * r - lambda;
    }
}

/// The correction of the kept nodes is in s meanwhile.
template <int N>
HAWSER_BENCH_INLINE void correct_node(const SweepView& v, std::int64_t a) {
    double y[N];
    product<N>(v, a, v.s, y);
    for (int i = 0; i < N; ++i) {
        const std::int32_t k = v.offset[a] + i;
        v.x[k] += v.inverse[k] * (y[i] - v.r[k]);
    }
}

template <int N>
HAWSER_BENCH_INLINE void residual_node(const SweepView& v, std::int64_t a) {
    double y[N];
    product<N>(v, a, v.x, y);
    V8 own = {};
    for (int j = 0; j < N; ++j) {
        V8 g;
        load(g, v.values + v.diagonal[a] + j * N);
        own += g * v.x[v.offset[a] + j];
    }
    double d[8];
    std::memcpy(d, &own, sizeof own);
    for (int i = 0; i < N; ++i) {
        const std::int32_t k = v.offset[a] + i;
        v.folded[k] = v.b[k] - (y[i] + d[i]);
    }
}

#define HAWSER_BENCH_BY_SIZE(call) \
    switch (v.size[a]) {           \
        case 1:                    \
            call(1);               \
            break;                 \
        case 2:                    \
            call(2);               \
            break;                 \
        case 3:                    \
            call(3);               \
            break;                 \
        case 4:                    \
            call(4);               \
            break;                 \
        case 5:                    \
            call(5);               \
            break;                 \
        default:                   \
            call(6);               \
            break;                 \
    }

HAWSER_BENCH_CLONES void fold_nodes(const SweepView& v, std::int64_t begin, std::int64_t end,
                                    bool of_residual) {
#define HAWSER_BENCH_CALL(n) fold_node<n>(v, a, of_residual)
    for (std::int64_t a = begin; a < end; ++a)
        if (v.index[a] >= 0) HAWSER_BENCH_BY_SIZE(HAWSER_BENCH_CALL)
#undef HAWSER_BENCH_CALL
}

HAWSER_BENCH_CLONES void unfold_nodes(const SweepView& v, std::int64_t begin, std::int64_t end) {
#define HAWSER_BENCH_CALL(n) unfold_node<n>(v, a)
    for (std::int64_t a = begin; a < end; ++a)
        if (v.index[a] < 0) HAWSER_BENCH_BY_SIZE(HAWSER_BENCH_CALL)
#undef HAWSER_BENCH_CALL
}

HAWSER_BENCH_CLONES void correct_nodes(const SweepView& v, std::int64_t begin, std::int64_t end) {
#define HAWSER_BENCH_CALL(n) correct_node<n>(v, a)
    for (std::int64_t a = begin; a < end; ++a)
        if (v.index[a] < 0) HAWSER_BENCH_BY_SIZE(HAWSER_BENCH_CALL)
#undef HAWSER_BENCH_CALL
}

HAWSER_BENCH_CLONES void residual_nodes(const SweepView& v, std::int64_t begin, std::int64_t end) {
#define HAWSER_BENCH_CALL(n) residual_node<n>(v, a)
    for (std::int64_t a = begin; a < end; ++a) HAWSER_BENCH_BY_SIZE(HAWSER_BENCH_CALL)
#undef HAWSER_BENCH_CALL
}

/// Kept scalars of the form's vector to the places of the system's.
void spread(const BlockSystem& s, const BlockForm& f, const std::vector<double>& from,
            std::vector<double>& to) {
    for (std::size_t k = 0; k < f.kept.size(); ++k) {
        const std::int32_t at = s.offset[static_cast<std::size_t>(f.kept[k])];
        for (std::int32_t i = f.offset[k]; i < f.offset[k + 1]; ++i)
            to[static_cast<std::size_t>(at + i - f.offset[k])] = from[static_cast<std::size_t>(i)];
    }
}

}  // namespace

void SweepVectors::resize(const BlockSystem& system) {
    const auto n = static_cast<std::size_t>(system.scalars()) + 8;
    for (auto* v : {&x, &r, &s, &folded}) v->assign(n, 0.0);
}

void fold(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
          SweepVectors& vectors, base::Executor& executor) {
    if (!f.condensed) {
        std::copy(s.rhs.begin(), s.rhs.end(), vectors.folded.begin());
        return;
    }
    const SweepView v = view_of(s, f, inverse, vectors);
    // Scalars of kept nodes are scaled by what happens to be there and never read.
    in_pieces(s.scalars(), executor, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) v.s[i] = v.inverse[i] * v.b[i];
    });
    in_pieces(s.pattern.nodes(), executor,
              [&](std::int64_t begin, std::int64_t end) { fold_nodes(v, begin, end, false); });
}

void unfold(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
            SweepVectors& vectors, base::Executor& executor) {
    if (!f.condensed) {
        std::copy(vectors.folded.begin(), vectors.folded.end(), vectors.x.begin());
        return;
    }
    spread(s, f, vectors.folded, vectors.x);
    const SweepView v = view_of(s, f, inverse, vectors);
    in_pieces(s.pattern.nodes(), executor,
              [&](std::int64_t begin, std::int64_t end) { unfold_nodes(v, begin, end); });
}

void fold_residual(const BlockSystem& s, const BlockForm& f, SweepVectors& vectors,
                   base::Executor& executor) {
    static const std::vector<double> none;
    const SweepView v = view_of(s, f, none, vectors);
    in_pieces(s.pattern.nodes(), executor, [&](std::int64_t begin, std::int64_t end) {
        if (f.condensed)
            fold_nodes(v, begin, end, true);
        else
            residual_nodes(v, begin, end);
    });
}

void add_correction(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
                    SweepVectors& vectors, base::Executor& executor) {
    const SweepView v = view_of(s, f, inverse, vectors);
    if (!f.condensed) {
        for (std::size_t i = 0; i < vectors.x.size(); ++i) vectors.x[i] += vectors.folded[i];
        return;
    }
    spread(s, f, vectors.folded, vectors.s);
    in_pieces(s.pattern.nodes(), executor,
              [&](std::int64_t begin, std::int64_t end) { correct_nodes(v, begin, end); });
    for (std::size_t k = 0; k < f.kept.size(); ++k)
        for (int i = 0; i < f.pattern.size[k]; ++i)
            v.x[s.offset[static_cast<std::size_t>(f.kept[k])] + i] += v.folded[f.offset[k] + i];
}

}  // namespace hawser::bench
