// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file told.h
/// What happened in a step, and why a step failed, for clients.

#include "live/outbox.h"

#include <hawser/world.h>

#include <span>
#include <string>

namespace hawser::live {

/// Events of one step, the rarest kinds first told in full: of `slack` and `taut` at most 8, of all
/// 64, and how many more there were.
void tell_events(const World& world, std::span<const Event> events, Outbox& out);

/// An event in words, such as "work1/s3 (work1 at 12.5 m) parted at 3.4 MN".
[[nodiscard]] std::string event_words(const std::string& where, EventKind kind, double value);

/// Why the last step failed, where, and what to do.
struct Failure {
    double time = 0.0;  ///< At which the failed step began [s].
    std::string status, element, reason, remedy;
};
[[nodiscard]] Failure failure_of(const World& world, Status status);

}  // namespace hawser::live
