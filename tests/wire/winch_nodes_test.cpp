// SPDX-License-Identifier: Apache-2.0
/// Nodes inserted and removed at a drum: accounts, threads, both ends, contacts, rejected
/// definitions. The tension at the fairlead is checked by `hawser validate payout`.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace hawser::test {
namespace {

constexpr double kMass = 23.0, kStored = 300.0;

struct Hoist {
    World w;
    WireId wire{};
    WinchIds ids{};

    explicit Hoist(int elements, int end = 0, double element = kDefault, bool pieces = true,
                   int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        BodyDef load{.name = "load", .position = Vec3(0, 0, -2.5 * elements)};
        load.mass = 13e3;
        load.inertia = 5e3 * Mat3::Identity();
        const BodyId body = w.add_body(load);
        WireDef def;
        def.name = "wire";
        def.from = end == 0 ? deck : body;
        def.to = end == 0 ? body : deck;
        def.elements = elements;
        def.EA = 2.33e8;
        def.mass_per_length = kMass;
        def.radius = 0.04;
        def.EI = 5e3;
        def.consistent_mass = pieces;
        wire = w.wires().add(def);
        WinchDef winch{.name = "winch", .wire = wire, .end = end, .core_radius = 0.6, .width = 2.4};
        winch.wire_diameter = 0.076;
        winch.mass_per_length = kMass;
        winch.element = element;
        winch.stored = kStored;
        winch.inertia = 4e4;
        winch.mode = WinchMode::speed;
        ids = w.add(winch);
    }
    /// Run the winch; it accelerates within a second.
    void run(double seconds, double speed) {
        const double before = w.system_signal("winch.speed");
        for (long i = 0; i < std::lround(60.0 * seconds); ++i) {
            const double share = std::min(1.0, static_cast<double>(i + 1) / 60.0);
            w.set_system_signal("winch.speed", before + share * (speed - before));
            ASSERT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
        }
    }
    [[nodiscard]] double get(const char* signal) const {
        return w.system_signal(std::string("winch.") + signal);
    }
    /// Return the length on the drum and off it [m].
    [[nodiscard]] double material() const {
        double sum = get("wire_left") + get("at_drum");
        for (const InteractionId id : w.wires().elements(wire))
            if (id != ids.line) sum += w.interaction_def(id).get("mass") / kMass;
        return sum;
    }
};

TEST(WinchNodes, ComeWithMassBendsAndContacts) {
    for (const int end : {0, 1}) {
        Hoist h(4, end);
        const double whole = h.material();
        h.run(20.0, 1.0);
        const auto nodes = h.w.wires().nodes(h.wire);
        const auto elements = h.w.wires().elements(h.wire);
        ASSERT_EQ(elements.size(), 12U) << "19.5 m more in elements of 2.5 m";
        ASSERT_EQ(nodes.size(), 13U);
        EXPECT_EQ(end == 0 ? elements.front() : elements.back(), h.ids.line);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            EXPECT_EQ(h.w.interaction_def(elements[i]).body[0], nodes[i]);
            EXPECT_EQ(h.w.interaction_def(elements[i]).body[1], nodes[i + 1]);
        }
        EXPECT_EQ(h.w.shapes().size(), 10U) << "between all lumps";
        EXPECT_NEAR(h.material(), whole, 1e-11) << "an account";
        // The node next to the drum has no part of the drum's element; all others have a whole
        // element.
        for (std::size_t i = 2; i + 2 < nodes.size(); ++i)
            EXPECT_NEAR(h.w.body_def(nodes[i]).mass, 2.5 * kMass, 1e-9);
        EXPECT_NEAR(h.w.body_def(end == 0 ? nodes[1] : nodes[nodes.size() - 2]).mass, 1.25 * kMass,
                    1e-9);
        h.run(23.0, -1.0);
        EXPECT_LE(h.w.wires().elements(h.wire).size(), 5U);
        EXPECT_NEAR(h.material(), whole, 1e-11);
    }
}

/// New elements are longer and heavier than the existing ones.
TEST(WinchNodes, ComeWhereOthersAreShorter) {
    for (const double element : {2.6, 4.0, 7.5}) {
        Hoist h(4, 0, element);
        const double whole = h.material();
        h.run(40.0, 1.0);
        EXPECT_NEAR(static_cast<double>(h.w.wires().elements(h.wire).size()), 4.0 + 39.5 / element,
                    1.5);
        EXPECT_NEAR(h.material(), whole, 1e-11);
    }
}

TEST(WinchNodes, AreTheSameOnAnyThreadsAndAfterRestore) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 4, 8}) {
        Hoist h(4, 0, kDefault, true, threads);
        h.run(3.0, 1.0);
        // From between two insertions, and from the step before the next one.
        while (h.get("at_drum") + 1.0 / 60.0 < 1.5 * 2.5) h.run(1.0 / 60.0, 1.0);
        const auto saved = h.w.state().save();
        World twin = h.w.twin();
        h.run(4.0, 1.0);
        if (threads == 1) hash = h.w.state().hash();
        EXPECT_EQ(h.w.state().hash(), hash) << threads;
        twin.state().restore(saved);
        for (int i = 0; i < 240; ++i) {
            twin.set_system_signal("winch.speed", 1.0);
            ASSERT_EQ(twin.step(), Status::ok);
        }
        EXPECT_EQ(twin.state().hash(), hash) << threads;
    }
}

TEST(WinchNodes, AWireOfOneElementRunsOut) {
    Hoist h(1, 0, 2.0);
    h.run(9.0, 1.0);
    EXPECT_GE(h.w.wires().elements(h.wire).size(), 5U);
    EXPECT_GE(h.w.shapes().size(), 3U) << "its contacts are known though it had no lumps";
    h.run(11.0, -1.0);
    EXPECT_LE(h.w.wires().elements(h.wire).size(), 2U);
}

/// A fault in mode render: the motor pulled on, the length at the drum became negative, and a free
/// drum continued.
TEST(WinchNodes, AFreeEndIsHauledInUpToTheFairleadInAnyMode) {
    for (const WinchMode mode :
         {WinchMode::speed, WinchMode::tension, WinchMode::render, WinchMode::free}) {
        Hoist d(6);
        (void)d.w.wires().cut(d.wire, 6.0);
        d.w.set_system_signal("winch.tension", 5e4);
        d.run(2.0, -1.5);
        d.w.set_system_signal("winch.mode", static_cast<double>(mode));
        double least = 1.0;
        for (int i = 0; i < 20 * 60; ++i) {
            ASSERT_EQ(d.w.step(), Status::ok) << to_string(d.w.bad_load(), d.w);
            least = std::min(least, d.get("at_drum"));
        }
        // The step that reaches the end exceeds it slightly.
        EXPECT_GT(least, -1.5 / 60.0) << static_cast<int>(mode);
        EXPECT_LT(least, 0.1) << static_cast<int>(mode);
        EXPECT_NE(d.w.verdict().grade, Grade::wrong) << static_cast<int>(mode);
        if (mode != WinchMode::free) {
            EXPECT_EQ(d.get("state"), static_cast<double>(WinchState::full));
        }
        d.w.set_system_signal("winch.mode", static_cast<double>(WinchMode::speed));
        d.run(3.0, 0.5);
        EXPECT_GT(d.get("at_drum"), 0.8) << static_cast<int>(mode);
    }
}

/// A load that swings while it is hauled in keeps its angular momentum: it swings faster the
/// shorter the element gets. Hauling stops before the element turns by more than 0.1 rad a step.
TEST(WinchNodes, ASwingingLoadIsHauledInUpToASafeLength) {
    for (const double speed : {0.5, 1.5, 2.5})
        for (const WinchMode mode : {WinchMode::speed, WinchMode::tension}) {
            Hoist d(1, 0, 5.0);
            const BodyId load = d.w.find_body("load");
            d.w.set_velocity(load, {.linear = {speed, 0.3 * speed, 0.0}, .angular = Vec3::Zero()});
            d.w.set_system_signal("winch.tension", 6e5);
            d.w.set_system_signal("winch.mode", static_cast<double>(mode));
            d.run(20.0, -1.5);
            const std::array<Vec3, 2> ends = d.w.wires().ends(d.ids.line);
            const double length = (ends[1] - ends[0]).norm();
            std::printf("%.1f m/s: %.3f m from the fairlead\n", speed, length);
            EXPECT_EQ(d.get("state"), static_cast<double>(WinchState::full)) << speed;
            EXPECT_GE(length, 0.25) << speed;  // g (10 h)² = 0.27 m, less a step of hauling
            EXPECT_LE(length, 0.25 * 5.0 + 0.05) << speed;
            EXPECT_NE(d.w.verdict().grade, Grade::wrong) << speed;
        }
}

TEST(WinchNodes, AreRefusedWhereTheyCannotBe) {
    EXPECT_THROW(Hoist(4, 0, 5.0, false), DefError) << "lumps without pieces";
    EXPECT_NO_THROW(Hoist(4, 0, 0.0, false));
    EXPECT_THROW(Hoist(4, 0, -1.0), DefError);
    EXPECT_THROW(Hoist(1, 1, 2.0), DefError) << "which end is at the drum";
    Hoist h(4);
    const InteractionId plain = h.w.wires().elements(h.wire)[1];
    EXPECT_THROW((void)h.w.wires().insert_node(h.ids.line, 0.5), DefError)
        << "its mass is the winch's";
    EXPECT_THROW((void)h.w.wires().insert_node(plain, 0.5, 10.0), DefError)
        << "its mass is its own";
    EXPECT_EQ(h.w.wires().of(plain), h.wire);
    EXPECT_THROW(h.w.wires().set_mass(h.ids.drum, 1.0), DefError);
    EXPECT_THROW(h.w.wires().set_mass(h.w.wires().nodes(h.wire)[1], 0.0), DefError);
}

}  // namespace
}  // namespace hawser::test
