// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// What a world refuses, with the reason and the remedy.

#include <hawser/def.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>

#include "model/bodies.h"

#include <vector>

namespace hawser::world {

/// @throws DefError
void check(const WorldDef& def);
/// @throws DefError
void check(const BodyDef& def);
/// Checks bodies, points, frames and row constants. @throws DefError
void check(const InteractionDef& def, const model::Bodies& bodies,
           const std::vector<InteractionDef>& before);
/// Checks parameters once defaults have been filled in. @throws DefError
void check_params(const InteractionDef& def);
/// @param method  Not all of them have every resistance. @throws DefError
void check(const MaterialDef& def, Nonsmooth method);
/// @param materials  That there are. @throws DefError
void check(const MaterialPairDef& def, int materials, Nonsmooth method);
/// @throws DefError
void check(const ShapeDef& def, const model::Bodies& bodies, int materials);

/// "body 'bob'" or "body 7 (unnamed)" for messages.
[[nodiscard]] std::string label(const char* what, const std::string& name);

}  // namespace hawser::world
