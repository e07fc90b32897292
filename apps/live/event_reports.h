// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file event_reports.h
/// Report the events of a step, and the cause of a failed step, to clients.

#include "live/outbox.h"

#include <hawser/world.h>

#include <span>
#include <string>

namespace hawser::live {

/// Send the events of one step, the rarest kinds first. At most 64 events are sent, with at most 8
/// of `slack` and `taut`; the others are counted.
void send_events(const World& world, std::span<const Event> events, Outbox& out);

/// Return an event in words, such as "work1/s3 (work1 at 12.5 m) broke at 3.4 MN".
[[nodiscard]] std::string event_words(const std::string& where, EventKind kind, double value);

/// Cause of the last step's failure, its source and the remedy.
struct Failure {
    double time = 0.0;  ///< Time at which the failed step began [s].
    std::string status, element, reason, remedy;
};
[[nodiscard]] Failure failure_of(const World& world, Status status);

}  // namespace hawser::live
