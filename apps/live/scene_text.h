// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_text.h
/// The message `scene`: data that a client needs to show frames (docs/live.md).
///
/// It is JSON without its first brace: the server puts the role of each client in front.

#include "live/frame_plan.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace hawser::live {

using Json = nlohmann::json;

/// Data of the message that does not come from the scene.
struct SceneNotes {
    std::uint32_t epoch = 1;
    Vec3 origin{0.0, 0.0, 0.0};
    bool recording = false;
};

/// Return the message `scene` of the protocol as JSON, to be sent by text_of(). @param plan  Plan
/// of the present scene.
[[nodiscard]] Json scene_json(const scene::Scene& scene, const FramePlan& plan,
                              const SceneNotes& notes);

// --- Pieces of it, also for recordings --------------------------------------------------------
/// Numbers with significant digits: lengths to 0.1 mm, directions to 1e-7.
[[nodiscard]] Json lengths(const Vec3& v);
[[nodiscard]] Json turn(const Quat& q);
[[nodiscard]] double shorter(double value, double unit);
/// Return the JSON form of a limit: null if the value means "no limit".
[[nodiscard]] Json limit(double value);
[[nodiscard]] Json vertices_of(const std::vector<Vec3>& points);
[[nodiscard]] Json triangles_of(const std::vector<std::array<std::int32_t, 3>>& triangles);
[[nodiscard]] const char* to_string(BodyKind kind) noexcept;
[[nodiscard]] Json shape_json(const World& world, ShapeId id);
/// Return an entry for each vessel: propulsors, rudders, switchboards, alarms of its control.
[[nodiscard]] Json vessels_json(const World& world);
/// Return an entry for each stability gauge: its name and the body of its ship.
[[nodiscard]] Json gauges_json(const World& world);
/// Add waves, depth and wetted hulls of the world's sea, if there is one.
void add_sea(const World& world, Json& out);
/// Return the text to send: compact, without its first brace; invalid UTF-8 is replaced.
[[nodiscard]] std::string text_of(const Json& message);

}  // namespace hawser::live
