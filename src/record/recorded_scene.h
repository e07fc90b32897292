// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recorded_scene.h
/// Build the world in which a recording is repeated.

#include <hawser/recording.h>
#include <hawser/scene.h>

namespace hawser::record {

/// Return the scene in a recording, without systems, in the state at the start of the recording, as
/// a Repeater needs it. @throws RecordingError if the recording has no valid scene,
/// scene::SceneError, DefError.
[[nodiscard]] scene::Scene recorded_scene(const Recording& recording, int threads);

}  // namespace hawser::record
