// SPDX-License-Identifier: Apache-2.0
#include "record/random_control.h"

#include "record/control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace hawser::test {

namespace {

const std::vector<record::RandomInput> kRandomLevers = {
    {.name = "thrust", .min = -123456.789, .max = 4.1e5, .start = 0.0, .rest = 0.0},
    {.name = "winch.mode", .min = 0.0, .max = 5.0, .start = 1.0, .rest = 1.0, .whole = true}};

std::vector<record::ControlChange> read_back(const std::string& text) {
    const std::vector<std::string> names = {"thrust", "winch.mode"};
    std::vector<record::ControlRange> ranges;
    for (const auto& i : kRandomLevers) ranges.push_back({i.min, i.max});
    return record::parse_control(text, "levers.csv", names, ranges);  // Throws if a value is out of
                                                                      // range.
}

/// Return the values of an input by time, as pairs independent of the text.
std::map<double, double> values_of(const std::string& text, std::int32_t input) {
    std::map<double, double> out;
    for (const auto& c : read_back(text))
        if (c.input == input) out[c.time] = c.value;
    return out;
}

}  // namespace

TEST(RandomControl, StaysInRangesAndTimesAndMovesEverything) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::string text =
            record::random_control(kRandomLevers, {.seed = seed, .duration = 120.0});
        const auto thrust = values_of(text, 0), mode = values_of(text, 1);
        EXPECT_EQ(thrust.begin()->first, 0.0);
        EXPECT_EQ(thrust.begin()->second, 0.0);
        EXPECT_EQ(mode.begin()->second, 1.0);
        EXPECT_LT(thrust.rbegin()->first, 120.0);
        std::set<double> modes;
        for (const auto& [time, value] : mode) modes.insert(value);
        for (const double m : modes) EXPECT_EQ(m, std::round(m));
        EXPECT_GE(modes.size(), 3u) << seed;
        // A ramp has lines 0.1 s apart; a step change does not.
        int near = 0, far = 0;
        for (auto next = std::next(thrust.begin()); next != thrust.end(); ++next)
            ++(next->first - std::prev(next)->first < 0.15 ? near : far);
        EXPECT_GT(near, 20) << seed;
        EXPECT_GT(far, 5) << seed;
    }
}

TEST(RandomControl, DependsOnTheSeedAndTheNameAlone) {
    const record::RandomControlDef def{.seed = 5, .duration = 60.0};
    const std::string text = record::random_control(kRandomLevers, def);
    EXPECT_EQ(text, record::random_control(kRandomLevers, def));
    EXPECT_NE(text, record::random_control(kRandomLevers, {.seed = 6, .duration = 60.0}));
    const std::vector<record::RandomInput> swapped = {kRandomLevers[1], kRandomLevers[0]};
    const std::string other = record::random_control(swapped, def);
    EXPECT_EQ(values_of(text, 0), values_of(other, 0));
    EXPECT_EQ(values_of(text, 1), values_of(other, 1));
}

}  // namespace hawser::test
