// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file regroup.h
/// Groups of bodies that the world makes itself and that follow its state (docs/partition.md).
///
/// Where WorldDef::parts is above 0 and some coupling is not exact, every body without a group by
/// hand gets one: a part of about equal cost, cut where the interactions may be cut and where
/// forces, velocities and violations are least. A *round* chooses:
/// ```
///     step     0            kSettle             2 regroup_every · … from 0 on
///     by       model alone  weights, all anew   weights, beside the parts there are:
///                                               at most one cut moves (graph/split.h)
/// ```
/// Only where a body changes its group are cuts made anew and the system analysed. Rounds depend on
/// the state alone: costs are those of the model, since those of an analysis would depend on the
/// cuts there are, and rows are evaluated at the present poses.

#include <hawser/stats.h>

#include "assembly/parts.h"
#include "context/context.h"
#include "graph/partition.h"
#include "graph/split.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// The model of the user as a graph, for all who choose parts. @throws std::bad_alloc.
void read_graph(StepContext& ctx, assembly::PartGraph& graph);
/// Weights of the state, rows evaluated at the present poses; the state stays as it is. The system
/// must have been analysed.
/// @throws std::bad_alloc.
void weigh_graph(StepContext& ctx, assembly::PartGraph& graph);

/// Part of prepare(), before cuts are made: groups from the model where there are none or where
/// they no longer belong to it. @throws std::bad_alloc.
void make_groups(StepContext& ctx);

/// Cuts::group from the parts and the groups by hand. @return bodies that change theirs.
std::int64_t assign_groups(StepContext& ctx);

/// Stage graph: the round that is due, if any; new cuts, and stage analyse, where groups changed.
/// The state stays as it is where memory ends.
[[nodiscard]] Status regroup(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
