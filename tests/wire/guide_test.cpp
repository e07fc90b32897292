// SPDX-License-Identifier: Apache-2.0
/// Wires of point masses over guides: Euler's ratio, nodes that pass, stops, bits, rejected
/// definitions.
#include <hawser/guide.h>
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace hawser {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDensity = 23.0, kEA = 2.33e8, kWeight = 13e3;  // kg/m, N, kg

/// A wire from a winch along a deck, over a roller and down to a weight.
struct OverRoller {
    World w;
    BodyId deck{}, anchor{};
    WireId wire{};
    WinchIds winch{};
    Guide roller{};

    explicit OverRoller(const GuideDef& like = {.radius = 1.0, .friction = 0.2},
                        const WorldDef& world = {.step = 1.0 / 60.0}, double element = 5.0,
                        double bending = 0.0)
        : w(world) {
        const double radius = std::abs(like.radius);
        const double stretched = element * (1.0 + kWeight * 9.81 / kEA), over = 0.4 * element;
        std::vector<Vec3> path;
        for (int k = 4; k >= 0; --k) path.push_back({-over - k * stretched, 0, radius});
        for (int k = 0; k < 3; ++k)
            path.push_back({radius, 0, over + 0.5 * kPi * radius - (1 + k) * stretched});
        deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        anchor = w.add_body({.name = "anchor",
                             .kind = BodyKind::lump,
                             .position = path.back(),
                             .mass = kWeight + 0.5 * kDensity * element});
        WireDef def{.name = "wire", .from = deck, .from_point = path.front(), .to = anchor};
        def.elements = static_cast<int>(path.size()) - 1;
        def.length = element * def.elements;
        def.EA = kEA;
        def.EI = bending;
        def.mass_per_length = kDensity;
        def.consistent_mass = true;
        def.path.assign(path.begin() + 1, path.end() - 1);
        wire = w.wires().add(def);
        GuideDef guide = like;
        guide.name = "roller";
        guide.wire = wire;
        if (!guide.body.valid()) guide.body = deck;
        roller = w.add(guide);
        winch = w.add(WinchDef{.name = "winch",
                               .wire = wire,
                               .core_radius = 0.6,
                               .width = 2.4,
                               .flange_radius = 1.4,
                               .wire_diameter = 0.076,
                               .mass_per_length = kDensity,
                               .stored = 500.0,
                               .inertia = 4e4,
                               .mode = WinchMode::speed});
    }
    [[nodiscard]] double get(const char* signal) const { return w.system_signal(signal); }
    void run(double seconds, double speed, double ramp = 5.0) {
        const double from = get("winch.speed");
        const long steps = std::lround(seconds / w.settings().step);
        for (long i = 0; i < steps; ++i) {
            const double u = std::min(1.0, static_cast<double>(i) * w.settings().step / ramp);
            w.set_system_signal("winch.speed", from + u * u * (3.0 - 2.0 * u) * (speed - from));
            ASSERT_EQ(w.step(), Status::ok) << i << ": " << to_string(w.bad_load(), w);
        }
    }
    /// Return the length of all wire, from its mass [m].
    [[nodiscard]] double material() const {
        double sum = get("winch.wire_left") + get("winch.at_drum") + get("roller.wire_before") +
                     get("roller.wire_behind");
        for (const BodyId id : w.wires().nodes(wire))
            if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass / kDensity;
        return sum;
    }
    [[nodiscard]] std::ptrdiff_t nodes_behind() const {
        const auto nodes = w.wires().nodes(wire);
        return nodes.end() - std::find(nodes.begin(), nodes.end(), deck) -
               (std::find(nodes.begin() + 1, nodes.end(), deck) - nodes.begin());
    }
    [[nodiscard]] double euler() const { return std::exp(0.2 * get("roller.angle")); }
};

TEST(Guides, NodesRunThroughAtEulersRatio) {
    for (const double bending : {0.0, 5e3}) {
        OverRoller d({.radius = 1.0, .friction = 0.2}, {.step = 1.0 / 60.0}, 5.0, bending);
        const double whole = d.material();
        const auto before = d.nodes_behind();
        d.run(60.0, 1.0);
        EXPECT_GE(d.nodes_behind(), before + 10);
        EXPECT_NEAR(d.material(), whole, 1e-10 * whole);
        // The weight of half an element is not at the point of its tension: 0.1 %.
        EXPECT_NEAR(d.get("roller.behind") / d.get("roller.before") / d.euler(), 1.0, 2e-3);
        d.run(70.0, -1.0);
        EXPECT_LE(d.nodes_behind(), before + 3);
        EXPECT_NEAR(d.get("roller.before") / d.get("roller.behind") / d.euler(), 1.0, 2e-3);
        EXPECT_NEAR(d.material(), whole, 1e-10 * whole);
        EXPECT_EQ(d.w.verdict().grade, Grade::good);
    }
}

TEST(Guides, TensionIsTheWeightOfWhatHangs) {
    OverRoller d({.radius = 1.0});  // without friction
    d.run(40.0, 0.5);
    d.run(20.0, 0.0);
    // From the point at which the wire leaves the roller to the weight.
    const double hangs = -d.w.pose(d.anchor).position.z();
    const double weight = 9.81 * (kWeight + kDensity * hangs);
    EXPECT_NEAR(d.get("roller.behind") / weight, 1.0, 2e-3);  // strain, and remaining oscillation
    EXPECT_NEAR(d.get("roller.before") / d.get("roller.behind"), 1.0, 1e-3);
}

TEST(Guides, AnEyeAndARollerThatTurns) {
    {
        OverRoller d({.radius = 0.0, .friction = 0.2});
        d.run(30.0, 0.8);
        EXPECT_NEAR(d.get("roller.behind") / d.get("roller.before") / d.euler(), 1.0, 3e-3);
    }
    OverRoller d({.radius = 1.0, .efficiency = 0.95, .inertia = 5e3});
    d.run(30.0, 0.8);
    EXPECT_NEAR(d.get("roller.before") / d.get("roller.behind"), 0.95, 2e-3);
    EXPECT_EQ(d.w.verdict().grade, Grade::good);
}

TEST(Guides, WhatCannotRunThroughStops) {
    OverRoller d;
    d.run(25.0, -0.5);  // 12 m of wire hang there, and the weight
    d.run(5.0, 0.0, 1.0);
    EXPECT_NEAR(d.get("roller.speed"), 0.0, 1e-3);
    EXPECT_GT(d.w.pose(d.anchor).position.z(), -1.0);
    EXPECT_GT(d.get("roller.wire_behind"), 0.0);
    const double highest = d.w.pose(d.anchor).position.z();
    d.run(20.0, 0.5);  // lowered again
    EXPECT_LT(d.w.pose(d.anchor).position.z(), highest - 2.0);
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

// Without friction, the row that stops the slide had a bound of 0 before: it must restart at each
// stop.
TEST(Guides, StopAgainAfterTheWireWasPaidOut) {
    OverRoller d({.radius = 1.0});
    const double whole = d.material();
    for (int k = 0; k < 3; ++k) {
        double least = 1e300;
        for (int i = 0; i < 30; ++i) {
            d.run(0.5, -1.0, 0.5);
            least = std::min(least, d.get("roller.wire_behind"));
        }
        EXPECT_GT(least, 0.0) << k;
        d.run(4.0, 1.0, 0.5);
        EXPECT_GT(d.get("roller.wire_behind"), 1.0) << k;
    }
    EXPECT_NEAR(d.material(), whole, 1e-10 * whole);
}

// A wire that breaks after a guide keeps its length before it: no force acts on the slide from the
// other side.
TEST(Guides, HoldAWireThatPartsAtThem) {
    OverRoller d({.radius = 1.0});
    const InteractionId behind = d.roller.behind;
    d.run(1.0, 0.0);
    const double before = d.get("roller.wire_before");
    d.w.wires().part(behind);
    d.run(5.0, 0.0);
    ASSERT_FALSE(d.w.intact(behind));
    EXPECT_NEAR(d.get("roller.wire_before"), before, 0.05);  // [m], the last steps of sliding
    const double slide = d.w.pose(d.roller.slide).position.x();
    d.run(5.0, 0.0);
    EXPECT_NEAR(d.w.pose(d.roller.slide).position.x(), slide, 1e-6);
}

TEST(Guides, EqualBitsForAnyThreadsAndAfterARestore) {
    std::vector<std::uint64_t> expected;
    std::vector<std::byte> saved;
    Structure made_of;
    const auto speed = [](int i) { return std::sin(0.01 * i); };
    for (const int threads : {1, 2, 4, 8}) {
        OverRoller d({.radius = 1.0, .friction = 0.2}, {.step = 1.0 / 60.0, .threads = threads});
        for (int i = 0; i < 1000; ++i) {
            d.w.set_system_signal("winch.speed", speed(i));
            ASSERT_EQ(d.w.step(), Status::ok);
            if (threads == 1) expected.push_back(d.w.state().hash());
            ASSERT_EQ(d.w.state().hash(), expected[static_cast<std::size_t>(i)]) << threads;
            if (threads == 1 && i == 617) {
                saved = d.w.state().save();
                made_of = d.w.state().structure();
            }
        }
    }
    OverRoller again;
    again.w.state().restore(made_of, saved);
    for (int i = 618; i < 1000; ++i) {
        again.w.set_system_signal("winch.speed", speed(i));
        ASSERT_EQ(again.w.step(), Status::ok);
        ASSERT_EQ(again.w.state().hash(), expected[static_cast<std::size_t>(i)]) << i;
    }
}

TEST(Guides, OnAMovingBodyMomentumStays) {
    // A free frame with a wire between two of its points over a bollard of its own: no external
    // forces act.
    World w(WorldDef{.step = 1.0 / 120.0, .gravity = Vec3::Zero()});
    BodyDef body{.name = "frame"};
    body.mass = 2e4;
    body.inertia = Vec3(1e5, 2e5, 2e5).asDiagonal();
    body.velocity = {0.3, 0, 0.1};
    body.angular_velocity = {0, 0.02, 0};
    const BodyId frame = w.add_body(body);
    WireDef def{.name = "wire", .from = frame, .from_point = {-12, 0, 1}};
    def.to = frame;
    def.to_point = {12, 0, 1};
    def.elements = 6;
    def.length = 23.9;
    def.EA = 1e7;
    def.mass_per_length = 10.0;
    def.consistent_mass = true;
    const WireId wire = w.wires().add(def);
    // Past the middle of an element, so that the wire passes while it is drawn straight.
    w.add(GuideDef{.name = "post",
                   .wire = wire,
                   .body = frame,
                   .point = {1.0, 0, 0.5},
                   .radius = 0.5,
                   .friction = 0.1,
                   .element_length = 2.0});
    const auto momentum = [&] {
        Vec3 sum = Vec3::Zero();
        for (const BodyId id : w.bodies()) {
            const BodyDef& b = w.body_def(id);
            if (b.kind != BodyKind::scalar) sum += b.mass * w.velocity(id).linear;
        }
        // Mass of the elements at the bollard that is in no node moves with nodes and frame.
        return sum;
    };
    ASSERT_EQ(w.step(), Status::ok);
    const Vec3 start = momentum();
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok) << i;
    // The half elements that nodes have as a load have speeds within 1 m/s of each other: 20 kg.
    EXPECT_LT((momentum() - start).norm(), 40.0);
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

/// Return the message of plan_guide() for an element from (−1, 0, 0) to `last` and a wheel; "" if
/// it touches.
std::string plan_refused(const Vec3& last, const Vec3& wheel, double radius) {
    const std::array<Vec3, 3> at{Vec3(-1, 0, 0), last, wheel};
    InteractionDef element;
    element.kind = InteractionKind::Stretch;
    element.name = "tow/s4";
    element.body = {BodyId{0}, BodyId{1}};
    element.set("EA", 1e6).set("length", (last - at[0]).norm());
    const GuideDef guide{.name = "roller", .body = {2}, .axis = {0, 1, 0}, .radius = radius};
    try {
        (void)plan_guide(guide, element, 0.0, [&](BodyId b) {
            return RouteBody{at[static_cast<std::size_t>(b.index)], Quat::Identity(),
                             b.index == 2 ? BodyKind::fixed : BodyKind::lump, 1.0};
        });
    } catch (const DefError& error) {
        return error.what();
    }
    return {};
}

/// The part of a wire in a guide is between nodes without mass to share. A fault rejected a cut
/// there, as if the element were not whole.
TEST(Guides, ACutAtOneGoesIntoTheElementBeyond) {
    for (const std::size_t part : {0U, 1U}) {
        OverRoller d;
        d.run(5.0, 0.2);
        const auto elements = d.w.wires().elements(d.wire);
        double s = 0.0;
        std::size_t k = 0;
        for (; elements[k] != (part == 0 ? d.roller.before : d.roller.behind); ++k)
            s += d.w.interaction_def(elements[k]).get("length");
        const double whole = d.w.wires().length(d.wire);
        const WireId second = d.w.wires().cut(d.wire, s + (part == 0 ? 0.1 : 1.0));
        // True if it lies on the roller, or hangs from it.
        const auto has = [&](WireId wire) {
            const auto of = d.w.wires().elements(wire);
            return std::find(of.begin(), of.end(), d.roller.before) != of.end();
        };
        EXPECT_EQ(has(second), part == 0);
        EXPECT_EQ(has(d.wire), part == 1);
        EXPECT_NEAR(d.w.wires().length(d.wire) + d.w.wires().length(second), whole, 1e-3 * whole);
        for (int i = 0; i < 60; ++i) ASSERT_EQ(d.w.step(), Status::ok) << i;
    }
}

/// The other sign is suggested only if the wire would touch with it: around a corner. With both
/// ends on one side of the wheel the wire would turn back by more than π with either sign.
TEST(Guides, AdviseTheOtherSignOnlyWhereItHelps) {
    const Vec3 down(0, 0, -1);
    int lies = 0;
    for (const double radius : {0.3, -0.3}) {
        const std::string why = plan_refused(down, {0, 0, 0}, radius);
        lies += why.empty() ? 1 : 0;
        if (!why.empty()) {
            EXPECT_NE(why.find("change the sign of `radius`"), std::string::npos) << why;
        }
        const std::string beside = plan_refused({1, 0, 0}, {2, 0, 0}, radius);
        EXPECT_EQ(beside.find("change the sign"), std::string::npos) << beside;
        EXPECT_NE(beside.find("'tow/s4'"), std::string::npos) << beside;
    }
    EXPECT_EQ(lies, 1);
}

TEST(Guides, RefuseWhatCannotBe) {
    const auto refused = [](const std::function<void(OverRoller&)>& what) {
        OverRoller d;
        const auto hash = d.w.state().hash();
        try {
            what(d);
        } catch (const DefError& error) {
            EXPECT_EQ(d.w.state().hash(), hash) << error.what();
            return std::string(error.what());
        }
        return std::string("taken");
    };
    const auto second = [](OverRoller& d) {
        return GuideDef{.name = "second", .wire = d.wire, .body = d.deck, .point = {-9, 0, 0.5}};
    };
    EXPECT_NE(refused([&](OverRoller& d) {
                  GuideDef def = second(d);
                  def.point.x() = -17.0;  // 5 m from the drum
                  d.w.add(def);
              }).find("next drum"),
              std::string::npos);
    const auto with = [&](const std::function<void(GuideDef&)>& change) {
        return refused([&](OverRoller& d) {
            GuideDef def = second(d);
            def.element_length = 1.0;
            change(def);
            d.w.add(def);
        });
    };
    EXPECT_NE(with([](GuideDef& g) { g.name = "roller"; }).find("name is in use"),
              std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.name = ""; }).find("needs a name"), std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.wire = {}; }).find("wire is missing"), std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.body = {}; }).find("body is missing"), std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.efficiency = 1.5; }).find("efficiency"), std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.friction = -1.0; }).find("friction"), std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.element_length = -1.0; }).find("element_length"),
              std::string::npos);
    EXPECT_NE(with([](GuideDef& g) { g.inertia = 10.0; }).find("inertia"), std::string::npos);
    EXPECT_NE(refused([&](OverRoller& d) {
                  GuideDef def = second(d);
                  def.element = d.winch.line;
                  d.w.add(def);
              }).find("at a drum"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser
