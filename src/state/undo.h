// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file undo.h
/// Restore the state of the last successful step after any failure: allocation, a limit, a
/// cancelled step, divergence.
///
/// Most of a step writes nothing of the state before stage integrate, which cannot fail. Earlier
/// changes are saved first:
/// 1. Velocities are saved before an impact or the staggered start changes them, and poses before
/// an impact does.
/// 2. The initial data of the analysis are saved before the system changes. This happens if bodies
/// touch for the first time, fall asleep, wake, change group or are added.
///
/// Restoring allocates nothing. The system itself is not saved, because a copy would double its
/// memory. It is *repaired* before its next use to the same bits, like that of a restored world
/// (factor::AnalysisState).
///
/// Limits: contacts, residuals and times that a step reports stay those of the failed step.

#include "context/context.h"
#include "context/undo_data.h"

namespace hawser::state {

/// Reserve the capacity to save motions without an allocation. @throws std::bad_alloc.
void reserve_undo(const context::Model& model, context::Undo& undo);
/// Save the motion. Call before v, λ or spin_change change outside stage integrate; later calls in
/// a step do nothing.
void save_motion(context::StepContext& ctx) noexcept;
/// Save the poses. Call before poses change outside stage integrate, in a world with shapes.
void save_poses(context::StepContext& ctx) noexcept;
/// Save the step in which each link was used last. @throws std::bad_alloc if the number of links
/// has grown.
void save_link_steps(const context::Model& model, context::Undo& undo);
/// Save the state before the system changes. @throws std::bad_alloc; nothing has changed then.
void save_state(context::StepContext& ctx, context::Undo::Depth depth);
/// Restore all saved values. A value saved several times gets the one that was saved first.
void restore_saved_values(context::StepContext& ctx) noexcept;
/// Discard the saved values after a successful step.
void discard_saved(context::Undo& undo) noexcept;

}  // namespace hawser::state
