// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file verdict_text.h
/// Describe World::verdict() in words.

#include <hawser/hawser.h>

#include <array>
#include <string>

namespace hawser::report {

/// A verdict with the names of the affected objects.
struct VerdictText {
    Verdict verdict{};
    std::array<std::string, kJudgeCount>
        where{};  ///< Affected object of each monitor; "": the whole scene.
    std::string
        description;  ///< Description of a failed or suspect result with place, time and remedy;
                      ///< "" if good.
};
[[nodiscard]] VerdictText verdict_in_words(const World& world, const Verdict& verdict);

/// Return the monitors with their fractions of the limits, for a report.
[[nodiscard]] std::string margins(const VerdictText& text);

}  // namespace hawser::report
