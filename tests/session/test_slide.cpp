// SPDX-License-Identifier: Apache-2.0
/// A wire that slides along a stern: verified while it slides, and replayed from its recording
/// without the system that moved it. Along an edge of a box, a hull or a mesh.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"
#include "support/sanitizer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace hawser::test {
namespace {

constexpr int kSteps = 4200;  // until it has slid to one quarter

TEST(SessionSlide, IsVerifiedAndRepeatedFromItsRecording) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("hawser_slide_" + std::to_string(::getpid()) + ".hwr");
    {
        Session session(
            {.scene = "scenes/wire_slide.json", .record = file.string(), .verify = true});
        const World& world = session.world();
        for (int k = 0; k < kSteps; ++k)
            ASSERT_EQ(session.step(), Status::ok) << world.time() << ": " << session.objection();
        EXPECT_EQ(world.system_signal("stern.held"), 1.0);
        EXPECT_GT(world.system_signal("stern.slid"), 1.0);
        EXPECT_EQ(world.verdict().grade, Grade::good);
        session.finish();
    }
    const record::Recording recording = record::Recording::open(file.string());
    EXPECT_EQ(recording.damage, "");
    for (const int threads : {1, 2}) EXPECT_EQ(expect_repeats(recording, threads).steps, kSteps);
    std::filesystem::remove(file);
}

void replace(std::string& text, std::string_view from, std::string_view to) {
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

/// Return the scene with the stern's edge taken from a shape that the wire does not touch.
std::string with_edge_of(const std::string& kind, const std::string& more) {
    std::ifstream in("scenes/wire_slide.json");
    std::string text{std::istreambuf_iterator<char>(in), {}};
    replace(text, "\"box\": [20, 7, 2]",
            R"("box": [20, 7, 2], "shapes": [{"name": "stern", "groups": "ship", "touches": "ship",
               "kind": ")" +
                kind + R"(", "vertices": [[-20, -7, -2], [20, -7, -2], [-20, 7, -2], [20, 7, -2],
               [-20, -7, 2], [20, -7, 2], [-20, 7, 2], [20, 7, 2]])" +
                more + "}]");
    replace(text, "\"edge\": [1, 0, 1]",
            R"("groups": "edge", "touches": "line",
               "edge_of": {"shape": "stern", "near": [[20, -6, 2], [20, 6, 2]]})");
    replace(text, "{\"radius\": 0.016}",
            R"({"radius": 0.016, "groups": "line", "touches": "edge"})");
    return text;
}

TEST(SessionSlide, GoesAlongEdgesOfHullsAndMeshesAlike) {
    HAWSER_SKIP_IF_SAMPLED();
    const auto place = [](const SessionDef& def) {
        Session session(def);
        for (int k = 0; k < kSteps; ++k) EXPECT_EQ(session.step(), Status::ok) << k;
        EXPECT_EQ(session.world().system_signal("stern.held"), 1.0);
        return session.world().system_signal("stern.along");
    };
    const double box = place({.scene = "scenes/wire_slide.json"});
    EXPECT_GT(box, 1.0);
    // The axis is equal to rounding, which sliding does not amplify.
    EXPECT_NEAR(place({.scene_text = with_edge_of("hull", "")}), box, 1e-6);
    EXPECT_NEAR(place({.scene_text = with_edge_of("mesh", R"(, "triangles": [
                 [1, 3, 7], [1, 7, 5], [0, 4, 6], [0, 6, 2], [2, 6, 7], [2, 7, 3],
                 [0, 1, 5], [0, 5, 4], [4, 5, 7], [4, 7, 6], [0, 2, 3], [0, 3, 1]])")}),
                box, 1e-6);
}

}  // namespace
}  // namespace hawser::test
