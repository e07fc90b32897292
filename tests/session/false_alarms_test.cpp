// SPDX-License-Identifier: Apache-2.0
/// Correct scenes that coarse monitors would suspect: all end as good, and each step is verified.
#include <hawser/session.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace hawser::test {

namespace {

constexpr const char* kNoGravity = R"("gravity": [0, 0, 0], )";

/// Run to the end of the scene.
void expect_good(const std::string& text) {
    Session session({.scene_text = text, .verify = true});
    const double end = session.scene().duration;
    while (session.time() < end - 1e-9) {
        ASSERT_EQ(session.step(), Status::ok) << session.time() << " s: " << session.objection();
        ASSERT_EQ(session.objection(), "") << session.time() << " s";
    }
    const Verdict v = session.world().verdict();
    EXPECT_EQ(v.grade, Grade::good) << to_string(v.judge) << " at " << v.of(v.judge).time;
}

/// Return a block that a spring drags, with a body of prescribed velocity at its other end.
std::string dragged_block(double stiffness, double friction, double speed, double step) {
    return fmt::format(
        R"({{"version": 1, "name": "dragged", "settings": {{"step": {}, "duration": 20}},
        "material_pairs": [{{"between": ["default", "default"], "friction": {},
                             "stiffness": 1e6}}],
        "bodies": [{{"name": "floor", "kind": "fixed", "shapes": [{{"kind": "plane"}}]}},
          {{"name": "carriage", "kind": "kinematic", "position": [2, 0, 0.25],
            "velocity": [{}, 0, 0]}},
          {{"name": "block", "position": [0, 0, 0.2498], "mass": 100, "box": [0.5, 0.5, 0.25],
            "shapes": [{{"kind": "box", "half_size": [0.5, 0.5, 0.25]}}]}}],
        "interactions": [{{"name": "spring", "kind": "distance", "bodies": ["carriage", "block"],
            "points": [[0, 0, 0], [0.5, 0, 0]], "length": 1.5, "compliance": {}}}]}})",
        step, friction, speed, 1.0 / stiffness);
}

/// Return the block without friction and damping: it oscillates for ever.
std::string drawn_block(double stiffness, double speed, double step) {
    return fmt::format(
        R"({{"version": 1, "name": "drawn", "settings": {{{}"step": {}, "duration": 20}},
        "bodies": [{{"name": "carriage", "kind": "kinematic", "position": [2, 0, 0],
                     "velocity": [{}, 0, 0]}},
          {{"name": "block", "position": [0, 0, 0], "mass": 100, "box": [0.5, 0.5, 0.25]}}],
        "interactions": [{{"name": "spring", "kind": "distance", "bodies": ["carriage", "block"],
            "length": 2, "compliance": {}, "damping_time": 0}}]}})",
        kNoGravity, step, speed, 1.0 / stiffness);
}

std::string atwood(double left, double right, double EA, double duration) {
    return fmt::format(
        R"({{"version": 1, "name": "atwood", "settings": {{"step": 0.05, "duration": {}}},
        "bodies": [{{"name": "beam", "kind": "fixed", "position": [0, 0, 30]}},
          {{"name": "left", "position": [-0.3, 0, 20], "mass": {}, "box": [0.3, 0.3, 0.3]}},
          {{"name": "right", "position": [0.3, 0, 20], "mass": {}, "box": [0.3, 0.3, 0.3]}}],
        "routes": [{{"name": "upper", "EA": {}, "first": {{"body": "left", "point": [0, 0, 0.3]}},
          "places": [{{"body": "beam", "point": [0, 0, 0], "axis": [0, 1, 0], "radius": 0.3,
                       "inertia": 0.5}}],
          "last": {{"body": "right", "point": [0, 0, 0.3]}}}}]}})",
        duration, left, right, EA);
}

/// Return Atwood's machine with a wire of point masses over a wheel of 0.5 m: nodes run over it.
/// Both sides lean outwards by 0.028 m per metre, so that the wire presses on the wheel.
std::string atwood_by_wire(double step, double element) {
    constexpr double kRadius = 0.5, kLean = 0.028;
    constexpr int kNodes = 5;  // per side, with the weight
    std::string nodes;
    double end = 0.0, x = 0.0;
    for (int k = -kNodes; k < kNodes; ++k) {
        const int i = k < 0 ? -k - 1 : k;  // counted from the wheel
        const double z = -(0.5 * element - 0.5 * 3.14159265 * kRadius) - element * i;
        const double side = (k < 0 ? -1.0 : 1.0) * (kRadius - kLean * z);
        if (i == kNodes - 1) {
            end = z;
            x = std::abs(side);
        } else {
            nodes += fmt::format("{}[{}, 0, {}]", nodes.empty() ? "" : ", ", side, z);
        }
    }
    return fmt::format(
        R"({{"version": 1, "name": "atwood_by_wire", "settings": {{"step": {}, "duration": 1.5}},
        "line_types": {{"wire": {{"mass_per_length": 0.5, "EA": 1e7, "diameter": 0.02}}}},
        "bodies": [{{"name": "beam", "kind": "fixed"}},
          {{"name": "left", "kind": "lump", "position": [{}, 0, {}], "mass": 1000}},
          {{"name": "right", "kind": "lump", "position": [{}, 0, {}], "mass": 1500}}],
        "cables": [{{"name": "line", "line_type": "wire", "from": {{"body": "left"}},
          "to": {{"body": "right"}}, "length": {}, "elements": {}, "consistent_mass": true,
          "shape": [{}]}}],
        "guides": [{{"name": "wheel", "cable": "line", "on": "beam", "radius": {}}}]}})",
        step, -x, end, x, end, element * (2 * kNodes - 1), 2 * kNodes - 1, nodes, kRadius);
}

/// Return a barge pulled back and forth around a bollard: the tension before it follows a
/// hysteresis loop.
std::string bollard(double friction, int turns, double step) {
    std::string timeline;
    for (int i = 0; i < 3; ++i)
        timeline += fmt::format(R"({}{{"at": {}, "set": {{"pull": {}}}}})", i == 0 ? "" : ", ",
                                5 + 5 * i, i % 2 == 0 ? 3e4 : -3e4);
    const auto body = [](const char* name, int side) {
        return fmt::format(
            R"({{"name": "{}", "position": [{}, -0.35, 0], "mass": 20000,
            "inertia": [1e4, 1e4, 1e4], "gravity": false, "half_size": [1, 1, 1],
            "force": [{}, 0, 0], "linear_damping": [2000, 5000, 5000],
            "angular_damping": [1e5, 1e5, 1e5]}})",
            name, 40 * side, 4e4 * side);
    };
    return fmt::format(
        R"({{"version": 1, "name": "bollard", "settings": {{"step": {}, "duration": 20}},
        "line_types": {{"wire": {{"mass_per_length": 10, "EA": 5e7, "diameter": 0.05}}}},
        "bodies": [{{"name": "quay", "kind": "fixed", "position": [0, 0, 0]}}, {}, {}],
        "cables": [{{"name": "line", "line_type": "wire",
          "from": {{"body": "left", "point": [1, 0, 0]}},
          "to": {{"body": "right", "point": [-1, 0, 0]}}, "elements": 23,
          "consistent_mass": true}}],
        "guides": [{{"name": "bollard", "cable": "line", "on": "quay", "point": [0, 0, 0],
          "axis": [0, 0, 1], "radius": 0.35, "friction": {}, "turns": {}}}],
        "inputs": [{{"name": "pull", "body": "right", "component": "force_x", "min": -1e5,
                     "max": 1e5}}],
        "timeline": [{}]}})",
        step, body("left", -1), body("right", 1), friction, turns, timeline);
}

/// Return two legs and a tow line that meet in one point mass.
std::string bridle(double step) {
    const auto ship = [](const char* name, double x, double mass, double force) {
        return fmt::format(
            R"({{"name": "{}", "position": [{}, 0, 0], "mass": {},
            "inertia": [{}, {}, {}], "gravity": false, "half_size": [12, 4, 2],
            "force": [{}, 0, 0], "linear_damping": [5e4, 2e5, 2e5],
            "angular_damping": [1e7, 1e7, 1e8]}})",
            name, x, mass, 8.0 * mass, 60.0 * mass, 60.0 * mass, force);
    };
    const auto line = [](const char* name, const char* from, const char* to, int elements) {
        return fmt::format(R"({{"name": "{}", "line_type": "wire", "from": {}, "to": {},
            "elements": {}, "consistent_mass": true}})",
                           name, from, to, elements);
    };
    return fmt::format(
        R"({{"version": 1, "name": "bridle", "settings": {{"step": {}, "duration": 20}},
        "line_types": {{"wire": {{"mass_per_length": 10, "EA": 8e7, "diameter": 0.05}}}},
        "bodies": [{}, {}, {{"name": "plate", "kind": "lump", "position": [30, 0, -0.1],
                             "mass": 150}}],
        "cables": [{}, {}, {}]}})",
        step, ship("barge", 0.0, 2e6, 0.0), ship("tug", 110.0, 5e5, 2e5),
        line("port", R"({"body": "barge", "point": [12, 4, 0]})", R"({"body": "plate"})", 6),
        line("starboard", R"({"body": "barge", "point": [12, -4, 0]})", R"({"body": "plate"})", 6),
        line("tow", R"({"body": "plate"})", R"({"body": "tug", "point": [-12, 0, 0]})", 12));
}

}  // namespace

TEST(FalseAlarms, ASpringFromAKinematicBody) {
    for (const double step : {1.0 / 60.0, 0.04}) {
        expect_good(dragged_block(2000.0, 0.3, 0.5, step));
        expect_good(dragged_block(200.0, 0.5, 0.1, step));
        expect_good(drawn_block(500.0, 1.0, step));
    }
    expect_good(drawn_block(5e4, 2.0, 1.0 / 60.0));
}

TEST(FalseAlarms, AtwoodsMachineAtATwentieth) {
    expect_good(atwood(100.0, 110.0, 1e6, 4.0));
    expect_good(atwood(1000.0, 1500.0, 1e7, 2.0));
    expect_good(atwood(20.0, 30.0, 1e7, 2.0));
}

/// Speed and tension follow the closed form, g/5 t and 2 m₁ m₂ g/(m₁ + m₂), while nodes leave the
/// wheel. A fault let nodes leave slower than the wire: the jerk was a fifth of the tension.
TEST(FalseAlarms, AtwoodsMachineByAWireOverAGuide) {
    constexpr double kTension = 2.0 * 1000.0 * 1500.0 * 9.81 / 2500.0;
    for (const double step : {0.05, 0.0125})
        for (const double element : {1.3, 1.7, 2.0}) {
            SCOPED_TRACE(fmt::format("step {}, element {}", step, element));
            Session run({.scene_text = atwood_by_wire(step, element)});
            World& w = run.world();
            const WireId line = w.wires().find("line");
            const std::size_t nodes = w.wires().nodes(line).size();
            bool moved = false;
            double most = 0.0;
            while (run.time() < 1.5 - 1e-9) {
                ASSERT_EQ(run.step(), Status::ok);
                moved = moved || w.wires().nodes(line).size() != nodes;
                // The leaning sides oscillate after the start.
                if (run.time() < 0.5) continue;
                for (const InteractionId id : w.wires().elements(line))
                    most = std::max(most, std::abs(w.force(id)[0]) / kTension - 1.0);
            }
            EXPECT_TRUE(moved) << "no node has run over the wheel";
            EXPECT_LT(most, 0.02);
            // The time is in the last step; the wire of at most 9 kg changes 0.4 %.
            const double fall = -w.velocity(w.find_body("right")).linear.z();
            constexpr double kSpeedUp = 9.81 / 5.0;
            EXPECT_NEAR(fall, kSpeedUp * (1.5 - 0.5 * step), 0.5 * kSpeedUp * step + 0.01 * fall);
            EXPECT_EQ(w.verdict().grade, Grade::good);
            EXPECT_LT(w.verdict().of(Judge::energy).doubtful, 0.3);
        }
}

TEST(FalseAlarms, HysteresisRoundBollards) {
    expect_good(bollard(0.2, 1, 1.0 / 60.0));
    expect_good(bollard(0.25, 1, 0.05));
    expect_good(bollard(0.3, 2, 1.0 / 60.0));
}

TEST(FalseAlarms, ABridleWhoseLinesMeetInOneNode) {
    for (const double step : {1.0 / 60.0, 0.05}) expect_good(bridle(step));
}

/// Return a scene with two weights on a rope over two eyes. The end of the lighter one is hauled to
/// its eye and stops.
std::string hauled_to_eye(double light, double heavy, double step) {
    return fmt::format(
        R"({{"version": 1, "name": "hauled", "settings": {{"step": {}, "duration": 3}},
        "bodies": [{{"name": "light", "kind": "lump", "mass": {}, "position": [0, 0, -1.5]}},
          {{"name": "heavy", "kind": "lump", "mass": {}, "position": [1, 0, -0.5]}}],
        "routes": [{{"name": "rope", "EA": 1e6, "first": {{"body": "light"}},
          "places": [{{"body": "world", "point": [0, 0, 0]}},
                     {{"body": "world", "point": [1, 0, 0]}}],
          "last": {{"body": "heavy"}}}}]}})",
        step, light, heavy);
}

// The slide that the stop holds creeps by 1e-9 m/s, the difference of velocities of 1 m/s. Its
// rounding times the resistance of the stop exceeds 1e-9 of the forces.
TEST(FalseAlarms, ASlideThatItsStopHolds) {
    for (const double step : {1.0 / 60.0, 1.0 / 120.0})
        for (const double heavy : {2.5, 4.0, 6.0}) {
            SCOPED_TRACE(fmt::format("{} kg, step {}", heavy, step));
            expect_good(hauled_to_eye(1.0, heavy, step));
        }
}

}  // namespace hawser::test
