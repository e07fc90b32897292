// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lane_ops.h
/// Merges ops of several lanes of one batch step.

#include "assembly/view.h"
#include "base/memory.h"
#include "factor/batches.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::assembly {

/// An op before it is added to the list. Members are words: byte-wise writes before a read of the
/// whole, or the reverse, would wait for the stores.
struct OpParts {
    std::int32_t id;
    Op::Kind kind;
    int a, b;
    std::int32_t jac_a, jac_b;
    int dof_a, dof_b, width;

    void write(Op& op, std::int64_t address, std::int32_t step, std::int32_t ld) const noexcept {
        op.address = address;
        op.step = step;
        op.ld = ld;
        op.id = id;
        op.jac_a = jac_a;
        op.jac_b = jac_b;
        op.kind = kind;
        op.a = static_cast<std::uint8_t>(a);
        op.b = static_cast<std::uint8_t>(b);
        op.dof_a = static_cast<std::uint8_t>(dof_a);
        op.dof_b = static_cast<std::uint8_t>(dof_b);
        op.width = static_cast<std::uint8_t>(width);
    }
};

/// Collects the ops of one batch step at a time, column by column. After the first use it allocates
/// nothing.
class LaneSharer {
  public:
    /// Begin a step. @param panel  Begin of the panel of the step. @param done  Number of lane ops
    /// of earlier steps.
    void begin(std::int64_t panel, std::size_t done) noexcept;
    /// Add an op of the step. @param rows  Rows of its interaction. @param from  Offset of its
    /// input. @param step  Distance of rows. @throws std::bad_alloc.
    void add(const OpParts& op, std::int64_t address, std::int32_t step, int rows,
             std::int32_t from, base::Array<LaneOp>& lane_ops);
    /// End a step. Ops that fill several lanes stay in `lane_ops`, after the lane ops of earlier
    /// steps. Ops of a single lane move to `ops`. @throws std::bad_alloc.
    void end(base::Array<LaneOp>& lane_ops, base::Array<Op>& ops);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Key of the lane op that an op belongs to.
    struct Key {
        std::int64_t address;
        std::uint64_t what;
        std::int32_t to_b;
        std::uint32_t used;
        std::uint32_t latest;  ///< Latest lane.
        std::int32_t a;        ///< Slot a of the first op.
        std::int32_t again;    ///< 1: the same op exists, but its lane was occupied.
    };
    [[nodiscard]] std::size_t find(Key& key, std::size_t lane) const noexcept;

    std::int64_t panel_ = 0;
    std::size_t done_ = 0;
    /// By lane: index after the entry of the previous op.
    std::size_t next_[factor::kLaneCount] = {};
    std::vector<Key> keys_;  ///< Keys of the lane ops of the step.
    std::vector<Op> first_;  ///< First op of each key.
};

}  // namespace hawser::assembly
