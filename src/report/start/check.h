// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file check.h
/// Check the start of a scene before its first step. Find impossible values and motions that the
/// step cannot resolve. docs/limits.md lists the findings and their limits.

#include "record/scene_info.h"
#include "report/start/findings.h"

#include <hawser/hawser.h>

namespace hawser::report::start {

/// Number of joint rows above which redundancy is not checked. At this size the check needs a few
/// seconds and some hundred megabytes.
inline constexpr std::size_t kMaxRows = 600'000;

/// Return all findings, sorted. The world stays unchanged. @throws std::bad_alloc.
[[nodiscard]] Findings check_start(const record::SceneInfo& scene, const World& world,
                                   std::size_t max_rows = kMaxRows);

}  // namespace hawser::report::start
