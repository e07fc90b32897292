// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeat.h
/// Replay the run of a recording from its changes alone, like `hawser replay`.

#include <hawser/hawser.h>
#include <hawser/repeater.h>
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace hawser::test {

struct Repeated {
    scene::Scene scene;  ///< Scene in its final state.
    std::int64_t steps = 0;
};

/// Expect the recorded motion in every frame and at the end, on `threads` threads, without the
/// systems that made the changes. Returns to earlier states are replayed, too.
inline Repeated expect_repeats(const record::Recording& recording, int threads) {
    scene::Options options;
    options.threads = threads;
    Repeated out{scene::load_text(recording.scene_text, "recorded", options)};
    World& world = out.scene.world;
    while (world.system_count() > 0) (void)world.remove_system(world.system(0));
    world.prepare();
    world.state().restore(recording.snapshot);
    record::Repeater repeater(recording);
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        const record::Frame frame = recording.frame_head(i);
        while (world.step_count() < frame.step || repeater.take() < recording.take_of(i)) {
            repeater.before_step(world);
            // A run may restore a state and write its frame before the next step.
            if (world.step_count() == frame.step && repeater.take() == recording.take_of(i)) break;
            const Status status = world.step();
            EXPECT_EQ(status, Status::ok) << "step " << world.step_count();
            if (status != Status::ok) return out;
            ++out.steps;
        }
        EXPECT_EQ(world.state().motion_hash(), frame.hash) << "step " << frame.step;
    }
    repeater.before_step(world);
    EXPECT_EQ(world.state().motion_hash(), recording.end_hash) << "at its end";
    return out;
}

}  // namespace hawser::test
