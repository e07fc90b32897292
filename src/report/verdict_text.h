// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file verdict_text.h
/// World::verdict() in words.

#include <hawser/hawser.h>

#include <array>
#include <string>

namespace hawser::report {

/// A verdict with the names of what it is about.
struct VerdictText {
    Verdict verdict{};
    std::array<std::string, kJudgeCount> where{};  ///< Of each judge; "" : the whole scene.
    std::string said;  ///< What is wrong or doubtful, where, when, and a remedy; "" where good.
};
[[nodiscard]] VerdictText in_words(const World& world, const Verdict& verdict);

/// The judges with the shares of their limits, for a report.
[[nodiscard]] std::string margins(const VerdictText& text);

}  // namespace hawser::report
