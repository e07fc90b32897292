// SPDX-License-Identifier: Apache-2.0
#include "record/scene_info.h"
#include "record/verdict_words.h"

#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <string>

namespace hawser::test {

// tackle.json contains the route "hoist" and its winch; the route made its slides.
TEST(MessageNames, OfPartsSayWhoMadeThem) {
    const scene::Scene scene = scene::load_file("scenes/tackle.json");
    int made = 0;
    for (const BodyId id : scene.world.bodies()) {
        const std::string name = scene.world.body_def(id).name;
        const std::string said = record::finding_sentence(
            scene.world, Judge::speed, {.value = 21.0, .time = 1.0, .interaction = {}, .body = id},
            name);
        const bool inner = name.find("/slide") != std::string::npos;
        made += inner ? 1 : 0;
        const std::string maker = " (made by \"" + name.substr(0, name.rfind('/')) + "\")";
        EXPECT_EQ(said.find(inner ? maker : "made by") != std::string::npos, inner) << said;
    }
    EXPECT_GT(made, 0);
}

// The sentence has the direction, the figure without a sign and the place.
TEST(MessageEnergy, SaysWhetherItWasLostOrGained) {
    const World world;
    const auto said = [&](double value) {
        return record::finding_sentence(
            world, Judge::energy, {.value = value, .time = 1.5, .interaction = {}, .body = {}}, "");
    };
    EXPECT_EQ(said(2500.0),
              "the whole world had gained 2.5 kJ of mechanical energy without a cause at 1.5 s");
    EXPECT_EQ(said(-2500.0),
              "the whole world had lost 2.5 kJ of mechanical energy without a cause at 1.5 s");
}

TEST(MessageRemedies, NameTheBudgetWhereThereIsOne) {
    const auto lifts = [](const WorldDef& def) {
        const World world(def);
        return std::string(record::remedy_for(world, Judge::certificate)).find("budget") !=
               std::string::npos;
    };
    EXPECT_FALSE(lifts({}));
    EXPECT_TRUE(lifts({.budget = 5e-3}));
    EXPECT_TRUE(lifts({.budget_work = 1e6}));
}

// DefError of a value far outside: six decimals of 1.9e30 are unreadable.
TEST(MessageNumbers, AreRounded) {
    World world;
    try {
        (void)world.add_body(
            {.name = "a", .kind = BodyKind::rigid, .mass = -1941747569999999945292799541248.0});
        ADD_FAILURE();
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find("-1.94174757e+30 "), std::string::npos)
            << error.what();
    }
}

}  // namespace hawser::test
