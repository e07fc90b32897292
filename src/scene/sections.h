// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sections.h
/// Registry of scene sections: lists of systems that need no code elsewhere in the reader.
///
/// A section is one entry of kSections (sections.cpp). From it follow the format, the schema, the
/// reference page, templates, copies ("repeat") and the world:
/// ```
///   scene file --shape()--> checked JSON --read()--> SectionItem --add(world)--> system
/// ```
/// Items refer to bodies, interactions and inputs by full name. A copy of the scene only has
/// another prefix. Items are added last, so that all other parts of the scene exist.
///
/// A new system with scene keys needs two files: its header, and a source with its section; and one
/// line in kSections. pids.cpp is the worked example.

#include <hawser/world.h>

#include "scene/description.h"
#include "scene/format.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::scene {

struct Section {
    const char* key;      ///< Key of the list in a scene and in a template.
    const char* entries;  ///< Entries in words, for messages: "controllers".
    const char* doc;      ///< One sentence for the reference page.
    /// Return the shape of an entry.
    ShapePtr (*shape)();
    /// Read an entry. Names that it refers to are resolved in its scope and checked.
    /// @throws SceneError.
    SectionItem (*read)(const Description& out, const Scope& scope, const Json& json,
                        const Place& place);
};

[[nodiscard]] std::span<const Section> sections();

/// Read all sections of one scope. All interactions and inputs of the scope have been read.
void expand_sections(Description& out, const Scope& scope);
/// Add the items to a world in which all other parts exist.
void add_sections(World& world, const Description& from);

/// Number of a definition: key, member, unit, default and range.
template <class Def>
struct SectionNumber {
    const char* key;
    double Def::* value;
    const char* unit;
    const char* fallback;  ///< Default in words; "" if the value is required.
    const char* doc;
    double least, most;
};

/// Return the fields of numbers for a shape.
template <class Def>
[[nodiscard]] std::vector<Field> number_fields(std::span<const SectionNumber<Def>> numbers) {
    std::vector<Field> out;
    for (const SectionNumber<Def>& n : numbers)
        out.push_back({n.key, make::number("a number", n.least, n.most),
                       std::string_view(n.fallback).empty(), n.fallback, n.unit, n.doc});
    return out;
}

/// Read the numbers that are given.
template <class Def>
void read_numbers(Def& def, const Json& json, std::span<const SectionNumber<Def>> numbers) {
    for (const SectionNumber<Def>& n : numbers) def.*n.value = number_or(json, n.key, def.*n.value);
}

/// Return the full name of an interaction of the scope. @throws SceneError with the nearest name.
[[nodiscard]] std::string interaction_name(const Description& out, const Scope& scope,
                                           const Json& json, const char* key, const Place& place);
/// Return the full name of an input of the scope. @throws SceneError with the nearest name.
[[nodiscard]] std::string input_name(const Description& out, const Scope& scope, const Json& json,
                                     const char* key, const Place& place);

// --- Entries of kSections -------------------------------------------------------------------
[[nodiscard]] ShapePtr pid_shape();
[[nodiscard]] SectionItem read_pid(const Description& out, const Scope& scope, const Json& json,
                                   const Place& place);

}  // namespace hawser::scene
