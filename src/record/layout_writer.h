// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file layout_writer.h
/// Write the description of a scene that precedes the first frame of a recording: bodies, cables,
/// joints (docs/recording.md).

#include "record/bytes.h"
#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <vector>

namespace hawser::record {

/// Return joints and rods between two bodies that are not elements of a cable, in the order of a
/// layout.
[[nodiscard]] std::vector<InteractionId> drawn_joints(const SceneInfo& scene, const World& world);
void write_body(ByteWriter& out, const BodyDef& def, const Pose& pose);
/// Write the names of inputs by index, "" for a removed input, and the inputs that systems drive.
void write_input_names(ByteWriter& out, const World& world);
void write_layout(ByteWriter& out, const SceneInfo& scene, const World& world);

}  // namespace hawser::record
