// SPDX-License-Identifier: Apache-2.0
/// Each bad definition is rejected with a DefError that names the field, and has no effect.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <functional>

namespace hawser::test {
namespace {

const double kNan = std::nan("");

/// Run f and return the message of its DefError; "" if it throws nothing.
std::string refused(const std::function<void()>& f) {
    try {
        f();
    } catch (const DefError& e) {
        return e.what();
    }
    return "";
}

BodyDef good_body() {
    BodyDef d;
    d.name = "block";
    d.mass = 2.0;
    d.inertia = Vec3(1.0, 1.5, 2.0).asDiagonal();
    return d;
}

struct BadBody {
    const char* field;
    std::function<void(BodyDef&)> spoil;
};

const BadBody kBadBodies[] = {
    {"mass", [](BodyDef& d) { d.mass = 0.0; }},
    {"mass", [](BodyDef& d) { d.mass = -1.0; }},
    {"mass", [](BodyDef& d) { d.mass = kNan; }},
    {"mass", [](BodyDef& d) { d.mass = HUGE_VAL; }},
    {"mass", [](BodyDef& d) { d.mass = 1e-13; }},
    {"mass", [](BodyDef& d) { d.mass = 1e16; }},
    {"inertia", [](BodyDef& d) { d.inertia.setZero(); }},
    {"inertia", [](BodyDef& d) { d.inertia(0, 0) = 0.0; }},
    {"inertia", [](BodyDef& d) { d.inertia(1, 1) = -1.0; }},
    {"inertia", [](BodyDef& d) { d.inertia(0, 1) = 0.5; }},
    {"inertia", [](BodyDef& d) { d.inertia(2, 2) = 3.0; }},
    {"inertia", [](BodyDef& d) { d.inertia(2, 0) = kNan; }},
    {"position", [](BodyDef& d) { d.position.x() = kNan; }},
    {"position", [](BodyDef& d) { d.position.z() = 1e8; }},
    {"orientation", [](BodyDef& d) { d.orientation.coeffs().setZero(); }},
    {"orientation", [](BodyDef& d) { d.orientation.w() = kNan; }},
    {"velocity", [](BodyDef& d) { d.velocity.y() = HUGE_VAL; }},
    {"angular_velocity", [](BodyDef& d) { d.angular_velocity.y() = 1e6; }},
    {"force", [](BodyDef& d) { d.force.x() = kNan; }},
    {"torque", [](BodyDef& d) { d.torque.x() = -HUGE_VAL; }},
    {"linear_damping", [](BodyDef& d) { d.linear_damping.x() = -1.0; }},
    {"angular_damping", [](BodyDef& d) { d.angular_damping.z() = kNan; }},
    {"half_size", [](BodyDef& d) { d.half_size.z() = kNan; }},
    {"kind", [](BodyDef& d) { d.kind = static_cast<BodyKind>(9); }},
};

TEST(DefError, BadBodies) {
    World w;
    for (const BadBody& bad : kBadBodies) {
        BodyDef d = good_body();
        bad.spoil(d);
        const std::string message = refused([&] { w.add_body(d); });
        EXPECT_NE(message.find(bad.field), std::string::npos) << bad.field << ": " << message;
        EXPECT_NE(message.find("block"), std::string::npos) << "names the body: " << message;
    }
    EXPECT_EQ(w.body_count(), 0);
    w.add_body(good_body());
    EXPECT_NE(refused([&] { w.add_body(good_body()); }).find("block"), std::string::npos);
    EXPECT_EQ(w.body_count(), 1);
    EXPECT_EQ(w.step(), Status::ok);
}

TEST(DefError, BadWorlds) {
    const std::pair<const char*, std::function<void(WorldDef&)>> bad[] = {
        {"step", [](WorldDef& d) { d.step = 0.0; }},
        {"step", [](WorldDef& d) { d.step = -0.1; }},
        {"step", [](WorldDef& d) { d.step = kNan; }},
        {"step", [](WorldDef& d) { d.step = 2.0; }},
        {"gravity", [](WorldDef& d) { d.gravity.z() = kNan; }},
        {"geometric_stiffness", [](WorldDef& d) { d.geometric_stiffness = -1.0; }},
        {"rotation_damping", [](WorldDef& d) { d.rotation_damping = kNan; }},
        {"refinements", [](WorldDef& d) { d.refinements = 9; }},
        {"solution_tolerance", [](WorldDef& d) { d.solution_tolerance = 1e-5; }},
        {"max_bodies", [](WorldDef& d) { d.max_bodies = -1; }},
        {"max_interactions", [](WorldDef& d) { d.max_interactions = -1; }},
        {"max_contacts", [](WorldDef& d) { d.max_contacts = 0; }},
        {"max_memory", [](WorldDef& d) { d.max_memory = kNan; }},
        {"form", [](WorldDef& d) { d.form = static_cast<Form>(7); }},
        {"threads", [](WorldDef& d) { d.threads = 0; }},
        {"threads", [](WorldDef& d) { d.threads = 1000; }}};
    for (const auto& [field, spoil] : bad) {
        WorldDef d;
        spoil(d);
        EXPECT_NE(refused([&] { World w(d); }).find(field), std::string::npos) << field;
    }
}

TEST(DefError, TooManyBodiesAndInteractions) {
    WorldDef def;
    def.max_bodies = 2;
    def.max_interactions = 1;
    Recipe r;
    const BodyId g = r.ground(), b = r.lump({1, 0, 0}, 1.0);
    r.add(between(InteractionKind::Distance, {g, b}));
    World w = r.make(def);
    EXPECT_NE(refused([&] { w.add_body(good_body()); }), "");
    EXPECT_NE(refused([&] { w.add_interaction(r.interactions[0]); }), "");
    EXPECT_FALSE(w.find_body("block").valid()) << "a refused body leaves its name behind";
    EXPECT_EQ(w.step(), Status::ok);
}

class BadInteractions : public testing::Test {
  protected:
    BadInteractions() : w(r.make()) {}
    /// Expect a message that contains `word`, and no addition.
    void expect_refused(const InteractionDef& d, const std::string& word) {
        const std::string message = refused([&] { w.add_interaction(d); });
        EXPECT_NE(message.find(word), std::string::npos) << "wanted '" << word << "': " << message;
        EXPECT_EQ(w.interaction_count(), 0);
    }
    static Recipe bodies() {
        Recipe r;
        r.ground();
        r.rigid({1, 0, 0}, Quat::Identity(), 1.0, {1, 1, 1});
        r.rigid({2, 0, 0}, Quat::Identity(), 1.0, {1, 1, 1});
        r.lump({3, 0, 0}, 1.0);
        r.scalar(0.0, 1.0);
        r.add({.name = "far", .kind = BodyKind::fixed});
        r.scalar(0.0, 1.0);
        return r;
    }
    Recipe r = bodies();
    World w;
    const BodyId ground{0}, a{1}, b{2}, lump{3}, drum{4}, far{5}, spool{6};
};

TEST_F(BadInteractions, Bodies) {
    expect_refused(between(InteractionKind::Ball, {a}), "body 1");
    expect_refused(between(InteractionKind::Ball, {a, BodyId{99}}), "body 1");
    expect_refused(between(InteractionKind::Ball, {BodyId{-7}, a}), "body 0");
    expect_refused(between(InteractionKind::Ball, {a, a}), "itself");
    expect_refused(between(InteractionKind::Ball, {ground, far}), "no body that moves");
    expect_refused(between(InteractionKind::Ball, {a, drum}), "scalar");
    expect_refused(between(InteractionKind::Hold, {a}), "scalar");
    expect_refused(between(InteractionKind::Hinge, {a, lump}), "lump");
    expect_refused(between(InteractionKind::Hydrostatic, {lump}), "rigid");
    InteractionDef winch = between(InteractionKind::WinchStretch, {a, lump, b});
    expect_refused(winch.set("radius", 1.0).set("EA", 1e3), "scalar");
    InteractionDef odd;
    odd.kind = static_cast<InteractionKind>(200);
    expect_refused(odd, "kind");
}

TEST_F(BadInteractions, Values) {
    InteractionDef d = between(InteractionKind::Ball, {a, b});
    d.point[1].x() = kNan;
    expect_refused(d, "point");
    d = between(InteractionKind::Hinge, {a, b});
    d.frame[0].coeffs().setZero();
    expect_refused(d, "frame");
    d = between(InteractionKind::Ball, {a, b});
    d.compliance[2] = -1e-9;
    expect_refused(d, "compliance");
    d.compliance[2] = HUGE_VAL;
    expect_refused(d, "compliance");
    d = between(InteractionKind::Ball, {a, b});
    d.damping_time[0] = -1.0;
    expect_refused(d, "damping_time");
    expect_refused(between(InteractionKind::Stretch, {a, lump}), "EA");
    d = between(InteractionKind::Stretch, {a, lump});
    d.set("EA", 1e5).set("length", 0.0);
    expect_refused(d, "length");
    d.set("EA", -1.0).set("length", 1.0);
    expect_refused(d, "EA");
    d = between(InteractionKind::HingeRange, {a, b});
    expect_refused(d.set("min", 1.0).set("max", -1.0), "min");
    d = between(InteractionKind::ScalarMotor, {drum});
    expect_refused(d.set("force_min", 1.0).set("force_max", -1.0), "force_min");
    expect_refused(d.set("force_min", -1.0).set("force_max", 1.0).set("speed", 1e9), "speed");
}

/// Every parameter of every kind: below its minimum, above its maximum, NaN if it has no default.
TEST_F(BadInteractions, EveryParameterIsChecked) {
    for (const KindInfo& info : interaction_kinds()) {
        std::vector<BodyId> ids;
        for (int slot = 0; slot < info.bodies; ++slot)
            ids.push_back(slot == info.scalar_slot  ? drum
                          : info.takes_scalar(slot) ? spool
                          : slot == 0               ? a
                          : slot == 1               ? b
                          : info.uses_frames        ? far
                                                    : lump);
        InteractionDef good = between(info.kind, ids);
        for (const ParamInfo& p : info.params)
            good.set(p.name, std::isnan(p.fallback) ? 1.0 : p.fallback);
        for (const ParamInfo& p : info.params) {
            for (double bad : {p.min - 1.0 - std::abs(p.min), p.max + 1.0 + std::abs(p.max)}) {
                InteractionDef d = good;
                expect_refused(d.set(p.name, bad), p.name);
            }
        }
    }
}

TEST(DefError, BadInputs) {
    World w = pendulum().make();
    InputDef d;
    d.body = BodyId{1};
    EXPECT_NE(refused([&] { w.add_input(d); }).find("name"), std::string::npos);
    d.name = "in";
    d.component = 6;
    EXPECT_NE(refused([&] { w.add_input(d); }).find("component"), std::string::npos);
    d.component = 0;
    d.min = 2;
    d.max = 1;
    EXPECT_NE(refused([&] { w.add_input(d); }).find("range"), std::string::npos);
    d.min = -1;
    d.body = BodyId{77};
    EXPECT_NE(refused([&] { w.add_input(d); }), "");
    d.interaction = InteractionId{0};
    d.param = "nothing";
    EXPECT_NE(refused([&] { w.add_input(d); }).find("nothing"), std::string::npos);
    EXPECT_EQ(w.input_count(), 0);
    d.param = "length";
    w.add_input(d);
    EXPECT_NE(refused([&] { w.add_input(d); }).find("in"), std::string::npos) << "name taken";
    d.name = "another";
    EXPECT_NE(refused([&] { w.add_input(d); }).find("one input a parameter"), std::string::npos);
    EXPECT_EQ(w.input_count(), 1);
}

TEST(DefError, BadStates) {
    World w = pendulum().make();
    Pose p;
    p.position.x() = kNan;
    EXPECT_NE(refused([&] { w.set_pose(BodyId{1}, p); }), "");
    p.position.x() = 0;
    p.orientation.coeffs().setZero();
    EXPECT_NE(refused([&] { w.set_pose(BodyId{1}, p); }), "");
    Twist t;
    t.angular.z() = HUGE_VAL;
    EXPECT_NE(refused([&] { w.set_velocity(BodyId{1}, t); }), "");
    EXPECT_NE(refused([&] { w.set_velocity(BodyId{0}, {}); }), "") << "fixed";
    EXPECT_NE(refused([&] { w.set_force(BodyId{1}, {kNan, 0, 0}, {0, 0, 0}); }), "");
    EXPECT_NE(refused([&] { (void)w.pose(BodyId{}); }), "");
    EXPECT_NE(refused([&] { (void)w.force(InteractionId{9}); }), "");
    EXPECT_EQ(w.step(), Status::ok);
}

}  // namespace
}  // namespace hawser::test
