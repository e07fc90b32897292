// SPDX-License-Identifier: Apache-2.0
#include "repeated_contacts.h"

#include "failure.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::cli {

scene::Scene recorded_scene(const record::Recording& recording, int threads) {
    if (recording.scene_text.empty())
        throw record::RecordingError(
            recording.file +
            ": a recording without a scene, of a world that a program built; it can be "
            "drawn, not repeated");
    scene::Options options;
    options.threads = threads;
    scene::Scene scene =
        scene::load_text(recording.scene_text, recording.file + " (embedded scene)", options);
    World& world = scene.world;
    // What systems of the scene did is in the recording.
    while (world.system_count() > 0) (void)world.remove_system(world.system(0));
    const auto bad_input = [&](const record::RecordedInput& input) {
        return input.input < 0 || input.input >= world.input_count();
    };
    if (world.body_count() != static_cast<std::int32_t>(recording.start_bodies) ||
        world.settings().step != recording.settings.step ||
        std::any_of(recording.inputs.begin(), recording.inputs.end(), bad_input))
        throw record::RecordingError(recording.file +
                                     ": the embedded scene does not fit the recording");
    world.prepare();
    world.restore(recording.snapshot);
    return scene;
}

RepeatedContacts::RepeatedContacts(const record::Recording& recording, int threads)
    : recording_(recording), scene_(recorded_scene(recording, threads)), repeater_(recording) {}

const exporting::ContactForces& RepeatedContacts::at(const record::Frame& frame) {
    World& world = scene_.world;
    while (world.step_count() < frame.step) {
        repeater_.before_step(world);
        if (world.step() != Status::ok)
            throw record::RecordingError(fmt::format("{}: the step from {:.6g} s failed: {}",
                                                     recording_.file, world.time(),
                                                     failure(world.stats())));
    }
    if (world.motion_hash() != frame.hash)
        throw record::RecordingError(fmt::format(
            "{}: repeated, the state at {:.6g} s is another one, so that contact forces would be "
            "those of another run; `hawser replay` says more",
            recording_.file, frame.time));
    world.contacts(contacts_);
    out_.points.clear();
    out_.forces.clear();
    for (const ContactView& contact : contacts_) {
        if (contact.force.isZero(0.0)) continue;  // near without touching
        for (int k = 0; k < 3; ++k) {
            out_.points.push_back(contact.point[k]);
            out_.forces.push_back(contact.force[k]);
        }
    }
    return out_;
}

}  // namespace hawser::cli
