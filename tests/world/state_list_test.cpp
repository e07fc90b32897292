// SPDX-License-Identifier: Apache-2.0
/// One list of state for snapshots and copies, one list of settings for checks and identity.
#include <hawser/hawser.h>

#include "support/recipe.h"
#include "support/sleep_yard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

WorldDef sleepy() {
    WorldDef def;
    def.sleep_after = 0.5;
    return def;
}

TEST(StateList, ACopySleepsAsItsOriginalDoes) {
    SleepYard y(sleepy());
    y.run(600);
    ASSERT_EQ(y.asleep(), "zzzzzzzzz");
    World twin = y.w.twin();
    for (int b = 0; b < y.w.body_count(); ++b)
        EXPECT_EQ(twin.asleep(BodyId{b}), y.w.asleep(BodyId{b})) << "body " << b;
    EXPECT_EQ(twin.state().hash(), y.w.state().hash());
    ASSERT_EQ(twin.step(), Status::ok);
    ASSERT_EQ(y.w.step(), Status::ok);
    EXPECT_EQ(twin.stats().asleep, y.w.stats().asleep);
    EXPECT_EQ(twin.stats().matrix_nnz, 0) << "what sleeps is solved for";
    EXPECT_EQ(twin.state().hash(), y.w.state().hash());
    // A world that was awake falls asleep with the copy, and wakes with the next one.
    SleepYard fresh(sleepy());
    const World awake = fresh.w.twin();
    fresh.w.state().copy_from(y.w);
    EXPECT_EQ(fresh.asleep(), "zzzzzzzzz");
    EXPECT_EQ(fresh.w.state().hash(), y.w.state().hash());
    ASSERT_EQ(fresh.w.step(), Status::ok);
    EXPECT_EQ(fresh.w.stats().matrix_nnz, 0);
    fresh.w.state().copy_from(awake);
    EXPECT_EQ(fresh.asleep(), ".........");
    ASSERT_EQ(fresh.w.step(), Status::ok);
    EXPECT_GT(fresh.w.stats().matrix_nnz, 0);
}

TEST(StateList, ACopyKeepsWhatTheJudgeHasSeen) {
    SleepYard y(sleepy());
    y.run(60);
    const World twin = y.w.twin();
    EXPECT_EQ(twin.verdict().of(Judge::energy).value, y.w.verdict().of(Judge::energy).value);
    EXPECT_EQ(twin.energy().mechanical(), y.w.energy().mechanical());
}

/// Return another value of a setting, within its range.
double other(const SettingInfo& s, double value) {
    if (s.type == SettingType::boolean || s.type == SettingType::word) return value == 0.0 ? 1 : 0;
    if (s.type == SettingType::integer) return value < s.max ? value + 1.0 : value - 1.0;
    if (s.type == SettingType::vector) return value + 1.0;
    return value * 1.25 <= s.max && value != 0.0 ? value * 1.25 : s.min + 0.5 * (s.max - s.min);
}

World falling(const WorldDef& def) {
    World w(def);
    w.add_body({.name = "stone", .kind = BodyKind::lump, .position = {0, 0, 5}, .mass = 2.0});
    return w;
}

TEST(Settings, ThoseThatGiveOtherStatesAreOfTheIdentityOfASnapshot) {
    World plain = falling({});
    ASSERT_EQ(plain.step(), Status::ok);
    const auto saved = plain.state().save();
    for (const SettingInfo& s : setting_infos()) {
        WorldDef def;
        s.set(def, 0, other(s, s.get(def, 0)));
        // Coupling belongs to interactions, of which there are none here.
        World w = falling(def);
        if (s.identity)
            EXPECT_THROW(w.state().restore(saved), DefError) << s.name;
        else
            EXPECT_NO_THROW(w.state().restore(saved)) << s.name;
    }
}

TEST(Settings, HaveDefaultsWithinTheirRangesAndAreRefusedBeyond) {
    for (const SettingInfo& s : setting_infos()) {
        ASSERT_EQ(find_setting(s.name), &s);
        if (s.type == SettingType::word) {
            EXPECT_LT(s.get(WorldDef{}, 0), static_cast<double>(s.words.size())) << s.name;
            continue;
        }
        const double usual = s.get(WorldDef{}, 0);
        EXPECT_TRUE(usual >= s.min && usual <= s.max) << s.name;
        if (s.type == SettingType::boolean) continue;
        // The next number beyond the range, or the limit of a counter.
        WorldDef def;
        s.set(def, 0, s.type == SettingType::integer ? s.max + 1.0 : std::nextafter(s.max, 1e300));
        try {
            const World w(def);
            ADD_FAILURE() << s.name << " above its range is accepted";
        } catch (const DefError& e) {
            EXPECT_NE(std::string(e.what()).find(s.name), std::string::npos) << e.what();
        }
    }
    EXPECT_EQ(find_setting("nothing"), nullptr);
}

}  // namespace
}  // namespace hawser::test
