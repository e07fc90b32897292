// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_ship_file.h
/// Read the data of ships for DNV-ST-0111 from JSON files (dp_capability.h).

#include <hawser/dp_capability.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::scene {

/// Data of a ship with its name.
struct NamedDpShip {
    std::string name{};
    DpShip ship{};
};

/// Return true if a file has the data of one ship by itself: an object without "bodies" whose key
/// "dp_capability" is an object. @throws SceneError if it cannot be read.
[[nodiscard]] bool is_dp_ship_file(const std::filesystem::path& file);
/// Read a file with the data of one ship: {"name": NAME, "dp_capability": {…}}. @throws SceneError
[[nodiscard]] NamedDpShip load_dp_ship(const std::filesystem::path& file);

}  // namespace hawser::scene
