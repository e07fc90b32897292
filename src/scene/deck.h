// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file deck.h
/// Deck gear of a scene (deck.cpp).

#include "scene/description.h"

namespace hawser::scene {

/// Stoppers, pins, hooks and chasers of one scope, when all bodies are there.
void expand_deck(Description& out, const Scope& scope);
/// After shapes, winches and posts. @throws SceneError where the world refuses some.
void add_deck(World& world, const Description& from);

/// What the hook of a crane or a wire may take, and which of it at the start; 0: none (cranes.cpp).
/// @throws SceneError.
void read_loads(Description& out, const Scope& scope, const Json& json, const Place& place,
                std::vector<CraneLoad>& loads, int& take);

}  // namespace hawser::scene
