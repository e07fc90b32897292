// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_factor.h
/// What stands behind hawser/factor.h: src/factor with places for the blocks of a public pattern.
///
/// With Precision::mixed there are two factorisations, one of S K S in float (Mixed), S a diagonal
/// of powers of two, and one of K in double, for where the first is not good enough. K itself is
/// kept, for residuals and for a factorisation that solve() asks for.

#include "base/index.h"
#include "base/memory.h"
#include "factor/numeric.h"
#include "factor/partial.h"
#include "factor/repair.h"
#include "factor/residual.h"
#include "runtime/tasks.h"

#include <hawser/factor.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hawser {

struct BlockFactor::Impl {
    /// Copies one block of values to its place; `group` is the front or batch that holds it.
    struct CopyOp {
        std::int64_t from = 0, to = 0;
        std::int32_t group = 0, step = 1, ld = 0;
        std::int8_t rows = 0, columns = 0;  ///< Of the block as it is given.
        bool diagonal = false;
    };

    /// What Precision::mixed adds.
    struct Mixed {
        /// First scalars of a block's nodes: where its rows and columns find their scale.
        struct Scalars {
            std::int32_t row = 0, column = 0;
        };
        factor::BasicNumeric<float> numeric;
        factor::BlockResidual residual;
        std::vector<Scalars> scalars;  ///< Of each of `ops`.
        // One a scalar, in the order of the nodes, and 8 more for vector loads: S, and the vectors
        // of a refinement.
        base::Array<double> scale, x, b, rest;
        base::Array<float> permuted;
        bool single = false;           ///< The factor in use is the one in float.
        int failed = 0;                ///< Fallbacks since the last solution by float.
        std::int64_t fallbacks = 0;    ///< Since the last analysis.
        std::int64_t refinements = 0;  ///< Of the last solution.

        void reserve(const factor::Symbolic& symbolic, int threads);
        [[nodiscard]] std::size_t bytes() const noexcept;
    };

    explicit Impl(const FactorOptions& o) : options(o), pool(std::max(1, o.threads)) {
        if (o.precision == Precision::mixed) mixed = std::make_unique<Mixed>();
        pool.pause();
        analysis.keep_updates(o.partial);
        analysis.use(&pool);
    }
    [[nodiscard]] bool single() const noexcept { return mixed && mixed->single; }

    void take(const BlockPattern& p);
    /// What float did for other matrices.
    void forget() noexcept {
        if (!mixed) return;
        mixed->failed = 0;
        mixed->fallbacks = 0;
    }
    void place();
    /// Call copy_one(k) for all of `ops`, or for those of groups `first` + each.
    template <class CopyOne>
    void copy_all(CopyOne&& copy_one) noexcept;
    template <class CopyOne>
    void copy_groups(std::span<const std::int32_t> groups, std::int32_t first,
                     CopyOne&& copy_one) noexcept;
    void copy(std::size_t k, const double* values) noexcept;
    void copy_scaled(std::size_t k) noexcept;

    // In double. Threads are awake in these and the following.
    [[nodiscard]] Status factor_full(const double* values) noexcept;
    [[nodiscard]] Status solve_full(double* x) noexcept;
    // In float, of the values that mixed.residual has.
    [[nodiscard]] bool worth_trying() const noexcept;
    [[nodiscard]] bool factor_single() noexcept;
    [[nodiscard]] bool refactor_single(std::span<const double> values,
                                       std::span<const std::int32_t> changed) noexcept;
    [[nodiscard]] Status solve_mixed(std::span<double> x) noexcept;
    [[nodiscard]] bool refine_single(double most) noexcept;
    void add_correction(double most) noexcept;
    [[nodiscard]] Status fall_back() noexcept;
    Status finish(int wrong) noexcept;

    /// Threads spin while this lives.
    class Awake {
      public:
        explicit Awake(runtime::Pool& pool) : pool_(pool) { pool_.resume(); }
        ~Awake() { pool_.pause(); }
        Awake(const Awake&) = delete;
        Awake& operator=(const Awake&) = delete;

      private:
        runtime::Pool& pool_;
    };

    FactorOptions options;
    runtime::Pool pool;
    factor::Analysis analysis;
    factor::Numeric numeric;
    std::unique_ptr<Mixed> mixed;  ///< Null: Precision::full.
    factor::DirtyParts dirty;
    factor::Pattern pattern;
    std::vector<BlockEdge> edges;
    std::vector<std::int64_t> value_begin, scalar_begin;
    std::vector<CopyOp> ops;                ///< Grouped: fronts, then batches.
    std::vector<std::int32_t> group_begin;  ///< Into ops.
    std::vector<std::int32_t> column_of;    ///< Of each block: the node whose column holds it.
    std::vector<std::int32_t> columns;      ///< Of changed blocks.
    std::vector<double> permuted, rest, row_sum;
    factor::RepairReport report;
    std::int64_t part_flops = 0;
    int wrong = 0;
    bool factored = false;  ///< Since the last analysis.
};

template <class CopyOne>
void BlockFactor::Impl::copy_all(CopyOne&& copy_one) noexcept {
    constexpr int kChunk = 256;
    auto fill = [&](int i, int) noexcept {
        const std::size_t begin = at(i) * kChunk, end = std::min(ops.size(), begin + kChunk);
        for (std::size_t k = begin; k < end; ++k) copy_one(k);
    };
    pool.for_each(base::chunks(ops.size(), kChunk), fill);
}

template <class CopyOne>
void BlockFactor::Impl::copy_groups(std::span<const std::int32_t> groups, std::int32_t first,
                                    CopyOne&& copy_one) noexcept {
    auto one = [&](int i, int) noexcept {
        const std::size_t g = at(first + groups[at(i)]);
        for (std::size_t k = at(group_begin[g]); k < at(group_begin[g + 1]); ++k) copy_one(k);
    };
    pool.for_each(static_cast<int>(groups.size()), one);
}

}  // namespace hawser
