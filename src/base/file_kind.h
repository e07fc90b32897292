// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file file_kind.h
/// Recognises files that were given in place of another kind, for messages that name the remedy.
///
/// Binary kinds are recognised by their first bytes, XML by its first element, JSON by its keys at
/// the top, MoorDyn by its headings. A guess from text is made only after a reader refused it.

#include <string>
#include <string_view>

namespace hawser::base {

enum class FileKind : unsigned char {
    unknown,  ///< None of these, or JSON of no known kind.
    empty,
    // Hawser's own.
    scene,
    exercise,
    recording,
    snapshot,
    pose_state,  ///< Written by `hawser settle`.
    operations,
    control,
    summary,
    // Kinds of files that other programs write.
    moordyn,
    orcaflex,
    urdf,
    xacro,
    mjcf,
    sdf,
    xml,
    gltf,
    yaml,
    toml,
    // JSON that the standard does not allow.
    json_comments,
    json_comma,
    // Not text.
    utf16,
    compressed,
    picture,
    hdf5,
    netcdf,
    binary,
};

/// A file of any kind by its content.
[[nodiscard]] FileKind file_kind(std::string_view content);

/// E.g. "this is a recording, not a scene; `hawser view a.hwr` plays it". @param expected  With its
/// article: "a scene". @param file  As the user named it. @return "" of FileKind::unknown, and
/// where the file is what is expected.
[[nodiscard]] std::string wrong_kind(std::string_view content, std::string_view expected,
                                     const std::string& file);

/// The same, with a fallback in place of "".
[[nodiscard]] std::string wrong_kind_or(std::string_view content, std::string_view expected,
                                        const std::string& file, const char* fallback);

}  // namespace hawser::base
