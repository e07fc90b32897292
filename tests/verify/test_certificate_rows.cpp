// SPDX-License-Identifier: Apache-2.0
// Momentum of bodies in joints, wires and chains, and bounds of rows, by separate code.
#include <hawser/scene.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace hawser {
namespace {

/// Change a force, so that the verifier reads a wrong one after the step.
void tamper(const World& world, InteractionId id, std::size_t row, double change) {
    const_cast<double&>(world.force(id)[row]) += change;
}

/// Return values of parameters without a default, so that every kind carries a force: ranges are
/// exceeded, motors and friction are at a bound.
double value_of(const std::string& param) {
    static const std::map<std::string, double> kValues{
        {"length", 0.9},         {"EA", 1e5},
        {"EI", 200.0},           {"GJ", 100.0},
        {"radius", 0.3},         {"heave_stiffness", 1e4},
        {"roll_stiffness", 1e3}, {"min", 0.05},
        {"max", 0.06},           {"pitch_stiffness", 2e3},
        {"speed", 1.0},          {"force_min", -3.0},
        {"force_max", 5.0},      {"target", 0.1},
        {"force", 2.0},          {"torque", 1.5},
        {"rest_height", 0.2},    {"teeth_1", 4.0},
        {"teeth_2", -6.0},       {"path", 1.0}};
    const auto found = kValues.find(param);
    return found == kValues.end() ? kDefault : found->second;
}

BodyDef tilted(const char* name, const Vec3& place, double angle) {
    BodyDef def{.name = name, .position = place, .mass = 3.0};
    def.orientation = Quat(Eigen::AngleAxisd(angle, Vec3(0.3, -0.5, 0.8).normalized()));
    def.inertia = Vec3(0.2, 0.3, 0.4).asDiagonal();
    def.angular_velocity = {0.5, -1.0, 2.0};
    def.torque = {1.0, 0.5, -0.7};
    return def;
}

/// Add rigid bodies whose points and frames are slightly apart, under gravity; and drums.
InteractionId build(World& world, InteractionKind kind) {
    const KindInfo& info = kind_info(kind);
    const BodyId rigid[3] = {world.add_body(tilted("a", {0, 0, 0}, 0.4)),
                             world.add_body(tilted("b", {0.4, 0.7, 0.5}, -0.9)),
                             world.add_body(tilted("c", {0.9, 1.2, 1.4}, 1.7))};
    const BodyId drum =
        world.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 2.0, .force = {9, 0, 0}});
    const BodyId spool =
        info.scalars == 2 ? world.add_body({.name = "spool", .kind = BodyKind::scalar, .mass = 1.5})
                          : BodyId{};
    InteractionDef def{.kind = kind};
    const Quat frame(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()));
    for (int b = 0; b < info.bodies; ++b) {
        const auto slot = static_cast<std::size_t>(b);
        def.body[slot] = b == info.scalar_slot ? drum : info.takes_scalar(b) ? spool : rigid[b];
        if (info.takes_scalar(b)) continue;
        const Pose pose = world.pose(def.body[slot]);
        const Vec3 shared = info.length_from_pose || info.bodies == 3
                                ? Vec3(pose.position + Vec3(0.1, -0.2, 0.15))
                                : Vec3(0.2, 0.4, 0.3);
        def.point[slot] = pose.orientation.conjugate() * (shared - pose.position);
        def.frame[slot] = pose.orientation.conjugate() * frame;
        // Slightly off their reference poses; the axes of a cardan joint are perpendicular.
        if (b == 1)
            def.frame[slot] = def.frame[slot] * Quat(Eigen::AngleAxisd(0.02, Vec3::UnitY()));
        if (b == 1 && kind == InteractionKind::Universal)
            def.frame[slot] = def.frame[slot] * Quat(Eigen::AngleAxisd(1.5, Vec3::UnitX()));
    }
    for (const ParamInfo& param : info.params)
        if (const double value = value_of(param.name); value == value) def.set(param.name, value);
    return world.add_interaction(def);
}

/// Run the kind. @return final report of the verifier. @param row  Row to change after the last
/// step.
std::string outcome(InteractionKind kind, int row, verify::Verification& result) {
    World world;
    const InteractionId id = build(world, kind);
    verify::Verifier verifier(world);
    for (int i = 0; i < 6; ++i) {
        verifier.before_step(world);
        EXPECT_EQ(world.step(), Status::ok);
        // In newtons or newton metres: the impulses of gravity on the bodies are 0.5 N s.
        if (i == 5 && row >= 0) tamper(world, id, static_cast<std::size_t>(row), 1e-6);
        const std::string wrong = verifier.after_step(world);
        result = verifier.result();
        if (i == 5) return wrong;
        EXPECT_EQ(wrong, "") << kind_info(kind).name << ", step " << i;
    }
    return {};
}

TEST(CertificateRows, EveryKindIsCoveredAndAWrongForceFound) {
    for (const KindInfo& info : interaction_kinds()) {
        verify::Verification result;
        EXPECT_EQ(outcome(info.kind, -1, result), "") << info.name;
        EXPECT_EQ(result.covered_bodies, info.scalars == 2 ? 5 : 4) << info.name;
        // Rounding of sums of a few terms.
        EXPECT_LE(result.momentum, 1e-12) << info.name;
        for (int row = 0; row < info.rows; ++row)
            EXPECT_NE(outcome(info.kind, row, result), "") << info.name << ", row " << row;
    }
}

TEST(CertificateRows, ChainsAndWiresOfScenes) {
    // Links, ropes with bending and twist on a drum, wires with point masses and rigid ends on a
    // cylinder, mechanisms, limits, motors.
    for (const char* name : {"hanging_chain", "anchor_lines", "heavy_hook", "cable_spin",
                             "wire_cylinder", "bricard", "joint_limits", "motor_limits"}) {
        // Residuals of the end-of-step iteration are not checked.
        scene::Options tight;
        tight.set = {"settings.solution_tolerance=1e-13"};
        scene::Scene scene = scene::load_file(std::string("scenes/") + name + ".json", tight);
        verify::Verifier verifier(scene.world);
        for (int i = 0; i < 20; ++i) {
            verifier.before_step(scene.world);
            ASSERT_EQ(scene.world.step(), Status::ok);
            ASSERT_EQ(verifier.after_step(scene.world), "") << name << ", step " << i;
        }
        EXPECT_EQ(verifier.result().covered_bodies, verifier.result().moving_bodies) << name;
        EXPECT_EQ(verifier.result().bounds, 0.0) << name;
        EXPECT_LE(verifier.result().momentum, 1e-11) << name;
    }
}

TEST(CertificateRows, StiffnessBesideTheRowsCounts) {
    // Without the links' stiffness and damping in the sum, momentum of this chain is not balanced.
    scene::Scene scene = scene::load_file("scenes/hanging_chain.json");
    double largest = 0.0;
    std::vector<Pose> pose(static_cast<std::size_t>(scene.world.body_count()));
    std::vector<Twist> twist(pose.size());
    const BodyId last{scene.world.body_count() - 1};
    scene.world.set_force(last, {200.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
    for (int i = 0; i < 10; ++i) {
        for (std::int32_t b = 0; b < scene.world.body_count(); ++b) {
            pose[static_cast<std::size_t>(b)] = scene.world.pose({b});
            twist[static_cast<std::size_t>(b)] = scene.world.velocity({b});
        }
        std::vector<std::vector<double>> before;
        for (std::int32_t k = 0; k < scene.world.interaction_count(); ++k) {
            const auto force = scene.world.force({k});
            before.emplace_back(force.begin(), force.end());
        }
        ASSERT_EQ(scene.world.step(), Status::ok);
        for (std::int32_t k = 0; k < scene.world.interaction_count(); ++k)
            for (const verify::Wrench& w :
                 verify::stiffness_wrenches(scene.world, {k}, pose, twist, twist,
                                            before[static_cast<std::size_t>(k)], 0)
                     .on)
                largest = std::max(largest, w.torque.norm() + w.force.norm());
    }
    // A thousand times the verifier's tolerance, which is relative to the weight of one link.
    const double weight = scene.world.settings().step * 9.81 * scene.world.body_def(last).mass;
    EXPECT_GT(largest, 1e-6 * weight);
}

/// Return the report on a scene after three steps, and a fourth one whose row has this force.
std::string with_force(const char* name, const char* interaction, double force) {
    scene::Scene scene = scene::load_file(std::string("scenes/") + name + ".json");
    const InteractionId id = scene.world.find_interaction(interaction);
    EXPECT_TRUE(id.valid()) << interaction;
    verify::Verifier verifier(scene.world);
    for (int i = 0; i < 4; ++i) {
        verifier.before_step(scene.world);
        EXPECT_EQ(scene.world.step(), Status::ok);
        if (i == 3) tamper(scene.world, id, 0, force - scene.world.force(id)[0]);
        const std::string wrong = verifier.after_step(scene.world);
        if (i == 3) return wrong;
        EXPECT_EQ(wrong, "");
    }
    return {};
}

TEST(CertificateRows, FindsForcesBeyondTheirBounds) {
    const auto beyond = [](const std::string& said) {
        return said.find("beyond its bound") != std::string::npos;
    };
    // A line that pushes: the smallest detected force is a millionth of a node's weight.
    EXPECT_TRUE(beyond(with_force("joint_friction", "grips_light_end", 1e-3)));
    // Motors of 150 N and 6 N m, exceeded by slightly more than a millionth of the weight of 20 kg.
    EXPECT_TRUE(beyond(with_force("motor_limits", "starts_slide_motor", 150.0005)));
    EXPECT_FALSE(beyond(with_force("motor_limits", "starts_slide_motor", 150.0)));
    EXPECT_TRUE(beyond(with_force("motor_limits", "spins_hinge_motor", -6.1)));
    // Friction bounds of 300 N, of 12 N m, and of 0.3 times 100 kg 9.81 m/s² 0.93 carried by the
    // slide itself (274 N), in both directions.
    EXPECT_TRUE(beyond(with_force("joint_friction", "stops_slide_friction", -300.01)));
    EXPECT_TRUE(beyond(with_force("joint_friction", "coasts_hinge_friction", 12.001)));
    EXPECT_TRUE(beyond(with_force("joint_friction", "slips_slide_friction", 274.0)));
    EXPECT_FALSE(beyond(with_force("joint_friction", "slips_slide_friction", 273.0)));
    // A limit pushes only when it is reached.
    EXPECT_TRUE(beyond(with_force("joint_limits", "door_hinge_range", -0.1)));
    EXPECT_TRUE(beyond(with_force("joint_limits", "block_slide_range", 0.1)));
}

}  // namespace
}  // namespace hawser
