// SPDX-License-Identifier: Apache-2.0
#include "repeated_contacts.h"

#include "failure.h"
#include "record/recorded_scene.h"

#include <fmt/format.h>

namespace hawser::cli {

RepeatedContacts::RepeatedContacts(const record::Recording& recording, int threads)
    : recording_(recording),
      scene_(record::recorded_scene(recording, threads)),
      repeater_(recording) {}

const exporting::ContactForces& RepeatedContacts::at(const record::Frame& frame,
                                                     std::size_t index) {
    World& world = scene_.world;
    const std::size_t take = recording_.take_of(index);
    while (world.step_count() < frame.step || repeater_.take() < take) {
        repeater_.before_step(world);
        // A branch may begin with a frame, before its first step.
        if (world.step_count() == frame.step && repeater_.take() == take) break;
        if (world.step() != Status::ok)
            throw record::RecordingError(fmt::format("{}: the step from {:.6g} s failed: {}",
                                                     recording_.file, world.time(),
                                                     failure(world)));
    }
    if (world.state().motion_hash() != frame.hash)
        throw record::RecordingError(
            fmt::format("{}: the repeated state at {:.6g} s differs from the recording, so that "
                        "contact forces cannot be computed; `hawser replay` shows the difference",
                        recording_.file, frame.time));
    world.contacts(contacts_);
    out_.points.clear();
    out_.forces.clear();
    for (const ContactView& contact : contacts_) {
        if (contact.force.isZero(0.0)) continue;  // near, but not touching
        for (int k = 0; k < 3; ++k) {
            out_.points.push_back(contact.point[k]);
            out_.forces.push_back(contact.force[k]);
        }
    }
    return out_;
}

}  // namespace hawser::cli
