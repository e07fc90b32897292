// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file verdict_words.h
/// What a judge found, in the same words wherever it is told.

#include <hawser/stats.h>
#include <hawser/world.h>

#include <string>

namespace hawser::record {

/// E.g. "joint 'l' stood open by 1.2 m at 0.4 s".
/// @param where  Its joint, element or body; "": the whole scene.
[[nodiscard]] std::string sentence(const World& world, Judge judge, const Finding& finding,
                                   const std::string& where);

/// remedy(judge), with the budget of a step only where the world has one.
[[nodiscard]] const char* remedy_for(const World& world, Judge judge);

}  // namespace hawser::record
