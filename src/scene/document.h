// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file document.h
/// From a parsed file to one self-contained document: includes merged, options applied, the
/// stored state read in, the shape checked.

#include "scene/format.h"
#include "scene/mistakes.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hawser::scene {

struct Document {
    Json root;    ///< Self-contained.
    Place place;  ///< Of the scene itself.
    /// Where the entries that came from other files stand, by name.
    std::map<std::string, Place, std::less<>> line_types;
    std::map<std::string, Place, std::less<>> templates;
    std::map<std::string, Place, std::less<>> materials;
    Place operations;              ///< Of the entries of "timeline" that came from a file …
    std::size_t own_operations{};  ///< … which are those from this one on.
    Place state;                   ///< Of the state's "bodies".
    std::vector<std::filesystem::path> files;  ///< Read beside the scene's own.
    std::filesystem::path state_file;          ///< Of these; empty: none.
    Mistakes* mistakes = nullptr;  ///< Where mistakes are taken down; null: they are thrown.
};

/// @param mistakes  Where they are taken down; null: the first is thrown. @throws SceneError.
[[nodiscard]] Document make_document(Json root, const std::filesystem::path& file,
                                     const Options& options, Mistakes* mistakes = nullptr);

/// Meshes of hulls that are in files (hull_files.cpp).
void read_hull_files(Document& document, const std::filesystem::path& file);

/// Apply one "path=value" (see Options::set). @throws SceneError.
void apply_override(Json& root, const std::string& option, const Place& place);

}  // namespace hawser::scene
