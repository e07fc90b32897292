// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control.h
/// Input values over time from a CSV file.
///
/// First line `time,<input name>,<input name>,…`; then one line per moment, times ascending.
/// A value holds from its time on until the next. An empty field leaves the input as it is.
/// Lines that are empty or begin with # are skipped.

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

/// what() = "file:line:column: message".
struct ControlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What an input takes.
struct ControlRange {
    double min = -1e300, max = 1e300;
    std::string unit{};  ///< For messages.
};

struct ControlChange {
    double time = 0.0;  ///< [s]
    std::int32_t input = 0;
    double value = 0.0;
};

/// @param inputs Names of the world's inputs in their order.
/// @param ranges Of each; empty: none has one. @throws ControlError, for what is not within it too.
[[nodiscard]] std::vector<ControlChange> read_control(const std::filesystem::path& file,
                                                      std::span<const std::string> inputs,
                                                      std::span<const ControlRange> ranges = {});
[[nodiscard]] std::vector<ControlChange> parse_control(std::string_view text,
                                                       const std::string& file,
                                                       std::span<const std::string> inputs,
                                                       std::span<const ControlRange> ranges = {});

}  // namespace hawser::record
