// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file message_fields.h
/// Fields of a client's message: numbers within a range, vectors, switches. Whatever a field is not
/// meant to be is refused in words.

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hawser::live {

using Json = nlohmann::json;

/// A message that is refused; what() says why.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// 2^53: whole numbers that a double can hold.
inline constexpr double kMostWhole = 9007199254740992.0;

/// The first bytes of a text, cut between two characters of UTF-8.
[[nodiscard]] std::string_view shortened(std::string_view text, std::size_t most);
/// A JSON string of valid UTF-8: what is none is replaced.
[[nodiscard]] std::string json_string(std::string_view text);
/// Quote a text, cut after 60 bytes.
[[nodiscard]] std::string in_quotes(std::string_view text);

// Read a field: each @throws Refused where the key is missing or its value out of range.
[[nodiscard]] double number(const Json& from, const char* key, double least, double most);
[[nodiscard]] double number_or(const Json& from, const char* key, double least, double most,
                               double otherwise);
[[nodiscard]] double whole(const Json& from, const char* key, double least, double most);
[[nodiscard]] bool switched(const Json& from, const char* key);
/// Read the coordinates of a place [m], each within 10,000 km.
[[nodiscard]] std::array<double, 3> vector(const Json& from, const char* key);

/// Parse a message as JSON; discarded where it is none. Of two keys of one name the reader would
/// take the last without a word: @throws Refused.
[[nodiscard]] Json parsed(std::string_view text);

}  // namespace hawser::live
