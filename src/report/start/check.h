// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file check.h
/// Looks at the start of a scene before its first step: what is impossible, and what the step will
/// not resolve. docs/limits.md says what is found, and what is not.

#include "record/scene_info.h"
#include "report/start/findings.h"

#include <hawser/hawser.h>

namespace hawser::report::start {

/// Rows of joints above which they are not compared with each other: a few seconds and some hundred
/// megabytes.
inline constexpr std::size_t kMostRows = 600'000;

/// All there is to find, sorted. The world stays as it is. @throws std::bad_alloc.
[[nodiscard]] Findings check_start(const record::SceneInfo& scene, const World& world,
                                   std::size_t most_rows = kMostRows);

}  // namespace hawser::report::start
