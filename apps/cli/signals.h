// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file signals.h
/// Convert Ctrl-C and termination to a request. Long tasks check it between steps, and it cancels
/// the present step.

namespace hawser {
class World;
}

namespace hawser::cli {

/// Let SIGINT and SIGTERM only set a flag from now on. A second signal ends the program at once.
void catch_signals() noexcept;
[[nodiscard]] bool stop_requested() noexcept;

/// During its lifetime such a signal also cancels the step of this world (World::cancel()). Only
/// one object may exist, and the world must not move.
class CancelledBySignal {
  public:
    explicit CancelledBySignal(World& world) noexcept;
    ~CancelledBySignal();
    CancelledBySignal(const CancelledBySignal&) = delete;
    CancelledBySignal& operator=(const CancelledBySignal&) = delete;
};

}  // namespace hawser::cli
