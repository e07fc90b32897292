// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file verdict_words.h
/// Sentences about the findings of a monitor, shared by all outputs.

#include <hawser/stats.h>
#include <hawser/world.h>

#include <string>

namespace hawser::record {

/// Return a sentence such as "joint 'l' was open by 1.2 m at 0.4 s". @param where  Joint, element
/// or body; "": the whole scene.
[[nodiscard]] std::string finding_sentence(const World& world, Judge judge, const Finding& finding,
                                           const std::string& where);

/// Return a sentence about a change of mechanical energy that no work explains: lost if below 0.
/// @param tense  "" or "had ", before the verb.
[[nodiscard]] std::string energy_change(double value, const char* tense);

/// Return remedy(judge). The budget of a step is included only if the world has one.
[[nodiscard]] const char* remedy_for(const World& world, Judge judge);

}  // namespace hawser::record
