// SPDX-License-Identifier: Apache-2.0
/// A factor in float, refined in double against K as it was given; double itself where that does
/// not do (factor/residual.h, Precision in hawser/factor.h).
#include "base/index.h"
#include "factor/residual.h"
#include "world/block_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {
namespace {

constexpr int kMostRefinements = 10;
/// Fallbacks in a row after which float is no longer tried.
constexpr int kMostFailed = 3;
/// Powers of two that the scale of a changed diagonal may be off. Its square is what entries are
/// off by, which is little in the range of floats.
constexpr int kOffScale = 8;
constexpr double kTolerance = BlockFactor::kMixedTolerance;

/// Call one(v) for each of so many nodes.
template <class One>
void for_nodes(std::size_t count, base::Executor& executor, One&& one) noexcept {
    constexpr int kNodes = 512;
    auto some = [&](int task, int) noexcept {
        const std::size_t begin = at(task) * kNodes, end = std::min(begin + kNodes, count);
        for (std::size_t v = begin; v < end; ++v) one(v);
    };
    executor.for_each(base::chunks(count, kNodes), some);
}

/// The largest of some numbers; a number that is not finite if there is one.
template <class Value>
double largest(std::size_t count, Value&& value) {
    double most = 0.0, unfit = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double v = std::abs(value(i));
        most = std::max(most, v);
        unfit += v - v;
    }
    return most + unfit;
}

}  // namespace

void BlockFactor::Impl::Mixed::reserve(const factor::Symbolic& s, int threads) {
    numeric.reserve(s, threads);
    const std::size_t n = at(s.scalars) + 8;
    for (base::Array<double>* vector : {&scale, &x, &b, &rest}) vector->assign(n, 0.0);
    permuted.assign(n, 0.0F);
    single = false;
    refinements = 0;
}

std::size_t BlockFactor::Impl::Mixed::bytes() const noexcept {
    return numeric.bytes() + residual.bytes() + base::bytes(scalars) + base::bytes(scale) +
           base::bytes(x) + base::bytes(b) + base::bytes(rest) + base::bytes(permuted);
}

bool BlockFactor::Impl::worth_trying() const noexcept { return mixed->failed < kMostFailed; }

/// @return whether all pivots are right.
bool BlockFactor::Impl::factor_single() noexcept {
    Mixed& m = *mixed;
    const factor::Symbolic& s = analysis.symbolic();
    m.residual.find_scale(m.scale.data(), pool);
    m.numeric.clear(s, pool);
    copy_all([&](std::size_t k) noexcept { copy_scaled(k); });
    m.single = m.numeric.factor(s, pool) == 0;
    if (!m.single) return false;
    wrong = 0;
    factored = true;
    return true;
}

/// Of the parts in `dirty`. Powers of two do not change a bit, so the scale of the last whole
/// factorisation still does.
bool BlockFactor::Impl::refactor_single(std::span<const double> values,
                                        std::span<const std::int32_t> changed) noexcept {
    Mixed& m = *mixed;
    const factor::Symbolic& s = analysis.symbolic();
    int off = 0;
    for (const std::int32_t block : changed) {
        m.residual.keep(values, block);
        if (at(block) < pattern.size.size())
            off = std::max(off, m.residual.off_scale(m.scale.data(), block));
    }
    if (off > kOffScale) {
        part_flops = s.flops;
        return factor_single();
    }
    m.numeric.clear(s, dirty, pool);
    auto copy = [&](std::size_t k) noexcept { copy_scaled(k); };
    copy_groups(dirty.fronts, 0, copy);
    copy_groups(dirty.batches, static_cast<std::int32_t>(s.fronts.size()), copy);
    m.single = m.numeric.refactor(s, dirty, pool) == 0;
    return m.single;
}

/// In double, the values that were kept. @return as factor().
Status BlockFactor::Impl::fall_back() noexcept {
    Mixed& m = *mixed;
    m.single = false;
    ++m.fallbacks;
    ++m.failed;
    return factor_full(m.residual.values().data());
}

/// x += S (S K S)⁻¹ S r, where the largest of S r is `most`.
void BlockFactor::Impl::add_correction(double most) noexcept {
    Mixed& m = *mixed;
    const factor::Symbolic& s = analysis.symbolic();
    // Floats hold a residual of any size if its largest entry is about one.
    const int exponent = std::clamp(std::ilogb(most), -1000, 1000);
    const double down = std::ldexp(1.0, -exponent), up = std::ldexp(1.0, exponent);
    for_nodes(pattern.size.size(), pool, [&](std::size_t v) noexcept {
        const double *from = m.rest.data() + scalar_begin[v],
                     *by = m.scale.data() + scalar_begin[v];
        float* to = m.permuted.data() + s.node_offset[v];
        for (int i = 0; i < pattern.size[v]; ++i)
            to[i] = static_cast<float>(from[i] * by[i] * down);
    });
    m.numeric.solve(s, m.permuted.data(), pool);
    for_nodes(pattern.size.size(), pool, [&](std::size_t v) noexcept {
        const float* from = m.permuted.data() + s.node_offset[v];
        const double* by = m.scale.data() + scalar_begin[v];
        double* to = m.x.data() + scalar_begin[v];
        for (int i = 0; i < pattern.size[v]; ++i) to[i] += from[i] * by[i] * up;
    });
}

/// K x = b from nothing, as long as each step takes at least half of the error.
/// @return whether the error went below the tolerance.
bool BlockFactor::Impl::refine_single(double most) noexcept {
    Mixed& m = *mixed;
    std::fill(m.x.begin(), m.x.end(), 0.0);
    std::copy(m.b.begin(), m.b.end(), m.rest.begin());
    const double load = most;
    double last = HUGE_VAL;
    for (int step = 0;; ++step) {
        add_correction(most);
        // A loose scalar next to none has a large scale, and so a large scaled load: what it does
        // to the solution tells how large the others' rows are.
        const double reach = largest(at(analysis.symbolic().scalars),
                                     [&](std::size_t i) { return m.x[i] / m.scale[i]; });
        const double guard = std::max(std::numeric_limits<double>::min(),
                                      factor::BlockResidual::kLeast * std::min(load, reach));
        const factor::ResidualSize left =
            m.residual.run(m.scale.data(), m.x.data(), m.b.data(), guard, m.rest.data(), pool);
        m.refinements = step;
        if (left.error <= kTolerance) return true;
        // Not of what is no number.
        if (step == kMostRefinements || !(2.0 * left.error <= last)) return false;
        last = left.error;
        most = left.size;
    }
}

Status BlockFactor::Impl::solve_mixed(std::span<double> x) noexcept {
    Mixed& m = *mixed;
    std::copy(x.begin(), x.end(), m.b.begin());
    const double most = largest(x.size(), [&](std::size_t i) { return x[i] * m.scale[i]; });
    m.refinements = 0;
    const double unscaled = largest(x.size(), [&](std::size_t i) { return x[i]; });
    if (unscaled == 0.0 || !std::isfinite(unscaled)) {
        std::fill(x.begin(), x.end(), unscaled);
        return unscaled == 0.0 ? Status::ok : Status::not_finite;
    }
    // The scale may take what is finite, and not zero, out of the range of double.
    if (most != 0.0 && std::isfinite(most) && refine_single(most)) {
        m.failed = 0;
        std::copy_n(m.x.begin(), x.size(), x.begin());
        return Status::ok;
    }
    const Status status = fall_back();
    const Status solved = solve_full(x.data());
    return status == Status::ok ? solved : status;
}

}  // namespace hawser
