// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file layout_writer.h
/// What a recording says of a scene before its first frame: bodies, cables, joints
/// (docs/recording.md).

#include "record/bytes.h"
#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <vector>

namespace hawser::record {

/// Joints and rods between two bodies that are not elements of a cable, as a layout has them.
[[nodiscard]] std::vector<InteractionId> joints_of(const SceneInfo& scene, const World& world);
void put_body(ByteWriter& out, const BodyDef& def, const Pose& pose);
/// Names of inputs by place, "" where one was removed; and which of them systems drive.
void put_input_names(ByteWriter& out, const World& world);
void put_layout(ByteWriter& out, const SceneInfo& scene, const World& world);

}  // namespace hawser::record
