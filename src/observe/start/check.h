// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file check.h
/// Looks at the start of a scene before its first step: what is impossible, and what the step will
/// not resolve. docs/limits.md says what is found, and what is not.

#include "observe/scene_info.h"
#include "observe/start/findings.h"

#include <hawser/hawser.h>

namespace hawser::observe::start {

/// Rows of joints above which they are not compared with each other: a few seconds and some hundred
/// megabytes.
inline constexpr std::size_t kMostRows = 600'000;

/// All there is to find, sorted. The world stays as it is. @throws std::bad_alloc.
[[nodiscard]] Findings check_start(const SceneInfo& scene, const World& world,
                                   std::size_t most_rows = kMostRows);

}  // namespace hawser::observe::start
