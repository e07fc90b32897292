// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lay_out_batches.h
/// From chains to batches (batches.h): grouping of chains and layout of their panels.

#include "factor/chains.h"
#include "factor/symbolic.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Lays out batches. A second run on chains of similar number and size allocates nothing.
class BatchBuilder {
  public:
    /// Group the chains to batches. Assign a step and a slot to every node, and place the panels
    /// behind the ordinary ones. `s` must have its fronts, rows and offsets. `front_of_chain` is
    /// the front of each chain.
    /// @throws std::bad_alloc.
    void run(const Pattern& pattern, const Chains& chains,
             const std::vector<std::int32_t>& front_of_chain, Symbolic& s);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// A boundary node of a chain, and the number of steps before the end at which it is first
    /// touched.
    struct SlotUse {
        std::int32_t node, size, steps;
    };
    /// A boundary slot shared by the lanes.
    struct Slot {
        std::int32_t size, steps, offset;
    };
    /// A chain with its sort key: shape, carried scalars, length.
    struct Alike {
        std::array<std::int32_t, 4> key;
        std::int32_t chain;
        friend auto operator<=>(const Alike&, const Alike&) = default;
    };
    /// Arguments of the current call.
    struct Job {
        const Pattern& pattern;
        const Chains& chains;
        const std::vector<std::int32_t>& front;  ///< By chain.
        Symbolic& s;
    };

    void find_touches(const Job& job);
    void sort_chains(const Chains& chains);
    void add_batch(const Job& job, std::span<const Alike> members);
    void find_row_slots(const Job& job, std::span<const Alike> members, std::int32_t steps);
    void assign_slots(std::span<const Alike> members);
    void assign_slot_offsets(Batch& batch);
    void add_step(const Job& job, Batch& batch, std::int32_t q, std::span<const std::int32_t> rows);
    void assign_lane(const Job& job, Batch& batch, int lane, std::int32_t chain);
    void assign_unit(const Job& job, Batch& batch, int lane, std::int32_t unit, std::int32_t step);
    [[nodiscard]] std::span<const SlotUse> touches(std::int32_t chain) const noexcept {
        const auto c = static_cast<std::size_t>(chain);
        return {touches_.data() + touch_begin_[c], touches_.data() + touch_begin_[c + 1]};
    }
    /// Return the sizes of the row nodes of a step of the current batch, ascending.
    [[nodiscard]] std::span<const std::int32_t> row_slots(std::int32_t step) const noexcept {
        const auto k = static_cast<std::size_t>(step);
        return {row_sizes_.data() + row_begin_[k], row_sizes_.data() + row_begin_[k + 1]};
    }

    std::vector<std::int32_t> chain_of_, touched_by_;  ///< By node.
    std::vector<std::int32_t> touch_begin_;            ///< By chain: its range of touches_.
    std::vector<SlotUse> touches_;
    std::vector<Alike> order_;
    // Data of the current batch.
    std::vector<std::int32_t> row_begin_, row_sizes_, sizes_, union_, merged_;
    std::vector<Slot> slots_;
    std::vector<std::int32_t> chosen_;  ///< Slots of the lanes' touches, lane after lane.
    std::size_t lane_begin_[kLaneCount + 1] = {};  ///< Start of each lane in chosen_.
    std::vector<std::int32_t> by_touch_;
    std::vector<std::uint8_t> slot_used_;
};

}  // namespace hawser::factor
