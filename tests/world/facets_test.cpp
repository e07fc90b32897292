// SPDX-License-Identifier: Apache-2.0
/// Facets of a world, and the old names that call them.
#include <hawser/experimental/splits.h>
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

/// Two nodes of 100 kg held by a fixed body, with a wire of four elements from it.
struct Facets {
    World w{{.step = 0.01}};
    BodyId post = w.add_body({.name = "post", .kind = BodyKind::fixed});
    BodyId load = w.add_body(
        {.name = "load", .kind = BodyKind::lump, .position = {10.0, 0.0, 0.0}, .mass = 100.0});
    WireId wire = w.wires().add({.name = "wire",
                                 .from = post,
                                 .to = load,
                                 .elements = 4,
                                 .EA = 1e6,
                                 .mass_per_length = 1.0,
                                 .consistent_mass = true});
    void steps(int count) {
        for (int k = 0; k < count; ++k) ASSERT_EQ(w.step(), Status::ok);
    }
};

/// A facet is one pointer, and that of a const world does not edit.
TEST(Facets, AreOnePointerAndConstOnesOnlyRead) {
    static_assert(sizeof(WorldWires) == sizeof(void*) && sizeof(WorldState) == sizeof(void*) &&
                  sizeof(WorldEvents) == sizeof(void*) && sizeof(WorldSolver) == sizeof(void*) &&
                  sizeof(WorldSplits) == sizeof(void*));
    using Const = const World&;
    static_assert(std::is_same_v<decltype(std::declval<Const>().wires()), WorldWiresView> &&
                  std::is_same_v<decltype(std::declval<Const>().state()), WorldStateView> &&
                  std::is_same_v<decltype(std::declval<Const>().events()), WorldEventsView> &&
                  std::is_same_v<decltype(std::declval<Const>().solver()), WorldSolverView> &&
                  std::is_same_v<decltype(std::declval<Const>().splits()), WorldSplitsView>);
    Facets f;
    f.steps(3);
    const WorldWires copy = f.w.wires();
    EXPECT_EQ(copy.find("wire"), f.wire);
    EXPECT_EQ(copy.elements(f.wire).size(), 4U);
    EXPECT_NEAR(copy.length(f.wire), 10.0, 1e-12);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

TEST(Facets, OldNamesOfWiresCallTheNewOnes) {
    Facets f, g;
    const InteractionId second = f.w.wires().elements(f.wire)[1];
    EXPECT_EQ(f.w.find_wire("wire"), f.w.wires().find("wire"));
    EXPECT_EQ(f.w.wire_name(f.wire), "wire");
    EXPECT_EQ(f.w.wire_of(second), f.w.wires().of(second));
    EXPECT_EQ(f.w.nodes(f.wire).size(), 5U);
    EXPECT_EQ(f.w.elements(f.wire)[1], second);
    EXPECT_EQ(f.w.length(f.wire), f.w.wires().length(f.wire));
    EXPECT_EQ(f.w.ends(second), f.w.wires().ends(second));
    EXPECT_EQ(f.w.wrapped(second), f.w.wires().wrapped(second));
    // The same edits by old and new names give the same bits.
    EXPECT_EQ(f.w.insert_node(second, 0.5), g.w.wires().insert_node(second, 0.5));
    f.w.set_mass(f.load, 120.0);
    g.w.wires().set_mass(g.load, 120.0);
    f.steps(2);
    g.steps(2);
    EXPECT_EQ(f.w.tension(f.wire, 1.0), g.w.wires().tension(g.wire, 1.0));
    EXPECT_EQ(f.w.cut(f.wire, 5.0), g.w.wires().cut(g.wire, 5.0));
    EXPECT_EQ(
        f.w.attach(f.wire, 1, f.post, Vec3::Zero(), {.gear = Gear::shackle, .reach = 9.0}).held[0],
        g.w.wires()
            .attach(g.wire, 1, g.post, Vec3::Zero(), {.gear = Gear::shackle, .reach = 9.0})
            .held[0]);
    f.w.part(f.wire, 1.0);
    g.w.wires().part(g.wire, 1.0);
    f.steps(2);
    g.steps(2);
    EXPECT_EQ(f.w.state_hash(), g.w.state().hash());
    EXPECT_EQ(f.w.remove_wire(f.wire).interactions, g.w.wires().remove(g.wire).interactions);
    EXPECT_FALSE(f.w.alive(f.wire));
}

TEST(Facets, TheListOfWiresIsStillARange) {
    Facets f;
    EXPECT_EQ(f.w.wires().size(), 1U);
    EXPECT_FALSE(f.w.wires().empty());
    EXPECT_EQ(f.w.wires()[0], f.wire);
    EXPECT_EQ(f.w.wires().front(), f.wire);
    EXPECT_EQ(f.w.wires().back(), f.wire);
    const std::span<const WireId> list = f.w.wires();
    EXPECT_EQ(list.size(), 1U);
    int count = 0;
    for (const WireId id : f.w.wires()) count += id == f.wire ? 1 : 0;
    EXPECT_EQ(count, 1);
}

TEST(Facets, OldNamesOfStateAndEventsCallTheNewOnes) {
    Facets f;
    f.steps(3);
    EXPECT_EQ(f.w.save(), f.w.state().save());
    EXPECT_EQ(f.w.save_motion(), f.w.state().save_motion());
    EXPECT_EQ(f.w.identity(), f.w.state().identity());
    EXPECT_EQ(f.w.motion_hash(), f.w.state().motion_hash());
    const StateView arrays = f.w.state();
    EXPECT_EQ(arrays.positions.data(), f.w.state().arrays().positions.data());
    const std::vector<std::byte> start = f.w.save();
    const Structure made_of = f.w.structure();
    f.steps(3);
    const std::uint64_t after = f.w.state().hash();
    f.w.restore(start);
    f.steps(3);
    EXPECT_EQ(f.w.state().hash(), after);
    f.w.restore(made_of, start);
    f.steps(3);
    EXPECT_EQ(f.w.state().hash(), after);
    Facets other;
    other.w.copy_state(f.w);
    EXPECT_EQ(other.w.state().hash(), after);
    f.w.part(f.wire, 1.0);
    EXPECT_EQ(f.w.event_extremes(EventKind::line_break).count,
              f.w.events().extremes(EventKind::line_break).count);
    EXPECT_GT(f.w.event_extremes(EventKind::line_break).count, 0);
    std::uint64_t cursor = 0, end = f.w.event_cursor();
    std::vector<Event> out;
    EXPECT_EQ(f.w.events_since(cursor, out), 0U);
    EXPECT_EQ(cursor, end);
    EXPECT_EQ(f.w.take_events().size(), out.size());
}

TEST(Facets, OldNamesOfSolverAndSplitsCallTheNewOnes) {
    Facets f;
    f.steps(3);
    const InteractionId first = f.w.wires().elements(f.wire)[0];
    EXPECT_EQ(f.w.inspect().factor_nnz, f.w.solver().matrix().factor_nnz);
    EXPECT_EQ(f.w.rows(first).violation, f.w.solver().rows(first).violation);
    EXPECT_EQ(f.w.completed(first), f.w.solver().completed(first));
    EXPECT_EQ(f.w.stiffness_force(first), f.w.solver().stiffness_force(first));
    EXPECT_EQ(f.w.coarsening(), f.w.solver().coarsening());
    EXPECT_EQ(f.w.memory_bytes(), f.w.solver().memory_bytes());
    EXPECT_EQ(f.w.wire_alert(first), f.w.wires().damped_steps(first));
    f.w.start_trace(1000);
    f.steps(1);
    EXPECT_EQ(f.w.trace().steps, 1);
    f.w.set_group(f.load, "a");
    EXPECT_EQ(f.w.body_def(f.load).group, "a");
    EXPECT_EQ(f.w.groups(), f.w.splits().groups());
    EXPECT_EQ(f.w.coupling(first), f.w.splits().coupling(first));
    EXPECT_EQ(f.w.cuts().size(), f.w.splits().cuts().size());
    EXPECT_EQ(f.w.partition({.parts = 2}).part_of_body,
              f.w.splits().partition({.parts = 2}).part_of_body);
}

#pragma GCC diagnostic pop

}  // namespace
}  // namespace hawser::test
