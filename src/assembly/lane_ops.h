// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lane_ops.h
/// Ops of several lanes of one batch step become one.

#include "assembly/view.h"
#include "base/memory.h"
#include "factor/batches.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::assembly {

/// An op on its way into the list. Members are words: what is written byte by byte and read as a
/// whole, or the other way round, waits for the stores.
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

/// Collects the ops of one batch step after the other, column by column. A used one needs no
/// memory.
class LaneSharer {
  public:
    /// @param panel  Where the panel of the step begins. @param done  Lane ops of the steps before.
    void begin(std::int64_t panel, std::size_t done) noexcept;
    /// One more of the step. @param rows  Of its interaction. @param from  Offset of what it reads.
    /// @param step  Distance of rows. @throws std::bad_alloc.
    void add(const OpParts& op, std::int64_t address, std::int32_t step, int rows,
             std::int32_t from, base::Array<LaneOp>& lane_ops);
    /// What several lanes do is behind `done` in `lane_ops`; what only one does goes to `ops`.
    /// @throws std::bad_alloc.
    void end(base::Array<LaneOp>& lane_ops, base::Array<Op>& ops);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// What finds the lane op that an op belongs to.
    struct Key {
        std::int64_t address;
        std::uint64_t what;
        std::int32_t to_b;
        std::uint32_t used;
        std::uint32_t latest;  ///< Lane that came last.
        std::int32_t a;        ///< Slot of the first one.
        std::int32_t again;    ///< 1: the same was there before, but not free in the lane.
    };
    [[nodiscard]] std::size_t find(Key& key, std::size_t lane) const noexcept;

    std::int64_t panel_ = 0;
    std::size_t done_ = 0;
    std::size_t next_[factor::kLaneCount] = {};  ///< By lane: behind the one of the op before.
    std::vector<Key> keys_;                      ///< Of the lane ops of the step.
    std::vector<Op> first_;                      ///< The first op of each.
};

}  // namespace hawser::assembly
