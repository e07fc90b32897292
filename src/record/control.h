// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control.h
/// Read input values over time from a CSV file.
///
/// The first line is `time,<input name>,<input name>,…`. Each further line has the values at one
/// time; times ascend.
/// A value applies from its time until the next one. An empty field leaves the input unchanged.
/// Lines that are empty or begin with # are skipped.

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

/// `what()` = "file:line:column: message".
struct ControlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Range of the values that an input accepts.
struct ControlRange {
    double min = -1e300, max = 1e300;
    std::string unit{};  ///< For messages.
};

struct ControlChange {
    double time = 0.0;  ///< Time from which the value applies [s].
    std::int32_t input = 0;
    double value = 0.0;
};

/// Read the values of a control file. @param inputs Names of the world's inputs in their order.
/// @param ranges Range of each input; empty: no input has a range. @throws ControlError, also if a
/// value is outside its range.
[[nodiscard]] std::vector<ControlChange> read_control(const std::filesystem::path& file,
                                                      std::span<const std::string> inputs,
                                                      std::span<const ControlRange> ranges = {});
[[nodiscard]] std::vector<ControlChange> parse_control(std::string_view text,
                                                       const std::string& file,
                                                       std::span<const std::string> inputs,
                                                       std::span<const ControlRange> ranges = {});

}  // namespace hawser::record
