// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file split.h
/// Declare splits for all other folders, which include no other header of `split/`. Interactions
/// between groups of bodies may be *cut*, so that the groups become independent islands
/// (docs/partition.md; docs/theory/splits.md). A step calls these functions:
/// ```
///     preparation   may_split, split_model      ghost bodies and copies (cuts.h)
///     graph         regroup                     automatic groups follow the state
///     analyse       analyse, relink             cuts in force; then the system
///     assemble      copy_ghost_poses, predict       poses and velocities of ghost bodies
///                   sum_contact_impulses                  contacts of the last step, for
///                   predictors
///     integrate     finish_cuts                 one multiplier for readers; errors of cuts
///                   part_all                    a line breaks with all its copies
/// ```
/// In a world without cuts each of them does the work of an exact step or nothing.

#include <hawser/stats.h>

#include "assembly/parts.h"
#include "context/context.h"

#include <cstdint>

namespace hawser::split {

// Preparation.

/// True if ghost bodies and duplicated interactions exist, or split_model() would make some.
[[nodiscard]] bool may_split(const context::Model& model) noexcept;

/// Make groups if they are required, and missing or outdated. Then make ghost bodies and duplicated
/// interactions for the present groups and couplings. @throws std::bad_alloc.
void split_model(context::StepContext& ctx);

/// Remove ghost bodies and duplicated interactions. Call before bodies or interactions are added or
/// removed. Automatic groups are then computed again for the changed model.
void join_model(context::Model& model) noexcept;

// Stages of a step.

/// Update the groups if the interval has passed (stage graph). If groups have changed, make new
/// cuts and run stage analyse. If allocation fails, the state is unchanged.
[[nodiscard]] Status regroup(context::StepContext& ctx) noexcept;

/// Analyse the system of the present interactions and links, without cut interactions (stage
/// analyse).
/// @param state  State of the analysis of a saved world, from which to continue.
/// @throws std::bad_alloc.
void analyse(context::StepContext& ctx, const factor::AnalysisState* state = nullptr);

/// Update the links of contacts in stage analyse, if new pairs of bodies are in contact. If the set
/// of active cuts changes, analyse the whole system. @throws std::bad_alloc; call prepare() then.
void relink(context::StepContext& ctx);

/// Copy the poses of bodies to their ghost bodies.
void copy_ghost_poses(context::Model& model) noexcept;

/// Set poses and velocities of ghost bodies before rows are assembled. The velocities come from the
/// predictor of the world (WorldDef::predictor).
void predict(context::Model& model, const context::State& state) noexcept;

/// Sum the contact impulses of the last step on each body, for predictors. No effect without cuts.
/// @param room  Buffer of three values for each triple of contacts and resistances.
void sum_contact_impulses(context::Model& model, std::vector<double>& room) noexcept;

/// Compute the multipliers for readers, which are the means of the sides, and the errors of the
/// cuts. Call after the solve, before bodies move.
void finish_cuts(context::StepContext& ctx) noexcept;

/// Mark a line as broken. If it is cut, mark its duplicates on both sides, too.
void part_all(context::Model& model, std::int32_t id) noexcept;

// Requests of deadlines (budget).

/// Activate the cuts at the given interfaces (Degradation::cuts), and analyse if that changes a
/// cut.
[[nodiscard]] Status request_cuts(context::StepContext& ctx, std::uint64_t interfaces) noexcept;

/// Return the interfaces with an active cut of Coupling::deadline.
[[nodiscard]] std::uint64_t open_interfaces(const context::Model& model) noexcept;

/// Remove from a second system the interactions that would be cut if the given interfaces were
/// active. The cuts of the world do not change.
void remove_cut_interactions(context::Model& model, std::uint64_t interfaces,
                             assembly::System& beside);

// Functions for the world and its saved states.

/// True if an interaction can be cut: it is no drive, friction, range or winch, and does not load
/// friction.
[[nodiscard]] bool can_cut(const context::Model& model, std::int32_t id) noexcept;

/// True if the world makes groups automatically (WorldDef::parts).
[[nodiscard]] bool makes_groups(const context::Model& model) noexcept;

/// Set Cuts::group from the parts and the groups of the user. @return number of bodies that change
/// their group.
std::int64_t assign_groups(context::Model& model);

/// Set the multipliers of duplicated interactions to those of their originals.
void follow_cuts(context::Model& model) noexcept;

/// Build the graph of the user's model for a partition. @throws std::bad_alloc.
void read_graph(const context::Model& model, assembly::PartGraph& graph);

/// Set the weights from the state; rows are evaluated at the present poses. The state does not
/// change. The system must have been analysed. @throws std::bad_alloc.
void weigh_graph(context::Model& model, assembly::PartGraph& graph);

}  // namespace hawser::split
