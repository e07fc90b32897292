// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file undo.h
/// The way back to the state of the last good step, for whatever fails: memory that ends, a bound,
/// a step that is cancelled or diverges.
///
/// Most of a step writes nothing of the state before stage integrate, which cannot fail. What comes
/// earlier is kept first: velocities before an impact or the staggered start changes them, and
/// before the system changes (bodies touch for the first time, fall asleep or wake, groups move,
/// something was added) what the analysis goes on from. To go back allocates nothing. The system
/// itself is not kept, it would take as much again: it is *mended* before it is needed next, like
/// that of a restored world, to the same bits (factor::AnalysisState).
///
/// Limits: what a step computes for readers (contacts, residuals, times) is that of the step that
/// failed.

#include "context/context.h"
#include "context/undo_data.h"

namespace hawser::stepper {

/// Room to keep motions without allocating. @throws std::bad_alloc.
void reserve_undo(const Model& model, Undo& undo);
/// Before v, λ or spin_change change outside stage integrate; later calls keep nothing more.
void keep_motion(StepContext& ctx) noexcept;
/// Steps in which links were used last. @throws std::bad_alloc where there are more of them.
void keep_links(const Model& model, Undo& undo);
/// Before the system changes. @throws std::bad_alloc, and nothing has changed then.
void keep_state(StepContext& ctx, Undo::Depth depth);
/// Everything as it was when it was kept first.
void restore_kept(StepContext& ctx) noexcept;
/// The step has succeeded: forget what restore_kept() would have brought back.
void drop_kept(Undo& undo) noexcept;

}  // namespace hawser::stepper
