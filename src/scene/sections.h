// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sections.h
/// Sections: lists of systems that need no code elsewhere in the reader.
///
/// A section is one line of section_list.h. From it follow the format, the schema, the reference
/// page, templates, copies ("repeat") and the world:
/// ```
///   scene file --item_shape()--> checked JSON --read_item()--> SectionItem --add(world)--> system
/// ```
/// Items refer to bodies, interactions and inputs by full name. A copy of the scene only has
/// another prefix. Items are added last, so that all other parts of the scene exist.
///
/// A new system with scene keys needs two files, its header and a source with its section, and the
/// line in section_list.h. pids.cpp is the worked example.

#include <hawser/world.h>

#include "scene/description.h"
#include "scene/field_reader.h"
#include "scene/field_shapes.h"
#include "scene/format.h"
#include "scene/section_list.h"

#include <string>
#include <vector>

namespace hawser::scene {

/// Add the items to a world in which all other parts exist.
void add_sections(World& world, const Description& from);

/// Return the full name of an interaction of the scope. @throws SceneError with the nearest name.
[[nodiscard]] std::string interaction_name(const Description& out, const Scope& scope,
                                           const Json& json, const char* key,
                                           const SourceLocation& location);
/// Return the full name of an input of the scope. @throws SceneError with the nearest name.
[[nodiscard]] std::string input_name(const Description& out, const Scope& scope, const Json& json,
                                     const char* key, const SourceLocation& location);

// Readers of entries. Names that an entry refers to are resolved in its scope and checked.
// @throws SceneError.
#define HAWSER_SECTION_READER(key, item, entries, doc)                                \
    [[nodiscard]] SectionItem read_##item(const Description& out, const Scope& scope, \
                                          const Json& json, const SourceLocation& location);
HAWSER_SCENE_SECTIONS(HAWSER_SECTION_READER)
#undef HAWSER_SECTION_READER

}  // namespace hawser::scene
