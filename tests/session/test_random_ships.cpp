// SPDX-License-Identifier: Apache-2.0
// Random ships in random seas: scaled sets of the library of vessels, random orders on each input.
// Each run stays finite, and a suspect or failed end names its cause.
#include <hawser/hawser.h>
#include <hawser/scene.h>
#include <hawser/vessel.h>

#include "support/random_ships.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Return the inputs of the vessel, with their ranges.
std::vector<SystemSignal> inputs_of(const World& world) {
    std::vector<SystemSignal> out;
    for (const SystemSignal& s : world.system_signals())
        if (s.system == "ship" && s.input) out.push_back(s);
    return out;
}

/// Expect that the largest coordinate, velocity and turning rate are plausible for a ship.
void expect_sane(const World& world, BodyId hull) {
    const Pose pose = world.pose(hull);
    const Twist v = world.velocity(hull);
    ASSERT_TRUE(pose.position.allFinite() && v.linear.allFinite() && v.angular.allFinite());
    ASSERT_LT(v.linear.norm(), 40.0);
    ASSERT_LT(v.angular.norm(), 10.0);
}

/// Give random orders. @return number of orders beyond their range.
int give_order(World& world, ShipMaker& chance, const std::vector<SystemSignal>& inputs) {
    if (inputs.empty()) return 0;
    const SystemSignal& one =
        inputs[static_cast<std::size_t>(chance.unit() * static_cast<double>(inputs.size()))];
    const double low = std::max(one.min, -10.0), high = std::min(one.max, 5e6);
    const double width = high - low;
    double value = chance.between(low - 0.3 * width, high + 0.3 * width);
    if (one.name.ends_with("_failed") && chance.unit() < 0.7) value = 0.0;
    // A fraction is no mode and is refused: most orders name one, so that all modes act.
    if (one.name == "mode" && chance.unit() < 0.8) value = std::round(value);
    const std::int64_t before = world.events().extremes(EventKind::input_clamped).count;
    world.set_system_signal("ship." + one.name, value);
    const bool beyond = value < one.min || value > one.max;
    EXPECT_EQ(world.events().extremes(EventKind::input_clamped).count - before, beyond ? 1 : 0)
        << one.name << ' ' << value;
    return beyond ? 1 : 0;
}

void sail(std::uint32_t seed, std::uint64_t number, double seconds, int& good) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", ship " + std::to_string(number));
    ShipMaker maker(seed * 1000u + number, ".");
    scene::Scene s = scene::load_text(maker.scene(number, seconds, false), "random ship");
    World& world = s.world;
    const BodyId hull = world.find_body("hull");
    const VesselDef* def = find_vessel(world, hull);
    ASSERT_NE(def, nullptr);
    const std::vector<SystemSignal> inputs = inputs_of(world);
    int beyond = 0;
    const auto steps = static_cast<int>(seconds * 60.0);
    for (int i = 0; i < steps; ++i) {
        if (i % 90 == 0) beyond += give_order(world, maker, inputs);
        const Status status = world.step();
        if (status != Status::ok) {
            // A failed end names its cause.
            EXPECT_STRNE(to_string(status), "");
            break;
        }
        expect_sane(world, hull);
        if (::testing::Test::HasFatalFailure()) return;
    }
    if (!inputs.empty() && seconds > 60.0) {
        EXPECT_GT(beyond, 0);
    }
    const Verdict& verdict = world.verdict();
    if (verdict.grade != Grade::good) {
        EXPECT_GT(std::abs(verdict.of(verdict.judge).value), 0.0) << to_string(verdict.judge);
    } else {
        ++good;
    }
}

TEST(RandomShips, AreFiniteAndNameTheirEnd) {
    const std::uint32_t seed = first_seed(71);
    const int count = by_tier(4, 20, 20);
    const double seconds = kSanitized ? 2.0 : by_tier(10, 60, 300);
    int good = 0;
    for (int i = 0; i < count; ++i) sail(seed, static_cast<std::uint64_t>(i), seconds, good);
    // Without a cause, each run ends as good.
    EXPECT_GE(good, count * 9 / 10);
}

}  // namespace
}  // namespace hawser::test
