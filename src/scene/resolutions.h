// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resolutions.h
/// Numbers of a cable's resolution in a scene. Format and reader use one table.

#include <hawser/resolution.h>

#include <span>

namespace hawser::scene {

struct ResolutionNumber {
    const char* key;
    double ResolutionDef::* value;
    const char* unit;
    const char* fallback;  ///< In words.
    const char* doc;
    double least, most;
};
struct ResolutionCount {
    const char* key;
    int ResolutionDef::* value;
    const char* fallback;  ///< In words.
    const char* doc;
    double least, most;
};

[[nodiscard]] std::span<const ResolutionNumber> resolution_numbers() noexcept;
[[nodiscard]] std::span<const ResolutionCount> resolution_counts() noexcept;

}  // namespace hawser::scene
