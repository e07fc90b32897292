// SPDX-License-Identifier: Apache-2.0
/// Systems as part of a world: their order, their state, their failures and the names in messages.
#include "systems/acting.h"

#include "support/recipe.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hawser::test {
namespace {

template <class F>
std::string refusal(F&& f) {
    try {
        f();
    } catch (const DefError& e) {
        return e.what();
    }
    return "";
}

/// Make hulls in swell, loaded by all threads at once; their water has a memory.
World fleet(int threads) {
    WorldDef def;
    def.threads = threads;
    World w(def);
    for (int i = 0; i < 300; ++i) w.add_body(floating({3.0 * i, 0, 0}, 5.0 + i % 7, {2, 3, 4}));
    for (int i = 0; i + 1 < 300; i += 2) {
        InteractionDef d = between(InteractionKind::Stretch, {BodyId{i}, BodyId{i + 1}});
        w.add_interaction(d.set("EA", 1e4).set("length", 2.9));
    }
    act(
        w, "water",
        [](Acting& self, Prestep& now, Loads& loads) {
            const int n = now.world.body_count();
            std::vector<BodyId> all;
            for (int b = 0; b < n; ++b) all.push_back(BodyId{b});
            loads.reserve(all);
            now.for_each(n, [&](int b) {
                const BodyId id{b};
                double& memory = self.state[static_cast<std::size_t>(b)];
                const Pose p = now.world.pose(id);
                memory = 0.9 * memory + std::sin(1.3 * now.time + 0.2 * b) + p.position.z();
                loads.add_mass(id, coupled(static_cast<unsigned>(b), 3.0));
                loads.add_damping(id, coupled(static_cast<unsigned>(b) + 5, 2.0));
                loads.add_force(id, {0.1 * memory, 0, 5.0 * memory - 9.0 * p.position.z()},
                                {0.2 * memory, 0, 0});
            });
        },
        300);
    return w;
}

void run(World& w, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok);
}

TEST(Systems, GiveTheSameBitsOnAnyNumberOfThreadsAndAfterRestore) {
    World one = fleet(1), two = fleet(2), four = fleet(4);
    run(one, 40);
    const auto saved = one.state().save();
    run(one, 40);
    run(two, 80);
    run(four, 80);
    EXPECT_EQ(one.state().hash(), two.state().hash());
    EXPECT_EQ(one.state().hash(), four.state().hash());
    EXPECT_EQ(one.energy().system, four.energy().system);
    // In a world with another state, and in a new one.
    two.state().restore(saved);
    run(two, 40);
    EXPECT_EQ(one.state().hash(), two.state().hash());
    World fresh = fleet(1);
    fresh.state().restore(saved);
    EXPECT_EQ(fresh.state().save(), saved);
    run(fresh, 20);
    World twin = fresh.twin();
    EXPECT_EQ(twin.state().hash(), fresh.state().hash());
    run(twin, 20);
    EXPECT_EQ(one.state().hash(), twin.state().hash());
    EXPECT_EQ(one.energy().system, twin.energy().system);
    fresh.state().copy_from(twin);
    EXPECT_EQ(one.state().hash(), fresh.state().hash());
    run(fresh, 5);
    run(one, 5);
    EXPECT_EQ(one.state().hash(), fresh.state().hash());
}

/// Counts, drives an input beyond its range, adds loads, and cancels the step on request.
struct Driven {
    World w{WorldDef{}};
    BodyId body{};
    InputId push{};
    int cancels = 0;

    Driven() {
        body = w.add_body(floating({0, 0, 1}, 3.0, {1, 1, 1}));
        w.add_input({.name = "push",
                     .interaction = {},
                     .param = {},
                     .body = body,
                     .component = 0,
                     .min = -5.0,
                     .max = 5.0});
        push = w.find_input("push");
        act(
            w, "driver",
            [this](Acting& self, Prestep& now, Loads& loads) {
                self.state[0] += 1.0 + 0.1 * self.state[0];
                now.set_input(push, self.state[0]);
                loads.add_force(body, {0, 0, 2.0 * self.state[0]});
                if (cancels-- > 0) w.cancel();
            },
            1);
    }
};

TEST(Systems, AStepThatFailsTakesBackWhatTheyDid) {
    Driven failing, well;
    for (int i = 0; i < 20; ++i) {
        failing.cancels = i % 3;
        const std::uint64_t before = failing.w.state().hash();
        const auto saved = i > 0 ? failing.w.state().save() : std::vector<std::byte>{};
        for (int k = 0; k < i % 3; ++k) {
            ASSERT_EQ(failing.w.step(), Status::cancelled);
            ASSERT_EQ(failing.w.state().hash(), before);
            ASSERT_EQ(failing.w.input(failing.push), well.w.input(well.push));
            if (i > 0) {
                ASSERT_EQ(failing.w.state().save(), saved);
            }
        }
        ASSERT_EQ(failing.w.step(), Status::ok);
        ASSERT_EQ(well.w.step(), Status::ok);
        ASSERT_EQ(failing.w.state().hash(), well.w.state().hash()) << i;
    }
    // Each successful step with an excessive value reported it once.
    const auto clamped = failing.w.events().extremes(EventKind::input_clamped);
    EXPECT_GT(clamped.count, 0);
    EXPECT_EQ(clamped.count, well.w.events().extremes(EventKind::input_clamped).count);
    EXPECT_EQ(failing.w.input(failing.push), 5.0);
}

TEST(Systems, ActInOrderOnceAStepAndSeeTheStepThatBegins) {
    World w;
    const BodyId b = w.add_body(floating({0, 0, 0}, 1.0, {1, 1, 1}));
    std::string order;
    for (const char* name : {"b", "a", "c"})
        act(w, name, [&order, &w, name](Acting&, Prestep& now, Loads&) {
            order += name;
            EXPECT_EQ(now.time, w.time());
            EXPECT_EQ(now.count, w.step_count());
            EXPECT_EQ(now.step, w.settings().step);
            EXPECT_EQ(&now.world, &w);
        });
    run(w, 2);
    EXPECT_EQ(order, "bacbac");
    const std::unique_ptr<System> gone = w.remove_system(w.system(1));
    EXPECT_EQ(gone->name(), "a");
    run(w, 1);
    EXPECT_EQ(order, "bacbacbc");
    EXPECT_EQ(w.find_system("a"), nullptr);
    EXPECT_EQ(w.find_system("c"), &w.system(1));
    (void)b;
}

TEST(Systems, BadLoadsEndTheStepAndNameSystemAndBody) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Mat6 indefinite = Mat6::Identity();
    indefinite(0, 4) = indefinite(4, 0) = 1.1;
    Mat6 aside = Mat6::Zero();
    aside(2, 5) = aside(5, 2) = 1e-3;
    struct Case {
        const char* wrong;
        std::function<void(Prestep&, Loads&, BodyId)> act;
    };
    const Case cases[] = {
        {"finite", [&](Prestep&, Loads& l, BodyId b) { l.add_force(b, {0, nan, 0}); }},
        {"added mass", [&](Prestep&, Loads& l, BodyId b) { l.add_mass(b, indefinite); }},
        {"damping",
         [&](Prestep&, Loads& l, BodyId b) { l.add_damping(b, Mat3(-Mat3::Identity())); }},
        {"stiffness", [&](Prestep&, Loads& l, BodyId b) { l.add_stiffness(b, aside); }},
        {"no such body", [&](Prestep&, Loads& l, BodyId) { l.add_force(BodyId{77}, {1, 0, 0}); }},
        {"no such input", [&](Prestep& p, Loads&, BodyId) { p.set_input(InputId{3}, 1.0); }},
    };
    for (const Case& c : cases) {
        World w;
        w.add_body({.name = "buoy", .kind = BodyKind::lump, .mass = 1.0});
        BodyDef def = floating({5, 0, 0}, 2.0, {1, 1, 1});
        def.name = "hull";
        const BodyId hull = w.add_body(def);
        bool now_wrong = false;
        act(w, "calm", [&](Acting&, Prestep&, Loads& l) { l.add_force(hull, {0, 0, 1}); });
        act(w, "storm", [&](Acting&, Prestep& p, Loads& l) {
            if (now_wrong) c.act(p, l, hull);
        });
        run(w, 3);
        now_wrong = true;
        const std::uint64_t before = w.state().hash();
        ASSERT_EQ(w.step(), Status::bad_load) << c.wrong;
        EXPECT_EQ(w.state().hash(), before);
        const std::string said = to_string(w.bad_load(), w);
        EXPECT_NE(said.find("'storm'"), std::string::npos) << said;
        EXPECT_NE(said.find(c.wrong), std::string::npos) << said;
        const bool of_hull = std::string(c.wrong).find("no such") == std::string::npos;
        EXPECT_EQ(said.find("'hull'") != std::string::npos, of_hull) << said;
        now_wrong = false;
        EXPECT_EQ(w.step(), Status::ok);
        EXPECT_EQ(to_string(w.bad_load(), w), "");
    }
}

/// Matrices that are semi-definite up to rounding are accepted: of rank one, with very different
/// units.
TEST(Systems, TellAllTheirEventsHoweverMany) {
    World w;
    const BodyId drum = w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 1.0});
    act(w, "talker", [&](Acting& self, Prestep& now, Loads&) {
        for (int i = 0; i < 300; ++i)
            now.tell(EventKind::layer, drum, 300.0 * static_cast<double>(self.calls) + i);
    });
    act(w, "other",
        [&](Acting&, Prestep& now, Loads&) { now.tell(EventKind::brake_slip, drum, 7.0); });
    std::uint64_t cursor = 0;
    std::vector<Event> events;
    for (int step = 1; step <= 3; ++step) {
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_EQ(w.events().since(cursor, events), 0U);
        ASSERT_EQ(events.size(), 301U);
        for (int i = 0; i < 300; ++i)
            EXPECT_EQ(events[static_cast<std::size_t>(i)].value, 300.0 * step + i);
        EXPECT_EQ(events.back().kind, EventKind::brake_slip);
    }
    EXPECT_EQ(w.events().extremes(EventKind::layer).count, 900);
}

TEST(Systems, LoadsOfRankOneAreTaken) {
    World w;
    const BodyId b = w.add_body(floating({0, 0, 0}, 1e3, {1e5, 2e5, 3e5}));
    std::uint32_t seed = first_seed(1);
    act(w, "drag", [&](Acting&, Prestep&, Loads& loads) {
        Vec6 along;
        for (int i = 0; i < 6; ++i) {
            seed = seed * 1664525u + 1013904223u;
            along[i] = (static_cast<double>(seed >> 8) / (1 << 24) - 0.5) * (i < 3 ? 1.0 : 40.0);
        }
        loads.add_damping(b, Mat6(7.0 * along * along.transpose()));
    });
    run(w, by_tier(300, 1500, 15'000));
}

TEST(Systems, AreRefusedWithAReason) {
    World w;
    w.add_body(floating({0, 0, 0}, 1.0, {1, 1, 1}));
    const auto nothing = [](Acting&, Prestep&, Loads&) {};
    act(w, "one", nothing);
    EXPECT_NE(refusal([&] { act(w, "one", nothing); }).find("name is in use"), std::string::npos);
    EXPECT_NE(refusal([&] { act(w, "", nothing); }).find("name"), std::string::npos);
    EXPECT_NE(refusal([&] { w.add_system(nullptr); }).find("no system"), std::string::npos);
    const Acting other("other", nothing);
    EXPECT_NE(refusal([&] { w.remove_system(other); }).find("none"), std::string::npos);
    EXPECT_EQ(w.system_count(), 1);
    World swept({.nonsmooth = Nonsmooth::pgs});
    EXPECT_NE(refusal([&] { act(swept, "one", nothing); }).find("newton"), std::string::npos);
    // Snapshots of worlds with other systems.
    run(w, 2);
    const auto saved = w.state().save();
    World bare;
    bare.add_body(floating({0, 0, 0}, 1.0, {1, 1, 1}));
    EXPECT_NE(refusal([&] { bare.state().restore(saved); }).find("other systems"),
              std::string::npos);
    EXPECT_NE(refusal([&] { bare.state().copy_from(w); }).find("other systems"), std::string::npos);
    act(bare, "one", nothing, 1);
    EXPECT_NE(refusal([&] { bare.state().restore(saved); }).find("other systems"),
              std::string::npos);
}

/// A system without a clone.
struct Fixed final : System {
    double target = 1.0, seen = 0.0;
    [[nodiscard]] std::string_view name() const noexcept override { return "fixed"; }
    void prestep(Prestep&, Loads&) noexcept override { seen = 2.0 * target; }
    void visit_state(StateVisitor& v) override {
        v.visit(target);
        v.visit(seen);
    }
    void signals(SignalTable& table) override {
        table.input("target", "N", target, -10.0, 10.0);
        table.output("seen", "N", seen);
    }
};

TEST(Systems, ShowTheirSignalsByName) {
    World w;
    w.add_body(floating({0, 0, 0}, 1.0, {1, 1, 1}));
    w.add_system(std::make_unique<Fixed>());
    ASSERT_EQ(w.system_signals().size(), 2u);
    EXPECT_EQ(w.system_signals()[1].unit, "N");
    w.set_system_signal("fixed.target", 3.0);
    run(w, 1);
    EXPECT_EQ(w.system_signal("fixed.seen"), 6.0);
    w.set_system_signal("fixed.target", 300.0);
    EXPECT_EQ(w.system_signal("fixed.target"), 10.0);
    EXPECT_NE(refusal([&] { (void)w.system_signal("fixed.tarlet"); }).find("'fixed.target'"),
              std::string::npos);
    EXPECT_NE(refusal([&] { w.set_system_signal("fixed.seen", 1.0); }).find("output"),
              std::string::npos);
    EXPECT_NE(refusal([&] { (void)w.twin(); }).find("'fixed'"), std::string::npos);
    // Events belong to the state.
    const auto saved = w.state().save();
    w.set_system_signal("fixed.target", 1.0);
    w.state().restore(saved);
    EXPECT_EQ(w.system_signal("fixed.target"), 10.0);
}

TEST(Systems, ABodyWithALoadStaysAwake) {
    WorldDef def;
    def.sleep_after = 0.2;
    World w(def);
    for (const double y : {0.0, 5.0}) w.add_body(floating({0, y, 0}, 1.0, {1, 1, 1}));
    bool on = false;
    act(w, "breeze", [&](Acting&, Prestep&, Loads& l) {
        if (on) l.add_force(BodyId{1}, {0, 0, 0});
    });
    run(w, 60);
    EXPECT_TRUE(w.asleep(BodyId{0}));
    EXPECT_TRUE(w.asleep(BodyId{1}));
    on = true;
    run(w, 60);
    EXPECT_TRUE(w.asleep(BodyId{0}));
    EXPECT_FALSE(w.asleep(BodyId{1}));
}

TEST(Systems, ThatDoNothingChangeNothingAndCostNothing) {
    Recipe r = mixed(3);
    World with = r.make(), without = r.make();
    struct Idle final : System {
        std::string own;
        [[nodiscard]] std::string_view name() const noexcept override { return own; }
        void prestep(Prestep&, Loads&) noexcept override {}
    };
    for (int i = 0; i < 50; ++i) {
        auto idle = std::make_unique<Idle>();
        idle->own = "idle " + std::to_string(i);
        with.add_system(std::move(idle));
    }
    run(with, 50);
    run(without, 50);
    EXPECT_EQ(with.state().hash(), without.state().hash());
    // Time of the stage itself, least of many steps of a small world.
    World a, b;
    for (World* w : {&a, &b}) w->add_body(floating({0, 0, 0}, 1.0, {1, 1, 1}));
    constexpr int kMany = 1000;
    for (int i = 0; i < kMany; ++i) {
        auto idle = std::make_unique<Idle>();
        idle->own = "idle " + std::to_string(i);
        a.add_system(std::move(idle));
    }
    double least[2] = {1.0, 1.0};
    for (int i = 0; i < 300; ++i)
        for (World* w : {&a, &b}) {
            ASSERT_EQ(w->step(), Status::ok);
            if (i == 0) continue;  // the first step calls them before its clock starts
            double& now = least[w == &a ? 0 : 1];
            now = std::min(now, w->stats().stage_seconds[0]);
        }
    const double each = (least[0] - least[1]) / kMany;
    std::printf("a system that does nothing: %.1f ns a step\n", 1e9 * each);
    if (!kSanitized) {
        EXPECT_LT(each, 100e-9);
    }
}

}  // namespace
}  // namespace hawser::test
