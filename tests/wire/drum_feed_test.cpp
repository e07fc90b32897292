// SPDX-License-Identifier: Apache-2.0
/// Bare drums that feed a wire (hawser/drum_feed.h): statics, material, end stop, random speeds.
#include <hawser/hawser.h>

#include "support/bits.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kLine = 23.0, kWeight = 13e3, kG = 9.81, kRadius = 0.5, kInertia = 4e3;

/// A load on a wire over a fixed fairlead; a motor turns the drum.
struct BareDrum {
    World w;
    WireId wire{};
    BodyId drum{}, load{};
    DrumIds parts{};
    InteractionId line{};

    explicit BareDrum(int elements, double element = kDefault, double torque = 1e6, int end = 0,
                      int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        drum = w.add_body(
            {.name = "drum", .kind = BodyKind::scalar, .mass = kInertia, .gravity = false});
        BodyDef def{.name = "load", .position = Vec3(0, 0, -2.5 * elements)};
        def.mass = kWeight;
        def.inertia = 5e3 * Mat3::Identity();
        load = w.add_body(def);
        wire = w.wires().add({.name = "wire",
                              .from = end == 0 ? deck : load,
                              .to = end == 0 ? load : deck,
                              .elements = elements,
                              .EA = 2.33e8,
                              .mass_per_length = kLine,
                              .consistent_mass = true});
        line = w.wires().spool(wire, end, drum, kRadius);
        parts = w.add(
            DrumDef{.name = "winch",
                    .drum = drum,
                    .motor = AxisMotor{.speed = 0.0, .force_min = -torque, .force_max = torque}});
        w.add_input({.name = "speed", .interaction = parts.motor, .param = "speed"});
        w.add(DrumFeedDef{.name = "feed",
                          .wire = wire,
                          .end = end,
                          .element = element,
                          .mass_per_length = kLine});
    }
    /// Run the drum at a speed of the wire [m/s], reached within a second.
    void run(double seconds, double speed) {
        const double before = w.input(w.find_input("speed"));
        for (long i = 0; i < std::lround(60.0 * seconds); ++i) {
            const double share = std::min(1.0, static_cast<double>(i + 1) / 60.0);
            w.set_input(w.find_input("speed"), before + share * (speed / kRadius - before));
            ASSERT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
        }
    }
    [[nodiscard]] double at_drum() const { return w.system_signal("feed.at_drum"); }
    /// Return the unstretched length of all elements, from their masses [m].
    [[nodiscard]] double material() const {
        double sum = at_drum();
        for (const InteractionId id : w.wires().elements(wire))
            if (id != line) sum += w.interaction_def(id).get("mass") / kLine;
        return sum;
    }
    [[nodiscard]] double rest() const {
        const InteractionDef& d = w.interaction_def(line);
        return d.get("length") + d.get("radius") * (w.pose(drum).position.x() - d.get("drum_zero"));
    }
    [[nodiscard]] std::int64_t stops() const {
        return w.events().extremes(EventKind::hauled_in).count;
    }
};

/// Statics: the torque of the motor is r (m + ρ L) g, for wire paid out and hauled in.
TEST(DrumFeed, CarriesTheWeightOfLoadAndWire) {
    for (const int end : {0, 1}) {
        BareDrum d(4, kDefault, 1e6, end);
        for (const double speed : {0.0, 1.0, 0.0, -1.0, 0.0}) {
            d.run(12.0, speed);
            if (speed != 0.0) continue;
            d.run(20.0, 0.0);  // until the load is at rest
            const double paid = kRadius * d.w.pose(d.drum).position.x();
            const double length = 10.0 + paid;
            const double torque = -d.w.force(d.parts.motor)[0];
            // Half of the last element is part of the load's mass. 1e-5: the load still moves up
            // and down slightly.
            const double mass = kWeight + kLine * (length - 0.5 * 2.5);
            EXPECT_NEAR(torque, kRadius * kG * mass, 1e-5 * torque);
            EXPECT_NEAR(d.material(), length, 1e-9);
            EXPECT_NEAR(d.w.pose(d.load).position.z(), -length, 0.02);  // strain 6e-4 of 24 m
        }
        EXPECT_EQ(d.stops(), 0);
    }
}

TEST(DrumFeed, InsertsAndRemovesNodes) {
    BareDrum d(4);
    d.run(14.0, 1.0);
    EXPECT_EQ(d.w.wires().elements(d.wire).size(), 9U) << "13.5 m more in elements of 2.5 m";
    d.run(20.0, -1.0);
    EXPECT_LE(d.w.wires().elements(d.wire).size(), 3U);
}

/// The drum stops when the load is at the fairlead; the motor's torque changes its speed by Q
/// h/(1000 J).
TEST(DrumFeed, StopsAtTheFairlead) {
    for (const double element : {0.0, 2.5}) {
        constexpr double kTorque = 3e5;
        BareDrum d(element == 0.0 ? 1 : 4, element, kTorque);
        d.run(30.0, -1.0);
        EXPECT_EQ(d.stops(), 1);
        EXPECT_EQ(d.w.wires().elements(d.wire).size(), 1U);
        const double length = d.w.interaction_def(d.line).get("length");
        constexpr double kSwing = kG / 36.0;  // g (10 h)² at 1/60 s
        const double least = element == 0.0 ? kLeastOfDrumElement * length : kSwing;
        EXPECT_NEAR(d.w.pose(d.load).position.z(), -least, 0.2);
        const double creep = kTorque / (60.0 * 1000.0 * kInertia);
        EXPECT_GE(d.rest(), least - 30.0 * kRadius * creep - 0.02);
        EXPECT_LE(std::abs(d.w.velocity(d.drum).linear.x()), 1.01 * creep);
        // No energy is created: the work of the motor is at most torque times angle.
        EXPECT_LE(d.w.energy().driven, kTorque * std::abs(d.w.pose(d.drum).position.x()));
        d.run(8.0, 1.0);
        EXPECT_NEAR(d.w.pose(d.load).position.z(), -7.5, 0.3) << "pays out at once";
        d.run(20.0, -1.0);
        EXPECT_EQ(d.stops(), 2);
    }
}

/// Random speeds: every status is ok, monitors report nothing, material is conserved, and the
/// motor's work is the change of energy plus losses.
TEST(DrumFeed, KeepsAccountsAtRandomSpeeds) {
    for (const std::uint32_t seed : seeds(7, 4, 60, 600)) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> speed(-2.0, 2.0), seconds(1.0, 12.0);
        const int elements = 1 + static_cast<int>(random() % 6);
        BareDrum d(elements, random() % 2 == 0 ? kDefault : 2.0);
        for (int i = 0; i < 8; ++i) {
            d.run(seconds(random), speed(random));
            // Accounts are taken at the start of a step: the angle is one step older.
            const double paid =
                kRadius * (d.w.pose(d.drum).position.x() - d.w.velocity(d.drum).linear.x() / 60.0);
            EXPECT_NEAR(d.material(), 2.5 * elements + paid, 1e-9) << seed;
            ASSERT_GE(d.w.pose(d.load).position.z(), -200.0);
        }
        EXPECT_EQ(d.w.events().extremes(EventKind::energy_created).count, 0) << seed;
        EXPECT_EQ(d.w.events().extremes(EventKind::cable_law).count, 0) << seed;
        EXPECT_LE(d.rest(), 1.6 * 2.5) << seed;
    }
}

TEST(DrumFeed, RepeatsBitForBit) {
    const auto drive = [](BareDrum& d, int i) {
        d.w.set_input(d.w.find_input("speed"), (i < 400 ? 1.5 : -1.5) / kRadius);
    };
    expect_same_bits(
        {.steps = 1200, .restored = {1, 200, 399, 640, 1150}},
        [](int threads) { return BareDrum(4, kDefault, 1e6, 0, threads); }, drive,
        [](const BareDrum& d) { EXPECT_EQ(d.stops(), 1); });
}

TEST(DrumFeed, RefusesWhatItCannotFeed) {
    World w;
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId drum =
        w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 1.0, .gravity = false});
    const BodyId load =
        w.add_body({.name = "load", .kind = BodyKind::lump, .position = {0, 0, -9}, .mass = 100.0});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = deck,
                                       .to = load,
                                       .elements = 3,
                                       .EA = 1e7,
                                       .mass_per_length = 2.0});
    const auto message = [&](const DrumFeedDef& def) -> std::string {
        try {
            w.add(def);
        } catch (const DefError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message({.name = "", .wire = wire}), "");
    EXPECT_NE(message({.name = "f", .wire = wire}).find("spool()"), std::string::npos);
    w.wires().spool(wire, 0, drum, 0.5);
    EXPECT_NE(message({.name = "f", .wire = wire}).find("mass_per_length"), std::string::npos);
    EXPECT_NE(message({.name = "f", .wire = wire, .mass_per_length = 2.0}).find("consistent_mass"),
              std::string::npos);
    EXPECT_NE(message({.name = "f", .wire = wire, .end = 2}), "");
    EXPECT_NE(message({.name = "f", .wire = wire, .end = 1}), "");
    EXPECT_EQ(message({.name = "f", .wire = wire, .element = 0.0}), "");
    EXPECT_NE(message({.name = "f", .wire = wire, .element = 0.0}).find("name is in use"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser::test
