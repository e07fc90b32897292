// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recorded_scene.h
/// The world that a recording is repeated in.

#include <hawser/recording.h>
#include <hawser/scene.h>

namespace hawser::record {

/// The scene in a recording, without systems, in the state in which the recording began: what a
/// Repeater needs. @throws RecordingError where it has none that fits, scene::SceneError, DefError.
[[nodiscard]] scene::Scene recorded_scene(const Recording& recording, int threads);

}  // namespace hawser::record
