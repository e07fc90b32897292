// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file snapshot_file.h
/// A saved state in a file that knows which scene it belongs to (docs/recording.md).

#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <filesystem>
#include <stdexcept>

namespace hawser::record {

/// what() begins with the file.
struct SnapshotError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @param with_structure  The world is made of other pieces than its scene at the start.
/// @throws SnapshotError when the file cannot be written.
void save_snapshot(const std::filesystem::path& file, const SceneInfo& scene, const World& world,
                   bool with_structure = false);

/// Continue from a saved state. The scene may differ in numbers from the one that was saved, but
/// for the step and where the run had changed what the world is made of (World::restore_variant).
/// @return the numbers that differ, "/bodies/3/mass: 100 -> 120". @throws SnapshotError when the
/// file is damaged or was saved from a scene of another structure, with the first difference; the
/// world is then unchanged.
std::vector<std::string> restore_snapshot(const std::filesystem::path& file, const SceneInfo& scene,
                                          World& world);

}  // namespace hawser::record
