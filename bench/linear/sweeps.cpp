// SPDX-License-Identifier: Apache-2.0
#include "linear/sweeps.h"

#include "index.h"
#include "linear/kernels.h"
#include "linear/pieces.h"

#include <algorithm>
#include <type_traits>

namespace hawser::bench {
namespace {

struct SweepView {
    const double* values;
    const SweepTables::Row* rows;
    const SweepTables::RowTerm* row_terms;
    const SweepTables::Body* bodies;
    const SweepTables::Column* columns;
    const SweepTables::Other* others;
    const std::int32_t* row_to;
    const double *inverse, *b;
    double *x, *r, *s, *folded;
    std::int32_t asked;  ///< Number of columns to prefetch: all, or none.
    bool distant;        ///< True if the blocks are several times larger than a core's own cache.
};

SweepView make_sweep_view(const BlockSystem& s, const BlockForm& f,
                          const std::vector<double>& inverse, SweepVectors& v) {
    const SweepTables& t = f.tables;
    const std::size_t size = s.values.size();
    return {
        s.values.data(),    t.rows.data(),
        t.row_terms.data(), t.bodies.data(),
        t.columns.data(),   t.others.data(),
        t.row_to.data(),    inverse.data(),
        s.rhs.data(),       v.x.data(),
        v.r.data(),         v.s.data(),
        v.folded.data(),    size > kNearScattered ? static_cast<std::int32_t>(t.columns.size()) : 0,
        size > kNearSize};
}

/// Compute rows [first, first + 4) of G x, of the N rows of a row node.
template <int N, int kFirst>
HAWSER_BENCH_INLINE void row_product(const SweepView& v, std::int64_t e, const double* x, V4& y) {
    constexpr int kRows = N - kFirst < 4 ? N - kFirst : 4;
    V4 sum[4] = {};
    for (std::int32_t k = e > 0 ? v.rows[e - 1].end : 0; k < v.rows[e].end; ++k) {
        const SweepTables::RowTerm& t = v.row_terms[k];
        const double* from = x + t.scalar;
        if (t.size == 3) {
            const double* g = v.values + t.g + kFirst * 3;
            const V4 other = {from[0], from[1], from[2], 0.0};
            HAWSER_BENCH_UNROLL
            for (int i = 0; i < kRows; ++i) {
                V4 row;
                load(row, g + i * 3);
                sum[i] += row * other;
            }
            continue;
        }
        const double* g = v.values + t.g + kFirst * t.size;
        V8 mask, other;
        load(mask, kMask[t.size]);
        load(other, from);
        other *= mask;
        HAWSER_BENCH_UNROLL
        for (int i = 0; i < kRows; ++i) {
            V8 row;
            load(row, g + i * t.size);
            add_halves(sum[i], row * other);
        }
    }
    totals(y, sum);
}

enum class Sweep : std::uint8_t { unfold, correct, residual };

/// Prefetch a block of rows. Blocks are adjacent, but too short for the hardware prefetcher.
HAWSER_BENCH_INLINE void fetch_row(const SweepView& v, std::int64_t e) {
    constexpr int kAhead = 320, kLines = 5;  // doubles, at most, of a row node
    if (v.distant) fetch(v.values + v.rows[e].sigma + kAhead, kLines);
}

/// Condensed form: compute multipliers and residuals from the velocities, or corrections of the
/// multipliers from those of the velocities, which are stored in s. Saddle form: compute residuals.
template <Sweep kSweep, int N, int kFirst = 0>
HAWSER_BENCH_INLINE void sweep_row(const SweepView& v, std::int64_t e) {
    constexpr int kRows = N - kFirst < 4 ? N - kFirst : 4;
    const SweepTables::Row& row = v.rows[e];
    const std::int32_t k = row.scalar + kFirst;
    const double* diagonal = v.values + row.sigma + kFirst * (N + 1);
    V4 y, b, sigma = {};
    row_product<N, kFirst>(v, e, kSweep == Sweep::correct ? v.s : v.x, y);
    load(b, v.b + k);
    if constexpr (kSweep != Sweep::correct) {
        double entry[4] = {};
        HAWSER_BENCH_UNROLL
        for (int i = 0; i < kRows; ++i) entry[i] = diagonal[i * (N + 1)];
        load(sigma, entry);
    }
    if constexpr (kSweep == Sweep::residual) {
        V4 x;
        load(x, v.x + k);
        store<kRows>(v.folded + v.row_to[e] + kFirst, b - y - sigma * x);
        store<kRows>(v.s + k, -x);
    } else {
        V4 inverse;
        load(inverse, v.inverse + k);
        if constexpr (kSweep == Sweep::unfold) {
            const V4 lambda = inverse * (y - b), r = b - y - sigma * lambda;
            store<kRows>(v.x + k, lambda);
            store<kRows>(v.r + k, r);
            store<kRows>(v.s + k, inverse * r - lambda);
        } else {
            V4 x, r;
            load(x, v.x + k);
            load(r, v.r + k);
            store<kRows>(v.x + k, x + inverse * (y - r));
        }
    }
    if constexpr (N - kFirst > 4) sweep_row<kSweep, N, kFirst + 4>(v, e);
}

/// Compute A x of one body of N scalars: its own block and those of other bodies.
template <int N, class V>
HAWSER_BENCH_INLINE void body_product(const SweepView& v, std::int64_t a, const double* x, V& sum) {
    const SweepTables::Body& body = v.bodies[a];
    for (int j = 0; j < N; ++j) {
        V g;
        load(g, v.values + body.diagonal + j * N);
        sum += g * x[body.scalar + j];
    }
    const std::int32_t begin = a > 0 ? v.bodies[a - 1].other_end : 0;
    if (begin == body.other_end) return;
    double other[8] = {};
    for (std::int32_t k = begin; k < body.other_end; ++k) {
        const SweepTables::Other& t = v.others[k];
        const double* block = v.values + t.block;
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < t.size; ++j)
                other[i] +=
                    (t.by_rows ? block[i * t.size + j] : block[j * N + i]) * x[t.scalar + j];
    }
    V more;
    load(more, other);
    sum += more;
}

/// Compute b + Gᵀ s, minus A x for a residual.
template <bool kResidual, int N>
HAWSER_BENCH_INLINE void sweep_body(const SweepView& v, std::int64_t a) {
    const SweepTables::Body& body = v.bodies[a];
    using V = std::conditional_t<(N <= 4), V4, V8>;
    V sum, odd = {};
    load(sum, v.b + body.scalar);
    if constexpr (kResidual) {
        V kept = {};
        body_product<N>(v, a, v.x, kept);
        sum -= kept;
    }
    std::int32_t k = a > 0 ? v.bodies[a - 1].end : 0;
    constexpr std::int32_t kAhead = 24;
    for (std::int32_t j = k + kAhead; j < std::min(body.end + kAhead, v.asked); ++j)
        fetch(v.values + v.columns[j].g, 1);
    for (; k + 1 < body.end; k += 2) {  // two chains of sums
        V g, h;
        load(g, v.values + v.columns[k].g);
        load(h, v.values + v.columns[k + 1].g);
        sum += g * v.s[v.columns[k].scalar];
        odd += h * v.s[v.columns[k + 1].scalar];
    }
    if (k < body.end) {
        V g;
        load(g, v.values + v.columns[k].g);
        sum += g * v.s[v.columns[k].scalar];
    }
    sum += odd;
    store<N>(v.folded + body.to, sum);
}

#define HAWSER_BENCH_BY_SIZE(n, call) \
    switch (n) {                      \
        case 1:                       \
            call(1);                  \
            break;                    \
        case 2:                       \
            call(2);                  \
            break;                    \
        case 3:                       \
            call(3);                  \
            break;                    \
        case 4:                       \
            call(4);                  \
            break;                    \
        case 5:                       \
            call(5);                  \
            break;                    \
        default:                      \
            call(6);                  \
            break;                    \
    }

HAWSER_BENCH_CLONES void sweep_rows(const SweepView& v, std::int64_t begin, std::int64_t end,
                                    Sweep sweep) {
#define HAWSER_BENCH_UNFOLD(n) sweep_row<Sweep::unfold, n>(v, e)
#define HAWSER_BENCH_CORRECT(n) sweep_row<Sweep::correct, n>(v, e)
#define HAWSER_BENCH_RESIDUAL(n) sweep_row<Sweep::residual, n>(v, e)
    if (sweep == Sweep::unfold)
        for (std::int64_t e = begin; e < end; ++e) {
            fetch_row(v, e);
            HAWSER_BENCH_BY_SIZE(v.rows[e].rows, HAWSER_BENCH_UNFOLD)
        }
    else if (sweep == Sweep::correct)
        for (std::int64_t e = begin; e < end; ++e) {
            fetch_row(v, e);
            HAWSER_BENCH_BY_SIZE(v.rows[e].rows, HAWSER_BENCH_CORRECT)
        }
    else
        for (std::int64_t e = begin; e < end; ++e) {
            fetch_row(v, e);
            HAWSER_BENCH_BY_SIZE(v.rows[e].rows, HAWSER_BENCH_RESIDUAL)
        }
#undef HAWSER_BENCH_UNFOLD
#undef HAWSER_BENCH_CORRECT
#undef HAWSER_BENCH_RESIDUAL
}

HAWSER_BENCH_CLONES void sweep_bodies(const SweepView& v, std::int64_t begin, std::int64_t end,
                                      bool of_residual) {
#define HAWSER_BENCH_FOLD(n) sweep_body<false, n>(v, a)
#define HAWSER_BENCH_RESIDUAL(n) sweep_body<true, n>(v, a)
    if (of_residual)
        for (std::int64_t a = begin; a < end; ++a)
            HAWSER_BENCH_BY_SIZE(v.bodies[a].size, HAWSER_BENCH_RESIDUAL)
    else
        for (std::int64_t a = begin; a < end; ++a)
            HAWSER_BENCH_BY_SIZE(v.bodies[a].size, HAWSER_BENCH_FOLD)
#undef HAWSER_BENCH_FOLD
#undef HAWSER_BENCH_RESIDUAL
}

HAWSER_BENCH_CLONES void scale(const double* a, const double* b, double* to, std::int64_t begin,
                               std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) to[i] = a[i] * b[i];
}

void all_rows(const BlockForm& f, const SweepView& v, Sweep sweep, base::Executor& executor) {
    in_pieces(static_cast<std::int64_t>(f.tables.rows.size()), executor,
              [&](std::int64_t begin, std::int64_t end) { sweep_rows(v, begin, end, sweep); });
}

void all_bodies(const BlockForm& f, const SweepView& v, bool residual, base::Executor& executor) {
    in_pieces(static_cast<std::int64_t>(f.tables.bodies.size()), executor,
              [&](std::int64_t begin, std::int64_t end) { sweep_bodies(v, begin, end, residual); });
}

/// Call work(scalar in the system, scalar in the form) for all scalars of the bodies.
template <class F>
void all_scalars(const BlockForm& f, base::Executor& executor, F work) {
    constexpr std::int64_t kMinimum = 1024;
    in_pieces(
        std::ssize(f.tables.bodies), executor,
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t a = begin; a < end; ++a) {
                const SweepTables::Body& body = f.tables.bodies[at(a)];
                for (std::int32_t i = 0; i < body.size; ++i)
                    work(at(body.scalar + i), at(body.to + i));
            }
        },
        kMinimum);
}

/// Scatter the scalars of the bodies from the form's vector to the system's.
void spread(const BlockForm& f, const std::vector<double>& from, std::vector<double>& to,
            base::Executor& executor) {
    all_scalars(f, executor, [&](std::size_t k, std::size_t i) { to[k] = from[i]; });
}

}  // namespace

void SweepVectors::resize(const BlockSystem& system) {
    const auto n = static_cast<std::size_t>(system.scalars()) + 8;
    for (auto* v : {&x, &r, &s, &folded}) v->assign(n, 0.0);
}

void fold_right_side(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
                     SweepVectors& vectors, base::Executor& executor) {
    if (!f.condensed) {
        std::copy(s.rhs.begin(), s.rhs.begin() + s.scalars(), vectors.folded.begin());
        return;
    }
    const SweepView v = make_sweep_view(s, f, inverse, vectors);
    // Scalars of bodies are multiplied by unset values, which are never read.
    in_pieces(s.scalars(), executor, [&](std::int64_t begin, std::int64_t end) {
        scale(v.inverse, v.b, v.s, begin, end);
    });
    all_bodies(f, v, false, executor);
}

void unfold_solution(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
                     SweepVectors& vectors, base::Executor& executor) {
    if (!f.condensed) {
        std::copy(vectors.folded.begin(), vectors.folded.end(), vectors.x.begin());
        return;
    }
    spread(f, vectors.folded, vectors.x, executor);
    all_rows(f, make_sweep_view(s, f, inverse, vectors), Sweep::unfold, executor);
}

void fold_residual(const BlockSystem& s, const BlockForm& f, SweepVectors& vectors,
                   base::Executor& executor) {
    static const std::vector<double> none;
    const SweepView v = make_sweep_view(s, f, none, vectors);
    if (!f.condensed) all_rows(f, v, Sweep::residual, executor);
    all_bodies(f, v, true, executor);
}

void add_correction(const BlockSystem& s, const BlockForm& f, const std::vector<double>& inverse,
                    SweepVectors& vectors, base::Executor& executor) {
    if (!f.condensed) {
        for (std::size_t i = 0; i < vectors.x.size(); ++i) vectors.x[i] += vectors.folded[i];
        return;
    }
    const SweepView v = make_sweep_view(s, f, inverse, vectors);
    spread(f, vectors.folded, vectors.s, executor);
    all_rows(f, v, Sweep::correct, executor);
    all_scalars(f, executor, [&](std::size_t k, std::size_t i) { v.x[k] += v.folded[i]; });
}

}  // namespace hawser::bench
