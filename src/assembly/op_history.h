// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file op_history.h
/// What the last list of contributions was made of, so that the next one takes over what stays.
///
/// An edit, or a link of contacts, changes what few columns hold; most of the list is in batches
/// (factor/batches.h), of which nothing changes but numbers: where panels, Jacobians and records
/// begin, and which number a block of contacts has. A batch is taken over if
///
/// - its steps have their sizes, and their columns the nodes, lanes and slots that they had;
/// - rows behind the chains are in the slots that they were in;
/// - none of its columns belongs to a body of an interaction, or of a block of contacts, that came,
///   went or has other bodies, freedoms or another form now.
///
/// Columns of ordinary fronts are few and always listed anew.

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

/// What a list is made of.
struct OpSources {
    const factor::Symbolic& symbolic;
    const model::Bodies& bodies;
    const model::Interactions& interactions;
    /// Columns by place in the panels: addresses, positions.
    std::span<const std::pair<std::int64_t, std::int32_t>> columns;
    std::span<const std::int32_t> member_of_node;  ///< Body or interaction.
    std::span<const std::int32_t> node_of_interaction;
    std::span<const std::uint8_t> dof, rests;
    std::span<const GeoPlace> geo;
    std::span<const ContactBlock> blocks;
};

class OpHistory {
  public:
    /// Find what stays, and remember what the next list is made of. @throws std::bad_alloc. The
    /// next call finds nothing unless done() is called.
    void follow(const OpSources& now);
    /// To be called when the new list has been made: the next follow() compares with it.
    void done() noexcept { known_ = true; }
    /// The list is about to change in its place.
    void forget() noexcept { known_ = false; }
    /// It has, and blocks of contacts have these numbers now. @throws std::bad_alloc.
    void renumber_blocks(std::span<const ContactBlock> blocks);
    /// The step of the last list that a step of a batch is, −1: none.
    [[nodiscard]] std::int32_t step_before(std::int32_t step) const noexcept {
        return step_before_[static_cast<std::size_t>(step)];
    }
    [[nodiscard]] std::ptrdiff_t carried() const noexcept {
        return std::count_if(step_before_.begin(), step_before_.end(),
                             [](std::int32_t step) { return step >= 0; });
    }
    /// By how much the panel of such a step moved.
    [[nodiscard]] std::int64_t moved(std::int32_t step) const noexcept {
        return moved_[static_cast<std::size_t>(step)];
    }
    /// An op of such a step, from the last list to the next one.
    void carry(std::int64_t moved, Op& op) const noexcept;
    void carry(std::int64_t moved, LaneOp& op) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// What ops of an interaction depend on beside places.
    struct Traits {
        std::int32_t body[kMaxInteractionBodies];
        std::uint8_t bodies, rows, flags;
        std::uint8_t dof[kMaxInteractionBodies];
        friend bool operator==(const Traits&, const Traits&) = default;
    };
    struct Place {
        std::int32_t jacobian, record;
    };
    /// A column of a batch, or a row behind it. `node`: of bodies 2 body, of interactions 2 id + 1.
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

    bool known_ = false;
    std::vector<Traits> traits_;
    std::vector<Place> places_, place_moved_;            ///< By interaction; and by how much.
    std::vector<std::int32_t> dof_begin_, block_moved_;  ///< By body.
    std::vector<ContactBlock> blocks_;
    std::vector<std::int32_t> block_now_;  ///< New number of each block; empty: as it was.
    Batches batches_, before_;
    std::vector<std::uint8_t> changed_;  ///< By 2 body and 2 id + 1.
    std::vector<std::int32_t> step_before_;
    std::vector<std::int64_t> moved_;
};

}  // namespace hawser::assembly
