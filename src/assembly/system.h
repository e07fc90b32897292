// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file system.h
/// From bodies and interactions to the block system and back: the only place that knows both.
///
/// Every interaction is either *condensed* (eliminated first: G ᵀΣ⁻¹G in the body blocks, the
/// paper's second form) or *kept* (a node of its own with negative pivots). That is a choice of
/// pivot order, not a second code path: residuals are always those of the saddle system, and
/// refinement works on them. Automatic choice: condensed when G M⁻¹Gᵀ/Σ ≤ kSafeRatio for each
/// row, beyond which the sum would lose the body's own digits.
///
/// The order of elimination follows what happens: where bodies touch for the first time, or some
/// are added, it is repaired (factor/repair.h) and so depends on the past; it is part of the state.

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

/// Largest ratio G M⁻¹Gᵀ/Σ at which a row is condensed. With one refinement on the saddle
/// residual the error at 1e9 is 1e-15, at 1e12 it is 1e-9 (see docs/theory/solver.md).
inline constexpr double kSafeRatio = 1e10;

/// Σ of a rigid row, as a share of G M⁻¹Gᵀ: rows that repeat each other leave the matrix regular,
/// and twenty links between bodies a hundred thousand times heavier give by some thousandths in
/// their first step.
inline constexpr double kRigidShare = 2e-9;

/// Part of the nodes that may come or go for a repair; beyond, a new order is made.
inline constexpr double kRepairable = 0.125;

/// Consecutive interactions, each the rows of the same one for one side of a cut.
struct Sides {
    std::int32_t first, count;
    bool soften;  ///< Their Σ as large as stability needs, see soften_sides().
};

class System {
  public:
    System() = default;
    System(const System&) = delete;
    System& operator=(const System&) = delete;

    /// Choose forms, order, analyse, make room. Called when the set of bodies or interactions
    /// changed, or which bodies are asleep: these count as fixed, and what holds them is left out.
    /// @param state  Of the analysis of the same system elsewhere, to go on from; null: none.
    /// @throws std::bad_alloc.
    void analyse(const model::Bodies& bodies, model::Interactions& interactions,
                 const WorldDef& def, int threads, const factor::AnalysisState* state = nullptr);
    /// Follow to contacts.touching() where links stay: the list of contributions alone.
    /// @throws std::bad_alloc; analyse() then.
    void follow_touching(const model::Bodies& bodies, const model::Interactions& interactions);
    /// Follow to contacts.links: order, structure and addresses. Forms and floors stay as they are.
    /// @throws std::bad_alloc; analyse() then.
    void relink(const model::Bodies& bodies, const model::Interactions& interactions, int threads);
    /// What an analysis goes on from, to go back to where one fails.
    struct Kept {
        factor::KeptAnalysis analysis;
        std::vector<std::int32_t> node_of_body, node_of_interaction;
        bool ordered = false, updates_kept = false;
    };
    /// @throws std::bad_alloc.
    void keep(Kept& out) const;
    /// Only analyse() makes the system one again.
    void go_back(Kept& to) noexcept;
    /// Bytes that the factorisation may take. @throws LimitError from analyse() and relink() where
    /// it would take more.
    double most_bytes = 1e15;
    bool consistent_mass = true;  ///< Elements move as such (View::pair_mass); else none does.
    /// What the last of these did.
    [[nodiscard]] const factor::RepairReport& report() const noexcept { return report_; }
    /// Steps of batches whose contributions the last list took over from the one before.
    [[nodiscard]] std::ptrdiff_t carried() const noexcept { return history_.carried(); }

    /// Raw pointers for the kernels; valid until the next analyse().
    [[nodiscard]] View view(model::Bodies& bodies, model::Interactions& interactions,
                            const WorldDef& def) noexcept;

    factor::Analysis analysis;
    const factor::Pattern& pattern = analysis.pattern();
    const factor::Symbolic& symbolic = analysis.symbolic();
    factor::Numeric numeric;
    factor::DirtyParts dirty;         ///< Of a world in which something may touch.
    factor::Unsymmetric unsymmetric;  ///< Of a world in which something may touch.
    graph::Islands islands;
    std::vector<std::int32_t> node_of_body, node_of_interaction;  ///< −1: no node.
    Strips strips;
    Contacts contacts;
    base::Array<Op> ops;           ///< By column of the matrix.
    base::Array<LaneOp> lane_ops;  ///< By place in the panels.
    /// Interactions that no step looks at, and those that stand for them, each for the bodies of
    /// one side (split/cuts.h). To be set before analyse().
    std::vector<std::int32_t> left_out;
    std::vector<Sides> sides;
    bool keeps_momentum = false;           ///< View::momentum is not null. Before analyse().
    std::vector<std::int32_t> bounded;     ///< Interactions with a bounded force, ascending.
    std::vector<double> bounded_mobility;  ///< Of their first row: G M⁻¹ Gᵀ at the last analysis.
    /// Friction of lines on what they run over, whose bound is part of the matrix
    /// (solve/capstans.h). None where other methods than Newton's find the forces.
    std::vector<Capstan> capstans;
    std::vector<CapstanEntry> capstan_entries;  ///< Those of one capstan follow each other.
    base::Array<std::uint8_t> turning;          ///< View::turning.
    std::vector<std::int32_t> breakable;
    std::vector<double> breaking_load;  ///< Of each breakable one [N].

    /// Write the blocks of one of numeric.pieces() into its panels, which are zero.
    void write_blocks(const View& view, int piece, double* panel) const noexcept;
    /// What contacts that slide add beyond the symmetric part that write_blocks() wrote to both
    /// halves of a piece with unsymmetric fronts (factor/unsymmetric.h).
    void write_skew(const View& view, int piece, double* upper) const noexcept;
    /// Write the blocks, and what contacts that slide add to them, for a part of the panels.
    void write_blocks(const View& view, const factor::DirtyParts& part, double* panel,
                      base::Executor& executor) const noexcept;
    void write_skew(const View& view, const factor::DirtyParts& part, double* upper,
                    base::Executor& executor) const noexcept;
    /// Write what capstans add to both halves, with CapstanEntry::value as it is, of one piece.
    void write_capstans(int piece, double* panel, double* upper) const noexcept;
    /// Node whose column holds a block of contacts.
    [[nodiscard]] std::int32_t column_of(const ContactBlock& block) const noexcept {
        return factor::DirtyParts::column(symbolic, node_of_body[static_cast<std::size_t>(block.a)],
                                          node_of_body[static_cast<std::size_t>(block.b)]);
    }

    /// Whether an interaction is left out, since its bodies sleep.
    [[nodiscard]] bool rests(std::int32_t id) const noexcept {
        return rests_[static_cast<std::size_t>(id)] != 0;
    }
    [[nodiscard]] std::size_t bytes() const noexcept;
    /// Whether the system, with the bodies and interactions of a model of `model` bytes, holds more
    /// memory than at any call before [B]; counts as one growth.
    [[nodiscard]] bool grew(std::size_t model) noexcept {
        const std::size_t held = bytes() + model, before = held_;
        held_ = std::max(held, before);
        return held > before;
    }

  private:
    /// What a view shows of the arrays of the system.
    void show_own(View& v) noexcept;
    void find_resting(const model::Bodies& bodies, const model::Interactions& interactions);
    void place_masses(const model::Interactions& interactions);
    void build_incidence(const model::Bodies& bodies, const model::Interactions& interactions);
    /// Links: rigid bodies that only two ball joints touch, of which the first has them as its
    /// second body. In a chain one's second joint is the next one's first, and bodies, joints and
    /// all that belongs to them stand in a row.
    void find_links(const model::Bodies& bodies);
    /// Where Jacobians and geometric terms are.
    void lay_out_rows(const model::Bodies& bodies, model::Interactions& interactions);
    /// Sets mobilities of dampers, and what follows from them.
    void share_damping(const model::Bodies& bodies, model::Interactions& interactions,
                       double h) const;
    /// Sets least_sigma of the rows of sides.
    void soften_sides(const model::Bodies& bodies, model::Interactions& interactions, double h);
    void choose_forms(const model::Bodies& bodies, model::Interactions& interactions,
                      const WorldDef& def);
    /// Nodes and edges of the pattern that is next, and what each node was. @return of these how
    /// many came or went.
    std::int32_t build_pattern(const model::Bodies& bodies,
                               const model::Interactions& interactions);
    void find_islands(const model::Interactions& interactions);
    void find_bounded(const model::Interactions& interactions);
    void find_capstans(const model::Interactions& interactions, const WorldDef& def);
    void place_capstans(const model::Interactions& interactions);
    /// Whether a matrix may be unsymmetric.
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
    [[nodiscard]] std::size_t list_place(std::size_t column, const model::Bodies& bodies,
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

    std::size_t held_ = 0;  ///< See grew().
    factor::RepairReport report_;
    bool ordered_ = false;                                        ///< There is an order to repair.
    std::vector<std::int32_t> old_of_new_;                        ///< Nodes.
    std::vector<std::int32_t> body_before_, interaction_before_;  ///< Their nodes.
    factor::Pattern next_;
    factor::EdgeDealer edge_dealer_;
    std::vector<std::int32_t> edge_from_, edge_to_;
    graph::IslandFinder island_finder_;
    std::vector<std::int32_t> member_begin_, members_;  ///< Of islands.
    std::vector<std::int32_t> cursor_;                  ///< Scratch, by body.
    std::vector<double> side_mobility_;                 ///< Scratch of soften_sides().
    std::vector<std::pair<std::int64_t, std::int32_t>> column_place_;  ///< Addresses, positions.
    std::vector<std::int32_t> step_begin_, pieces_by_place_;
    std::vector<std::int32_t> member_of_node_;                 ///< Body or interaction.
    std::vector<std::int32_t> contact_begin_, contact_order_;  ///< By node: blocks in its column.
    LaneSharer sharer_;
    std::vector<OpRange> piece_ops_, step_ops_, steps_before_;
    base::Array<Op> ops_before_;  ///< The last list.
    base::Array<LaneOp> lane_ops_before_;
    OpHistory history_;
    std::vector<std::int64_t> op_place_, lane_place_;  ///< Of each op, ascending.
    std::vector<std::int32_t> skew_ops_;               ///< Ops of contacts, ascending.
    base::Array<GeoPlace> geo_place_;
    base::Array<std::uint8_t> dof_, kept_, rests_;
    base::Array<std::uint8_t> links_;        ///< View::links.
    base::Array<std::uint8_t> among_lumps_;  ///< View::among_lumps.
    base::Array<double> pair_mass_;          ///< View::pair_mass; empty: there is none.
    base::Array<std::int32_t> incident_begin_;
    base::Array<Incidence> incident_;
    std::vector<std::int32_t> incident_of_;  ///< Interaction of each.
    base::Array<std::int32_t> body_offset_, interaction_offset_;
    base::Array<double> body_block_, a_, v_new_, momentum_, geo_record_, geo_force_, solution_,
        spin_momentum_, spin_next_, c_next_, rate_;
};

}  // namespace hawser::assembly
