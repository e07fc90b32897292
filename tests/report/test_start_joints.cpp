// SPDX-License-Identifier: Apache-2.0
/// Joints of a start: redundant, inconsistent and open ones.
#include "start_scene.h"

#include <cmath>
#include <numbers>

namespace hawser::test {
namespace {

const std::string kPlatformAndBoom = R"("bodies": [
    {"name": "platform", "mass": 500, "box": [1, 1, 0.3]},
    {"name": "boom", "position": [3, 0, 0.3], "mass": 120, "box": [3, 0.3, 0.2]}],)";

std::string hinge(const std::string& name, const std::string& at) {
    return R"({"name": ")" + name +
           R"(", "kind": "hinge", "bodies": ["platform", "boom"], "at": )" + at +
           R"(, "axis": [0, 1, 0]})";
}

TEST(StartJoints, OneHingeRepeatsNothing) {
    const Started s =
        start_of(kPlatformAndBoom + R"("interactions": [)" + hinge("foot", "[0, 0, 0.3]") + "]");
    EXPECT_TRUE(s.found.list.empty()) << s.text();
}

TEST(StartJoints, TwoCollinearHingesRepeatEachOtherInFiveDirections) {
    const Started s =
        start_of(kPlatformAndBoom + R"("interactions": [)" + hinge("left", "[0, -0.4, 0.3]") + "," +
                 hinge("right", "[0, 0.4, 0.3]") + "]");
    const Finding f = only(s, FindingKind::repeated);
    EXPECT_FALSE(f.error);
    EXPECT_EQ(f.about, (Names{"left", "right"}));
    // Ten rows leave one freedom of six: five rows follow from the others.
    EXPECT_EQ(f.value, 5.0);
    EXPECT_NE(f.text.find("\"left\" and \"right\""), std::string::npos) << f.text;
    EXPECT_EQ(s.found.errors(), 0U);
}

TEST(StartJoints, TwoDoorsOnOneWallAreToldApart) {
    std::string members = R"("bodies": [{"name": "wall", "mass": 9e3, "box": [2, 0.1, 1]})";
    std::string joints;
    for (const char* door : {"a", "b"}) {
        const std::string x = door[0] == 'a' ? "-1.5" : "1.5";
        members += std::string(R"(, {"name": ")") + door + R"(", "position": [)" + x +
                   R"(, 0.5, 0], "mass": 40, "box": [0.4, 0.05, 1]})";
        for (const char* z : {"-0.8", "0.8"})
            joints += std::string(joints.empty() ? "" : ", ") + R"({"name": ")" + door + z +
                      R"(", "kind": "hinge", "bodies": ["wall", ")" + door + R"("], "at": [)" + x +
                      ", 0.1, " + z + R"(], "axis": [0, 0, 1]})";
    }
    const Started s = start_of(members + R"(], "interactions": [)" + joints + "]");
    const std::vector<Finding> found = s.of(FindingKind::repeated);
    ASSERT_EQ(found.size(), 2U) << s.text();
    EXPECT_EQ(found[0].about, (Names{"a-0.8", "a0.8"}));
    EXPECT_EQ(found[1].about, (Names{"b-0.8", "b0.8"}));
}

std::string wheel_with_ranges(const std::string& ranges) {
    return R"("bodies": [{"name": "wheel", "mass": 1000, "box": [0.5, 0.5, 0.5]}],
        "interactions": [
            {"name": "hub", "kind": "hinge", "bodies": ["world", "wheel"], "at": [0, 0, 0],
             "axis": [0, 0, 1]})" +
           ranges + "]";
}

std::string range(const std::string& name, const std::string& ends) {
    return R"(, {"name": ")" + name +
           R"(", "kind": "hinge_range", "bodies": ["world", "wheel"], "axis": [0, 0, 1], )" + ends +
           "}";
}

TEST(StartJoints, RangesWithNothingInCommonContradictEachOther) {
    const Started s = start_of(wheel_with_ranges(range("left", R"("min": -0.1, "max": 0.1)") +
                                                 range("right", R"("min": 0.3, "max": 0.6)")));
    const Finding f = only(s, FindingKind::contradiction);
    EXPECT_TRUE(f.error);
    EXPECT_EQ(f.about, (Names{"left", "right"}));
    EXPECT_NEAR(f.value, 0.2, 1e-12);
    const Finding outside = only(s, FindingKind::gap);
    EXPECT_FALSE(outside.error);
    EXPECT_EQ(outside.about, Names{"right"});
    EXPECT_NE(outside.text.find("starts at 0 rad, outside of its range [0.3, 0.6]"),
              std::string::npos)
        << outside.text;
}

TEST(StartJoints, AnEndOfARangeBeyondHalfATurnNeverActs) {
    const Started s = start_of(wheel_with_ranges(range("wrapped", R"("min": -1, "max": 4)") +
                                                 range("one_end", R"("min": -1, "max": 1e9)")));
    const Finding f = only(s, FindingKind::gap);
    EXPECT_FALSE(f.error);
    EXPECT_EQ(f.about, Names{"wrapped"});
    EXPECT_EQ(f.value, 4.0);
}

TEST(StartJoints, RangesThatOverlapAreNoMistake) {
    const Started s = start_of(wheel_with_ranges(range("wide", R"("min": -1, "max": 1)") +
                                                 range("narrow", R"("min": -0.2, "max": 1.5)")));
    EXPECT_TRUE(s.found.list.empty()) << s.text();
}

/// Overconstrained but mobile: six hinges in a ring have 30 rows for 5 x 6 relative freedoms.
TEST(StartJoints, BricardIsAWarningAtMost) {
    const Started s = start_of_file("scenes/bricard.json");
    const Finding f = only(s, FindingKind::repeated);
    EXPECT_EQ(f.about.size(), 6U);
    EXPECT_EQ(f.value, 1.0);
    EXPECT_EQ(s.found.errors(), 0U) << s.text();
}

TEST(StartJoints, ACylindricalJointAndALockElsewhereContradictEachOther) {
    const Started s = start_of(R"("bodies": [
        {"name": "a", "mass": 4, "box": [1, 1, 0.3]},
        {"name": "b", "mass": 5, "box": [0.2, 1, 0.5], "position": [0, 2, -0.5]}],
      "interactions": [
        {"name": "c", "kind": "cylindrical", "bodies": ["a", "b"], "at": [0.5, -0.5, 1],
         "axis": [0, 0, 1]},
        {"name": "l", "kind": "lock", "bodies": ["a", "b"],
         "points": [[-1, 0.5, 0], [0.5, -0.7, 0.7]]}])");
    const Finding f = only(s, FindingKind::contradiction);
    EXPECT_TRUE(f.error);
    EXPECT_EQ(f.about, (Names{"c", "l"}));
    EXPECT_GT(f.value, 0.1) << "[m]";
    EXPECT_NE(f.text.find("\"c\" and \"l\""), std::string::npos) << f.text;
}

TEST(StartJoints, RodsTooShortForTheirTriangleContradictEachOther) {
    const auto rods = [](double length) {
        return start_of(R"("bodies": [{"name": "bob", "kind": "lump", "position": [0, 0, -1],
            "mass": 1}], "interactions": [
            {"name": "left", "kind": "distance", "bodies": ["world", "bob"],
             "points": [[-3, 0, 0], [0, 0, 0]], "length": )" +
                        std::to_string(length) + R"(},
            {"name": "right", "kind": "distance", "bodies": ["world", "bob"],
             "points": [[3, 0, 0], [0, 0, 0]], "length": )" +
                        std::to_string(length) + "}]");
    };
    const Started separation = rods(2.0);
    const Finding f = only(separation, FindingKind::contradiction);
    EXPECT_EQ(f.about, (Names{"left", "right"}));
    EXPECT_NEAR(f.value, 1.0, 1e-3) << "each is a metre short when the bob is between both";
    // If long enough, they start open and close: not inconsistent.
    const Started closes = rods(3.5);
    EXPECT_EQ(closes.found.errors(), 0U) << closes.text();
    EXPECT_EQ(closes.of(FindingKind::gap).size(), 2U) << closes.text();
    EXPECT_NE(closes.text().find(" too short"), std::string::npos) << closes.text();
}

/// A planar four-bar of hinges has redundant rows across its plane, and is 5 cm open in it: it
/// closes.
TEST(StartJoints, AnOpenFourBarIsAGapAndNoContradiction) {
    const Started s = start_of(R"("bodies": [
        {"name": "crank", "position": [0, 0, 0.5], "mass": 10, "box": [0.05, 0.05, 0.5]},
        {"name": "rod", "position": [1, 0, 1], "mass": 20, "box": [1, 0.05, 0.05]},
        {"name": "arm", "position": [2.05, 0, 0.5], "mass": 10, "box": [0.05, 0.05, 0.5]}],
      "interactions": [
        {"name": "o", "kind": "hinge", "bodies": ["world", "crank"], "at": [0, 0, 0], "axis": [0, 1, 0]},
        {"name": "p", "kind": "hinge", "bodies": ["crank", "rod"], "at": [0, 0, 1], "axis": [0, 1, 0]},
        {"name": "q", "kind": "hinge", "bodies": ["rod", "arm"], "points": [[1, 0, 0], [0, 0, 0.5]],
         "axis": [0, 1, 0]},
        {"name": "r", "kind": "hinge", "bodies": ["world", "arm"], "at": [2.05, 0, 0], "axis": [0, 1, 0]}])");
    EXPECT_EQ(s.found.errors(), 0U) << s.text();
    const Finding gap = only(s, FindingKind::gap);
    EXPECT_EQ(gap.about, Names{"q"});
    EXPECT_NEAR(gap.value, 0.05, 1e-9);
    EXPECT_EQ(only(s, FindingKind::repeated).value, 3.0);
}

/// Rows of a chain differ by at least 1/n², far more than redundant ones.
TEST(StartJoints, ALongChainBetweenTwoFixedPointsRepeatsNothing) {
    const Started s = start_of(R"("line_types": {"t": {"mass_per_length": 10, "diameter": 0.05}},
      "cables": [{"name": "chain", "line_type": "t", "as": "links", "elements": 1000, "length": 500,
        "shape": "catenary", "from": {"at": [0, 0, 0]}, "to": {"at": [400, 0, 0]}}])");
    EXPECT_TRUE(s.of(FindingKind::repeated).empty()) << s.text();
    EXPECT_EQ(s.found.errors(), 0U) << s.text();
}

TEST(StartJoints, SpeedsThatTearAJointAreTold) {
    const Started s = start_of(kPlatformAndBoom + R"("interactions": [)" +
                               hinge("foot", "[0, 0, 0.3]") + R"(], "settings": {"step": 0.01})");
    EXPECT_TRUE(s.of(FindingKind::speed).empty());
    const Started moving = start_of(R"("bodies": [
        {"name": "platform", "mass": 500, "box": [1, 1, 0.3]},
        {"name": "boom", "position": [3, 0, 0.3], "mass": 120, "box": [3, 0.3, 0.2],
         "velocity": [0, 2, 0]}], "interactions": [)" +
                                    hinge("foot", "[0, 0, 0.3]") + "]");
    const Finding f = only(moving, FindingKind::speed);
    EXPECT_NEAR(f.value, 2.0, 1e-12);
}

std::string driven(const std::string& motors, bool locked) {
    return R"("bodies": [{"name": "rotor", "position": [0, 0, 1], "mass": 5, "sphere": 0.2}],
      "interactions": [{"name": "bearing", "kind": "hinge", "bodies": ["world", "rotor"],
        "at": [0, 0, 1], "axis": [0, 0, 1]})" +
           std::string(locked ? R"(, {"name": "stop", "kind": "lock", "bodies": ["world", "rotor"],
        "at": [0, 0, 1]})"
                              : "") +
           motors + "]";
}

std::string motor(const std::string& name, const std::string& rest) {
    return R"(, {"name": ")" + name +
           R"(", "kind": "hinge_motor", "bodies": ["world", "rotor"], "axis": [0, 0, 1], )" + rest +
           "}";
}

TEST(StartJoints, MotorsAgainstWhatHolds) {
    EXPECT_TRUE(start_of(driven(motor("m", R"("speed": 2)"), false)).found.list.empty());
    const Started limited =
        start_of(driven(motor("m", R"("speed": 2, "force_min": -300, "force_max": 300)"), true));
    const Finding weak = only(limited, FindingKind::motor);
    EXPECT_FALSE(weak.error);
    EXPECT_EQ(weak.value, 2.0);
    EXPECT_NE(std::find(weak.about.begin(), weak.about.end(), "stop"), weak.about.end());
    EXPECT_NE(weak.text.find(" wants 2 rad/s where "), std::string::npos) << weak.text;
    EXPECT_NE(weak.text.find(" hold still or drive otherwise"), std::string::npos) << weak.text;
    const Started unlimited = start_of(driven(motor("m", R"("speed": 2)"), true));
    EXPECT_TRUE(only(unlimited, FindingKind::motor).error) << unlimited.text();
}

TEST(StartJoints, MotorsAgainstAClosedRangeAndAHold) {
    const std::string m = motor("m", R"("speed": 2, "force_min": -300, "force_max": 300)");
    const auto range = [](const char* max) {
        return R"(, {"name": "catch", "kind": "hinge_range", "bodies": ["world", "rotor"],
            "axis": [0, 0, 1], "min": 0, "max": )" +
               std::string(max) + "}";
    };
    const Finding closed = only(start_of(driven(m + range("0"), false)), FindingKind::motor);
    EXPECT_NE(closed.text.find("\"catch\""), std::string::npos) << closed.text;
    EXPECT_TRUE(start_of(driven(m + range("1"), false)).of(FindingKind::motor).empty());

    const Started drum = start_of(R"("bodies": [{"name": "drum", "kind": "scalar", "mass": 50}],
      "interactions": [{"name": "brake", "kind": "hold", "bodies": ["drum"]},
        {"name": "haul", "kind": "scalar_motor", "bodies": ["drum"], "speed": -1,
         "force_min": -500, "force_max": 500}])");
    EXPECT_EQ(only(drum, FindingKind::motor).about, (Names{"brake", "haul"}));
}

TEST(StartJoints, TwoMotorsOfOneJoint) {
    const std::string a = motor("a", R"("speed": 2)"), b = motor("b", R"("speed": 1.5)");
    const Started separation = start_of(driven(a + b, false));
    EXPECT_EQ(separation.of(FindingKind::motor).size(), 2U) << separation.text();
    // The same speed twice is consistent.
    const Started alike = start_of(driven(a + motor("b", R"("speed": 2)"), false));
    EXPECT_EQ(alike.found.errors(), 0U) << alike.text();
    EXPECT_EQ(only(alike, FindingKind::repeated).about, (Names{"a", "b"}));
}

TEST(StartJoints, AMotorThatFrictionHolds) {
    const std::string brake =
        R"(, {"name": "brake", "kind": "hinge_friction", "bodies": ["world", "rotor"],
        "axis": [0, 0, 1], "torque": 500})";
    const std::string m = motor("m", R"("speed": 2, "force_min": -300, "force_max": 300)");
    const Finding held = only(start_of(driven(m + brake, false)), FindingKind::motor);
    EXPECT_EQ(held.about, (Names{"m", "brake"}));
    const std::string strong = motor("m", R"("speed": 2, "force_min": -600, "force_max": 600)");
    EXPECT_TRUE(start_of(driven(strong + brake, false)).of(FindingKind::motor).empty());
}

TEST(StartJoints, PrescribedVelocitiesThatCannotBeKept) {
    const auto between = [](const char* speed) {
        return start_of(R"("bodies": [
            {"name": "cart", "kind": "kinematic", "position": [0, 0, 0], "velocity": [)" +
                        std::string(speed) + R"(, 0, 0]},
            {"name": "load", "mass": 5, "sphere": 0.2, "position": [0, 0, 0.5]}],
          "interactions": [
            {"name": "on", "kind": "lock", "bodies": ["cart", "load"], "at": [0, 0, 0.5]},
            {"name": "held", "kind": "ball", "bodies": ["world", "load"], "at": [0, 0, 0.5]}])");
    };
    const Finding f = only(between("1"), FindingKind::contradiction);
    EXPECT_TRUE(f.error);
    EXPECT_EQ(f.about, (Names{"on", "held"}));
    EXPECT_EQ(between("0").found.errors(), 0U);
}

TEST(StartJoints, TooManyRowsAreSaidNotToHaveBeenLookedAt) {
    const Started s = start_of_file("scenes/bricard.json");
    const auto found = report::start::check_start(s.info, s.scene.world, 29);
    ASSERT_EQ(found.list.size(), 1U);
    EXPECT_EQ(found.list[0].kind, FindingKind::unexamined);
    EXPECT_EQ(found.list[0].value, 30.0);
}

}  // namespace
}  // namespace hawser::test
