// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A recording's run once more, by its changes alone.
#include <hawser/hawser.h>
#include <hawser/recording.h>
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace hawser::test {

/// Every frame has the motion that was recorded, on `threads` threads, without the systems that
/// made the changes. @return the scene as it ends.
inline scene::Scene expect_repeats(const record::Recording& recording, int threads) {
    scene::Options options;
    options.threads = threads;
    scene::Scene scene = scene::load_text(recording.scene_text, "recorded", options);
    World& world = scene.world;
    while (world.system_count() > 0) (void)world.remove_system(world.system(0));
    world.prepare();
    world.restore(recording.snapshot);
    record::Repeater repeater(recording);
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        const record::Frame frame = recording.frame_head(i);
        while (world.step_count() < frame.step) {
            repeater.before_step(world);
            const Status status = world.step();
            EXPECT_EQ(status, Status::ok) << "step " << world.step_count();
            if (status != Status::ok) return scene;
        }
        EXPECT_EQ(world.motion_hash(), frame.hash) << "step " << frame.step;
    }
    return scene;
}

}  // namespace hawser::test
