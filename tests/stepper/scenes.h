// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scenes.h
/// The committed scenes, for properties that every scene must have.

#include <hawser/scene.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace hawser::test {

/// Return scene files of the repository, sorted.
inline std::vector<std::filesystem::path> scene_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".json" && name.find(".settled.") == std::string::npos)
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace hawser::test
