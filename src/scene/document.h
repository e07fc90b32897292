// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file document.h
/// Convert a parsed file to one self-contained document: merge includes, apply options, read the
/// stored state, check the shape.

#include "scene/format.h"
#include "scene/mistakes.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hawser::scene {

struct Document {
    Json root;                ///< Self-contained.
    SourceLocation location;  ///< Place of the scene itself.
    /// Places of the entries that came from other files, by name.
    std::map<std::string, SourceLocation, std::less<>> line_types;
    std::map<std::string, SourceLocation, std::less<>> templates;
    std::map<std::string, SourceLocation, std::less<>> materials;
    SourceLocation operations;     ///< Place of the entries of "timeline" that came from a file …
    std::size_t own_operations{};  ///< … whose index is ≥ this one.
    SourceLocation state;          ///< Place of the state's "bodies".
    std::vector<std::filesystem::path>
        files;                         ///< Files that were read in addition to the scene's own.
    std::filesystem::path state_file;  ///< File of the state, among these; empty: none.
    Mistakes* mistakes = nullptr;      ///< List for mistakes; null: mistakes are thrown.
};

/// Make a document. @param mistakes  List for mistakes; null: the first is thrown. @throws
/// SceneError.
[[nodiscard]] Document make_document(Json root, const std::filesystem::path& file,
                                     const Options& options, Mistakes* mistakes = nullptr);

/// Read the meshes of hulls from files (hull_files.cpp).
void read_hull_files(Document& document, const std::filesystem::path& file);

/// Apply one option "path=value" (see Options::set). @throws SceneError.
void apply_override(Json& root, const std::string& option, const SourceLocation& location);

}  // namespace hawser::scene
