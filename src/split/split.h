// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file split.h
/// Splits, as all other rooms meet them: they include nothing else of this room. Interactions
/// between groups of bodies may be *cut*, so that the groups become islands of their own
/// (docs/partition.md; docs/methods.md, 10). A step calls these functions where it passes by:
/// ```
///     preparation   may_split, split_model      images and copies for the groups there are
///     (cuts.h) graph         regroup                     groups that the world makes itself follow
///     its state analyse       analyse, relink             which cuts are in force; then the system
///     assemble      place_images, predict       where the other sides of cuts are, and go
///                   keep_touch                  contacts of the last step, for predictors
///     integrate     finish_cuts                 one multiplier for readers; what cuts left open
///                   part_all                    a line parts with all its copies
/// ```
/// Of a world in which nothing is cut each of them is what an exact step needs, or nothing.

#include <hawser/stats.h>

#include "assembly/parts.h"
#include "context/context.h"

#include <cstdint>

namespace hawser::stepper {

// Preparation.

/// Whether there are images and copies, or would be after split_model().
[[nodiscard]] bool may_split(const Model& model) noexcept;

/// Groups where they are to be made and there are none, or where they no longer belong to the
/// model; then images and copies for the groups and couplings there are. @throws std::bad_alloc.
void split_model(StepContext& ctx);

/// Images and copies away, as must be before bodies or interactions come or go; groups that the
/// world makes are made again for what there is then.
void join_model(Model& model) noexcept;

// Stages of a step.

/// Stage graph: the round that is due, if any; new cuts, and stage analyse, where groups changed.
/// The state stays as it is where memory ends.
[[nodiscard]] Status regroup(StepContext& ctx) noexcept;

/// Stage analyse: the system for the interactions and links there are, without what is cut.
/// @param state  Of the analysis of a saved world, to go on from. @throws std::bad_alloc.
void analyse(StepContext& ctx, const factor::AnalysisState* state = nullptr);

/// Stage analyse where bodies touch that did not before: only links of contacts change, unless
/// other cuts come into force by that. @throws std::bad_alloc; prepare() then.
void relink(StepContext& ctx);

/// Images where their bodies are.
void place_images(Model& model) noexcept;

/// Before rows are assembled: images where their bodies are, at the velocities that the predictor
/// of the world (WorldDef::predictor) gives.
void predict(Model& model, const State& state) noexcept;

/// Impulses of contacts in the last step, by body, for predictors; nothing without cuts.
/// @param room  Three numbers for each triple of contacts and resistances.
void keep_touch(Model& model, std::vector<double>& room) noexcept;

/// After the solve, before bodies move: multipliers for readers, which are the means of the sides,
/// and what the cuts left open.
void finish_cuts(StepContext& ctx) noexcept;

/// A line parted; if it is cut, with all copies.
void part_all(Model& model, std::int32_t id) noexcept;

// What deadlines ask for (budget).

/// Have these interfaces in force, see Degradation::cuts, and analyse if that changes a cut.
[[nodiscard]] Status ask_for_cuts(StepContext& ctx, std::uint64_t interfaces) noexcept;

/// Interfaces with a cut of Coupling::deadline in force.
[[nodiscard]] std::uint64_t open_interfaces(const Model& model) noexcept;

/// Have a system beside that of the world leave out what would be cut if these interfaces were
/// asked for; the cuts of the world are those that were in force afterwards.
void leave_out(Model& model, std::uint64_t interfaces, assembly::System& beside);

// What the world and its saved states ask for.

/// Whether an interaction is one that can be cut: no drive, friction, range or winch, nor what
/// loads friction.
[[nodiscard]] bool can_cut(const Model& model, std::int32_t id) noexcept;

/// Whether the world makes groups itself (WorldDef::parts).
[[nodiscard]] bool makes_groups(const Model& model) noexcept;

/// Cuts::group from the parts and the groups by hand. @return bodies that change theirs.
std::int64_t assign_groups(Model& model);

/// Multipliers of copies become those of what they stand for.
void follow_cuts(Model& model) noexcept;

/// The model of the user as a graph, for all who choose parts. @throws std::bad_alloc.
void read_graph(const Model& model, assembly::PartGraph& graph);

/// Weights of the state, rows evaluated at the present poses; the state stays as it is. The system
/// must have been analysed. @throws std::bad_alloc.
void weigh_graph(Model& model, assembly::PartGraph& graph);

}  // namespace hawser::stepper
