// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_difference.h
/// Compare two resolved scene documents (scene::Scene::text): numbers that differ, and the first
/// other difference.

#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

struct SceneDifferences {
    /// Numbers that differ: "/bodies/3/mass: 100 -> 120", in the order of the document.
    std::vector<std::string> numbers;
    /// First difference other than a number, with its path; "": none. Names and descriptions of the
    /// scene, the plotted objects and the duration do not count.
    std::string structure;
};

/// Compare two scene documents. @throws std::runtime_error if a text is not JSON.
[[nodiscard]] SceneDifferences compare_scenes(std::string_view before, std::string_view now);

}  // namespace hawser::record
