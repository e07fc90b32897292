// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file system.h
/// Assembly of the block system from bodies and interactions, and the addresses of its solution.
///
/// Every interaction has one of two forms. *Condensed* means eliminated first, with GᵀΣ⁻¹G in the
/// body blocks, the second form of the paper. *Kept* means a node of its own with negative pivots.
/// The form is a choice of pivot order, not a second code path. Residuals are always those of the
/// saddle system, and refinement works on them. Automatic choice: condensed if G M⁻¹Gᵀ/Σ ≤
/// kSafeRatio for each row. Beyond that ratio the sum would lose digits of the block of the body.
///
/// If bodies touch for the first time or are added, the order of elimination is repaired
/// (factor/repair.h). The order depends on the past and is part of the state.

#include <hawser/def.h>

#include "assembly/contacts.h"
#include "assembly/kernels.h"
#include "assembly/lane_ops.h"
#include "assembly/op_history.h"
#include "assembly/strips.h"
#include "assembly/view.h"
#include "base/executor.h"
#include "base/memory.h"
#include "factor/numeric.h"
#include "factor/partial.h"
#include "factor/repair.h"
#include "factor/symbolic.h"
#include "graph/islands.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::assembly {

/// Largest ratio G M⁻¹Gᵀ/Σ at which a row is condensed. With one refinement on the saddle residual
/// the error at 1e9 is 1e-15, at 1e12 it is 1e-9 (see docs/methods.md).
inline constexpr double kSafeRatio = 1e10;

/// Σ of a rigid row, as a fraction of G M⁻¹Gᵀ. With it redundant rows leave the matrix regular.
/// Twenty links between bodies 100,000 times heavier yield by some thousandths in their first step.
inline constexpr double kRigidFraction = 2e-9;

/// Largest fraction of nodes added or removed for a repair; beyond it a new order is computed.
inline constexpr double kMaxRepairFraction = 0.125;

/// Consecutive interactions, each with the rows of one cut interaction for one side of the cut.
struct Sides {
    std::int32_t first, count;
    bool soften;  ///< Raise their Σ to the minimum for stability, see soften_sides().
};

class System {
  public:
    System() = default;
    System(const System&) = delete;
    System& operator=(const System&) = delete;

    /// Choose forms, compute the order, analyse and allocate. Call it if the set of bodies or
    /// interactions has changed, or the set of bodies asleep. Bodies asleep count as fixed, and the
    /// interactions with such a body are left out.
    /// @param state  Analysis of the same system elsewhere from which to continue; null: none.
    /// @throws std::bad_alloc.
    void analyse(const model::Bodies& bodies, model::Interactions& interactions,
                 const WorldDef& def, int threads, const factor::AnalysisState* state = nullptr);
    /// Update the list of matrix contributions if the set of bodies with contacts has changed and
    /// the links between them have not.
    /// @throws std::bad_alloc; call analyse() then.
    void follow_touching(const model::Bodies& bodies, const model::Interactions& interactions);
    /// Update order, structure and addresses for contacts.links. Forms and floors do not change.
    /// @throws std::bad_alloc; call analyse() then.
    void relink(const model::Bodies& bodies, const model::Interactions& interactions, int threads);
    /// Data from which an analysis starts, for a return if the analysis fails.
    struct Kept {
        factor::KeptAnalysis analysis;
        std::vector<std::int32_t> node_of_body, node_of_interaction;
        bool ordered = false, updates_kept = false;
    };
    /// Save the data with which a later analysis starts. @throws std::bad_alloc
    void keep(Kept& out) const;
    /// Restore the data saved by keep(). The system is complete only after the next analyse().
    void go_back(Kept& to) noexcept;
    /// Limit of the memory of the factorisation [B]. @throws LimitError from analyse() and relink()
    /// if more is needed.
    double max_bytes = 1e15;
    /// Elements have consistent mass (View::pair_mass); else lumped mass.
    bool consistent_mass = true;
    /// Return the report of the last update of the order.
    [[nodiscard]] const factor::RepairReport& report() const noexcept { return report_; }
    /// Return the number of batch steps whose contributions the last list copied from the list
    /// before.
    [[nodiscard]] std::ptrdiff_t carried() const noexcept { return history_.carried(); }

    /// Return raw pointers for the kernels; valid until the next analyse().
    [[nodiscard]] View view(model::Bodies& bodies, model::Interactions& interactions,
                            const WorldDef& def) noexcept;

    factor::Analysis analysis;
    const factor::Pattern& pattern = analysis.pattern();
    const factor::Symbolic& symbolic = analysis.symbolic();
    factor::Numeric numeric;
    factor::DirtyParts dirty;         ///< Used if something may touch.
    factor::Unsymmetric unsymmetric;  ///< Used if something may touch.
    graph::Islands islands;
    std::vector<std::int32_t> node_of_body, node_of_interaction;  ///< −1: no node.
    RowBlocks strips;
    Contacts contacts;
    base::Array<Op> ops;           ///< By column of the matrix.
    base::Array<LaneOp> lane_ops;  ///< Sorted by address in the panels.
    /// Cut interactions, which no step evaluates, and their replacements for the bodies of each
    /// side (split/cuts.h). Set both before analyse().
    std::vector<std::int32_t> left_out;
    std::vector<Sides> sides;
    bool keeps_momentum = false;        ///< View::momentum is not null. Set it before analyse().
    std::vector<std::int32_t> bounded;  ///< Interactions with a bounded force, ascending.
    /// G M⁻¹Gᵀ of the first row of each at the last analysis.
    std::vector<double> bounded_mobility;
    /// Friction of lines at turning points, whose bound is part of the matrix (solve/capstans.h).
    /// Empty if another method than Newton's computes the forces.
    std::vector<Capstan> capstans;
    std::vector<CapstanEntry> capstan_entries;  ///< Entries of one capstan are consecutive.
    base::Array<std::uint8_t> turning;          ///< View::turning.
    std::vector<std::int32_t> breakable;
    std::vector<double> breaking_load;  ///< Breaking load of each breakable interaction [N].

    /// Write the blocks of the matrix that belong to one piece (an entry of numeric.pieces()) into
    /// the panels of the piece, which must be zero.
    void write_blocks(const View& view, int piece, double* panel) const noexcept;
    /// Add the unsymmetric contributions of sliding contacts to one piece with unsymmetric fronts
    /// (factor/unsymmetric.h). write_blocks() wrote the symmetric part to both halves.
    void write_skew(const View& view, int piece, double* upper) const noexcept;
    /// Write the blocks and the contributions of sliding contacts for a part of the panels.
    void write_blocks(const View& view, const factor::DirtyParts& part, double* panel,
                      base::Executor& executor) const noexcept;
    void write_skew(const View& view, const factor::DirtyParts& part, double* upper,
                    base::Executor& executor) const noexcept;
    /// Add the contributions of capstans to both halves of one piece, with the present
    /// CapstanEntry::value.
    void write_capstans(int piece, double* panel, double* upper) const noexcept;
    /// Return the node whose column contains a block of contacts.
    [[nodiscard]] std::int32_t column_of(const ContactBlock& block) const noexcept {
        return factor::DirtyParts::column(symbolic, node_of_body[static_cast<std::size_t>(block.a)],
                                          node_of_body[static_cast<std::size_t>(block.b)]);
    }

    /// @return true if an interaction is left out of the system because its bodies sleep.
    [[nodiscard]] bool rests(std::int32_t id) const noexcept {
        return rests_[static_cast<std::size_t>(id)] != 0;
    }
    [[nodiscard]] std::size_t bytes() const noexcept;
    /// Return true if the system and a model of `model` bytes need more memory [B] than at any
    /// earlier call. This counts as one growth.
    [[nodiscard]] bool needed_more_memory(std::size_t model) noexcept {
        const std::size_t held = bytes() + model, before = held_;
        held_ = std::max(held, before);
        return held > before;
    }

  private:
    /// Set the pointers of a view to the arrays of the system.
    void show_own(View& v) noexcept;
    void find_resting(const model::Bodies& bodies, const model::Interactions& interactions);
    void place_masses(const model::Interactions& interactions);
    void build_incidence(const model::Bodies& bodies, const model::Interactions& interactions);
    /// Find links: rigid bodies with exactly two ball joints and nothing else. The first joint has
    /// the link as its second body. In a chain the second joint of a link is the first joint of the
    /// next. The data of links and joints are consecutive in memory.
    void find_links(const model::Bodies& bodies);
    /// Assign the addresses of Jacobians and geometric terms of all interactions.
    void lay_out_rows(const model::Bodies& bodies, model::Interactions& interactions);
    /// Set the mobilities of dampers and the fractions of damping that depend on them.
    void split_damping(const model::Bodies& bodies, model::Interactions& interactions,
                       double h) const;
    /// Set the lower bound min_sigma of Σ for the duplicated interactions at cuts, which stability
    /// requires.
    void soften_sides(const model::Bodies& bodies, model::Interactions& interactions, double h);
    void choose_forms(const model::Bodies& bodies, model::Interactions& interactions,
                      const WorldDef& def);
    /// Build the nodes and edges of the next pattern, and the previous index of each node. @return
    /// the number of nodes added and removed.
    std::int32_t build_pattern(const model::Bodies& bodies,
                               const model::Interactions& interactions);
    void find_islands(const model::Interactions& interactions);
    void find_bounded(const model::Interactions& interactions);
    void find_capstans(const model::Interactions& interactions, const WorldDef& def);
    void place_capstans(const model::Interactions& interactions);
    /// @return true if the matrix may become unsymmetric, because of sliding contacts or capstans.
    [[nodiscard]] bool may_skew() const noexcept {
        return !contacts.blocks.empty() || !capstans.empty();
    }
    void evaluate(const model::Bodies& bodies, model::Interactions& interactions,
                  const WorldDef& def);
    void find_order(const model::Bodies& bodies, const model::Interactions& interactions,
                    const factor::AnalysisState* state);
    void place(const model::Bodies& bodies, const model::Interactions& interactions, int threads);
    /// The ops of one piece, or of one step of a batch.
    struct OpRange {
        std::int64_t op_begin, op_end, lane_begin, lane_end;
    };
    void build_ops(const model::Bodies& bodies, const model::Interactions& interactions);
    void write_skew(const View& view, std::int64_t begin, std::int64_t end,
                    double* upper) const noexcept;
    template <class F>
    void over_panels(const factor::DirtyParts& part, base::Executor& executor,
                     F&& work) const noexcept;
    void list_skew_ops();
    void shift_pieces(std::int64_t from, std::int64_t by) noexcept;
    void add_own_block(std::int32_t block, std::int32_t node);
    void drop_block(std::int32_t block);
    void place_columns();
    void sort_contacts();
    struct Slots;
    template <class Sink>
    void list_interaction(const model::Interactions& interactions, std::int32_t id, int b,
                          Sink&& sink) const;
    template <class Sink>
    void list_kept(const model::Interactions& interactions, std::int32_t id, Sink&& sink) const;
    template <class Sink>
    void list_column(std::int32_t node, const model::Bodies& bodies,
                     const model::Interactions& interactions, Sink&& sink) const;
    [[nodiscard]] std::size_t list_slot(std::size_t column, const model::Bodies& bodies,
                                        const model::Interactions& interactions);
    [[nodiscard]] std::size_t list_step(std::size_t column, const model::Bodies& bodies,
                                        const model::Interactions& interactions);
    [[nodiscard]] std::size_t carry_step(std::size_t column, std::int32_t step,
                                         std::int32_t before);
    [[nodiscard]] std::size_t list_columns_at(std::size_t column, const model::Bodies& bodies,
                                              const model::Interactions& interactions);
    void reserve(const model::Bodies& bodies, model::Interactions& interactions);
    void check_memory(const model::Bodies& bodies, const model::Interactions& interactions,
                      int threads) const;

    std::size_t held_ = 0;  ///< Maximum memory so far [B], see needed_more_memory().
    factor::RepairReport report_;
    bool ordered_ = false;                  ///< An order exists, which can be repaired.
    std::vector<std::int32_t> old_of_new_;  ///< Nodes.
    std::vector<std::int32_t> body_before_, interaction_before_;  ///< Their nodes.
    factor::Pattern next_;
    factor::NeighbourLists edge_dealer_;
    std::vector<std::int32_t> edge_from_, edge_to_;
    graph::IslandFinder island_finder_;
    std::vector<std::int32_t> member_begin_, members_;  ///< Members of islands.
    std::vector<std::int32_t> cursor_;                  ///< Scratch, by body.
    std::vector<double> side_mobility_;                 ///< Scratch of soften_sides().
    std::vector<std::pair<std::int64_t, std::int32_t>> column_slot_;  ///< Addresses, positions.
    std::vector<std::int32_t> step_begin_, pieces_by_slot_;
    std::vector<std::int32_t> member_of_node_;                 ///< Body or interaction.
    std::vector<std::int32_t> contact_begin_, contact_order_;  ///< By node: blocks in its column.
    LaneSharer sharer_;
    std::vector<OpRange> piece_ops_, step_ops_, steps_before_;
    base::Array<Op> ops_before_;  ///< The last list.
    base::Array<LaneOp> lane_ops_before_;
    OpHistory history_;
    std::vector<std::int64_t> op_slot_, lane_slot_;  ///< Address of each op, ascending.
    std::vector<std::int32_t> skew_ops_;             ///< Ops of contacts, ascending.
    base::Array<GeoSlot> geo_slot_;
    base::Array<std::uint8_t> dof_, kept_, rests_;
    base::Array<std::uint8_t> links_;        ///< View::links.
    base::Array<std::uint8_t> among_nodes_;  ///< View::among_nodes.
    base::Array<double> pair_mass_;          ///< View::pair_mass; empty: none.
    base::Array<std::int32_t> incident_begin_;
    base::Array<Incidence> incident_;
    std::vector<std::int32_t> incident_of_;  ///< Interaction of each.
    base::Array<std::int32_t> body_offset_, interaction_offset_;
    base::Array<double> body_block_, a_, v_new_, momentum_, geo_record_, geo_force_, solution_,
        spin_momentum_, spin_next_, c_next_, rate_;
};

}  // namespace hawser::assembly
