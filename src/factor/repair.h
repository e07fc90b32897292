// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repair.h
/// Update of an analysis to a changed pattern. Contacts begin and end in every step.
///
/// Ordering is the larger part of an analysis and hardly depends on a few contacts. A repair does
/// not change the order of the remaining nodes, with these exceptions:
///
/// - A new body (positive node) comes before the first eliminated of its neighbours, directly or
///   through rows.
/// - Rows (negative) that are new, or whose neighbours changed, come behind the first eliminated of
///   their bodies, for stability (ordering.h).
/// - If the neighbours lie in different branches of the tree, the position is before the front in
///   which the branches meet. If two remaining bodies in different branches become neighbours,
///   one of them moves to such a position. Otherwise one branch would be below the other, and all
///   its updates would pass through the other as well.
/// - A body that was moved to such a position is treated like a new one when its neighbours change
///   again.
/// - If a chain (chains.h) changed inside or becomes a neighbour of another chain, its nodes keep
///   their position, but are eliminated in ordinary fronts.
///
/// Lists of neighbours are compared as a whole, and only nodes with a changed list are processed.
/// Then the changed part of the structure is computed again (columns.h). If nodes keep their
/// indices and no chain is removed, unchanged nodes form the same fronts (tree.h) and have the same
/// positions in their parents (layout.h). Addresses depend on all preceding ones and are computed
/// again, in time linear in the number of fronts and rows. The result equals the result of
/// analyse() for the same order and chains, member by member.
///
/// Limits: an order becomes stale. A new order is computed by update() if the flops exceed
/// kReplanGrowth times those after the last plan, or if more than kMaxEditedFraction of the nodes
/// changed. Measurements on the paper's scene are in docs/factor_benchmark.md.

#include "factor/columns.h"
#include "factor/layout.h"
#include "factor/ordering.h"
#include "factor/symbolic.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace hawser::factor {

/// Growth of the flops since the last plan at which update() makes a new plan. A plan takes about
/// twice the time of a repair.
inline constexpr double kReplanGrowth = 1.2;

/// Fraction of new or changed nodes above which update() makes a plan at once. A plan takes about
/// as long as the repairs and the later plan that it replaces, and its order is a new one. Above
/// MinimumDegree::kMaximum nodes, ordering takes most of the time, so repairs pay for more changes.
inline constexpr double kMaxEditedFraction = 0.125;

/// Result of a repair.
struct RepairReport {
    std::int32_t placed = 0;     ///< Nodes that received a new position in the order.
    std::int32_t columns = 0;    ///< Block columns computed again; all if replanned.
    std::int32_t dissolved = 0;  ///< Chains that became ordinary fronts.
    std::int32_t same = 0;       ///< Fronts with the pivots and rows of an earlier one.
    bool replanned = false;      ///< true if update() computed a new order.
};

/// All data besides the pattern that later repairs depend on. An analysis planned with it continues
/// like the original: equal member by member, after any repairs.
struct AnalysisState {
    Elimination elimination;
    std::vector<std::uint8_t> at_branch_meeting;  ///< By node: placed at a meeting of branches.
    std::int64_t planned_flops = 0;               ///< Flops of the last plan.
    friend bool operator==(const AnalysisState&, const AnalysisState&) = default;
};

/// A saved analysis, sufficient to continue from that state.
struct KeptAnalysis {
    Pattern pattern;
    AnalysisState state;
    bool stale = false;
};

class Analysis {
  public:
    using Planner = std::function<Elimination(const Pattern&)>;
    /// Create an analysis.
    /// @param planner  Computes the orders; none: chains first, other nodes by minimum degree.
    explicit Analysis(Planner planner = nullptr) : planner_(std::move(planner)) {}

    /// Assign separate memory to every update matrix from the next call on (partial.h).
    void separate_updates(bool keep) noexcept { symbolic_.updates_kept = keep; }

    /// Set whether the caller's order is fixed. update() then computes no other order as long as
    /// this order fits the pattern.
    void set_fixed_order(bool given) noexcept { order_fixed_ = given; }

    /// Set the executor for the next calls; nullptr: none. Results do not depend on it.
    void use(base::Executor* team) noexcept { executor_ = team; }

    /// Order and analyse a pattern.
    /// @throws std::bad_alloc.
    void plan(const Pattern& pattern);
    /// Analyse a pattern with this order.
    /// @throws std::bad_alloc.
    void plan(const Pattern& pattern, Elimination elimination);
    /// Continue from a state.
    /// @return false, after a new plan(), if it belongs to another pattern.
    bool resume(const Pattern& pattern, const AnalysisState& state);

    /// Update the analysis to a changed pattern. A node of another size or sign counts as new.
    /// @param old_of_new  For each node its former index, −1: new, each former node at most once.
    ///        Empty: nodes keep their indices, further ones are new.
    /// @throws std::bad_alloc; plan() again then.
    RepairReport repair(const Pattern& next, std::span<const std::int32_t> old_of_new = {});

    /// Call repair(), and plan() if the order has become stale or if much changed.
    RepairReport update(const Pattern& next, std::span<const std::int32_t> old_of_new = {});

    /// Save the analysis.
    /// @throws std::bad_alloc.
    void keep(KeptAnalysis& out) const;
    /// Restore a saved analysis. The next update(), repair() or resume() computes the derived data.
    /// Until then symbolic() is invalid.
    void restore(KeptAnalysis& to) noexcept;

    [[nodiscard]] const Symbolic& symbolic() const noexcept { return symbolic_; }
    [[nodiscard]] const Columns& columns() const noexcept { return columns_; }
    /// Return the current order and chains.
    [[nodiscard]] Elimination elimination() const { return {symbolic_.order, chains_}; }
    [[nodiscard]] AnalysisState state() const {
        return {elimination(), at_branch_meeting_, planned_flops_};
    }
    /// Return the pattern of the last call.
    [[nodiscard]] const Pattern& pattern() const noexcept { return pattern_; }
    /// Return the flops of the last plan.
    [[nodiscard]] std::int64_t planned_flops() const noexcept { return planned_flops_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    bool find_changed_nodes(const Pattern& next, std::span<const std::int32_t> old_of_new);
    RepairReport follow(const Pattern& next, bool same_numbers);
    bool match_nodes(const Pattern& next, std::span<const std::int32_t> old_of_new);
    void find_changes(const Pattern& next, bool same_numbers);
    void compare_lists(const Pattern& next);
    void keep_unchanged_chains(const Pattern& next, RepairReport& report);
    [[nodiscard]] bool chain_is_unchanged(const Pattern& next, std::int32_t chain);
    // Choose the nodes that move to new positions (placing.cpp).
    void choose_moves(const Pattern& next);
    void join(const Pattern& next, std::int32_t a, std::int32_t b);
    void collect_nodes_outside_chains(const Pattern& next);
    void place_body(const Pattern& next, std::int32_t node);
    void place_rows(const Pattern& next, std::int32_t node);
    struct Meeting;
    [[nodiscard]] std::int32_t common_ancestor(std::int32_t a, std::int32_t b) const noexcept;
    void visit(Meeting& meeting, std::int32_t node) const noexcept;
    [[nodiscard]] std::int32_t front_of_node(std::int32_t node) const noexcept;
    [[nodiscard]] std::int64_t key_before_front(std::int32_t front) const noexcept;
    void emit_order();
    void prepend_node(std::vector<std::int32_t>& heads, std::size_t place, std::int32_t node);

    void analyse_order();
    void rebuild_derived_data();
    /// Call f(node) for each marked node, ascending. Eight marks are tested at a time.
    template <class F>
    static void for_each_marked(const std::vector<std::uint8_t>& marks, F&& f) {
        const std::size_t n = marks.size();
        for (std::size_t v = 0, end; v < n; v = end) {
            end = std::min(v + 8, n);
            std::uint8_t any = 0;
            for (std::size_t i = v; i < end; ++i) any |= marks[i];
            for (std::size_t i = v; any != 0 && i < end; ++i)
                if (marks[i] != 0) f(static_cast<std::int32_t>(i));
        }
    }

    Planner planner_;
    bool order_fixed_ = false;  ///< See set_fixed_order().
    base::Executor* executor_ = nullptr;
    Orderer orderer_;
    Pattern pattern_;
    Chains chains_;
    Columns columns_;
    Layout layout_;
    Symbolic symbolic_;
    std::int64_t planned_flops_ = 0;
    /// true if columns, layout and structure do not belong to pattern and order.
    bool stale_ = false;

    // Buffers of repair(), indexed by node of the next pattern unless stated otherwise.
    std::vector<std::int32_t> old_of_new_, new_of_old_;
    std::vector<std::uint8_t> changed_;  ///< 1: new, or with other neighbours.
    std::vector<std::int32_t> changes_;  ///< These nodes, ascending.
    /// Non-zero: gets a new position; kAddedNode: from its neighbours alone.
    std::vector<std::uint8_t> placing_;
    std::vector<std::uint8_t>
        at_branch_meeting_;  ///< Kept between calls: placed at a meeting of branches.
    std::vector<std::uint8_t> spare_;
    /// Front of the last structure that represents the node's position.
    std::vector<std::int32_t> anchor_;
    std::vector<std::int32_t> chain_of_, mark_;
    /// Nodes in no chain: those that stay; those that are placed.
    std::vector<std::int32_t> nodes_outside_chains_, placed_;
    std::vector<std::int64_t> key_;  ///< 2 rank + 1 of a node that stays, 2 rank before it.
    std::vector<std::int32_t> bodies_before_;  ///< By rank: bodies placed before that node.
    std::vector<std::int32_t> rows_behind_;    ///< Rows placed behind a node.
    std::vector<std::int32_t> next_;           ///< Links of both lists.
    Chains intact_chains_;
};

}  // namespace hawser::factor
