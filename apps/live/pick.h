// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pick.h
/// Numbers of one body, wire or joint, for the client that points at it.

#include "live/command.h"
#include "live/frame_plan.h"

#include <nlohmann/json_fwd.hpp>

namespace hawser::live {

/// Return the body of a scene by its number in messages. @throws DefError if there is none.
[[nodiscard]] BodyId body_of(const World& world, std::int32_t number);
/// Return the wire of the scene that a command names, by number or name. @throws DefError with the
/// nearest name.
[[nodiscard]] const WireSource& find_wire_source(const FramePlan& plan, const Command& command);

/// Return the message `picked` (docs/live.md). @throws DefError if the object does not exist.
[[nodiscard]] nlohmann::json picked_object_json(const World& world, const FramePlan& plan,
                                                const Command& command);

}  // namespace hawser::live
