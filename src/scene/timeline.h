// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Reads what is done to a scene at times.

#include "scene/document.h"

#include <hawser/scene.h>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace hawser::scene {

/// Words of Gear, in its order.
[[nodiscard]] std::span<const char* const> gear_words() noexcept;

/// Words of an input, by its name: what stands at place k is the number k + 1.
using InputWords = std::map<std::string, std::vector<std::string>>;

class Description;
/// What the signals NAME.take of cranes know, by the names of bodies (cranes.cpp).
[[nodiscard]] InputWords loads_by_word(const Description& description);

/// The operations by time. What they name has to be there or to come of earlier ones.
/// @param world  Of the scene. @param levers  Its inputs that set signals: operations have the
/// signals. @throws SceneError where there is no list of mistakes.
[[nodiscard]] std::vector<Operation> read_timeline(const World& world, const Document& document,
                                                   const InputWords& words,
                                                   std::span<const SignalInput> levers);

}  // namespace hawser::scene
