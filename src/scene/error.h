// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file error.h
/// Where a value stands in a file, how a mistake is reported, and the nearest valid name.

#include <hawser/def.h>
#include <hawser/scene.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::scene {

/// A place in a file: the file and a JSON pointer into it.
struct Place {
    std::string file;
    std::string path;  ///< JSON pointer; "" is the document.

    [[nodiscard]] Place operator/(std::string_view key) const;
    [[nodiscard]] Place operator/(std::size_t index) const;
};

/// One reference token of a JSON pointer, with its leading slash (RFC 6901, section 3).
[[nodiscard]] std::string pointer_token(std::string_view key);

/// @throws SceneError always.
[[noreturn]] void refuse(const Place& place, const std::string& message);

/// What the library says against a definition, "hook 'NAME': loads/0/eyes: why": without the name,
/// which the place in the file tells.
[[nodiscard]] std::string own_words(const DefError& error);

/// own_words() that begin with the path of a field, "loads/0/eyes: why", taken apart.
struct FieldWords {
    std::string path;  ///< Empty: they name no field.
    std::string words;
};
[[nodiscard]] FieldWords field_words(const DefError& error);

/// Refuses below the place, at the field that the library names. @throws SceneError always.
[[noreturn]] void refuse_field(const Place& place, const FieldWords& said);

/// Smallest number of insertions, deletions, replacements and swaps of neighbours that turns
/// one text into the other (optimal string alignment).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// Ending of a message about a name that does not exist: `; did you mean "x"?` where a known
/// name is near, else the list of known names when it is short, else nothing.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> known);

/// Text in double quotes, shortened when long, for messages.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace hawser::scene
