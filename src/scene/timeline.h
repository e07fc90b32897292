// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Reads what is done to a scene at times.

#include "scene/document.h"

#include <hawser/scene.h>

#include <span>
#include <vector>

namespace hawser::scene {

/// Words of Gear, in its order.
[[nodiscard]] std::span<const char* const> gear_words() noexcept;

/// The operations by time. What they name has to be there or to come of earlier ones.
/// @param world  Of the scene. @throws SceneError where there is no list of mistakes.
[[nodiscard]] std::vector<Operation> read_timeline(const World& world, const Document& document);

}  // namespace hawser::scene
