// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file read_json.h
/// Convert text to a JSON value, with limits, and read files for the scene reader.

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

/// Parse a document. Rejects invalid JSON (comments, NaN, Infinity, damaged UTF-8), duplicate keys
/// in an object, numbers beyond the range of double, and deep nesting. Rejects too many values
/// during parsing, before the document is stored. The message about a file of another kind names
/// the kind and the remedy (base/file_kind.h). @param keys  Known keys of the outermost object; few
/// values of other keys are read. @param expected  Expected kind, with its article. @throws
/// SceneError with line and column.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& file,
                              const std::set<std::string>& keys, Mistakes* mistakes = nullptr,
                              const char* expected = "a scene");

/// Read and parse a file. @throws SceneError if it cannot be read or is too large.
[[nodiscard]] Json read_json_file(const std::filesystem::path& file,
                                  const std::set<std::string>& keys, Mistakes* mistakes = nullptr,
                                  const char* expected = "a scene");

/// Reject a document of another kind, such as an exercise. @throws SceneError.
void check_document_kind(const Json& root, const std::string& file, const char* expected);

/// Resolve a file name found at `location`, relative to `base`. Reject it if it leaves the folder
/// `root` (links followed) or does not exist.
[[nodiscard]] std::filesystem::path resolve_inside(const std::filesystem::path& root,
                                                   const std::filesystem::path& base,
                                                   const std::string& name,
                                                   const SourceLocation& location);

/// Return a short description of a value for messages: `3.5`, `"text"`, `an array of 4`.
[[nodiscard]] std::string describe(const Json& value);

}  // namespace hawser::scene
