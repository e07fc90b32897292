// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Timeline of a scene: operations at given times (key `timeline`, docs/scenes.md). Part of
/// hawser::scene; hawser::Session executes it.

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

/// Kind of an operation.
enum class OperationKind : std::uint8_t { set, cut, detach, attach, join, release };

/// Entry of a timeline. Names are resolved on execution, because earlier entries may create pieces
/// of wires.
struct Operation {
    double at = 0.0;  ///< Time [s]; executed before the first step that starts at or after it.
    OperationKind kind = OperationKind::set;          ///< Kind of the operation.
    std::vector<std::pair<std::string, double>> set;  ///< Names and values of inputs, or of signals
                                                      ///< "system.signal".
    std::string wire;         ///< Wire of all kinds except `set` and `release`.
    int end = 0;              ///< End of `wire`: 0 the first, 1 the last.
    double s = 0.0;           ///< Material coordinate of `cut` [m].
    std::string body;         ///< Body of `attach`.
    Vec3 point{0, 0, 0};      ///< Point of `attach` in the body's frame [m].
    std::string other;        ///< Second wire of `join`.
    int other_end = 0;        ///< End of the second wire.
    JoinDef gear{};           ///< Gear of `attach` and `join`.
    std::string interaction;  ///< Pelican hook of `release`.
    std::string description;  ///< Purpose; "": not given.
};

/// Execute an operation.
/// @throws DefError if a name does not exist or the operation is not possible. The world is then
/// unchanged, except inputs of a `set` before the rejected one.
void perform(const Operation& operation, World& world);

/// Return a line without the time, such as "cut tow at 120 m". It follows the description if there
/// is one: "the tow parts: cut tow at 120 m".
[[nodiscard]] std::string to_string(const Operation& operation);

}  // namespace hawser::scene
