// SPDX-License-Identifier: Apache-2.0
/// Wires as things of a world.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

struct Hanging {
    World w;
    BodyId top;
    WireId wire;
    Hanging() {
        top = w.add_body({.name = "top", .kind = BodyKind::fixed});
        WireDef def{.name = "wire", .from = top};
        def.elements = 5;
        def.length = 50.0;
        def.EA = 1e8;
        def.mass_per_length = 4.0;
        wire = w.add_wire(def);
    }
};

TEST(Wires, HangByTheirWeight) {
    Hanging h;
    World& w = h.w;
    EXPECT_EQ(w.find_wire("wire"), h.wire);
    EXPECT_EQ(w.nodes(h.wire).size(), 6U);
    EXPECT_EQ(w.elements(h.wire).size(), 5U);
    EXPECT_DOUBLE_EQ(w.length(h.wire), 50.0);
    double mass = 0.0;
    for (const BodyId b : w.bodies()) mass += b == h.top ? 0.0 : w.body_def(b).mass;
    EXPECT_DOUBLE_EQ(mass, 4.0 * 45.0) << "half an element hangs on the body at the top";
    for (int i = 0; i < 240; ++i) ASSERT_EQ(w.step(), Status::ok);
    // Lumps below the middle of element k: (4 - k) whole ones and a half.
    for (int k = 0; k < 5; ++k) {
        const double weight = 9.81 * 4.0 * 10.0 * (4.5 - k);
        EXPECT_NEAR(w.tension(h.wire, 10.0 * k + 5.0), weight, 1e-3 * weight) << "element " << k;
    }
    EXPECT_DOUBLE_EQ(w.tension(h.wire, 50.0), w.tension(h.wire, 45.0));
    EXPECT_THROW((void)w.tension(h.wire, 50.1), DefError);
    EXPECT_THROW((void)w.tension(h.wire, std::nan("")), DefError);
}

TEST(Wires, PartWhereTheyAreTold) {
    Hanging h;
    World& w = h.w;
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    (void)w.take_events();
    const double before = w.tension(h.wire, 25.0);
    w.part(h.wire, 25.0);
    w.part(h.wire, 25.0);  // nothing more
    const auto events = w.take_events();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::line_break);
    EXPECT_EQ(events[0].value, before);
    EXPECT_EQ(events[0].interaction, w.elements(h.wire)[2]);
    EXPECT_EQ(w.tension(h.wire, 25.0), 0.0);
    const double z = w.pose(w.nodes(h.wire)[5]).position.z();
    const double h_step = w.settings().step;
    for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    // The lower part falls freely, half a second.
    EXPECT_NEAR(w.pose(w.nodes(h.wire)[5]).position.z() - z, -0.5 * 9.81 * 0.25,
                9.81 * 0.5 * h_step);
    EXPECT_NEAR(w.tension(h.wire, 5.0), 9.81 * 4.0 * 20.0, 0.2 * 9.81 * 4.0 * 20.0);
    EXPECT_EQ(w.verdict().grade, Grade::good);
    EXPECT_THROW(w.part(InteractionId{99}), DefError);
}

/// Without a breaking load, too: its snapshots are states that a world can have.
TEST(Wires, PartedOnesAreSavedAndRestored) {
    Hanging h;
    for (int i = 0; i < 10; ++i) ASSERT_EQ(h.w.step(), Status::ok);
    h.w.part(h.wire, 25.0);
    ASSERT_EQ(h.w.step(), Status::ok);
    const auto saved = h.w.save();
    const std::uint64_t hash = h.w.state_hash();
    ASSERT_EQ(h.w.step(), Status::ok);
    h.w.restore(saved);
    EXPECT_EQ(h.w.state_hash(), hash);
    World twin = h.w.twin();
    EXPECT_EQ(twin.state_hash(), hash);
    EXPECT_FALSE(twin.intact(twin.elements(h.wire)[2]));
}

TEST(Wires, TakeTheirPiecesWithThem) {
    Hanging h;
    World& w = h.w;
    ASSERT_EQ(w.step(), Status::ok);
    const Removed& gone = w.remove_wire(h.wire);
    EXPECT_EQ(gone.bodies.size(), 5U);
    EXPECT_EQ(gone.interactions.size(), 5U);
    EXPECT_FALSE(w.alive(h.wire));
    EXPECT_EQ(w.bodies().size(), 1U);
    EXPECT_THROW((void)w.length(h.wire), DefError);
    WireDef def{.name = "wire", .from = h.top};
    def.elements = 2;
    def.length = 3.0;
    def.EA = 1e6;
    def.mass_per_length = 1.0;
    const WireId next = w.add_wire(def);
    EXPECT_EQ(next.index, h.wire.index);
    EXPECT_NE(next, h.wire);
    ASSERT_EQ(w.step(), Status::ok);
}

TEST(Wires, AreAddedWholeOrNotAtAll) {
    Hanging h;
    World& w = h.w;
    (void)w.add_body({.name = "second/2", .kind = BodyKind::fixed});  // takes the name of a node
    const std::size_t bodies = w.bodies().size(), interactions = w.interactions().size();
    WireDef def{.name = "second", .from = h.top};
    def.elements = 3;
    def.length = 3.0;
    def.EA = 1e6;
    def.mass_per_length = 1.0;
    EXPECT_THROW(w.add_wire(def), DefError);
    EXPECT_EQ(w.bodies().size(), bodies);
    EXPECT_EQ(w.interactions().size(), interactions);
    EXPECT_FALSE(w.find_wire("second").valid());
    EXPECT_FALSE(w.find_body("second/1").valid());
    def.name = "wire";
    EXPECT_THROW(w.add_wire(def), DefError) << "the name is taken";
    def.name = "third";
    def.mass_per_length = 0.0;
    EXPECT_THROW(w.add_wire(def), DefError);
    def.mass_per_length = 1.0;
    def.path = {Vec3::Zero()};
    EXPECT_THROW(w.add_wire(def), DefError);
    EXPECT_EQ(w.bodies().size(), bodies);
    ASSERT_EQ(w.step(), Status::ok);
}

TEST(Wires, AreAdoptedFromElementsEndToEnd) {
    Hanging h;
    World& w = h.w;
    const auto all = w.elements(h.wire);
    const std::vector<InteractionId> lower{all[2], all[3]};
    const WireId part = w.adopt_wire("lower", lower);
    EXPECT_DOUBLE_EQ(w.length(part), 20.0);
    EXPECT_EQ(w.nodes(part).front(), w.nodes(h.wire)[2]);
    const std::vector<InteractionId> apart{all[0], all[2]};
    EXPECT_THROW((void)w.adopt_wire("apart", apart), DefError);
    (void)w.remove_wire(part);
    EXPECT_EQ(w.elements(h.wire).size(), 5U) << "it did not own them";
    EXPECT_TRUE(w.alive(w.elements(h.wire)[2]));
    World twin = w.twin();
    EXPECT_EQ(twin.find_wire("wire"), h.wire);
}

}  // namespace
}  // namespace hawser::test
