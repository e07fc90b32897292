// SPDX-License-Identifier: Apache-2.0
/// Wires as objects of a world.
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
        wire = w.wires().add(def);
    }
};

TEST(Wires, HangByTheirWeight) {
    Hanging h;
    World& w = h.w;
    EXPECT_EQ(w.wires().find("wire"), h.wire);
    EXPECT_EQ(w.wires().nodes(h.wire).size(), 6U);
    EXPECT_EQ(w.wires().elements(h.wire).size(), 5U);
    EXPECT_DOUBLE_EQ(w.wires().length(h.wire), 50.0);
    double mass = 0.0;
    for (const BodyId b : w.bodies()) mass += b == h.top ? 0.0 : w.body_def(b).mass;
    EXPECT_DOUBLE_EQ(mass, 4.0 * 45.0) << "half an element hangs on the body at the top";
    for (int i = 0; i < 240; ++i) ASSERT_EQ(w.step(), Status::ok);
    // Nodes below the middle of element k: (4 - k) whole ones and a half.
    for (int k = 0; k < 5; ++k) {
        const double weight = 9.81 * 4.0 * 10.0 * (4.5 - k);
        EXPECT_NEAR(w.wires().tension(h.wire, 10.0 * k + 5.0), weight, 1e-3 * weight)
            << "element " << k;
    }
    EXPECT_DOUBLE_EQ(w.wires().tension(h.wire, 50.0), w.wires().tension(h.wire, 45.0));
    EXPECT_THROW((void)w.wires().tension(h.wire, 50.1), DefError);
    EXPECT_THROW((void)w.wires().tension(h.wire, std::nan("")), DefError);
}

WireDef of_wire_and_chain(BodyId top) {
    WireDef def{.name = "line", .from = top};
    def.sections = {{.elements = 4, .length = 40.0, .EA = 1e8, .mass_per_length = 4.0, .EI = 900.0},
                    {.elements = 3,
                     .length = 12.0,
                     .EA = 5e8,
                     .mass_per_length = 60.0,
                     .EI = 300.0,
                     .breaking_load = 1e6,
                     .drag = 2.0}};
    return def;
}

TEST(Wires, OfSectionsHangByTheWeightOfEach) {
    World w;
    const BodyId top = w.add_body({.name = "top", .kind = BodyKind::fixed});
    const WireId line = w.wires().add(of_wire_and_chain(top));
    EXPECT_EQ(w.wires().elements(line).size(), 7U);
    EXPECT_DOUBLE_EQ(w.wires().length(line), 52.0);
    double mass = 0.0;
    for (const BodyId b : w.bodies()) mass += b == top ? 0.0 : w.body_def(b).mass;
    EXPECT_NEAR(mass, 4.0 * 35.0 + 60.0 * 12.0, 1e-9) << "half an element hangs on the top";
    const auto lump = [&](std::size_t i) { return w.body_def(w.wires().nodes(line)[i]); };
    EXPECT_DOUBLE_EQ(lump(3).mass, 40.0);
    EXPECT_DOUBLE_EQ(lump(4).mass, 0.5 * 40.0 + 0.5 * 240.0) << "where the line types meet";
    EXPECT_DOUBLE_EQ(lump(4).linear_damping.x(), 0.5 * 8.0);
    EXPECT_DOUBLE_EQ(lump(7).mass, 120.0);
    EXPECT_NEAR((lump(4).position - w.body_def(top).position).norm(), 40.0, 1e-12);
    // A bend about this node: flexibilities in series, 5 m of 900 and 2 m of 300 N m².
    const InteractionDef bend = w.interaction_def(w.find_interaction("line/b4"));
    EXPECT_DOUBLE_EQ(bend.get("length"), 7.0);
    EXPECT_NEAR(bend.get("EI"), 7.0 / (5.0 / 900.0 + 2.0 / 300.0), 1e-9);
    EXPECT_NE(w.interaction_def(w.wires().elements(line)[3]).get("breaking_load"), 1e6);
    EXPECT_EQ(w.interaction_def(w.wires().elements(line)[4]).get("breaking_load"), 1e6);
    for (int i = 0; i < 240; ++i) ASSERT_EQ(w.step(), Status::ok);
    const double chain = 9.81 * 60.0 * 12.0;
    EXPECT_NEAR(w.wires().tension(line, 5.0), chain + 9.81 * 4.0 * 35.0, 1e-3 * chain);
    EXPECT_NEAR(w.wires().tension(line, 42.0), 9.81 * 60.0 * 10.0, 1e-3 * chain);
}

TEST(Wires, OfOneSectionIsTheWireWithoutIt) {
    std::uint64_t hash[2]{};
    for (const bool section : {false, true}) {
        World w;
        const BodyId top = w.add_body({.name = "top", .kind = BodyKind::fixed});
        const BodyId end =
            w.add_body({.name = "end", .kind = BodyKind::fixed, .position = {30.0, 0.0, 0.0}});
        WireDef def{.name = "line", .from = top, .to = end};
        def.consistent_mass = true;
        const WireSection same{.elements = 8,
                               .length = 33.0,
                               .EA = 1e7,
                               .mass_per_length = 3.0,
                               .EI = 50.0,
                               .axial_damping = 0.2,
                               .drag = 1.0};
        if (section) {
            def.sections = {same};
        } else {
            def.elements = same.elements;
            def.length = same.length;
            def.EA = same.EA;
            def.mass_per_length = same.mass_per_length;
            def.EI = same.EI;
            def.axial_damping = same.axial_damping;
            def.drag = same.drag;
        }
        (void)w.wires().add(def);
        for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
        hash[section ? 1 : 0] = w.state().hash();
    }
    EXPECT_EQ(hash[0], hash[1]);
}

TEST(Wires, OfSectionsThatAreNotWholeAreRefused) {
    World w;
    const BodyId top = w.add_body({.name = "top", .kind = BodyKind::fixed});
    const WireDef good = of_wire_and_chain(top);
    const auto refused = [&](auto&& change) {
        WireDef def = good;
        change(def);
        const std::size_t before = w.bodies().size();
        EXPECT_THROW((void)w.wires().add(def), DefError);
        EXPECT_EQ(w.bodies().size(), before);
    };
    refused([](WireDef& d) { d.sections[1].length = kDefault; });
    refused([](WireDef& d) { d.sections[1].length = 0.0; });
    refused([](WireDef& d) { d.sections[0].elements = 0; });
    refused([](WireDef& d) { d.sections[0].EA = kDefault; });
    refused([](WireDef& d) { d.sections[1].mass_per_length = 0.0; });
    refused([](WireDef& d) { d.sections[1].EI = -1.0; });
    refused([](WireDef& d) { d.sections[0].elements = d.sections[1].elements = 60'000; });
    refused([](WireDef& d) { d.length = 52.0; });
    refused([](WireDef& d) { d.breaking_load = 1e6; });
    refused([](WireDef& d) { d.axial_damping = 0.1; });
    refused([](WireDef& d) { d.drag = 2.0; });
    refused([](WireDef& d) { d.path = {Vec3::Zero()}; });
    EXPECT_TRUE(w.wires().add(good).valid());
}

TEST(Wires, PartWhereTheyAreTold) {
    Hanging h;
    World& w = h.w;
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    (void)w.events().take();
    const double before = w.wires().tension(h.wire, 25.0);
    w.wires().part(h.wire, 25.0);
    w.wires().part(h.wire, 25.0);  // no further effect
    const auto events = w.events().take();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::line_break);
    EXPECT_EQ(events[0].value, before);
    EXPECT_EQ(events[0].interaction, w.wires().elements(h.wire)[2]);
    EXPECT_EQ(w.wires().tension(h.wire, 25.0), 0.0);
    const double z = w.pose(w.wires().nodes(h.wire)[5]).position.z();
    const double h_step = w.settings().step;
    for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    // The lower part falls freely for half a second.
    EXPECT_NEAR(w.pose(w.wires().nodes(h.wire)[5]).position.z() - z, -0.5 * 9.81 * 0.25,
                9.81 * 0.5 * h_step);
    EXPECT_NEAR(w.wires().tension(h.wire, 5.0), 9.81 * 4.0 * 20.0, 0.2 * 9.81 * 4.0 * 20.0);
    EXPECT_EQ(w.verdict().grade, Grade::good);
    EXPECT_THROW(w.wires().part(InteractionId{99}), DefError);
}

/// Also without a breaking load: snapshots are states that a world can have.
TEST(Wires, PartedOnesAreSavedAndRestored) {
    Hanging h;
    for (int i = 0; i < 10; ++i) ASSERT_EQ(h.w.step(), Status::ok);
    h.w.wires().part(h.wire, 25.0);
    ASSERT_EQ(h.w.step(), Status::ok);
    const auto saved = h.w.state().save();
    const std::uint64_t hash = h.w.state().hash();
    ASSERT_EQ(h.w.step(), Status::ok);
    h.w.state().restore(saved);
    EXPECT_EQ(h.w.state().hash(), hash);
    World twin = h.w.twin();
    EXPECT_EQ(twin.state().hash(), hash);
    EXPECT_FALSE(twin.intact(twin.wires().elements(h.wire)[2]));
}

TEST(Wires, TakeTheirPiecesWithThem) {
    Hanging h;
    World& w = h.w;
    ASSERT_EQ(w.step(), Status::ok);
    const Removed& gone = w.wires().remove(h.wire);
    EXPECT_EQ(gone.bodies.size(), 5U);
    EXPECT_EQ(gone.interactions.size(), 5U);
    EXPECT_FALSE(w.alive(h.wire));
    EXPECT_EQ(w.bodies().size(), 1U);
    EXPECT_THROW((void)w.wires().length(h.wire), DefError);
    WireDef def{.name = "wire", .from = h.top};
    def.elements = 2;
    def.length = 3.0;
    def.EA = 1e6;
    def.mass_per_length = 1.0;
    const WireId next = w.wires().add(def);
    EXPECT_EQ(next.index, h.wire.index);
    EXPECT_NE(next, h.wire);
    ASSERT_EQ(w.step(), Status::ok);
}

TEST(Wires, AreAddedWholeOrNotAtAll) {
    Hanging h;
    World& w = h.w;
    (void)w.add_body({.name = "second/2", .kind = BodyKind::fixed});  // uses the name of a node
    const std::size_t bodies = w.bodies().size(), interactions = w.interactions().size();
    WireDef def{.name = "second", .from = h.top};
    def.elements = 3;
    def.length = 3.0;
    def.EA = 1e6;
    def.mass_per_length = 1.0;
    EXPECT_THROW(w.wires().add(def), DefError);
    EXPECT_EQ(w.bodies().size(), bodies);
    EXPECT_EQ(w.interactions().size(), interactions);
    EXPECT_FALSE(w.wires().find("second").valid());
    EXPECT_FALSE(w.find_body("second/1").valid());
    def.name = "wire";
    EXPECT_THROW(w.wires().add(def), DefError) << "the name is in use";
    def.name = "third";
    def.mass_per_length = 0.0;
    EXPECT_THROW(w.wires().add(def), DefError);
    def.mass_per_length = 1.0;
    def.path = {Vec3::Zero()};
    EXPECT_THROW(w.wires().add(def), DefError);
    EXPECT_EQ(w.bodies().size(), bodies);
    ASSERT_EQ(w.step(), Status::ok);
}

TEST(Wires, AreAdoptedFromElementsEndToEnd) {
    Hanging h;
    World& w = h.w;
    const auto all = w.wires().elements(h.wire);
    const std::vector<InteractionId> lower{all[2], all[3]};
    const WireId part = w.wires().adopt("lower", lower);
    EXPECT_DOUBLE_EQ(w.wires().length(part), 20.0);
    EXPECT_EQ(w.wires().nodes(part).front(), w.wires().nodes(h.wire)[2]);
    const std::vector<InteractionId> separation{all[0], all[2]};
    EXPECT_THROW((void)w.wires().adopt("apart", separation), DefError);
    (void)w.wires().remove(part);
    EXPECT_EQ(w.wires().elements(h.wire).size(), 5U) << "it did not own them";
    EXPECT_TRUE(w.alive(w.wires().elements(h.wire)[2]));
    World twin = w.twin();
    EXPECT_EQ(twin.wires().find("wire"), h.wire);
}

}  // namespace
}  // namespace hawser::test
