// SPDX-License-Identifier: Apache-2.0
/// Random sequences of all operations on wires while a world runs. Bits are equal for any number of
/// threads, in a world that repeats the changes reported to a listener, and after a restored state.
#include <hawser/hawser.h>

#include "record/changes.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Operations per world; each adds nodes to its wires, which makes later steps slower.
constexpr int kOperations = kSanitized ? 60 : 200;

/// Return the number of worlds. HAWSER_OPERATIONS gives the number of operations of all worlds.
unsigned worlds_to_try() {
    if (const char* given = std::getenv("HAWSER_OPERATIONS"))
        return static_cast<unsigned>(std::atol(given) / kOperations);
    return static_cast<unsigned>(seed_count(2, 10, 100));
}

/// Make two wires between a beam and two blocks, one of point masses, one of straight pieces with
/// bends.
World wires_world(int threads) {
    World w({.step = 0.01, .threads = threads, .on_diverged = OnDiverged::warn});
    const BodyId beam =
        w.add_body({.name = "beam", .kind = BodyKind::fixed, .position = {0, 0, 20}});
    for (int k = 0; k < 2; ++k) {
        const BodyId block = w.add_body({.name = k == 0 ? "left" : "right",
                                         .position = {8.0 * k, 1, 8},
                                         .mass = 400.0,
                                         .inertia = Mat3::Identity() * 60.0,
                                         .linear_damping = Vec3::Constant(300.0),
                                         .angular_damping = Vec3::Constant(300.0)});
        (void)w.wires().add({.name = k == 0 ? "plain" : "pieces",
                             .from = beam,
                             .from_point = {8.0 * k, 0, 0},
                             .to = block,
                             .to_point = {0, 0, 0.5},
                             .elements = 8,
                             .length = 12.0,
                             .EA = 2e6,
                             .mass_per_length = 4.0,
                             .EI = k == 0 ? 0.0 : 30.0,
                             .drag = 30.0,
                             .radius = k == 0 ? 0.0 : 0.02,
                             .consistent_mass = k == 1,
                             .end_capsules = k == 1});
    }
    return w;
}

/// Return the mass of nodes and of half elements that end at other bodies, whose mass no node has.
double lump_mass(const World& w) {
    double sum = 0.0;
    for (const BodyId id : w.bodies())
        if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass;
    for (const InteractionId id : w.interactions()) {
        const InteractionDef& d = w.interaction_def(id);
        if (d.kind != InteractionKind::Stretch) continue;
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

struct Operation {
    std::string what;
    std::function<void(World&)> work;
    bool keeps_mass = true;
};

template <class T>
T pick(std::mt19937& dice, std::span<const T> from) {
    return from[dice() % from.size()];
}

/// Draw any operation, including ones that the world must reject.
Operation any(std::mt19937& dice, const World& w) {
    const WireId a = pick(dice, w.wires().ids()), b = pick(dice, w.wires().ids());
    const int end = static_cast<int>(dice() % 2), other = static_cast<int>(dice() % 2);
    const double share = static_cast<double>(dice() % 1000) / 999.0;
    const InteractionId element = pick(dice, w.wires().elements(a));
    switch (dice() % 8) {
        case 0:
            return {"cut", [=](World& x) { (void)x.wires().cut(a, share * x.wires().length(a)); }};
        case 1:
            return {"splice",
                    [=](World& x) { (void)x.wires().join(a, end, b, other, {.reach = 100.0}); }};
        case 2: {
            const JoinDef def{.gear = static_cast<Gear>(1 + dice() % 4),
                              .mass = 5.0,
                              .length = 0.5,
                              .breaking_load = 1e6,
                              .reach = 100.0};
            return {"gear", [=](World& x) { (void)x.wires().join(a, end, b, other, def); }, false};
        }
        case 3: {
            const BodyId body = w.find_body(dice() % 2 == 0 ? "left" : "right");
            const Gear gear = dice() % 2 == 0 ? Gear::splice : Gear::pelican_hook;
            return {"attach", [=](World& x) {
                        (void)x.wires().attach(a, end, body, {0, 0, 0.5},
                                               {.gear = gear, .reach = 100.0});
                    }};
        }
        case 4:
            return {"detach", [=](World& x) { x.wires().detach(a, end); }, false};
        case 5: {
            std::vector<InteractionId> all(w.interactions().begin(), w.interactions().end());
            for (std::size_t k = all.size(); k-- > 0;)
                if (w.interaction_def(all[k]).name.find("gear") == std::string::npos)
                    all.erase(all.begin() + static_cast<std::ptrdiff_t>(k));
            const InteractionId hook =
                all.empty() ? element : pick(dice, std::span<const InteractionId>(all));
            return {"release", [=](World& x) { x.wires().release(hook); }};
        }
        case 6:
            return {"insert",
                    [=](World& x) { (void)x.wires().insert_node(element, 0.1 + 0.8 * share); }};
        default: {
            const BodyId node = pick(dice, w.wires().nodes(a));
            return {"remove", [=](World& x) { (void)x.wires().remove_node(node, 3.15); }};
        }
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

void sequence(unsigned seed, std::vector<int>& done) {
    std::mt19937 dice(seed);
    std::vector<World> worlds;
    for (const int threads : {1, 2, 4}) worlds.push_back(wires_world(threads));
    World repeated = wires_world(1);
    record::ChangeBytes heard;
    worlds[0].set_change_listener(&heard);
    for (int k = 0; k < kOperations; ++k) {
        const Operation op = any(dice, worlds[0]);
        const double mass = lump_mass(worlds[0]);
        const auto bytes = heard.bytes().size();
        const std::uint64_t hash = worlds[0].state().hash();
        const std::string said = outcome(worlds[0], op);
        for (std::size_t i = 1; i < worlds.size(); ++i)
            ASSERT_EQ(outcome(worlds[i], op), said) << op.what;
        if (said == "done") {
            ++done[static_cast<std::size_t>(op.what[0] + op.what[1]) % done.size()];
        } else {
            ASSERT_EQ(worlds[0].state().hash(), hash) << op.what << ": " << said;
            ASSERT_EQ(heard.bytes().size(), bytes) << op.what << ": " << said;
        }
        if (op.keeps_mass) {
            ASSERT_NEAR(lump_mass(worlds[0]), mass, 1e-11 * mass) << op.what;
        }
        for (const WireId id : worlds[0].wires().ids())
            ASSERT_EQ(worlds[0].wires().nodes(id).size(), worlds[0].wires().elements(id).size() + 1)
                << op.what;
        record::apply_changes(heard.bytes(), repeated);
        heard.clear();
        ASSERT_EQ(repeated.state().hash(), worlds[0].state().hash()) << op.what << " " << k;
        for (int step = 0; step < 2; ++step) {
            const Status status = worlds[0].step();
            // Repeated insertion beside nodes leaves nodes of milligrams beside blocks of 400 kg,
            // with elements 1e15 times as stiff. A world that only warns also continues after a
            // failed monitor. Such a world may end with another status.
            ASSERT_TRUE(status == Status::ok || status == Status::diverged ||
                        lightest(worlds[0]) < 1e-4 || worlds[0].verdict().grade == Grade::wrong)
                << to_string(status) << " after " << op.what << ", seed " << seed << ", lightest "
                << lightest(worlds[0]) << " kg, " << to_string(worlds[0].verdict().grade);
            ASSERT_TRUE(finite(worlds[0])) << op.what;
            for (std::size_t i = 1; i < worlds.size(); ++i) ASSERT_EQ(worlds[i].step(), status);
            ASSERT_EQ(repeated.step(), status);
            if (status != Status::ok) return;
        }
        ASSERT_TRUE(finite(worlds[0])) << op.what;
        for (std::size_t i = 1; i < worlds.size(); ++i)
            ASSERT_EQ(worlds[i].state().hash(), worlds[0].state().hash()) << op.what << " " << k;
        ASSERT_EQ(repeated.state().hash(), worlds[0].state().hash()) << op.what << " " << k;
        if (k % 10 == 9) {  // one continues and is restored, and twins are in the same state
            const auto saved = worlds[1].state().save();
            (void)worlds[1].step();
            worlds[1].state().restore(saved);
            const World twin = worlds[2].twin();
            ASSERT_EQ(worlds[1].state().hash(), worlds[0].state().hash());
            ASSERT_EQ(twin.state().hash(), worlds[0].state().hash());
        }
    }
}

TEST(WireCutRandom, SequencesAreRepeatedInAllBits) {
    std::vector<int> done(64, 0);
    const unsigned first = first_seed(1);
    for (unsigned seed = first; seed < first + worlds_to_try() && !HasFatalFailure(); ++seed) {
        sequence(seed, done);
        if (seed % 50 == 0)
            std::printf("seed %u of %u\n", seed, first + worlds_to_try() - 1), std::fflush(stdout);
    }
    // The quick tier has too few operations to require some of each kind.
    const int least = by_tier(0, 2, 2);
    for (const char* what : {"cu", "sp", "ge", "at", "de", "in", "re"})
        EXPECT_GT(done[static_cast<std::size_t>(what[0] + what[1]) % done.size()], least) << what;
}

}  // namespace
}  // namespace hawser::test
