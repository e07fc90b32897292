// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file deck.h
/// Deck gear of a scene (deck.cpp).

#include "scene/description.h"

namespace hawser::scene {

/// Read the stoppers, pins, hooks and chasers of one scope. All bodies must exist.
void expand_deck(Description& out, const Scope& scope);
/// Add deck gear to the world, after shapes, winches and posts. @throws SceneError if the world
/// rejects some.
void add_deck(World& world, const Description& from);

/// Read the allowed loads of a hook of a crane or a wire, and the load at the start; 0: none
/// (cranes.cpp). @throws SceneError.
void read_loads(Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location, std::vector<CraneLoad>& loads, int& take);

}  // namespace hawser::scene
