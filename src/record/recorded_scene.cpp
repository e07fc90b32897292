// SPDX-License-Identifier: Apache-2.0
#include "record/recorded_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::record {

scene::Scene recorded_scene(const Recording& recording, int threads) {
    if (recording.scene_text.empty())
        throw RecordingError(
            recording.file +
            ": a recording without a scene, of a world that a program built; it can be "
            "drawn, not repeated");
    scene::Options options;
    options.threads = threads;
    scene::Scene scene =
        scene::load_text(recording.scene_text, recording.file + " (embedded scene)", options);
    World& world = scene.world;
    // The recording contains the effects of the scene's systems.
    while (world.system_count() > 0) (void)world.remove_system(world.system(0));
    const auto bad_input = [&](const record::RecordedInput& input) {
        return input.input < 0 || input.input >= world.input_count();
    };
    if (world.body_count() != static_cast<std::int32_t>(recording.start_bodies) ||
        world.settings().step != recording.settings.step ||
        std::any_of(recording.inputs.begin(), recording.inputs.end(), bad_input))
        throw RecordingError(recording.file + ": the embedded scene does not fit the recording");
    world.prepare();
    world.state().restore(recording.snapshot);
    return scene;
}

}  // namespace hawser::record
