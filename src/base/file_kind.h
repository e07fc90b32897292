// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file file_kind.h
/// Recognises files of another kind than expected, for messages that name the remedy.
///
/// Binary kinds are recognised by their first bytes, XML by its first element, JSON by its keys at
/// the top level, MoorDyn by its headings. A kind is guessed from text only after a reader rejected
/// the file.

#include <string>
#include <string_view>

namespace hawser::base {

enum class FileKind : unsigned char {
    unknown,  ///< None of the others, or JSON of no known kind.
    empty,
    // Files of Hawser.
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
    // JSON with deviations from the standard.
    json_comments,
    json_comma,
    // Binary files.
    utf16,
    compressed,
    picture,
    hdf5,
    netcdf,
    binary,
};

/// Return the kind of a file from its content.
[[nodiscard]] FileKind file_kind(std::string_view content);

/// Describe the mismatch, e.g. "this is a recording, not a scene; `hawser view a.hwr` plays it".
/// @param expected  Expected kind with its article: "a scene". @param file  File name as the user
/// wrote it. @return "" for FileKind::unknown, and if the file is of the expected kind.
[[nodiscard]] std::string file_kind_error(std::string_view content, std::string_view expected,
                                          const std::string& file);

/// Return file_kind_error(), with `fallback` instead of "".
[[nodiscard]] std::string file_kind_error_or(std::string_view content, std::string_view expected,
                                             const std::string& file, const char* fallback);

}  // namespace hawser::base
