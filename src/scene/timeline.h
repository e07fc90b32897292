// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Read the operations of a scene at given times.

#include "scene/document.h"

#include <hawser/scene.h>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace hawser::scene {

/// Return the words of Gear, in its order.
[[nodiscard]] std::span<const char* const> gear_words() noexcept;

/// Words of an input, by its name: the word at index k stands for the number k + 1.
using InputWords = std::map<std::string, std::vector<std::string>>;

class Description;
/// Return the words of the signals NAME.take of cranes: the names of the bodies (cranes.cpp).
[[nodiscard]] InputWords loads_by_word(const Description& description);

/// Return the operations by time. They may name existing objects and results of earlier operations.
/// @param world  World of the scene. @param levers  Inputs of the scene that set signals:
/// operations contain the signals. @throws SceneError if there is no list of mistakes.
[[nodiscard]] std::vector<Operation> read_timeline(const World& world, const Document& document,
                                                   const InputWords& words,
                                                   std::span<const SignalInput> levers);

}  // namespace hawser::scene
