// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file failure.h
/// Why a step failed, in words.

#include <hawser/world.h>

#include <string>

namespace hawser::cli {

/// Why the last step of a world failed: the status; of a load, an input or an edit of a system the
/// system, the body and what is wrong with it; or the bound that was met with its value and the
/// remedy.
[[nodiscard]] std::string failure(const World& world);

}  // namespace hawser::cli
