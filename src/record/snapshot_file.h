// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file snapshot_file.h
/// A saved state in a file that knows which scene it belongs to (docs/recording.md).

#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace hawser::record {

/// what() begins with the file.
struct SnapshotError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @param history  What was done to the structure of the scene's world since its start, as bytes of
/// apply_changes(), states included; empty: nothing. @throws SnapshotError when the file cannot be
/// written.
void save_snapshot(const std::filesystem::path& file, const SceneInfo& scene, const World& world,
                   std::span<const std::byte> history = {});

/// Continue from a saved state. @throws SnapshotError when the file is damaged or was saved
/// from another scene; the world is then unchanged.
/// @return the history.
std::vector<std::byte> restore_snapshot(const std::filesystem::path& file, const SceneInfo& scene,
                                        World& world);

}  // namespace hawser::record
