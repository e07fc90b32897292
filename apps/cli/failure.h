// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file failure.h
/// Describe a failed step.

#include <hawser/world.h>

#include <string>

namespace hawser::cli {

/// Describe the failure of a world's last step. The text contains the status. For a load, an input
/// or an edit of a system it names the system, the body and the error. For a limit it states the
/// value and the remedy.
[[nodiscard]] std::string failure(const World& world);

}  // namespace hawser::cli
