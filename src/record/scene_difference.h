// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_difference.h
/// Compares two resolved scene documents (scene::Scene::text): which numbers differ, and whether
/// anything else does.

#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

struct SceneDifferences {
    /// Numbers that differ: "/bodies/3/mass: 100 -> 120", in the order of the document.
    std::vector<std::string> numbers;
    /// The first difference that is none of a number, with its path; "": there is none. Names and
    /// descriptions of the scene, what is plotted and the duration do not count.
    std::string structure;
};

/// @throws std::runtime_error where a text is no JSON.
[[nodiscard]] SceneDifferences compare_scenes(std::string_view before, std::string_view now);

}  // namespace hawser::record
