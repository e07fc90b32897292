// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Which elements and lumps make up a wire, by topology, and what wires remember from step to step.
/// The guard over their energy is told of in guard.h.

#include "context/context.h"

namespace hawser::stepper {

/// Find the wires, after bodies or interactions were added. @throws std::bad_alloc.
void make_wires(Model& model, const State& state, WireWork& work);

/// Whether the guard looks at this step at all: sides of cuts have energy that crosses the cut, and
/// without geometric stiffness there is nothing to be more careful with.
[[nodiscard]] bool on_guard(const Model& model) noexcept;

/// Rows that gave way in a step that was not taken follow their law again.
void release_wires(Model& model) noexcept;

/// What the step that is being taken leaves for the next ones: gains, and recoils that end.
void remember_gains(Model& model) noexcept;

}  // namespace hawser::stepper
