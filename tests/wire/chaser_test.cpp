// SPDX-License-Identifier: Apache-2.0
/// A ring put around a mooring chain, hauled along it to the anchor, brought back and removed:
/// stops, Euler's ratio, accounts, bits, rejected definitions.
#include <hawser/catenary.h>
#include <hawser/hawser.h>

#include "support/bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace hawser {
namespace {

constexpr double kChain = 126.0, kChainEA = 5.8e8, kDeep = 60.0, kPitchOfChain = 5.0;
constexpr double kRub = 0.3;

/// Chain from a fairlead down to an anchor on the bottom, a ring beside it, and a boat above that
/// hauls the ring by a wire.
struct Mooring {
    World w;
    BodyId anchor{}, ring{}, boat{};
    WireId chain{}, work{};

    explicit Mooring(int threads = 1, bool closed = false)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
        w.add_shape({.kind = ShapeKind::plane, .body = ground, .position = {0, 0, -kDeep - 0.1}});
        constexpr double kLength = 188.0;
        CatenaryDef shape;
        shape.from = {0, 0, 0};
        shape.to = {175, 0, -kDeep};
        shape.seabed = FlatSeabed{.height = -kDeep};
        shape.sections = {
            {kLength, kChain * 9.81, kChainEA, static_cast<int>(kLength / kPitchOfChain)}};
        const Catenary start = catenary(shape);
        const BodyId fairlead =
            w.add_body({.name = "fairlead", .kind = BodyKind::fixed, .position = shape.from});
        anchor = w.add_body({.name = "anchor", .kind = BodyKind::fixed, .position = shape.to});
        WireDef def{.name = "chain", .from = fairlead, .to = anchor};
        def.elements = static_cast<int>(kLength / kPitchOfChain);
        def.length = kLength;
        def.EA = kChainEA;
        def.mass_per_length = kChain;
        def.drag = 300.0;
        def.consistent_mass = true;
        def.radius = 0.1;
        def.path.assign(start.nodes.begin() + 1, start.nodes.end() - 1);
        chain = w.wires().add(def);
        const Vec3 beside = 0.5 * (start.nodes[3] + start.nodes[4]) + Vec3(0, 0.4, 0);
        ring = w.add_body({.name = "ring",
                           .position = beside,
                           .mass = 1500.0,
                           .inertia = Mat3::Identity() * 500.0,
                           .linear_damping = Vec3::Constant(1500.0),
                           .angular_damping = Vec3::Constant(3000.0)});
        const Vec3 above = beside + Vec3(100, 0, 40);
        boat = w.add_body({.name = "boat", .kind = BodyKind::kinematic, .position = above});
        WireDef line{.name = "work", .from = boat, .to = ring, .to_point = {0, 0, 0.5}};
        line.elements = 16;
        line.length = 112.0;  // slack by 4 m
        line.EA = 2e8;
        line.mass_per_length = 15.0;
        line.drag = 100.0;
        line.consistent_mass = true;
        work = w.wires().add(line);
        w.add(ChaserDef{
            .name = "chaser", .body = ring, .reach = 0.8, .friction = kRub, .closed = closed});
    }
    [[nodiscard]] double get(const char* what) const {
        return w.system_signal(std::string("chaser.") + what);
    }
    void haul(const Vec3& by, double seconds) {
        w.set_velocity(boat, {.linear = by / seconds, .angular = Vec3::Zero()});
        for (long i = std::lround(60.0 * seconds); i > 0; --i)
            ASSERT_EQ(w.step(), Status::ok) << w.time() << " " << to_string(w.bad_load(), w);
        w.set_velocity(boat, {});
    }
    /// Return the mass of the chain, including the part in the ring [kg].
    [[nodiscard]] double mass() {
        double sum = 0.0;
        for (const BodyId id : w.wires().nodes(chain))
            if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass;
        const auto elements = w.wires().elements(chain);
        for (const InteractionId end : {elements.front(), elements.back()})
            if (const double its = w.interaction_def(end).get("mass"); its > 0.0) sum += 0.5 * its;
        for (const InteractionId id : elements) sum += w.system(0).carried_mass(id);
        return sum;
    }
    [[nodiscard]] std::int64_t count(EventKind kind) const {
        return w.events().extremes(kind).count;
    }
};

TEST(Chasers, RunAlongAChainToItsAnchorAndBack) {
    Mooring d;
    const double mass = d.mass(), length = d.w.wires().length(d.chain);
    d.w.set_system_signal("chaser.close", 1.0);
    d.haul(Vec3::Zero(), 0.5);
    ASSERT_EQ(d.get("state"), static_cast<double>(ChaserState::on));
    EXPECT_EQ(d.get("held"), 1.0);
    EXPECT_EQ(d.count(EventKind::join), 1);
    EXPECT_NEAR(d.get("at"), 17.5, 1.5);
    EXPECT_NEAR(d.mass(), mass, 1e-9 * mass);
    // Outwards along the chain: it slides at Euler's ratio.
    int slid = 0;
    double worst = 0.0;
    for (int i = 0; i < 200 && d.get("arrived") == 0.0; ++i) {
        d.haul({2.0, 0, 0}, 1.0);
        if (d.get("speed") > -0.2) continue;  // the chain runs back through it
        const double ratio = d.get("before") / d.get("behind");
        worst = std::max(worst, std::abs(ratio / std::exp(kRub * d.get("angle")) - 1.0));
        ++slid;
    }
    std::printf("chaser: %.2f m before the end, ratio off by %.1e in %d looks, %.0f s\n",
                d.get("left"), worst, slid, d.w.time());
    EXPECT_EQ(d.get("arrived"), 2.0);
    EXPECT_EQ(d.count(EventKind::range), 1);
    EXPECT_LT(d.get("left"), 2.0);
    EXPECT_GT(slid, 20);
    // Inserted and removed nodes keep tensions by changing rest lengths. The material, by its mass,
    // is conserved.
    EXPECT_NEAR(d.get("at") + d.get("left"), length, 0.5);
    EXPECT_LT((d.w.pose(d.ring).position - d.w.pose(d.anchor).position).norm(), 2.0);
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
    // Inwards.
    d.haul(Vec3(-20.0 - d.w.pose(d.boat).position.x(), 0, 0), 150.0);
    EXPECT_LT(d.get("at"), 120.0);
    EXPECT_EQ(d.get("arrived"), 0.0);
    d.w.set_system_signal("chaser.close", 0.0);
    d.haul(Vec3::Zero(), 1.0);
    EXPECT_EQ(d.get("state"), static_cast<double>(ChaserState::open));
    EXPECT_EQ(d.count(EventKind::detach), 1);
    for (const InteractionId id : d.w.wires().elements(d.chain))
        EXPECT_EQ(d.w.interaction_def(id).kind, InteractionKind::Stretch);
    EXPECT_NEAR(d.mass(), mass, 1e-9 * mass);
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

TEST(Chasers, WaitForAWireWithinReach) {
    Mooring d;
    d.w.set_pose(d.ring, {d.w.pose(d.ring).position + Vec3(0, 2, 0), Quat::Identity()});
    d.w.set_system_signal("chaser.close", 1.0);
    d.haul(Vec3::Zero(), 0.2);
    EXPECT_EQ(d.get("state"), static_cast<double>(ChaserState::waiting));
    EXPECT_EQ(d.count(EventKind::missed), 1) << "once";
    EXPECT_NEAR(d.w.events().extremes(EventKind::missed).first.value, 2.4, 0.1)
        << "of the chain, not of its own wire";
    d.w.set_system_signal("chaser.close", 0.0);
    d.haul(Vec3::Zero(), 0.1);
    EXPECT_EQ(d.get("state"), static_cast<double>(ChaserState::open));
}

TEST(Chasers, RepeatBitForBit) {
    const auto drive = [](Mooring& d, int i) {
        if (i == 5) d.w.set_system_signal("chaser.close", 1.0);
        if (i == 1400) d.w.set_system_signal("chaser.close", 0.0);
        d.w.set_velocity(d.w.find_body("boat"), {.linear = {4.0, 0, 0}, .angular = Vec3::Zero()});
    };
    test::expect_same_bits(
        {.steps = 1500, .restored = {4, 5, 6, 700, 1200, 1400, 1401}},
        [](int threads) { return Mooring(threads); }, drive,
        [](const Mooring& d) { EXPECT_EQ(d.count(EventKind::detach), 1); });
}

TEST(Chasers, RefuseWhatCannotBe) {
    Mooring d;
    struct Row {
        ChaserDef def;
        const char* says;
    };
    for (const Row& row : {Row{{.body = d.ring}, "needs a name"},
                           Row{{.name = "chaser", .body = d.ring}, "name is in use"},
                           Row{{.name = "c"}, "body of its ring is missing"},
                           Row{{.name = "c", .body = d.anchor}, "rigid body"},
                           Row{{.name = "c", .body = d.ring, .reach = 0.0}, "reach = 0"},
                           Row{{.name = "c", .body = d.ring, .friction = -0.1}, "friction = -0.1"},
                           Row{{.name = "c", .body = d.ring, .element = -1.0}, "element = -1"}}) {
        const std::string said = test::error_message(d.w, row.def);
        EXPECT_NE(said.find(row.says), std::string::npos) << row.says << " in: " << said;
    }
}

}  // namespace
}  // namespace hawser
