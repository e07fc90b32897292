// SPDX-License-Identifier: Apache-2.0
/// Structure and state together continue in another world of the same set-up with equal bits, after
/// any additions and removals.
#include <hawser/hawser.h>

#include "support/tier.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kMass = 23.0;

/// Make an anchor on a winch that pays out, and a wire between two fixed bodies.
World set_up(int threads) {
    World w(WorldDef{.step = 1.0 / 60.0, .threads = threads});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId post =
        w.add_body({.name = "post", .kind = BodyKind::fixed, .position = {30, 0, 0}});
    const BodyId load =
        w.add_body({.name = "load", .kind = BodyKind::lump, .position = {0, 0, -10}, .mass = 5e3});
    WireDef def{.name = "fall", .from = deck, .to = load, .elements = 4};
    def.EA = 2.33e8;
    def.mass_per_length = kMass;
    def.EI = 5e3;
    def.radius = 0.04;
    def.consistent_mass = true;
    WinchDef winch{.name = "winch", .wire = w.wires().add(def), .core_radius = 0.6, .width = 2.4};
    winch.wire_diameter = 0.076;
    winch.mass_per_length = kMass;
    winch.stored = 300.0;
    winch.inertia = 4e4;
    winch.mode = WinchMode::speed;
    w.add(winch);
    w.add_output({.name = "load.z", .kind = OutputKind::pose, .body = load, .component = "z"});
    def.name = "span";
    def.to = post;
    def.length = 33.0;
    def.elements = 8;
    w.wires().add(def);
    w.add_input({.name = "push", .body = load, .component = 0, .min = -1e4, .max = 1e4});
    return w;
}

std::vector<std::uint64_t> run(World& w, int steps) {
    std::vector<std::uint64_t> out;
    for (int i = 0; i < steps; ++i) {
        EXPECT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
        out.push_back(w.state().hash());
    }
    return out;
}

TEST(Structure, GoesOnInAnotherWorldInTheSameBits) {
    std::mt19937 dice(first_seed(5));
    const int rounds = by_tier(3, 12, 120);
    for (int round = 0; round < rounds; ++round) {
        World w = set_up(1);
        const std::uint64_t identity = w.state().identity();
        w.set_system_signal("winch.speed", round % 2 == 0 ? 1.0 : 2.0);
        (void)run(w, 60 + static_cast<int>(dice() % 300));
        const WireId span = w.wires().find("span");
        if (round % 3 == 1) (void)w.wires().insert_node(w.wires().elements(span)[2], 0.4);
        if (round % 3 == 2) {
            (void)w.wires().cut(span, 14.0);
            (void)run(w, 10);
            (void)w.wires().join(
                span, 1, w.wires().find("span/2"), 0,
                {.gear = Gear::pelican_hook, .mass = 20.0, .length = 1.0, .reach = 50.0});
        }
        (void)run(w, static_cast<int>(dice() % 20));
        EXPECT_NE(w.state().identity(), identity) << "or nothing has come and gone";
        const Structure made_of = w.state().structure();
        const std::vector<std::byte> state = w.state().save();
        World other = set_up(2);
        (void)run(other, 3);
        const std::vector<std::byte> before = other.state().save();
        EXPECT_THROW(other.state().restore(state), DefError) << "other pieces";
        other.state().restore(made_of, state);
        EXPECT_EQ(other.state().identity(), w.state().identity());
        EXPECT_EQ(other.state().hash(), w.state().hash());
        EXPECT_EQ(other.state().save(), state);
        w.set_system_signal("winch.speed", -1.0);
        other.set_system_signal("winch.speed", -1.0);
        w.set_input(w.find_input("push"), 2e3);
        other.set_input(other.find_input("push"), 2e3);
        EXPECT_EQ(run(other, 200), run(w, 200)) << round;
        EXPECT_EQ(other.output(other.find_output("load.z")), w.output(w.find_output("load.z")));
        EXPECT_EQ(other.wires().find("span"), span);
        EXPECT_EQ(other.events().take().size() > 0, w.events().take().size() > 0);
        // Back to its earlier state.
        World third = set_up(1);
        (void)run(third, 3);
        const Structure first = third.state().structure();
        other.state().restore(first, before);
        EXPECT_EQ(run(other, 50), run(third, 50));
    }
}

TEST(Structure, OfAnotherStateLeavesTheWorldAsItWas) {
    World w = set_up(1), other = set_up(1);
    w.set_system_signal("winch.speed", 1.0);
    (void)run(w, 200);
    (void)run(other, 20);
    const Structure made_of = w.state().structure();
    const auto state = w.state().save(), before = other.state().save();
    auto damaged = state;
    damaged[damaged.size() / 2] ^= std::byte{1};
    const auto refuses = [&](const Structure& s, std::span<const std::byte> bytes) {
        EXPECT_THROW(other.state().restore(s, bytes), DefError);
        EXPECT_EQ(other.state().save(), before);
        EXPECT_EQ(other.system_count(), 1);
    };
    refuses(made_of, damaged);
    refuses(made_of, before);
    Structure bad = made_of;
    bad.bodies.vacant = {static_cast<std::int32_t>(bad.bodies.defs.size())};
    refuses(bad, state);
    bad = made_of;
    bad.interactions.generations.pop_back();
    refuses(bad, state);
    bad = made_of;
    bad.wires.defs[0].nodes.pop_back();
    refuses(bad, state);
    bad = made_of;
    bad.wires.defs[1].name = bad.wires.defs[0].name;
    refuses(bad, state);
    bad = made_of;
    bad.interactions.defs[0].body[0] = BodyId{9999};
    refuses(bad, state);
    bad = made_of;
    bad.bodies.defs[2].mass *= 2.0;
    refuses(bad, state);
    // It continues as if none of this had been tried.
    World again = set_up(1);
    (void)run(again, 20);
    EXPECT_EQ(run(other, 30), run(again, 30));
}

}  // namespace
}  // namespace hawser::test
