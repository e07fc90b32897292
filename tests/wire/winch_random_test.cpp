// SPDX-License-Identifier: Apache-2.0
/// Winches with random commands while their wires are cut, joined, released and given nodes.
/// Material is conserved, bits do not depend on threads, and structure and state continue in
/// another world. HAWSER_OPERATIONS gives the number of operations (make test-long: 100,000).
#include <hawser/hawser.h>

#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kRandomMass = 23.0, kRandomStored = 120.0, kRandomLoad = 4e3;

long operations() {
    if (const char* given = std::getenv("HAWSER_OPERATIONS")) return std::atol(given);
    return kSanitized ? by_tier(300, 1000, 20'000) : by_tier(1000, 5000, 20'000);
}

/// Make two winches, one at the first end of its wire, one at the last.
World deck(int threads) {
    World w(WorldDef{.step = 1.0 / 60.0, .threads = threads, .on_diverged = OnDiverged::warn});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    for (int k = 0; k < 2; ++k) {
        const std::string n = std::to_string(k);
        const Vec3 at(4.0 * k, 0, 0);
        const BodyId load = w.add_body({.name = "load" + n,
                                        .kind = BodyKind::lump,
                                        .position = at - Vec3(0, 0, 10),
                                        .mass = kRandomLoad,
                                        .linear_damping = Vec3::Constant(2e3)});
        WireDef def{.name = "wire" + n};
        def.from = k == 0 ? deck : load;
        def.to = k == 0 ? load : deck;
        (k == 0 ? def.from_point : def.to_point) = at;
        def.elements = 4;
        def.EA = 2e8;
        def.mass_per_length = kRandomMass;
        def.EI = k == 0 ? 0.0 : 2e3;
        def.drag = 40.0;
        def.radius = k == 0 ? 0.0 : 0.03;
        def.consistent_mass = true;
        WinchDef winch{.name = "winch" + n, .wire = w.wires().add(def), .end = k};
        winch.core_radius = 0.4;
        winch.width = 0.5;
        winch.wire_diameter = 0.06;
        winch.mass_per_length = kRandomMass;
        winch.stored = kRandomStored;
        winch.inertia = 2e3;
        winch.torque_haul = winch.torque_pay = 1e5;
        winch.brake_static = 1e5;
        winch.weak_link = k == 0 ? 0.0 : 2e5;
        w.add(winch);
    }
    return w;
}

InteractionId line_of(const World& w, int winch) {
    for (const InteractionId id : w.interactions())
        if (w.interaction_def(id).kind == InteractionKind::WinchStretch &&
            w.interaction_def(id).name == (winch == 0 ? "wire0/s0" : "wire1/s3"))
            return id;
    return {};
}

/// Return the mass except for parts that hang on broken elements [kg].
double material(const World& w) {
    double sum = 0.0;
    for (const BodyId id : w.bodies())
        if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass;
    for (int k = 0; k < 2; ++k) {
        const std::string n = "winch" + std::to_string(k);
        sum += kRandomMass * w.system_signal(n + ".wire_left");
        const InteractionId line = line_of(w, k);
        if (line.valid() && w.intact(line)) sum += kRandomMass * w.system_signal(n + ".at_drum");
    }
    // Half elements at bodies that carry no mass of wires.
    for (const InteractionId id : w.interactions()) {
        const InteractionDef& d = w.interaction_def(id);
        if (d.kind != InteractionKind::Stretch || !(d.get("mass") > 0.0)) continue;
        for (std::size_t slot = 0; slot < 2; ++slot)
            if (w.body_def(d.body[slot]).kind != BodyKind::lump) sum += 0.5 * d.get("mass");
    }
    return sum;
}

double lightest(const World& w) {
    double least = HUGE_VAL;
    for (const BodyId id : w.bodies())
        if (w.body_def(id).kind == BodyKind::lump) least = std::min(least, w.body_def(id).mass);
    return least;
}

bool finite(const World& w) {
    for (const BodyId id : w.bodies())
        if (!w.pose(id).position.allFinite() || !w.velocity(id).linear.allFinite()) return false;
    return true;
}

/// Return the mass that a node has in addition to its half elements and keeps, if it was between
/// two drums (docs/theory/guides.md) [kg].
double kept_mass(const World& w, BodyId node) {
    if (w.body_def(node).kind != BodyKind::lump) return 0.0;
    double own = 0.0;
    for (const InteractionId id : w.interactions()) {
        const InteractionDef& d = w.interaction_def(id);
        if (d.kind == InteractionKind::Stretch && (d.body[0] == node || d.body[1] == node) &&
            d.get("mass") > 0.0)
            own += 0.5 * d.get("mass");
    }
    const double more = w.body_def(node).mass - own;
    return more > 1e-6 * own ? more : 0.0;  // otherwise rounding
}

struct Operation {
    std::string what;
    std::function<void(World&)> work;
    double adds = 0.0;  ///< Mass of gear minus mass removed [kg].
};

/// Draw any operation, including ones that the world must reject.
Operation any(std::mt19937& dice, const World& w) {
    const auto pick = [&](auto list) { return list[dice() % list.size()]; };
    const double share = static_cast<double>(dice() % 1000) / 999.0;
    const std::string winch = "winch" + std::to_string(dice() % 2);
    const WireId a = pick(w.wires().ids()), b = pick(w.wires().ids());
    const int end = static_cast<int>(dice() % 2), other = static_cast<int>(dice() % 2);
    const InteractionId element = pick(w.wires().elements(a));
    const BodyId node = pick(w.wires().nodes(a));
    switch (dice() % 12) {
        case 0:
            return {"mode", [=](World& x) { x.set_system_signal(winch + ".mode", 5.0 * share); }};
        case 1:
        case 2:
        case 3:
            return {"speed", [=](World& x) {
                        x.set_system_signal(winch + ".mode", 0.0);
                        x.set_system_signal(winch + ".speed", 6.0 * share - 3.0);
                    }};
        case 4:
            return {"pull", [=](World& x) {
                        x.set_system_signal(winch + ".tension", 1e5 * share);
                        x.set_system_signal(winch + ".brake", share);
                    }};
        case 5:
            return {"clutch", [=](World& x) { x.set_system_signal(winch + ".clutch", end); }};
        case 6:
            if (dice() % 4 != 0) return {"wait", [](World&) {}};
            return {"cut", [=](World& x) { (void)x.wires().cut(a, share * x.wires().length(a)); }};
        case 7:
            return {"splice",
                    [=](World& x) { (void)x.wires().join(a, end, b, other, {.reach = 100.0}); }};
        case 8: {
            const JoinDef def{.gear = Gear::shackle, .mass = 5.0, .length = 0.5, .reach = 100.0};
            return {"gear", [=](World& x) { (void)x.wires().join(a, end, b, other, def); },
                    def.mass};
        }
        case 9:
            if (dice() % 4 != 0) return {"wait", [](World&) {}};
            return {"detach", [=](World& x) { x.wires().detach(a, end); }};
        case 10:
            return {"insert",
                    [=](World& x) { (void)x.wires().insert_node(element, 0.1 + 0.8 * share); }};
        default:
            return {"remove",
                    [=](World& x) {
                        if (!x.wires().remove_node(node, 3.15)) throw DefError("it stays");
                    },
                    -kept_mass(w, node)};
    }
}

std::string outcome(World& w, const Operation& op) {
    try {
        op.work(w);
        return "done";
    } catch (const DefError& error) {
        return error.what();
    }
}

struct Tally {
    std::map<std::string, int> done;
    long operations = 0, failed = 0, restores = 0;
    double worst = 0.0;  ///< Relative error of material.
};

/// Run a world until it ends, or for a number of operations.
void sequence(std::uint32_t seed, long most, Tally& tally) {
    std::mt19937 dice(seed);
    std::vector<World> worlds;
    for (const int threads : {1, 3}) worlds.push_back(deck(threads));
    World& w = worlds[0];
    double owed = material(w);
    for (long k = 0; k < most; ++k) {
        const Operation op = any(dice, w);
        const std::uint64_t hash = w.state().hash();
        const double had = material(w);
        const std::string said = outcome(w, op);
        ASSERT_EQ(outcome(worlds[1], op), said) << op.what;
        ++tally.operations;
        if (said == "done") {
            ++tally.done[op.what];
            if (owed > 0.0) owed += op.adds;  // otherwise it is unknown
            ASSERT_NEAR(material(w), had + op.adds, 1e-11 * had) << op.what << " " << seed;
        } else {
            ASSERT_EQ(w.state().hash(), hash) << op.what << ": " << said;
        }
        for (int step = 0; step < 3; ++step) {
            const Status status = w.step();
            // After many cuts and divisions a wire has nodes of milligrams beside loads of 4 t.
            // Elements of micrometres are 1e13 times as stiff per weight: a failed status is
            // allowed.
            ASSERT_TRUE(status == Status::ok || status == Status::diverged || lightest(w) < 1e-4)
                << to_string(status) << " " << to_string(w.bad_load(), w) << " after " << op.what
                << " " << seed;
            ASSERT_EQ(worlds[1].step(), status);
            ASSERT_TRUE(finite(w)) << op.what << " " << seed;
            if (status != Status::ok) {
                ++tally.failed;
                return;
            }
        }
        ASSERT_EQ(worlds[1].state().hash(), w.state().hash()) << op.what << " " << k << " " << seed;
        for (int line = 0; line < 2; ++line)
            if (const InteractionId id = line_of(w, line); id.valid() && !w.intact(id)) owed = -1.0;
        if (owed > 0.0) {
            tally.worst = std::max(tally.worst, std::abs(material(w) / owed - 1.0));
            ASSERT_NEAR(material(w), owed, 1e-10 * owed) << op.what << " " << k << " " << seed;
        }
        if (k % 12 == 7) {
            World fresh = deck(2);
            fresh.state().restore(w.state().structure(), w.state().save());
            worlds[1] = std::move(fresh);
            ++tally.restores;
            ASSERT_EQ(worlds[1].state().hash(), w.state().hash());
        }
    }
}

TEST(WinchRandom, OperationsKeepMaterialAndBits) {
    Tally tally;
    constexpr long kEach = 200;
    for (std::uint32_t seed = first_seed(1); tally.operations < operations() && !HasFatalFailure();
         ++seed) {
        sequence(seed, kEach, tally);
        if (seed % 50 == 0)
            std::printf("seed %u: %ld operations\n", seed, tally.operations), std::fflush(stdout);
    }
    std::printf("%ld operations, %ld restores, %ld worlds ended early; material to %.1e\n",
                tally.operations, tally.restores, tally.failed, tally.worst);
    for (const auto& [what, count] : tally.done) std::printf("  %-8s %d\n", what.c_str(), count);
    for (const char* what : {"speed", "cut", "splice", "gear", "detach", "insert", "remove"})
        EXPECT_GT(tally.done[what], 1) << what;
}

/// Two faults of drums that had hauled in more than their element. In 332 others removed its node,
/// and its mass was lost. In 766 its end was released with created mass.
TEST(WinchRandom, DrumsThatHaveHauledInAllOfAnElementKeepItsAccount) {
    for (const std::uint32_t seed : {332U, 766U}) {
        Tally tally;
        sequence(seed, 200, tally);
        EXPECT_EQ(tally.operations, 200) << seed;
        EXPECT_EQ(tally.failed, 0) << seed;
    }
}

}  // namespace
}  // namespace hawser::test
