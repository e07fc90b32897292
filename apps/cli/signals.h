// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file signals.h
/// Ctrl-C and termination as a request that long work checks between steps, and that ends the step
/// under way.

namespace hawser {
class World;
}

namespace hawser::cli {

/// From now on SIGINT and SIGTERM only set a flag. A second one ends the program at once.
void catch_signals() noexcept;
[[nodiscard]] bool stop_requested() noexcept;

/// While it lives, such a signal also cancels the step of this world (World::cancel()). One at a
/// time; the world stays where it is.
class CancelledBySignal {
  public:
    explicit CancelledBySignal(World& world) noexcept;
    ~CancelledBySignal();
    CancelledBySignal(const CancelledBySignal&) = delete;
    CancelledBySignal& operator=(const CancelledBySignal&) = delete;
};

}  // namespace hawser::cli
