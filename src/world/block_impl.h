// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_impl.h
/// Data of a BlockFactor.

#include "factor/numeric.h"
#include "factor/partial.h"
#include "factor/repair.h"
#include "runtime/tasks.h"

#include <hawser/factor.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser {

struct BlockFactor::Impl {
    /// Copies one block of values to its address. `holder` is the front or batch with its panel.
    struct CopyOp {
        std::int64_t from = 0, to = 0;
        std::int32_t holder = 0, step = 1, ld = 0;
        std::int8_t rows = 0, columns = 0;  ///< Size of the given block.
        bool diagonal = false;
    };

    explicit Impl(const FactorOptions& o) : options(o), pool(std::max(1, o.threads)) {
        pool.pause();
        analysis.separate_updates(o.partial);
        analysis.use(&pool);
    }

    void take(const BlockPattern& p);
    void assign_addresses();
    void copy(const CopyOp& op, const double* values) noexcept;
    void copy_holder_blocks(std::span<const std::int32_t> holders, std::int32_t first,
                            const double* values) noexcept;
    Status finish(int wrong) noexcept;

    /// Keeps the threads spinning while it lives.
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
    factor::DirtyParts dirty;
    factor::Pattern pattern;
    std::vector<BlockEdge> edges;
    std::vector<std::int64_t> value_begin, scalar_begin;
    std::vector<CopyOp> ops;                 ///< Grouped: fronts, then batches.
    std::vector<std::int32_t> holder_begin;  ///< Offsets into ops.
    std::vector<std::int32_t> column_of;     ///< Node whose column contains each block.
    std::vector<std::int32_t> columns;       ///< Columns of changed blocks.
    std::vector<double> permuted, rest, row_sum;
    factor::RepairReport report;
    std::int64_t part_flops = 0;
    int wrong = 0;
    bool factored = false;  ///< True if factored since the last analysis.
};

}  // namespace hawser
