// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file signals.h
/// Ctrl-C and termination as a request that long work checks between steps.

namespace hawser::cli {

/// From now on SIGINT and SIGTERM only set a flag. A second one ends the program at once.
void catch_signals() noexcept;
[[nodiscard]] bool stop_requested() noexcept;

}  // namespace hawser::cli
