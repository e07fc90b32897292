// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file op_history.h
/// Sources of the last list of contributions, so that the next list can reuse the unchanged part.
///
/// An edit, or a link of contacts, changes few columns. Most of the list is in batches
/// (factor/batches.h). Only their numbers change: offsets of panels, Jacobians and records, and
/// numbers of contact blocks. A batch is reused under three conditions:
///
/// 1. Its steps have the same sizes, and its columns the same nodes, lanes and slots.
/// 2. Rows behind the chains are in the same slots.
/// 3. None of its columns belongs to a body of a changed interaction or contact block. Changed
///    means added, removed, or with other bodies, freedoms or form.
///
/// Columns of ordinary fronts are few and always listed again.

#include "assembly/contacts.h"
#include "assembly/view.h"
#include "base/memory.h"
#include "factor/symbolic.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::assembly {

/// Sources of a list.
struct OpSources {
    const factor::Symbolic& symbolic;
    const model::Bodies& bodies;
    const model::Interactions& interactions;
    /// Columns by address in the panels: addresses, positions.
    std::span<const std::pair<std::int64_t, std::int32_t>> columns;
    std::span<const std::int32_t> member_of_node;  ///< Body or interaction.
    std::span<const std::int32_t> node_of_interaction;
    std::span<const std::uint8_t> dof, rests;
    std::span<const GeoSlot> geo;
    std::span<const ContactBlock> blocks;
};

class OpHistory {
  public:
    /// Compare the sources of a new list of ops (contributions to the matrix) with the stored
    /// sources, then store the new ones. Call done() when the list is complete; otherwise the next
    /// comparison finds no unchanged part. @throws std::bad_alloc.
    void follow(const OpSources& now);
    /// Mark the new list of ops as complete, so that the next follow() compares with it.
    void done() noexcept { has_list_ = true; }
    /// Discard the stored list. Call before the list is changed in place.
    void forget() noexcept { has_list_ = false; }
    /// Report that the list was changed, with the new numbers of contact blocks. @throws
    /// std::bad_alloc
    void renumber_blocks(std::span<const ContactBlock> blocks);
    /// Return the step of the last list that corresponds to a step of a batch; −1 if there is none.
    [[nodiscard]] std::int32_t step_before(std::int32_t step) const noexcept {
        return step_before_[static_cast<std::size_t>(step)];
    }
    [[nodiscard]] std::ptrdiff_t carried() const noexcept {
        return std::count_if(step_before_.begin(), step_before_.end(),
                             [](std::int32_t step) { return step >= 0; });
    }
    /// Return the displacement of the panel of a batch step since the last list.
    [[nodiscard]] std::int64_t moved(std::int32_t step) const noexcept {
        return moved_[static_cast<std::size_t>(step)];
    }
    /// Convert an op of the last list to the present list. @param moved  Result of moved() for its
    /// step.
    void carry(std::int64_t moved, Op& op) const noexcept;
    void carry(std::int64_t moved, LaneOp& op) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Properties of an interaction on which its ops depend, apart from offsets.
    struct Traits {
        std::int32_t body[kMaxInteractionBodies];
        std::uint8_t bodies, rows, flags;
        std::uint8_t dof[kMaxInteractionBodies];
        friend bool operator==(const Traits&, const Traits&) = default;
    };
    struct Place {
        std::int32_t jacobian, record;
    };
    /// A column of a batch, or a row behind it. `node`: 2 body for bodies, 2 id + 1 for
    /// interactions.
    struct Entry {
        std::int32_t node, step, lane, slot;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    struct BatchRange {
        std::int32_t step_begin, step_end, entry_begin, entry_end;
    };
    /// Steps and entries of all batches.
    struct Batches {
        std::vector<factor::BatchStep> steps;
        std::vector<BatchRange> ranges;
        std::vector<Entry> entries;
    };

    void compare_interactions(const OpSources& now);
    void compare_bodies(const OpSources& now);
    void compare_blocks(std::span<const ContactBlock> now);
    void list_batches(const OpSources& now);
    template <class Key>
    void list_rows(const factor::Symbolic& symbolic, std::int32_t front, int lane, Key&& key);
    void match_batches();
    [[nodiscard]] bool same(const BatchRange& now, const BatchRange& before) const noexcept;
    void mark(const Traits& of) noexcept;
    void mark(const ContactBlock& block) noexcept;

    bool has_list_ = false;
    std::vector<Traits> traits_;
    std::vector<Place> places_, slot_moved_;  ///< Offsets by interaction, and their changes.
    std::vector<std::int32_t> dof_begin_, block_moved_;  ///< By body.
    std::vector<ContactBlock> blocks_;
    std::vector<std::int32_t> block_now_;  ///< New number of each block; empty: unchanged.
    Batches batches_, before_;
    std::vector<std::uint8_t> changed_;  ///< By 2 body and 2 id + 1.
    std::vector<std::int32_t> step_before_;
    std::vector<std::int64_t> moved_;
};

}  // namespace hawser::assembly
