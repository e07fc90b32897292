// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file plot.h
/// Key `plot` of a scene: names of curves, and the box of pictures.

#include <hawser/scene.h>

#include "scene/description.h"
#include "scene/document.h"

namespace hawser::scene {

/// Read the key `plot` into the scene. Unknown names are mistakes of the description. @throws
/// SceneError if the description collects no mistakes.
void read_plot(Scene& scene, const Description& description, const Document& document);

}  // namespace hawser::scene
