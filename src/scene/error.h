// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file error.h
/// Locate values in files, report mistakes, and find the nearest valid name.

#include <hawser/def.h>
#include <hawser/scene.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::scene {

/// A position in a file: the file and a JSON pointer into it.
struct SourceLocation {
    std::string file;
    std::string path;  ///< JSON pointer; "" is the document.

    [[nodiscard]] SourceLocation operator/(std::string_view key) const;
    [[nodiscard]] SourceLocation operator/(std::size_t index) const;
};

/// Return one reference token of a JSON pointer, with its leading slash (RFC 6901, section 3).
[[nodiscard]] std::string pointer_token(std::string_view key);

/// Throw an error at a place of the document. @throws SceneError always.
[[noreturn]] void throw_error(const SourceLocation& location, const std::string& message);

/// Return the reason in an error of the library, "hook 'NAME': loads/0/eyes: why". The result has
/// no name, because the place in the file identifies the object.
[[nodiscard]] std::string library_words(const DefError& error);

/// Parts of library_words() that begin with the path of a field, "loads/0/eyes: why".
struct FieldWords {
    std::string path;  ///< Path of the field; empty: the message names none.
    std::string words;
};
[[nodiscard]] FieldWords field_words(const DefError& error);

/// Report an error below the place, at the field in the message of the library. @throws SceneError
/// always.
[[noreturn]] void throw_field_error(const SourceLocation& location, const FieldWords& said);

/// Return the end of a message about an unknown name. It is `; did you mean "x"?` if a known name
/// is near. Else it is the list of known names if that is short, else "".
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> known);

/// Return a text in double quotes, shortened if it is long, for messages.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace hawser::scene
