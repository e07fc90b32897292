// SPDX-License-Identifier: Apache-2.0
/// A wire that sweeps along a stern: verified while it slides, and repeated from its recording
/// without the system that had it slide.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace hawser::test {
namespace {

TEST(SessionSlide, IsVerifiedAndRepeatedFromItsRecording) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("hawser_slide_" + std::to_string(::getpid()) + ".hwr");
    {
        Session session(
            {.scene = "scenes/wire_slide.json", .record = file.string(), .verify = true});
        const World& world = session.world();
        for (int k = 0; k < 4200; ++k)
            ASSERT_EQ(session.step(), Status::ok) << world.time() << ": " << session.objection();
        EXPECT_EQ(world.system_signal("stern.held"), 1.0);
        EXPECT_GT(world.system_signal("stern.slid"), 1.0);
        EXPECT_EQ(world.verdict().grade, Grade::good);
        session.finish();
    }
    const record::Recording recording = record::Recording::open(file.string());
    EXPECT_EQ(recording.damage, "");
    for (const int threads : {1, 2}) EXPECT_EQ(expect_repeats(recording, threads).steps, 4200);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace hawser::test
