// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file read_json.h
/// Text to JSON value, with limits, and the file access of the scene reader.

#include "scene/error.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace hawser::scene {

class Mistakes;  // mistakes.h

/// Objects keep their keys sorted, so a value has one text.
using Json = nlohmann::json;

inline constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;
inline constexpr int kMaxNesting = 64;

/// Parse a document. Refuses what JSON does not allow (comments, NaN, Infinity, damaged
/// UTF-8), keys given twice in one object, numbers beyond the range of double, deep nesting.
/// Refuses too many values while it reads, before a document is kept. A file of another kind is
/// named as such, with the remedy (base/file_kind.h).
/// @param keys  Of the outermost object: of others few values are read.
/// @param expected  With its article. @throws SceneError with line and column.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& file,
                              const std::set<std::string>& keys, Mistakes* mistakes = nullptr,
                              const char* expected = "a scene");

/// Read and parse a file. @throws SceneError when it cannot be read or is too large.
[[nodiscard]] Json read_json_file(const std::filesystem::path& file,
                                  const std::set<std::string>& keys, Mistakes* mistakes = nullptr,
                                  const char* expected = "a scene");

/// @throws SceneError where the document is one of another kind, such as an exercise.
void refuse_other_kind(const Json& root, const std::string& file, const char* expected);

/// Resolve a file name found at `place`, relative to `base`, and refuse it when it leaves the
/// folder `root` (links followed) or does not exist.
[[nodiscard]] std::filesystem::path resolve_inside(const std::filesystem::path& root,
                                                   const std::filesystem::path& base,
                                                   const std::string& name, const Place& place);

/// Short description of a value for messages: `3.5`, `"text"`, `an array of 4`.
[[nodiscard]] std::string describe(const Json& value);

}  // namespace hawser::scene
