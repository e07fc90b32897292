// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file debriefing.h
/// The message `debriefing`: score, entries and displays of an exercise over time, for the time
/// line of the page (docs/live.md).

#include <hawser/exercise.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace hawser::live {

/// Debriefing of a recorded exercise, for Player.
struct Debriefing {
    std::string text{};  ///< Message `debriefing`; "": the recording is of no exercise.
    /// Write the report (HTML). @param people  Names and date for its heading.
    std::function<std::string(const std::string& people)> report{};
};

/// Return the message `debriefing` of the protocol. Points are those of `result`, unrounded. Curves
/// have about `most` samples. Only the first 16 × `most` requests to controls are included.
[[nodiscard]] nlohmann::json debriefing_json(const exercise::Exercise& exercise,
                                             const exercise::Result& result,
                                             const exercise::Curves& curves,
                                             const std::vector<exercise::ControlRequest>& requests,
                                             std::size_t most = 1200);

}  // namespace hawser::live
