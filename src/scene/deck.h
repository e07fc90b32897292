// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file deck.h
/// Deck gear of a scene (deck.cpp).

#include "scene/description.h"

namespace hawser::scene {

/// Stoppers and pins of one scope, when all bodies are there.
void expand_deck(Description& out, const Scope& scope);
/// After shapes, winches and posts. @throws SceneError where the world refuses some.
void add_deck(World& world, const Description& from);

}  // namespace hawser::scene
