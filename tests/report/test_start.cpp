// SPDX-License-Identifier: Apache-2.0
/// Errors of a start other than those of joints.
#include "start_scene.h"

#include "report/start/start_forces.h"
#include "support/sanitizer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace hawser::test {
namespace {

std::string box(const std::string& name, double z, const std::string& more) {
    return R"({"name": ")" + name + R"(", "position": [0, 0, )" + std::to_string(z) +
           R"(], "mass": 1000, "box": [0.5, 0.5, 0.5],
        "shapes": [{"kind": "box", "half_size": [0.5, 0.5, 0.5]}])" +
           more + "}";
}

TEST(Start, OverlapsAreErrorsFromHalfTheNarrowerBody) {
    const auto separation = [](double z) {
        return start_of(R"("bodies": [)" + box("low", 0.0, "") + "," + box("high", z, "") + "]");
    };
    EXPECT_TRUE(separation(1.0).found.list.empty());
    const Finding shallow = only(separation(0.6), FindingKind::overlap);
    EXPECT_FALSE(shallow.error);
    EXPECT_NEAR(shallow.value, 0.4, 1e-9);
    EXPECT_EQ(shallow.about, (Names{"low", "high"}));
    EXPECT_TRUE(only(separation(0.4), FindingKind::overlap).error);
}

/// A wire through a solid is rejected with the positions of both in the file.
TEST(Start, AWireInsideASolidIsToldWithItsPlace) {
    const Started s = start_of(R"("settings": {"gravity": [0, 0, 0]},
        "line_types": {"rope": {"mass_per_length": 10, "EA": 1e6, "diameter": 0.05}},
        "bodies": [{"name": "block", "kind": "fixed", "position": [5, 0, 0],
                    "shapes": [{"kind": "box", "half_size": [0.1, 0.1, 0.1], "position": [0, 0, 9]},
                               {"kind": "box", "half_size": [1, 1, 1]}]}],
        "cables": [{"name": "short", "line_type": "rope", "elements": 2, "contact": {},
                    "from": {"body": "world", "point": [0, 0, 5]},
                    "to": {"body": "world", "point": [10, 0, 5]}},
                   {"name": "through", "line_type": "rope", "elements": 10, "contact": {},
                    "from": {"body": "world", "point": [0, 0, 0]},
                    "to": {"body": "world", "point": [10, 0, 0]}}])");
    const std::vector<Finding> found = s.of(FindingKind::overlap);
    ASSERT_EQ(found.size(), 4U) << s.text();
    for (const Finding& f : found) {
        // Two elements are inside the box, and two end at its faces.
        EXPECT_EQ(f.error, f.value > 1.0) << f.text;
        EXPECT_NE(f.text.find("start.json: /cables/1"), std::string::npos) << f.text;
        EXPECT_NE(f.text.find("start.json: /bodies/0/shapes/1"), std::string::npos) << f.text;
    }
    EXPECT_EQ(std::ranges::count(found, true, &Finding::error), 2);
}

TEST(Start, WhatLiesOnSoftGroundIsNoOverlap) {
    const auto on_ground = [](const char* stiffness) {
        // 9,810 N on four corners: 0.49 m at 5,000 N/m each.
        return start_of(R"("materials": {"mud": {"stiffness": )" + std::string(stiffness) +
                        R"(}}, "material_pairs": [{"between": ["mud", "default"], "stiffness": )" +
                        std::string(stiffness) +
                        R"(}], "bodies": [{"name": "ground", "kind": "fixed",
          "shapes": [{"kind": "plane", "material": "mud"}]}, )" +
                        box("crate", 0.01, "") + "]");
    };
    EXPECT_TRUE(on_ground("5000").of(FindingKind::overlap).empty());
    EXPECT_FALSE(on_ground("5e6").of(FindingKind::overlap).empty());
}

TEST(Start, OverlapsOfThousandsAreToldShortly) {
    std::string bodies;
    for (int i = 0; i < 60; ++i)
        bodies += (i > 0 ? ", " : "") + box("b" + std::to_string(i), 0.0, "");
    const Started s = start_of(R"("bodies": [)" + bodies + "]");
    EXPECT_EQ(s.found.errors(), 1000U) << "the worst of 60 x 59/2 pairs";
    EXPECT_NE(only(s, FindingKind::unexamined).text.find("1770 pairs"), std::string::npos);
    // A line for each of the first five, one for the others, one for those that are not listed.
    const std::string text = s.text();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
}

std::string rope(double from, double length, const std::string& more) {
    return R"("settings": {"gravity": [0, 0, 0]}, "line_types": {"rope": {"mass_per_length": 10,
        "EA": 1e6, "breaking_load": 5e4)" +
           more + R"(}}, "bodies": [{"name": "end", "kind": "lump", "mass": 100, "position": [)" +
           std::to_string(from) +
           R"(, 0, 0]}], "cables": [{"name": "tow", "line_type": "rope", "elements": 10,
        "length": )" +
           std::to_string(length) + R"(, "from": {"at": [0, 0, 0]}, "to": {"body": "end"}}])";
}

TEST(Start, TensionsBeyondTheBreakingLoadByCable) {
    EXPECT_TRUE(start_of(rope(104.0, 100.0, "")).of(FindingKind::tension).empty());
    const Finding f = only(start_of(rope(106.0, 100.0, "")), FindingKind::tension);
    EXPECT_FALSE(f.error);
    EXPECT_EQ(f.about, Names{"tow"});
    // 6 % of EA.
    EXPECT_NEAR(f.value, 6e4, 1.0);
    EXPECT_NE(f.text.find("1.2 times"), std::string::npos) << f.text;
}

TEST(Start, WiresThatTheStepDoesNotResolve) {
    // T = 4e4 N, ρ = 10 kg/m, l = 10 m: h c/l = 6.325 h/s, 2 from 0.316 s on.
    const auto with_step = [](const char* step) {
        std::string text = rope(104.0, 100.0, "");
        return start_of(
            text.replace(text.find("\"gravity\""), 0, std::string("\"step\": ") + step + ", "));
    };
    EXPECT_TRUE(with_step("0.3").of(FindingKind::wire_step).empty());
    const Finding f = only(with_step("0.5"), FindingKind::wire_step);
    EXPECT_EQ(f.about, Names{"tow"});
    EXPECT_NEAR(f.value, 0.5 * std::sqrt(4e4 / 10.0) / 10.0, 1e-2 * f.value)
        << "the force at the start is an estimate";
}

/// A thin rod of 1 m and 2 kg carries 1 t: f = 9.83 kN, r = 0.5 m, I = m l²/12.
TEST(Start, JointsThatTheStepDoesNotResolve) {
    const Started s = start_of(R"("bodies": [
        {"name": "rod", "position": [0, 0, -0.5], "mass": 2, "cylinder": {"radius": 0.01,
         "length": 1, "axis": "z"}},
        {"name": "load", "kind": "lump", "position": [0, 0, -1], "mass": 1000}],
      "interactions": [
        {"name": "top", "kind": "ball", "bodies": ["world", "rod"], "at": [0, 0, 0]},
        {"name": "hook", "kind": "ball", "bodies": ["rod", "load"], "at": [0, 0, -1]}])");
    const Finding f = only(s, FindingKind::joint_step);
    EXPECT_EQ(f.about, (Names{"top", "hook"}));
    const double inertia = 2.0 * (3.0 * 0.01 * 0.01 + 1.0) / 12.0, h = 1.0 / 60.0;
    // Rigid rows have a compliance of 1e-9 of the mobility, and the thin rod moves a thousand times
    // more easily than its load.
    EXPECT_NEAR(f.value, h * h * 1002 * 9.81 * 0.5 / inertia, 1e-5 * f.value);
}

TEST(Start, ForcesHoldWhatHangs) {
    const Started s = start_of(R"("bodies": [
        {"name": "a", "kind": "lump", "position": [0, 0, -1], "mass": 10},
        {"name": "b", "kind": "lump", "position": [0, 0, -2], "mass": 5, "force": [0, 0, -20]}],
      "interactions": [{"name": "r", "kind": "distance", "bodies": ["world", "a"], "length": 1},
                       {"name": "s", "kind": "distance", "bodies": ["a", "b"], "length": 1}])");
    const report::start::StartForces forces(s.scene.world);
    ASSERT_TRUE(forces.known());
    // Up to the floor of rigid rows, 1e-9 of the mobility.
    EXPECT_NEAR(forces.push({0}), 15 * 9.81 + 20, 1e-5);
    EXPECT_NEAR(forces.push({1}), 5 * 9.81 + 20, 1e-5);
}

TEST(Start, DensitiesOfNothing) {
    const auto of_mass = [](const char* mass) {
        return start_of(R"("bodies": [{"name": "crate", "mass": )" + std::string(mass) +
                        R"(, "box": [0.5, 0.5, 0.5]}])");
    };
    EXPECT_TRUE(of_mass("7850").found.list.empty());
    EXPECT_NEAR(only(of_mass("26000"), FindingKind::density).value, 26000, 1e-6);
    EXPECT_NEAR(only(of_mass("0.5"), FindingKind::density).value, 0.5, 1e-12);
    // A chain is heavier than a bar of its diameter.
    EXPECT_TRUE(
        start_of(rope(100.0, 100.0, R"(, "diameter": 0.02)")).of(FindingKind::density).empty());
    EXPECT_EQ(
        only(start_of(rope(100.0, 100.0, R"(, "diameter": 0.002)")), FindingKind::density).about,
        Names{"tow"});
}

TEST(Start, InertiasOfNoBody) {
    const auto of = [](const char* inertia) {
        return start_of(R"("bodies": [{"name": "b", "mass": 1000, "half_size": [1, 0.5, 0.5],
          "inertia": )" +
                        std::string(inertia) + "}]");
    };
    EXPECT_TRUE(of("[167, 417, 417]").found.list.empty());
    // Impossible moments of inertia, [100, 100, 201], are rejected by the scene reader.
    EXPECT_EQ(of("[1e5, 1e5, 1e5]").of(FindingKind::inertia).size(), 1U);
    EXPECT_EQ(of("[0.1, 0.1, 0.1]").of(FindingKind::inertia).size(), 1U);
}

TEST(Start, HullsThatDoNotCarryTheirMass) {
    const auto afloat = [](const char* mass, const char* draught_off) {
        return start_of(R"("bodies": [{"name": "barge", "mass": )" + std::string(mass) +
                        R"(, "box": [5, 5, 2], "position": [0, 0, )" + draught_off +
                        R"(]}], "sea": {"depth": 50,
          "hulls": [{"body": "barge", "mesh": {"box": [5, 5, 2]}}]})");
    };
    EXPECT_TRUE(afloat("205000", "0").found.list.empty());
    EXPECT_TRUE(afloat("206500", "0").found.list.empty());  // 0.7 %
    const Finding heavy = only(afloat("210000", "0"), FindingKind::displacement);
    EXPECT_FALSE(heavy.error);
    EXPECT_NEAR(heavy.value, 210.0 / 205.0, 1e-12);
    EXPECT_EQ(heavy.about, Names{"barge"});
    EXPECT_NEAR(only(afloat("205000", "0.1"), FindingKind::displacement).value, 2.0 / 1.9, 1e-12);
}

/// Return a barge of 205 t with hulls, and more of a scene after it.
std::string barge(const std::string& keys, const std::string& hulls, const std::string& more) {
    return R"("bodies": [{"name": "barge", "mass": 205000, "box": [5, 5, 2])" + keys +
           R"(}, {"name": "derrick", "mass": 20500, "box": [1, 1, 5], "position": [0, 0, 7]}],
          "sea": {"depth": 50, "hulls": [)" +
           hulls + "]}" + more;
}
const std::string kHull = R"({"body": "barge", "mesh": {"box": [5, 5, 2]}})";
constexpr const char* kDeep = R"({"body": "barge", "mesh": {"box": [5, 5, 2]}, "offset":
          [0, 0, -0.2]})";

TEST(Start, HullsOfABodyFloatTogether) {
    EXPECT_TRUE(start_of(barge("", kHull, "")).of(FindingKind::displacement).empty());
    const Finding twice =
        only(start_of(barge("", kHull + "," + kHull, "")), FindingKind::displacement);
    EXPECT_NEAR(twice.value, 0.5, 1e-12);
    EXPECT_NE(twice.text.find("the hulls of \"barge\" displace"), std::string::npos) << twice.text;
    const Finding weightless =
        only(start_of(barge(R"(, "gravity": false)", kHull, "")), FindingKind::displacement);
    EXPECT_NE(weightless.text.find("it rises"), std::string::npos) << weightless.text;
    const Finding spring = only(start_of(barge("", kHull, R"(, "interactions": [{"name": "float",
          "kind": "hydrostatic", "bodies": ["barge"], "heave_stiffness": 1e6, "roll_stiffness": 1e7,
          "pitch_stiffness": 1e7}])")),
                                FindingKind::displacement);
    EXPECT_NE(spring.text.find("hydrostatic \"float\""), std::string::npos) << spring.text;
}

/// A hull carries bodies that joints fix to it, and the pull of lines.
TEST(Start, HullsCarryWhatHangsOnThem) {
    const std::string welded = R"(, "interactions": [{"name": "foot", "kind": "lock",
          "bodies": ["barge", "derrick"], "at": [0, 0, 2]}])";
    // 0.2 m more draught: 20.5 t.
    EXPECT_TRUE(start_of(barge("", kDeep, welded)).of(FindingKind::displacement).empty());
    const Finding heavy = only(start_of(barge("", kHull, welded)), FindingKind::displacement);
    EXPECT_NEAR(heavy.value, 225.5 / 205.0, 1e-9);
    EXPECT_NE(heavy.text.find("the mass that it carries"), std::string::npos) << heavy.text;
    // A tension leg stretched by 0.1 m pulls straight down with 201 kN, 20.5 t.
    const std::string leg = R"(, "line_types": {"leg": {"mass_per_length": 1e-6, "EA": 5.630391e7}},
          "cables": [{"name": "leg", "line_type": "leg", "elements": 1, "length": 28,
          "from": {"body": "barge", "point": [0, 0, -2]}, "to": {"at": [0, 0, -30.1]}}])";
    EXPECT_TRUE(start_of(barge("", kDeep, leg)).of(FindingKind::displacement).empty())
        << start_of(barge("", kDeep, leg)).text();
    EXPECT_EQ(start_of(barge("", kHull, leg)).of(FindingKind::displacement).size(), 1U);
}

TEST(Start, PostsTakeCablesWhoseElementsHaveMass) {
    const auto beside = [](const char* more, const char* y) {
        return start_of(std::string(R"("line_types": {"wire": {"mass_per_length": 4, "EA": 1e7,
          "diameter": 0.03}}, "bodies": [{"name": "ship", "kind": "fixed"}],
          "cables": [{"name": "tow", "line_type": "wire", "elements": 10, "contact": {})") +
                        more + R"(, "from": {"at": [-10, 0, 0]}, "to": {"at": [10, 0, 0]}}],
          "posts": [{"name": "pin", "on": "ship", "radius": 0.1, "from": [0.5, )" +
                        y + R"(, -1], "to": [0.5, )" + y + ", 1]}]");
    };
    EXPECT_EQ(only(beside("", "0.5"), FindingKind::post).about, (Names{"pin", "tow"}));
    EXPECT_TRUE(beside("", "3").of(FindingKind::post).empty());
    EXPECT_TRUE(beside(R"(, "consistent_mass": true)", "0.5").of(FindingKind::post).empty());
}

/// A wire that rises from the roller to both sides would need a roller that pulls it down.
TEST(Start, LinksAreInAir) {
    const auto chain = [](const char* as) {
        return start_of(std::string(R"("sea": {"depth": 50}, "line_types": {"chain": {
          "mass_per_length": 126, "EA": 5e8, "diameter": 0.076, "cd_normal": 2.6}},
          "cables": [{"name": "anchor", "line_type": "chain", "elements": 4, "length": 20, )") +
                        as + R"( "from": {"at": [0, 0, -5]}, "to": {"at": [0, 0, -25]}}])");
    };
    EXPECT_TRUE(chain("").of(FindingKind::dry).empty());
    EXPECT_EQ(only(chain(R"("as": "links", "radius": 0.1,)"), FindingKind::dry).about,
              Names{"anchor"});
}

TEST(Start, RodsThatDisplaceWhatAHullDoes) {
    const auto with_rod = [](const char* hull, const char* area) {
        return start_of(std::string(R"("bodies": [{"name": "barge", "mass": 205000,
          "box": [5, 5, 2]}], "sea": {"depth": 50, )") +
                        hull + R"("rods": [{"body": "barge", "from": [-4, 0, 0], "to": [4, 0, 0],
          "diameter": 1)" +
                        area + "}]}");
    };
    const char* const hull = R"("hulls": [{"body": "barge", "mesh": {"box": [5, 5, 2]}}], )";
    EXPECT_TRUE(with_rod(hull, R"(, "displaced_area": 0)").found.list.empty());
    EXPECT_TRUE(with_rod("", "").found.list.empty());
    const Finding twice =
        only(with_rod(hull, R"(, "displaced_area": 0.5)"), FindingKind::displacement);
    EXPECT_FALSE(twice.error);
    EXPECT_NEAR(twice.value, 205000.0 / (1025.0 * 4.0), 1e-9);
    EXPECT_EQ(twice.about, Names{"barge"});
}

TEST(Start, ABodyThatTurnsTooFarInAStep) {
    const auto turning = [](const char* speed) {
        return start_of(R"("bodies": [{"name": "top", "mass": 10, "sphere": 0.1,
          "angular_velocity": [0, 0, )" +
                        std::string(speed) + "]}]");
    };
    EXPECT_TRUE(turning("29").of(FindingKind::spin_step).empty());
    EXPECT_NEAR(only(turning("60"), FindingKind::spin_step).value, 1.0, 1e-12);
}

/// The element at the drum is 10 m + 0.8 m × coordinate long (docs/scenes.md); 2 % of 10 m remain.
TEST(Start, ABareDrumThatKeepsOneElement) {
    const auto with = [](int version, const std::string& winch, const std::string& at) {
        const std::string text = R"({"version": )" + std::to_string(version) + R"(, "name": "start",
            "bodies": [{"name": "spool", "kind": "scalar", "mass": 500, "position": [)" +
                                 at + R"(, 0, 0], "gravity": false},
              {"name": "load", "kind": "lump", "mass": 1000, "position": [0, 0, -40]}],
            "line_types": {"wire": {"mass_per_length": 4, "EA": 1e7}},
            "cables": [{"name": "hoist", "line_type": "wire", "elements": 4,
              "from": {"at": [0, 0, 0]}, "to": {"body": "load"})" +
                                 winch + "}]}";
        return Started(scene::load_text(text, "start.json"));
    };
    const char* const drum = R"(, "winch": {"drum": "spool", "radius": 0.8})";
    struct Drum {
        const char* at;
        double hauled;
        const char* words;
    };
    for (const Drum& d : {Drum{"0", 9.8, "9.8 m"}, Drum{"5", 13.8, "13.8 m"}}) {
        const Finding f = only(with(1, drum, d.at), FindingKind::drum);
        EXPECT_FALSE(f.error);
        EXPECT_EQ(f.about, Names{"hoist"});
        EXPECT_NEAR(f.value, d.hauled, 1e-9);
        EXPECT_EQ(f.text, std::string("the cable \"hoist\" keeps one element at its drum, which "
                                      "stops after hauling ") +
                              d.words + "; set \"version\": 2 to feed elements");
        EXPECT_TRUE(with(2, drum, d.at).of(FindingKind::drum).empty());
    }
    EXPECT_TRUE(with(1, "", "0").of(FindingKind::drum).empty());
}

/// The check changes nothing: later steps have the same bits as without it.
TEST(Start, TheWorldStaysAsItIs) {
    for (const char* file : {"scenes/chain_pile.json", "scenes/heavy_hook.json",
                             "scenes/slider_crank.json", "scenes/box_stack.json"}) {
        scene::Scene plain = scene::load_file(file);
        Started looked = start_of_file(file);
        EXPECT_EQ(plain.world.state().hash(), looked.scene.world.state().hash()) << file;
        for (int i = 0; i < 5; ++i) {
            ASSERT_EQ(plain.world.step(), Status::ok);
            ASSERT_EQ(looked.scene.world.step(), Status::ok);
            ASSERT_EQ(plain.world.state().hash(), looked.scene.world.state().hash()) << file;
        }
        EXPECT_EQ(plain.world.state().save(), looked.scene.world.state().save()) << file;
    }
}

TEST(Start, NoSceneOfTheLibraryIsImpossible) {
    HAWSER_SKIP_IF_SAMPLED();
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        const std::string file = entry.path().string();
        if (entry.path().extension() != ".json" || file.find(".settled") != std::string::npos)
            continue;
        const Started s = start_of_file(file);
        EXPECT_EQ(s.found.errors(), 0U) << file << "\n" << s.text();
        ++scenes;
    }
    EXPECT_GE(scenes, 40);
}

}  // namespace
}  // namespace hawser::test
