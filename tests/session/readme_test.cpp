// SPDX-License-Identifier: Apache-2.0
/// The scene of README.md is valid, runs, and ends in the steady state of a tow.
#include <hawser/scene.h>
#include <hawser/session.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace hawser {
namespace {

TEST(ReadmeDocument, ItsSceneTowsTheBarge) {
    std::ifstream file("README.md");
    std::ostringstream text;
    text << file.rdbuf();
    const std::string document = text.str();
    const std::size_t begin = document.find("```json\n") + 8, end = document.find("```", begin);
    ASSERT_NE(end, std::string::npos);
    Session session(scene::load_text(document.substr(begin, end - begin), "README.md"));
    while (session.time() < 240.0) ASSERT_EQ(session.step(), Status::ok);
    const World& world = session.world();
    EXPECT_EQ(world.verdict().grade, Grade::good);
    // Steady: thrust F on drags a and b gives the speed F/(a + b), and the tension of the wire is b
    // v.
    constexpr double kThrust = 3e5, kTug = 3e4, kBarge = 9e4, kSpeed = kThrust / (kTug + kBarge);
    const double speed = world.velocity(world.find_body("tug")).linear.x();
    // 2 %: e^{-240 s/38 s} of the approach is left, and the wire still oscillates.
    EXPECT_NEAR(speed, kSpeed, 0.02 * kSpeed);
    EXPECT_NEAR(world.output(world.find_output("tension")), kBarge * kSpeed, 0.1 * kBarge * kSpeed);
}

}  // namespace
}  // namespace hawser
