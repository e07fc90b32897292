// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Timeline of a scene: operations that a session executes at given times, such as setting an input
/// or cutting a wire (key `timeline`, docs/scenes.md). Part of hawser::scene.

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

/// Kind of an operation: set inputs and signals, or a function of WorldWires.
enum class OperationKind : std::uint8_t { set, cut, detach, attach, join, release };

/// Operation of a timeline. Names are resolved when it is executed, because earlier operations may
/// create pieces of wires.
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
/// unchanged, except that a `set` keeps the values set before the rejected one.
void perform(const Operation& operation, World& world);

/// Return an operation in words without its time, such as "cut tow at 120 m". A description
/// precedes it: "the tow parts: cut tow at 120 m".
[[nodiscard]] std::string to_string(const Operation& operation);

}  // namespace hawser::scene
