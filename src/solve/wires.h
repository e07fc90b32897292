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

/// True if the energy check of wires runs in this step. It is off with cuts, whose energy crosses
/// the cut, and without geometric stiffness, which its measures need.
[[nodiscard]] bool on_guard(const context::Model& model) noexcept;

/// Undo the replacement of rows after a rejected step, so that they follow their law again.
void release_wires(context::Model& model) noexcept;

/// Store the energy gains of wires and the ends of recoils in the current step, for later steps.
void remember_gains(context::Model& model) noexcept;

}  // namespace hawser::solve
