// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repair.h
/// An analysis that follows its pattern: contacts come and go at every step.
///
/// Ordering is the larger part of an analysis and hardly depends on a few contacts, so a repair
/// keeps the order of the nodes that stay, but for a few:
///
/// - A new body (positive node) comes before the first eliminated of its neighbours, directly or
///   through rows.
/// - Rows (negative) that are new, or have other neighbours than before, come behind the first
///   eliminated of their bodies, as stability demands (ordering.h).
/// - Where the neighbours lie in different branches of the tree, the place is before the front in
///   which the branches meet. Of two bodies that stay and become neighbours, in different branches,
///   one moves to such a place. Otherwise one branch would come to hang below the other, and all
///   that it carries to its top would pass through the other one as well.
/// - A body placed where branches met is placed as if it were new when its neighbours change again.
/// - Nodes of a chain (chains.h) whose inside changed, or which touches another chain now, stay
///   where they were, but in ordinary fronts.
///
/// Lists of neighbours are compared as a whole, and only nodes with another one are looked at. Then
/// the structure is computed again where it changes (columns.h). Where it does not, nodes merge to
/// the fronts that they were (tree.h) and land in their parents as they did (layout.h), if nodes
/// keep their numbers and all chains hold. Addresses move with all that lies before them and are
/// laid out anew, which is linear in the number of fronts and rows. The result is what analyse()
/// gives for the same order and chains, member by member.
///
/// An order grows stale: update() makes a new one when the flops exceed kReplan times those after
/// the last plan, and at once where more than kEdited of the nodes changed. Measured on the
/// paper's scene in docs/factor_benchmark.md.

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

/// Growth of the flops since the last plan at which a new one is made: a plan takes about twice the
/// time of a repair.
inline constexpr double kReplan = 1.2;

/// Share of nodes that are new or have other neighbours above which a plan is made at once: it
/// takes about as long as repairs with the plans that they end in, and the order is a new one.
/// Where nodes are more than MinimumDegree::kMost an order takes most of the time: repairs pay for
/// more changes.
inline constexpr double kEdited = 0.125;

/// What a repair did.
struct RepairReport {
    std::int32_t placed = 0;     ///< Nodes that got a place in the order.
    std::int32_t columns = 0;    ///< Block columns computed again; replanned: all.
    std::int32_t dissolved = 0;  ///< Chains that became ordinary fronts.
    std::int32_t same = 0;       ///< Fronts with the pivots and rows of one before.
    bool replanned = false;      ///< update(): the order was made anew.
};

/// All that later repairs depend on beside the pattern. An analysis planned with it goes on as the
/// one that it was taken from: member by member, after any repairs.
struct AnalysisState {
    Elimination elimination;
    std::vector<std::uint8_t> between;  ///< By node: placed where branches met.
    std::int64_t planned_flops = 0;     ///< At the last plan.
    friend bool operator==(const AnalysisState&, const AnalysisState&) = default;
};

/// An analysis as it was, to go back to: enough to go on as if what came after had not been.
struct KeptAnalysis {
    Pattern pattern;
    AnalysisState state;
    bool stale = false;
};

class Analysis {
  public:
    using Planner = std::function<Elimination(const Pattern&)>;
    /// @param planner  Makes the orders; none: chains, then minimum degree.
    explicit Analysis(Planner planner = nullptr) : planner_(std::move(planner)) {}

    /// Give every update matrix a place of its own from the next call on (partial.h).
    void keep_updates(bool keep) noexcept { symbolic_.updates_kept = keep; }

    /// The order is the caller's: update() makes no other one while it serves.
    void keep_order(bool given) noexcept { order_given_ = given; }

    /// Who helps from the next call on; nullptr: nobody. Results are the same.
    void use(base::Executor* team) noexcept { team_ = team; }

    /// Order and analyse from nothing. @throws std::bad_alloc.
    void plan(const Pattern& pattern);
    /// Analyse from nothing with this order. @throws std::bad_alloc.
    void plan(const Pattern& pattern, Elimination elimination);
    /// Go on from a state. @return false, and a plan() from nothing: it belongs to another pattern.
    bool resume(const Pattern& pattern, const AnalysisState& state);

    /// Follow to another pattern. @param old_of_new  For each of its nodes the node that it was,
    /// −1: new, each old node at most once; empty: nodes keep their numbers, further ones are new.
    /// A node of another size or sign counts as new. @throws std::bad_alloc; plan() again then.
    RepairReport repair(const Pattern& next, std::span<const std::int32_t> old_of_new = {});

    /// repair(), and plan() where the order has become a bad one, or at once where much changed.
    RepairReport update(const Pattern& next, std::span<const std::int32_t> old_of_new = {});

    /// Copy what the analysis is. @throws std::bad_alloc.
    void keep(KeptAnalysis& out) const;
    /// Go back to it; what is computed from it is computed again when it is needed next, by
    /// update(), repair() or resume(). Until then symbolic() is of no use.
    void go_back(KeptAnalysis& to) noexcept;

    [[nodiscard]] const Symbolic& symbolic() const noexcept { return symbolic_; }
    [[nodiscard]] const Columns& columns() const noexcept { return columns_; }
    /// Order and chains as they are now.
    [[nodiscard]] Elimination elimination() const { return {symbolic_.order, chains_}; }
    [[nodiscard]] AnalysisState state() const { return {elimination(), between_, planned_flops_}; }
    /// That of the last call.
    [[nodiscard]] const Pattern& pattern() const noexcept { return pattern_; }
    /// Flops at the last plan.
    [[nodiscard]] std::int64_t planned_flops() const noexcept { return planned_flops_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    bool compare(const Pattern& next, std::span<const std::int32_t> old_of_new);
    RepairReport follow(const Pattern& next, bool same_numbers);
    bool match_nodes(const Pattern& next, std::span<const std::int32_t> old_of_new);
    void find_changes(const Pattern& next, bool same_numbers);
    void compare_lists(const Pattern& next);
    void keep_chains(const Pattern& next, RepairReport& report);
    [[nodiscard]] bool chain_holds(const Pattern& next, std::int32_t chain);
    // How nodes are moved to their new places: see placing.cpp.
    void choose_moves(const Pattern& next);
    void join(const Pattern& next, std::int32_t a, std::int32_t b);
    void collect_rest(const Pattern& next);
    void place_body(const Pattern& next, std::int32_t node);
    void place_rows(const Pattern& next, std::int32_t node);
    struct Meeting;
    [[nodiscard]] std::int32_t meet(std::int32_t a, std::int32_t b) const noexcept;
    void visit(Meeting& meeting, std::int32_t node) const noexcept;
    [[nodiscard]] std::int32_t branch(std::int32_t node) const noexcept;
    [[nodiscard]] std::int64_t before_front(std::int32_t front) const noexcept;
    void emit_order();
    void hang(std::vector<std::int32_t>& heads, std::size_t place, std::int32_t node);

    void analyse_order();
    void freshen();
    /// f(node) for each that is marked, ascending: eight at a time are looked at.
    template <class F>
    static void each_marked(const std::vector<std::uint8_t>& marks, F&& f) {
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
    bool order_given_ = false;  ///< See keep_order().
    base::Executor* team_ = nullptr;
    Orderer orderer_;
    Pattern pattern_;
    Chains chains_;
    Columns columns_;
    Layout layout_;
    Symbolic symbolic_;
    std::int64_t planned_flops_ = 0;
    bool stale_ = false;  ///< Columns, layout and structure do not belong to pattern and order.

    // Buffers of repair(); by node of the next pattern unless said otherwise.
    std::vector<std::int32_t> old_of_new_, new_of_old_;
    std::vector<std::uint8_t> changed_;  ///< New, or other neighbours.
    std::vector<std::int32_t> changes_;  ///< These nodes, ascending.
    std::vector<std::uint8_t> placing_;  ///< Gets a place; kFresh: from its neighbours alone.
    std::vector<std::uint8_t> between_;  ///< Kept from call to call: placed where branches met.
    std::vector<std::uint8_t> spare_;
    std::vector<std::int32_t> anchor_;  ///< Front of the last structure that stands for its place.
    std::vector<std::int32_t> chain_of_, mark_;
    std::vector<std::int32_t> rest_, placed_;  ///< Nodes in no chain: that stay; that are placed.
    std::vector<std::int64_t> key_;     ///< 2 rank + 1 of a node that stays, 2 rank before it.
    std::vector<std::int32_t> before_;  ///< By rank: bodies placed before that node.
    std::vector<std::int32_t> behind_;  ///< Rows placed behind a node.
    std::vector<std::int32_t> next_;    ///< In either list.
    Chains kept_;
};

}  // namespace hawser::factor
