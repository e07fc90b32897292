// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Elements and nodes of each wire, by topology, and the memory of wires between steps. guard.h
/// describes the check of their energy.

#include "context/context.h"

namespace hawser::solve {

/// Find the wires, after bodies or interactions were added.
/// @throws std::bad_alloc.
void make_wires(context::Model& model, const context::State& state, context::WireWork& work);

/// Return true if the guard checks this step. It does not with cuts, whose energy crosses the cut,
/// nor without geometric stiffness, which its measures need.
[[nodiscard]] bool on_guard(const context::Model& model) noexcept;

/// Undo the replacement of rows after a rejected step, so that they follow their law again.
void release_wires(context::Model& model) noexcept;

/// Store results of the current step for later steps: the gains of wires and the ends of recoils.
void remember_gains(context::Model& model) noexcept;

}  // namespace hawser::solve
