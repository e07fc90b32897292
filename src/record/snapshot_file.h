// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file snapshot_file.h
/// A saved state in a file that identifies its scene (docs/recording.md).

#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <filesystem>
#include <stdexcept>

namespace hawser::record {

/// `what()` begins with the file.
struct SnapshotError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Save the state of a world to a file.
/// @param with_structure  True if the objects of the world differ from those of its scene at the
///         start.
/// @throws SnapshotError if the file cannot be written.
void save_snapshot(const std::filesystem::path& file, const SceneInfo& scene, const World& world,
                   bool with_structure = false);

/// Continue from a saved state. The numbers of the scene may differ from the saved ones, except the
/// step. No number may differ if the run had edited the world (WorldState::restore_variant).
/// @return the numbers that differ, "/bodies/3/mass: 100 -> 120". @throws SnapshotError if the file
/// is damaged, or if its scene has another structure, with the first difference. The world is then
/// unchanged.
std::vector<std::string> restore_snapshot(const std::filesystem::path& file, const SceneInfo& scene,
                                          World& world);

}  // namespace hawser::record
