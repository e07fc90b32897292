// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_ship_file.h
/// Reader of the data of ships for DNV-ST-0111 (dp_capability.h) from JSON files. Part of
/// hawser::scene.

#include <hawser/dp_capability.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::scene {

/// Data of a ship with its name.
struct NamedDpShip {
    std::string name{};  ///< Name of the ship.
    DpShip ship{};       ///< Data.
};

/// Return true if a file is the data of one ship and no scene: a JSON object without the key
/// "bodies", whose key "dp_capability" is an object.
/// @throws SceneError if the file cannot be read.
[[nodiscard]] bool is_dp_ship_file(const std::filesystem::path& file);
/// Read a file with the data of one ship: {"name": NAME, "dp_capability": {…}}.
/// @throws SceneError if the file cannot be read or is invalid.
[[nodiscard]] NamedDpShip load_dp_ship(const std::filesystem::path& file);

}  // namespace hawser::scene
