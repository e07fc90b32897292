// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file message_fields.h
/// Read fields of a client's message: numbers within a range, vectors, switches. Invalid fields are
/// rejected with a reason.

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hawser::live {

using Json = nlohmann::json;

/// A rejected message; `what()` is the reason.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// 2^53: whole numbers up to this are exact in a double.
inline constexpr double kMaxWhole = 9007199254740992.0;

/// Return the first bytes of a text, cut between two characters of UTF-8.
[[nodiscard]] std::string_view shortened(std::string_view text, std::size_t most);
/// Return a JSON string of valid UTF-8; invalid bytes are replaced.
[[nodiscard]] std::string json_string(std::string_view text);
/// Return a text in quotes, cut after 60 bytes.
[[nodiscard]] std::string in_quotes(std::string_view text);

// Read a field. Each function @throws Refused if the key is missing or its value is out of range.
[[nodiscard]] double number(const Json& from, const char* key, double least, double most);
[[nodiscard]] double number_or(const Json& from, const char* key, double least, double most,
                               double otherwise);
[[nodiscard]] double read_integer(const Json& from, const char* key, double least, double most);
[[nodiscard]] bool read_switch(const Json& from, const char* key);
/// Read the coordinates of a point [m], each within 10,000 km.
[[nodiscard]] std::array<double, 3> vector(const Json& from, const char* key);

/// Parse a message as JSON. Return a discarded value if it is invalid. @throws Refused for
/// duplicate keys, of which the JSON reader would silently use the last.
[[nodiscard]] Json parse_message(std::string_view text);

}  // namespace hawser::live
