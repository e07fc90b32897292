// SPDX-License-Identifier: Apache-2.0
/// Values from 1e-320 to 1e308 for every input and signal of a scene. Each is rejected by name or
/// accepted, and the world continues in bounded time.
#include "files/mutate.h"
#include "files/watch.h"

#include <cmath>
#include <limits>
#include <optional>

namespace hawser::test {
namespace {

double any_number(Random& random) {
    if (random.chance(0.1))
        return pick<double>(random, {0.0, -0.0, std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity(), -1e308, 1e308, 5e-324,
                                     std::numeric_limits<double>::denorm_min()});
    const double size = std::pow(
        10.0, random.chance(0.5) ? random.uniform(-320.0, 308.0) : random.uniform(-3.0, 9.0));
    return random.chance(0.5) ? size : -size;
}

/// Return a value at an end of the range, or anywhere.
double value_for(Random& random, double min, double max) {
    if (random.chance(0.25)) return random.chance(0.5) ? min : max;
    return any_number(random);
}

struct Sets {
    int taken = 0, refused = 0, steps = 0, failed = 0;
    double longest = 0.0;
    std::string last;  ///< Values set in this round, for the report.
};

void set_one(World& world, Random& random, Sets& out) {
    const auto inputs = world.inputs();
    std::vector<const SystemSignal*> signals;
    for (const SystemSignal& s : world.system_signals())
        if (s.input) signals.push_back(&s);
    const int count = static_cast<int>(inputs.size() + signals.size());
    ASSERT_GT(count, 0);
    const auto k = static_cast<std::size_t>(random.integer(0, count - 1));
    std::string name;
    double value = 0.0;
    try {
        if (k < inputs.size()) {
            const InputDef& def = world.input_def(inputs[k]);
            name = def.name;
            value = value_for(random, def.min, def.max);
            world.set_input(inputs[k], value);
        } else {
            const SystemSignal& s = *signals[k - inputs.size()];
            name = s.system + "." + s.name;
            value = value_for(random, s.min, s.max);
            world.set_system_signal(name, value);
        }
        ++out.taken;
        char text[40];
        std::snprintf(text, sizeof text, " = %.17g; ", value);
        out.last += name + text;
        EXPECT_TRUE(std::isfinite(value)) << name;
    } catch (const DefError& error) {
        ++out.refused;
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
}

void set_inputs_of(const std::string& name, int rounds) {
    Random random(first_seed(62));
    std::optional<scene::Scene> scene(after_some_steps(name));
    const std::vector<std::byte> good = scene->world.state().save();
    Watch watch;
    Sets out;
    for (int i = 0; i < rounds; ++i) {
        watch.begin(name + ", round " + std::to_string(i));
        out.last.clear();
        for (int n = random.integer(1, 3); n > 0; --n) set_one(scene->world, random, out);
        const int steps = random.chance(0.1) ? 100 : 6;
        for (int k = 0; k < steps; ++k, ++out.steps) {
            if (scene->world.step() != Status::ok) ++out.failed;
            const double took = watch.seconds();
            out.longest = std::max(out.longest, took);
            ASSERT_LT(took, kLongest) << running << ", step " << k << ": " << out.last;
            watch.begin(running);
        }
        if (random.chance(0.5)) continue;  // keep values, so that they accumulate
        try {
            scene->world.state().restore(good);
        } catch (const DefError&) {  // a step has inserted or removed nodes
            scene.emplace(after_some_steps(name));
        }
    }
    std::printf("%s: %d values taken, %d refused, %d of %d steps failed, longest %.3f s\n",
                name.c_str(), out.taken, out.refused, out.failed, out.steps, out.longest);
    EXPECT_GT(out.taken, 0);
    EXPECT_GT(out.refused, 0);
}

class AnyValue : public testing::TestWithParam<const char*> {};

TEST_P(AnyValue, IsTakenOrRefused) { set_inputs_of(GetParam(), inputs_of(40, 400, 10'000)); }

INSTANTIATE_TEST_SUITE_P(Scenes, AnyValue,
                         testing::Values("winch_modes", "payout", "tow_payout", "chain_gypsy",
                                         "wire_bollard", "wire_edge", "wire_pins", "chaser",
                                         "crane_knuckle", "crane_lattice", "floating_box",
                                         "anchor_contact"),
                         [](const auto& scene_name) { return std::string(scene_name.param); });

TEST(AnyValueOfAScene, AnchorRun_full) { set_inputs_of("anchor_run", inputs_of(10, 40, 1000)); }

}  // namespace
}  // namespace hawser::test
