// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file failure.h
/// Why a step failed, in words.

#include <hawser/stats.h>

#include <string>

namespace hawser::cli {

/// The status, or the bound that was met with its value and the remedy.
[[nodiscard]] std::string failure(const StepStats& stats);

}  // namespace hawser::cli
