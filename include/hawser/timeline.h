// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// What a scene has done to it at times (its key `timeline`, docs/scenes.md). Part of
/// hawser::scene; hawser::Session does it.

#include <hawser/math.h>
#include <hawser/wire.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hawser {
class World;
}

namespace hawser::scene {

enum class OperationKind : std::uint8_t { set, cut, detach, attach, join, release };

/// One entry of a timeline. What it names is looked up when it is done: pieces of wires come to be
/// by earlier ones.
struct Operation {
    double at = 0.0;  ///< Done before the first step that begins at or after it [s].
    OperationKind kind = OperationKind::set;
    std::vector<std::pair<std::string, double>> set;  ///< Inputs, "system.signal" too.
    std::string wire;                                 ///< Of all but `set` and `release`.
    int end = 0;                                      ///< Of it: 0 the first, 1 the last.
    double s = 0.0;                                   ///< Of `cut` [m].
    std::string body;                                 ///< Of `attach`.
    Vec3 point{0, 0, 0};                              ///< In its frame [m].
    std::string other;                                ///< Wire of `join` …
    int other_end = 0;                                ///< … and its end.
    JoinDef gear{};                                   ///< Of `attach` and `join`.
    std::string interaction;                          ///< Hook of `release`.
    std::string description;                          ///< What it is for; "": not said.
};

/// Do one. @throws DefError where what it names is not there, or cannot be done; the world is as it
/// was then, but for inputs of a `set` before the one that was refused.
void perform(const Operation& operation, World& world);

/// In a line without its time, such as "cut tow at 120 m"; behind its description, if it has one:
/// "the tow parts: cut tow at 120 m".
[[nodiscard]] std::string to_string(const Operation& operation);

}  // namespace hawser::scene
