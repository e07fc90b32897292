// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bindings.h
/// Parts of the module hawser._core.

#include "box.h"

namespace hawser::python {

using WorldClass = py::class_<WorldBox, std::shared_ptr<WorldBox>>;

/// State of a world: structure and dynamic state (World::structure(), World::save()).
struct SavedState {
    std::shared_ptr<const Structure> structure;  ///< Null after unpickling.
    std::vector<std::byte> bytes;
    std::uint64_t identity = 0;
    double time = 0.0;
};
/// Save the state of a world.
SavedState save_state(World& world);
/// Restore a state. @throws DefError.
void restore_state(World& world, const SavedState& state);

/// Translate exceptions of the library to those of hawser.errors.
void bind_errors();
/// Add the classes Body, Interaction, … .
void bind_handles(py::module_& module);
/// Add the class World without its set-up.
WorldClass bind_world(py::module_& module);
/// Add the methods World.add_…().
void bind_definitions(WorldClass& world);
void bind_session(py::module_& module);
void bind_recording(py::module_& module);

}  // namespace hawser::python
