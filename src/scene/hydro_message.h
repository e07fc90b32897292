// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro_message.h
/// Coefficients as bytes between the reader program and the program that started it
/// (hydro_reader.cpp). Both run on one machine: numbers have its layout.
/// ```
///     magic  kind 0  text                                        an error
///     magic  kind 1  counts[7]  flags  matrices and tables       coefficients
/// ```
#include <hawser/hydro.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hawser::scene {

/// Largest size of a message. All tables that coefficients_fault() accepts fit.
inline constexpr std::size_t kMaxHydroMessage = std::size_t{512} << 20;

[[nodiscard]] std::vector<char> message_of(const WaveCoefficients& c);
[[nodiscard]] std::vector<char> message_of_error(const std::string& text);

struct HydroMessage {
    std::string error{};  ///< Printable text; empty: `value` is valid.
    WaveCoefficients value{};
};
/// Decode a message. Any bytes are safe. @return nullopt if the bytes are no message.
[[nodiscard]] std::optional<HydroMessage> read_message(std::span<const char> bytes);

}  // namespace hawser::scene
