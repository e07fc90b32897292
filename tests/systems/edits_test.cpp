// SPDX-License-Identifier: Apache-2.0
/// Additions and removals requested by systems, and objects that they keep from removal.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace hawser::test {
namespace {

/// Calls a given function.
struct Doer final : System {
    std::string called = "doer";
    std::function<void(Prestep&, Loads&)> act;
    std::function<void(HoldTable&)> hold;
    double calls = 0.0;
    [[nodiscard]] std::string_view name() const noexcept override { return called; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        calls += 1.0;
        if (act) act(now, loads);
    }
    void visit_state(StateVisitor& visitor) override { visitor.visit(calls); }
    void signals(SignalTable& table) override { table.output("calls", "1", calls); }
    void holds(HoldTable& table) const override {
        if (hold) hold(table);
    }
};

Doer& add_doer(World& w, std::function<void(Prestep&, Loads&)> act) {
    auto doer = std::make_unique<Doer>();
    doer->act = std::move(act);
    return static_cast<Doer&>(w.add_system(std::move(doer)));
}

BodyDef lump(const char* name, const Vec3& position) {
    BodyDef def{.name = name, .kind = BodyKind::lump, .position = position};
    def.mass = 2.0;
    return def;
}

struct Yard {
    World w{{.step = 0.01}};
    BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    BodyId bob = w.add_body(lump("bob", {1, 0, 0}));
    InteractionId rod = w.add(DistanceDef{.name = "rod", .a = ground, .b = bob});
};

void build(Prestep& now, Loads& loads) {
    loads.add_force(now.world.find_body("bob"), {3, 0, 0});
    if (now.count == 10) {
        const BodyId body = now.edits.add_body(lump("built", {2, 0, 0}));
        InteractionDef link;
        link.kind = InteractionKind::Distance;
        link.name = "link";
        link.body = {now.world.find_body("bob"), body};
        (void)now.edits.add_interaction(link);
        WireDef wire{.name = "wire", .from = body, .elements = 3, .length = 1.0, .EA = 1e5};
        wire.mass_per_length = 1.0;
        (void)now.edits.add_wire(wire);
    }
    if (now.count == 40) now.edits.remove_wire(now.world.wires().find("wire"));
    if (now.count == 60) now.edits.remove_body(now.world.find_body("built"));
}

TEST(SystemEdits, AreThoseThatAUserMakesBeforeTheStep) {
    Yard by_system, by_hand;
    Doer& doer = add_doer(by_system.w, build);
    add_doer(by_hand.w, [](Prestep& now, Loads& loads) {
        loads.add_force(now.world.find_body("bob"), {3, 0, 0});
    });
    for (int i = 0; i < 90; ++i) {
        World& w = by_hand.w;
        if (i == 10) {
            const BodyId body = w.add_body(lump("built", {2, 0, 0}));
            w.add(DistanceDef{.name = "link", .a = by_hand.bob, .b = body});
            WireDef wire{.name = "wire", .from = body, .elements = 3, .length = 1.0, .EA = 1e5};
            wire.mass_per_length = 1.0;
            w.wires().add(wire);
        }
        if (i == 40) w.wires().remove(w.wires().find("wire"));
        if (i == 60) w.remove_body(w.find_body("built"));
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_EQ(by_system.w.step(), Status::ok) << to_string(by_system.w.bad_load(), by_system.w);
        ASSERT_EQ(by_system.w.state().motion_hash(), w.state().motion_hash()) << "step " << i;
    }
    EXPECT_EQ(doer.calls, 90.0);
}

TEST(SystemEdits, ThatAreRefusedChangeNothing) {
    Yard y;
    bool wrong = true;
    Doer& doer = add_doer(y.w, [&](Prestep& now, Loads& loads) {
        loads.add_force(now.world.find_body("bob"), {3, 0, 0});
        if (!wrong) return;
        (void)now.edits.add_body(lump("fine", {5, 0, 0}));
        now.edits.remove_interaction(now.world.find_interaction("rod"));
        (void)now.edits.add_body(lump("bob", {6, 0, 0}));
    });
    const std::uint64_t before = y.w.state().hash();
    ASSERT_EQ(y.w.step(), Status::bad_edit);
    EXPECT_EQ(y.w.bad_load().system, "doer");
    const std::string said = to_string(y.w.bad_load(), y.w);
    EXPECT_NE(said.find("doer"), std::string::npos) << said;
    EXPECT_NE(said.find("the name is in use"), std::string::npos) << said;
    EXPECT_EQ(y.w.bodies().size(), 2U);
    EXPECT_TRUE(y.w.alive(y.rod));
    EXPECT_EQ(y.w.state().hash(), before);
    EXPECT_EQ(doer.calls, 0.0);
    wrong = false;
    Yard other;
    add_doer(other.w, [](Prestep& now, Loads& loads) {
        loads.add_force(now.world.find_body("bob"), {3, 0, 0});
    });
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(y.w.step(), Status::ok);
        ASSERT_EQ(other.w.step(), Status::ok);
    }
    EXPECT_EQ(y.w.state().hash(), other.w.state().hash());
}

TEST(SystemEdits, StayWhereTheStepIsCancelledAndAreAskedForOnce) {
    Yard cancelled, straight;
    bool cancel = true;
    add_doer(cancelled.w, [&](Prestep& now, Loads& loads) {
        build(now, loads);
        // A flag that the step reads after the edits.
        if (now.count == 10 && std::exchange(cancel, false)) cancelled.w.cancel();
    });
    add_doer(straight.w, build);
    for (int i = 0; i < 80; ++i) {
        Status status = cancelled.w.step();
        if (status == Status::cancelled) status = cancelled.w.step();
        ASSERT_EQ(status, Status::ok);
        ASSERT_EQ(straight.w.step(), Status::ok);
        ASSERT_EQ(cancelled.w.state().hash(), straight.w.state().hash()) << "step " << i;
    }
    EXPECT_FALSE(cancel);
}

TEST(SystemHolds, IsNotRemoved) {
    Yard y;
    Doer& doer = add_doer(y.w, {});
    doer.hold = [&](HoldTable& table) { table.hold(y.rod); };
    const auto refused = [&](auto&& remove) {
        try {
            remove();
        } catch (const DefError& error) {
            return std::string(error.what()).find("'doer'") != std::string::npos;
        }
        return false;
    };
    EXPECT_TRUE(refused([&] { y.w.remove_interaction(y.rod); }));
    EXPECT_TRUE(refused([&] { y.w.remove_body(y.bob); }));  // the rod would be removed with it
    EXPECT_TRUE(y.w.alive(y.rod));
    EXPECT_TRUE(y.w.alive(y.bob));
    (void)y.w.remove_system(doer);
    EXPECT_EQ(y.w.remove_body(y.bob).interactions.size(), 1U);
}

TEST(SystemSignals, AreOutputs) {
    Yard y;
    Doer& doer = add_doer(y.w, {});
    const OutputId calls = y.w.find_output("doer.calls");
    ASSERT_TRUE(y.w.alive(calls));
    EXPECT_EQ(y.w.output_def(calls).unit, "1");
    for (int i = 0; i < 3; ++i) ASSERT_EQ(y.w.step(), Status::ok);
    EXPECT_EQ(y.w.output(calls), 3.0);
    EXPECT_THROW(y.w.remove_output(calls), DefError);
    (void)y.w.remove_system(doer);
    EXPECT_FALSE(y.w.alive(calls));
    EXPECT_TRUE(std::isnan(y.w.outputs()[0]));
}

TEST(Forces, OfUserInputsAndSystemsAddUp) {
    Yard separation, together;
    for (Yard* y : {&separation, &together}) y->w.remove_interaction(y->rod);
    World& w = separation.w;
    const InputId one = w.add_input({.name = "one", .body = separation.bob, .component = 0});
    const InputId two = w.add_input({.name = "two", .body = separation.bob, .component = 0});
    add_doer(w, [](Prestep& now, Loads& loads) {
        loads.add_force(now.world.find_body("bob"), {8, 0, 0});
    });
    w.set_force(separation.bob, {1, 0, 0}, Vec3::Zero());
    w.set_input(one, 2.0);
    w.set_input(two, 4.0);
    w.set_force(separation.bob, {16, 0, 0}, Vec3::Zero());  // replaces only the user's own force
    together.w.set_force(together.bob, {30, 0, 0}, Vec3::Zero());
    const std::vector<std::byte> saved = w.state().save();
    double speed = 0.0;
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i < 20; ++i) ASSERT_EQ(w.step(), Status::ok);
        const double now = w.velocity(separation.bob).linear.x();
        if (round == 1) {
            EXPECT_EQ(now, speed);  // also after a restore
        }
        speed = now;
        w.state().restore(saved);
    }
    for (int i = 0; i < 20; ++i) ASSERT_EQ(together.w.step(), Status::ok);
    // Loads are added to the right-hand side separately: another order of a few sums.
    EXPECT_NEAR(speed, together.w.velocity(together.bob).linear.x(), 1e-12);
    EXPECT_NEAR(speed, 15.0 * (20 - 0.5) * 0.01, 1e-12);
    // Values set by an input remain after its removal.
    w.remove_input(two);
    EXPECT_EQ(w.body_def(separation.bob).force.x(), 20.0);
}

}  // namespace
}  // namespace hawser::test
