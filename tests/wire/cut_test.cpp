// SPDX-License-Identifier: Apache-2.0
/// Wires that are cut, joined, attached and released while a world runs.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kEA = 1e7, kDensity = 5.0;

BodyId fixed_at(World& w, const char* name, const Vec3& at) {
    return w.add_body({.name = name, .kind = BodyKind::fixed, .position = at});
}
BodyId block(World& w, const char* name, const Vec3& at, double mass) {
    return w.add_body({.name = name,
                       .position = at,
                       .mass = mass,
                       .inertia = Mat3::Identity() * mass,
                       .linear_damping = Vec3::Constant(mass)});
}

WireDef line(const char* name, BodyId from, BodyId to, bool consistent) {
    return {.name = name,
            .from = from,
            .to = to,
            .elements = 10,
            .length = 20.0,
            .EA = kEA,
            .mass_per_length = kDensity,
            .EI = 50.0,
            .drag = 20.0,
            .radius = 0.02,
            .consistent_mass = consistent};
}

double mass_of(const World& w) {
    double sum = 0.0;
    for (const BodyId id : w.bodies())
        if (w.body_def(id).kind != BodyKind::fixed) sum += w.body_def(id).mass;
    return sum;
}

/// Momentum and energy of the nodes of wires at the half step before their poses.
struct WireAccount {
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
    double mass = 0.0;
};
WireAccount account(const World& w) {
    WireAccount a;
    const double half = 0.5 * w.settings().step;
    for (const BodyId id : w.bodies()) {
        const BodyDef& d = w.body_def(id);
        if (d.kind != BodyKind::lump) continue;
        const Vec3 v = w.velocity(id).linear;
        a.mass += d.mass;
        a.linear += d.mass * v;
        a.angular += d.mass * Vec3(w.pose(id).position - half * v).cross(v);
    }
    // Elements that move as straight pieces.
    for (const InteractionId id : w.interactions()) {
        const InteractionDef& d = w.interaction_def(id);
        if (d.kind != InteractionKind::Stretch || !(d.get("mass") > 0.0)) continue;
        const BodyId ends[2] = {d.body[0], d.body[1]};
        if (w.body_def(ends[0]).kind != BodyKind::lump ||
            w.body_def(ends[1]).kind != BodyKind::lump)
            continue;
        const Vec3 u = w.velocity(ends[1]).linear - w.velocity(ends[0]).linear;
        const Vec3 separation = w.pose(ends[1]).position - w.pose(ends[0]).position - half * u;
        a.angular -= d.get("mass") / 6.0 * separation.cross(u);
    }
    return a;
}

void run(World& w, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok) << "step " << i;
}

/// A span between two fixed points, at rest.
struct Span {
    World w{{.step = 0.01}};
    BodyId left = fixed_at(w, "left", {0, 0, 10}), right = fixed_at(w, "right", {19, 0, 10});
    WireId wire;
    explicit Span(bool consistent, int settle = 600)
        : wire(w.wires().add(line("tow", left, right, consistent))) {
        run(w, settle);
    }
};

TEST(WireCut, KeepsMassesMomentaAndEnergy) {
    for (const bool consistent : {false, true}) {
        Span f(consistent, 50);
        const WireAccount had = account(f.w);
        const double energy = f.w.energy().mechanical(), length = f.w.wires().length(f.wire);
        const WireId second = f.w.wires().cut(f.wire, 6.7);
        const WireAccount has = account(f.w);
        EXPECT_NEAR(has.mass, had.mass, 1e-12 * had.mass);
        EXPECT_LE((has.linear - had.linear).norm(), 1e-12 * had.linear.norm());
        EXPECT_LE((has.angular - had.angular).norm(), 1e-11 * had.angular.norm());
        f.w.prepare();
        EXPECT_NEAR(f.w.energy().mechanical(), energy, 1e-6 * std::abs(energy));
        EXPECT_EQ(f.w.wires().name(second), "tow/2");
        EXPECT_EQ(f.w.wires().find("tow/2"), second);
        const double first = f.w.wires().length(f.wire);
        EXPECT_NEAR(first + f.w.wires().length(second), length, 1e-6 * length);
        // Exactly there if nodes fit, otherwise at the nearest node.
        EXPECT_NEAR(first, consistent ? 6.7 : 6.0, 1e-4);
        EXPECT_EQ(f.w.wires().nodes(f.wire).size(), f.w.wires().elements(f.wire).size() + 1);
        EXPECT_EQ(f.w.wires().nodes(second).size(), f.w.wires().elements(second).size() + 1);
        run(f.w, 300);
        EXPECT_EQ(f.w.verdict().grade, Grade::good);
        // Both parts hang from their ends.
        EXPECT_NEAR(f.w.pose(f.w.wires().nodes(f.wire).back()).position.z(), 10.0 - first, 1.5);
        EXPECT_EQ(f.w.events().extremes(EventKind::cut).count, 1);
        const WireId third = f.w.wires().cut(second, 3.0);
        EXPECT_EQ(f.w.wires().name(third), "tow/3");
        run(f.w, 50);
    }
}

TEST(WireCut, SplicedAgainPullsAsBefore) {
    for (const bool consistent : {false, true}) {
        Span uncut(consistent), cut(consistent);
        const WireId second = cut.w.wires().cut(cut.wire, 8.0);
        const double mass = account(cut.w).mass;
        const Joint joint = cut.w.wires().join(cut.wire, 1, second, 0);
        EXPECT_EQ(joint.wire, cut.wire);
        EXPECT_FALSE(cut.w.alive(second));
        EXPECT_FALSE(cut.w.wires().find("tow/2").valid());
        EXPECT_NEAR(account(cut.w).mass, mass, 1e-12 * mass);
        EXPECT_EQ(cut.w.wires().elements(cut.wire).size(),
                  uncut.w.wires().elements(uncut.wire).size());
        run(uncut.w, 200);
        run(cut.w, 200);
        for (double s = 1.0; s < 20.0; s += 2.0) {
            const double t = uncut.w.wires().tension(uncut.wire, s);
            EXPECT_NEAR(cut.w.wires().tension(cut.wire, s), t, 1e-6 * t) << s;
        }
        EXPECT_EQ(cut.w.verdict().grade, Grade::good);
    }
}

TEST(WireCut, PiecesAreJoinedAnyWayRound) {
    for (int ends = 0; ends < 4; ++ends) {
        World w({.step = 0.01, .gravity = Vec3::Zero()});
        const BodyId left = fixed_at(w, "left", {0, 0, 0}),
                     right = fixed_at(w, "right", {20, 0, 0});
        const WireId wire = w.wires().add(line("tow", left, right, true));
        const WireId second = w.wires().cut(wire, 10.0);
        const int a = ends & 1, b = ends >> 1;
        if (a == 0) w.wires().detach(wire, 0);
        if (b == 1) w.wires().detach(second, 1);
        // Move the ends to join to one position.
        const BodyId one = a == 0 ? w.wires().nodes(wire).front() : w.wires().nodes(wire).back();
        const BodyId other =
            b == 0 ? w.wires().nodes(second).front() : w.wires().nodes(second).back();
        w.set_pose(other, {w.pose(one).position + Vec3(0, 0, 0.01), Quat::Identity()});
        const double mass = account(w).mass;
        ASSERT_NO_THROW((void)w.wires().join(wire, a, second, b)) << ends;
        EXPECT_NEAR(account(w).mass, mass, 1e-12 * mass);
        const auto nodes = w.wires().nodes(wire);
        const auto elements = w.wires().elements(wire);
        ASSERT_EQ(elements.size(), 10U);
        ASSERT_EQ(nodes.size(), 11U);
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const InteractionDef& d = w.interaction_def(elements[k]);
            EXPECT_EQ(d.body[0], nodes[k]) << ends << " " << k;
            EXPECT_EQ(d.body[1], nodes[k + 1]) << ends << " " << k;
        }
        // Nodes between two elements can be removed with their bends and capsules.
        ASSERT_TRUE(w.wires().remove_node(nodes[5], 3.2) || w.wires().remove_node(nodes[7], 3.2));
    }
}

TEST(WireCut, GearHoldsWeighsBreaksAndReleases) {
    for (const Gear gear : {Gear::shackle, Gear::swivel, Gear::pelican_hook}) {
        World w({.step = 0.01});
        const BodyId top = fixed_at(w, "top", {0, 0, 40});
        WireDef def = line("upper", top, {}, false);
        const WireId upper = w.wires().add(def);
        def.name = "lower";
        def.path.clear();
        const BodyId middle = fixed_at(w, "middle", {0, 0, 19.8});
        def.from = middle;
        const WireId lower = w.wires().add(def);
        w.wires().detach(lower, 0);
        const JoinDef how{
            .name = "link", .gear = gear, .mass = 12.0, .length = 0.3, .breaking_load = 5e3};
        const Joint joint = w.wires().join(upper, 1, lower, 0, how);
        run(w, 1500);
        // Weight below: half the link and the lower wire, including the half element at its first
        // end.
        const double below = (6.0 + 20.0 * kDensity) * 9.81;
        EXPECT_NEAR(-w.force(joint.held[0])[0], below, 1e-4 * below);
        EXPECT_NEAR(w.wires().tension(upper, 0.5), (12.0 + 39.0 * kDensity) * 9.81, 0.2);
        EXPECT_THROW((void)w.wires().join(upper, 1, lower, 0, how), DefError)
            << "the ends are taken";
        if (gear == Gear::pelican_hook) {
            w.wires().release(joint.held[0]);
            EXPECT_THROW(w.wires().release(joint.held[0]), DefError);
            EXPECT_EQ(w.events().extremes(EventKind::release).count, 1);
        } else {
            EXPECT_THROW(w.wires().release(joint.held[0]), DefError);
            w.set_force(w.wires().nodes(lower).back(), {0, 0, -5e3}, Vec3::Zero());
        }
        run(w, 200);
        EXPECT_FALSE(w.intact(joint.held[0]));
        EXPECT_EQ(w.events().extremes(EventKind::line_break).count,
                  gear == Gear::pelican_hook ? 0 : 1);
        // It sinks at up to 2.5 m/s, at which drag balances its weight.
        EXPECT_LT(w.pose(w.wires().nodes(lower).front()).position.z(), 16.0);
        EXPECT_EQ(w.verdict().grade, Grade::good);
    }
}

TEST(WireCut, TriplateSharesALoadByItsHoles) {
    World w({.step = 0.01});
    const BodyId left = fixed_at(w, "left", {0, 0, 10}), right = fixed_at(w, "right", {19, 0, 10});
    WireDef span = line("tow", left, right, true);
    span.drag = 200.0;  // comes to rest without a jerk
    const WireId wire = w.wires().add(span);
    const WireId second = w.wires().cut(wire, 10.0);
    // Links are as long as the distance from the ends to the holes, to avoid a jerk.
    const JoinDef how{
        .name = "plate", .gear = Gear::triplate, .mass = 400.0, .length = 0.01, .reach = 0.5};
    const double mass = mass_of(w);
    const Joint joint = w.wires().join(wire, 1, second, 0, how);
    EXPECT_NEAR(mass_of(w), mass + 400.0, 1e-9);
    ASSERT_TRUE(w.alive(joint.plate));
    WireDef def = line("pennant", joint.plate, {}, true);
    def.from_point = triplate_hole(how, 2);
    def.length = 5.0;
    def.drag = 200.0;
    (void)w.wires().add(def);
    run(w, 6000);
    // At rest, the vertical forces of the links carry plate and pennant.
    Vec3 sum{0, 0, 0};
    for (const InteractionId id : joint.held) {
        const InteractionDef& d = w.interaction_def(id);
        const Vec3 a = w.world_point(d.body[0], d.point[0]),
                   b = w.world_point(d.body[1], d.point[1]);
        const double pull = -w.force(id)[0];
        EXPECT_GT(pull, 0.0);
        sum += pull * (d.body[1] == joint.plate ? Vec3(a - b) : Vec3(b - a)).normalized();
    }
    const double pennant = (5.0 - 0.25) * kDensity;  // without its half element at the plate
    EXPECT_NEAR(sum.z(), (400.0 + pennant) * 9.81, 1e-3 * (400.0 + pennant) * 9.81);
    EXPECT_NEAR(sum.x(), 0.0, 1.0);
    EXPECT_LT(w.world_point(joint.plate, triplate_hole(how, 2)).z(),
              w.pose(joint.plate).position.z());
    const Verdict verdict = w.verdict();
    const Finding& worst = verdict.of(verdict.judge);
    EXPECT_EQ(verdict.grade, Grade::good)
        << "judge " << static_cast<int>(verdict.judge) << ", " << worst.value << " at "
        << worst.time << " s, " << worst.doubtful << " of the limit";
}

TEST(WireCut, EndsAreAttachedWhereTheyAreAndLetGo) {
    World w({.step = 0.01});
    const BodyId top = fixed_at(w, "top", {0, 0, 30});
    WireDef def = line("sling", top, {}, true);
    def.length = 10.0;
    const WireId wire = w.wires().add(def);
    const BodyId load = block(w, "load", {0, 0, 19.0}, 500.0);
    const double mass = mass_of(w);
    (void)w.wires().attach(wire, 1, load, {0, 0, 1.0 + 0.02}, {.name = "eye"});
    EXPECT_EQ(w.events().extremes(EventKind::join).count, 1);
    EXPECT_NEAR(mass_of(w), mass, 1e-9);
    run(w, 1000);
    const double below = (500.0 + 9.5 * kDensity) * 9.81;
    EXPECT_NEAR(w.wires().tension(wire, 0.5), below, 2e-3 * below);
    EXPECT_THROW((void)w.wires().attach(wire, 1, load, {0, 0, 1}), DefError) << "taken";
    w.wires().detach(wire, 1);
    EXPECT_NEAR(mass_of(w), mass, 1e-9);
    EXPECT_FALSE(w.find_interaction("eye").valid());
    run(w, 100);
    EXPECT_LT(w.pose(load).position.z(), 17.0);
    // Released from the body at its start, it gets the half element that the body carried.
    w.wires().detach(wire, 0);
    EXPECT_NEAR(account(w).mass, 10.0 * kDensity, 1e-6);
    EXPECT_EQ(w.events().extremes(EventKind::detach).count, 2);
    run(w, 100);
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

/// A piece of one short element between a point mass and a body, which gear connects to the same
/// body. Released from the body, the new end has half of the element, like the other one. A fault
/// divided the mass by lengths, including the link's: a fifteenth of half, less than a straight
/// piece can move with. The step ended as wrong_pivot.
TEST(WireCut, AnEndBesideGearHasHalfOfItsElement) {
    World w({.step = 0.01});
    const BodyId left = fixed_at(w, "left", {0, 0, 0}), right = fixed_at(w, "right", {20, 0, 0});
    const WireId wire = w.wires().add(line("tow", left, right, true));
    const WireId piece = w.wires().cut(wire, w.wires().length(wire) - 0.02);
    ASSERT_EQ(w.wires().elements(piece).size(), 1U);
    (void)w.wires().attach(piece, 0, right, Vec3::Zero(), {.gear = Gear::shackle, .reach = 1.0});
    w.wires().detach(piece, 1);
    const double half = 0.5 * w.interaction_def(w.wires().elements(piece)[0]).get("mass");
    for (const BodyId node : w.wires().nodes(piece))
        EXPECT_NEAR(w.body_def(node).mass, half, 1e-12 * half);
    run(w, 100);
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

TEST(WireCut, WiresOnDrumsAreCutAndComeOff) {
    World w({.step = 0.01});
    const BodyId deck = fixed_at(w, "deck", {0, 0, 30});
    WireDef def = line("hoist", deck, {}, true);
    const WireId wire = w.wires().add(def);
    const WinchIds ids = w.add(WinchDef{.name = "winch",
                                        .wire = wire,
                                        .core_radius = 0.5,
                                        .width = 1.0,
                                        .wire_diameter = 0.04,
                                        .mass_per_length = kDensity,
                                        .stored = 50.0,
                                        .inertia = 100.0,
                                        .brake_static = 1e5});
    run(w, 200);
    const WireId piece = w.wires().cut(wire, 12.0);
    run(w, 100);
    EXPECT_GT(w.wires().tension(wire, 0.5), 100.0);
    EXPECT_EQ(w.wires().tension(piece, 1.0), 0.0);
    const double length = w.wires().length(wire);
    w.wires().detach(wire, 0);
    EXPECT_FALSE(w.intact(ids.line));
    EXPECT_NEAR(w.wires().length(wire), length, 1e-9);
    const double z = w.pose(w.wires().nodes(wire).front()).position.z();
    run(w, 100);
    EXPECT_LT(w.pose(w.wires().nodes(wire).front()).position.z(), z - 1.0);
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

std::string refusal(const std::function<void()>& work) {
    try {
        work();
    } catch (const DefError& e) {
        return e.what();
    }
    return "(none)";
}

TEST(WireCut, WhatMakesNoSenseIsRefusedAndChangesNothing) {
    Span f(true, 20);
    World& w = f.w;
    const WireId loose = w.wires().add({.name = "loose",
                                        .from = f.left,
                                        .elements = 3,
                                        .length = 3.0,
                                        .EA = 1e6,
                                        .mass_per_length = 2.0});
    const auto state = w.state().save();
    const auto expect = [&](const char* part, const std::function<void()>& work) {
        const std::string said = refusal(work);
        EXPECT_NE(said.find(part), std::string::npos) << said;
    };
    expect("wire 'tow': s = 25 m is not within it", [&] { (void)w.wires().cut(f.wire, 25.0); });
    expect("is not within it", [&] { (void)w.wires().cut(f.wire, 0.0); });
    expect("is not within it", [&] { (void)w.wires().cut(f.wire, std::nan("")); });
    expect("its last end is taken by the body 'right'",
           [&] { (void)w.wires().join(f.wire, 1, loose, 1); });
    expect("end must be 0", [&] { (void)w.wires().join(f.wire, 2, loose, 1); });
    expect("end must be 0", [&] { w.wires().detach(loose, -1); });
    expect("no gear holds this end", [&] { w.wires().detach(loose, 1); });
    expect("m apart", [&] { (void)w.wires().attach(loose, 1, f.right, Vec3::Zero()); });
    expect("mass", [&] { (void)w.wires().attach(loose, 1, f.left, {0, 0, -3}, {.mass = -1.0}); });
    expect("mass", [&] { (void)w.wires().join(loose, 1, loose, 1, {.gear = Gear::triplate}); });
    expect("joined to itself",
           [&] { (void)w.wires().join(loose, 1, loose, 1, {.gear = Gear::shackle}); });
    expect("length", [&] {
        (void)w.wires().attach(loose, 1, f.left, {0, 0, -3},
                               {.gear = Gear::shackle, .length = std::nan("")});
    });
    expect("the name is in use",
           [&] { (void)w.wires().attach(loose, 1, f.left, {0, 0, -3}, {.name = "tow/s1"}); });
    expect("it is no pelican hook", [&] { w.wires().release(w.wires().elements(f.wire)[0]); });
    EXPECT_EQ(w.state().save(), state);
    EXPECT_EQ(w.step(), Status::ok);
}

}  // namespace
}  // namespace hawser::test
