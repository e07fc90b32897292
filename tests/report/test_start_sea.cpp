// SPDX-License-Identifier: Apache-2.0
/// Warnings about inconsistent numbers of the sea, of line types, winches and exercises.
#include <hawser/exercise.h>

#include "report/start/parts.h"
#include "start_scene.h"

namespace hawser::test {
namespace {

/// Return a chain of 100 m that hangs into a sea of 60 m over a plane, and a hull in waves.
std::string scene_of(const std::string& line, double depth, double plane, double period,
                     const std::string& hull = "") {
    return R"("line_types": {"t": )" + line + R"(},
        "sea": {"depth": )" +
           std::to_string(depth) + R"(, "waves": [{"kind": "regular", "height": 0.5, "period": )" +
           std::to_string(period) + R"(}], "hulls": [{"body": "box", "mesh": {"box": [10, 4, 2]})" +
           hull + R"(}]},
        "bodies": [
          {"name": "bed", "kind": "fixed", "position": [0, 0, )" +
           std::to_string(plane) +
           R"(], "shapes": [{"kind": "plane"}]},
          {"name": "box", "position": [0, 0, 0], "mass": 328000, "box": [10, 4, 2]}],
        "cables": [{"name": "c", "line_type": "t", "length": 40, "elements": 10,
          "from": {"at": [30, 0, 10]}, "to": {"at": [30, 0, -29]}}])";
}

constexpr const char* kChain =
    R"({"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076, "cd_normal": 2.4})";

TEST(StartSea, NothingIsFoundInAGoodScene) {
    const Started s = start_of(scene_of(kChain, 60, -60, 7));
    for (const FindingKind kind :
         {FindingKind::depth, FindingKind::dry, FindingKind::short_waves, FindingKind::stiffness,
          FindingKind::memory, FindingKind::density})
        EXPECT_TRUE(s.of(kind).empty()) << s.text();
}

TEST(StartSea, DepthAndPlane) {
    EXPECT_NEAR(only(start_of(scene_of(kChain, 70, -60, 7)), FindingKind::depth).value, 10.0, 1e-9);
    EXPECT_NEAR(only(start_of(scene_of(kChain, 60, -61, 7)), FindingKind::depth).value, 1.0, 1e-9);
    EXPECT_TRUE(start_of(scene_of(kChain, 60, -60.2, 7)).of(FindingKind::depth).empty());
}

TEST(StartSea, WiresWithoutDrag) {
    const Started bare = start_of(
        scene_of(R"({"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076})", 60, -60, 7));
    EXPECT_NE(only(bare, FindingKind::dry).text.find("cd_normal"), std::string::npos);
    const Started none = start_of(
        scene_of(R"({"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076, "cd_normal": 0})",
                 60, -60, 7));
    EXPECT_EQ(only(none, FindingKind::dry).about, Names{"c"});
    const Started linear = start_of(scene_of(
        R"({"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076, "drag": 20})", 60, -60, 7));
    EXPECT_TRUE(linear.of(FindingKind::dry).empty());
}

/// 20 m long: periods of waves of 2.9 and 3.1 lengths in deep water.
TEST(StartSea, ShortWaves) {
    EXPECT_NEAR(only(start_of(scene_of(kChain, 400, -400, 6.095)), FindingKind::short_waves).value,
                2.9, 0.01);
    EXPECT_TRUE(start_of(scene_of(kChain, 400, -400, 6.302)).of(FindingKind::short_waves).empty());
}

TEST(StartSea, StiffnessByDiameter) {
    for (const auto& [EA, d, found] :
         {std::tuple("5.83e5", "0.076", 1U), std::tuple("5.83e11", "0.076", 1U),
          std::tuple("5.83e8", "76", 1U), std::tuple("6e6", "0.1", 0U),
          std::tuple("3.3e8", "0.217", 0U)}) {
        const Started s = start_of(
            scene_of(std::string(R"({"mass_per_length": 126.5, "EA": )") + EA +
                         R"(, "cd_normal": 2.4, "displaced_area": 0.016, "diameter": )" + d + "}",
                     60, -60, 7));
        EXPECT_EQ(s.of(FindingKind::stiffness).size(), found) << EA << ' ' << d;
    }
}

/// A narrow peak of damping has a memory of minutes.
TEST(StartSea, MemoriesThatEndTooEarly) {
    const std::string hull = R"(, "memory": %, "coefficients": {"frequencies": [0.9, 1.0, 1.1, 1.2],
        "radiation": [{"of": [3, 3], "infinite": 1e5, "added_mass": [1e5, 1e5, 1e5, 1e5],
        "damping": [0, 1e5, 0, 0]}]})";
    const auto with = [&](const std::string& memory) {
        std::string text = hull;
        text.replace(text.find('%'), 1, memory);
        return start_of(scene_of(kChain, 60, -60, 7, text));
    };
    const Finding f = only(with("20"), FindingKind::memory);
    // sinc²(0.05 t) at t = 16 s, where cos t is -0.96: 0.80² × 0.96.
    EXPECT_NEAR(f.value, 0.77, 0.05);
    EXPECT_NE(f.text.find("give \"memory\" of"), std::string::npos) << f.text;
    EXPECT_TRUE(with("500").of(FindingKind::memory).empty());
}

TEST(StartSea, PointsThatNobodyReaches) {
    exercise::Exercise e{.name = "lift"};
    e.goals = {{.name = "a", .points = 30.0}, {.name = "b", .points = 40.0}};
    for (const auto& [pass, found] : {std::pair(70.0, 0U), std::pair(71.0, 1U)}) {
        e.pass = pass;
        report::start::Findings out;
        report::start::check_points(e, out);
        EXPECT_EQ(out.list.size(), found);
    }
}

}  // namespace
}  // namespace hawser::test
