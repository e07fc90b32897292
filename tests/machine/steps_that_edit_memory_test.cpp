// SPDX-License-Identifier: Apache-2.0
/// Allocation fails in steps whose systems insert and remove nodes of wires. The step fails as a
/// whole, and the next one gives the same bits.
#include "machine/retry.h"

#include <cstddef>

namespace hawser::test {
namespace {

/// Make a winch on a deck that pays out over a roller to a moving end: new nodes leave the drum and
/// run over the roller.
World winch_and_roller() {
    World w(WorldDef{.step = 0.05});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId end = w.add_body({.name = "end",
                                   .kind = BodyKind::kinematic,
                                   .position = {15.5, 0, -9},
                                   .velocity = {4, 0, -2}});
    WireDef def{.name = "tow", .from = deck, .from_point = {-12, 0, 0.5}, .to = end};
    def.path = {{-9, 0, 0.5}, {-6, 0, 0.5}, {-2.5, 0, 0.5}, {2, 0, -0.4}, {6, 0, -3}, {11, 0, -6}};
    def.elements = 7;
    def.EA = 1e7;
    def.mass_per_length = 20.0;
    def.consistent_mass = true;
    const WireId wire = w.wires().add(def);
    w.add(GuideDef{.name = "roller", .wire = wire, .body = deck, .radius = 0.5});
    w.add(WinchDef{.name = "winch",
                   .wire = wire,
                   .core_radius = 0.5,
                   .width = 1.0,
                   .flange_radius = 1.4,
                   .wire_diameter = 0.05,
                   .mass_per_length = 20.0,
                   .stored = 60.0,
                   .inertia = 60.0,
                   .torque_haul = 4e4,
                   .torque_pay = 4e4});
    w.set_system_signal("winch.mode", static_cast<double>(WinchMode::free));
    return w;
}

TEST(MemoryEnds, WhereSystemsPutAndTakeNodes) {
    int edits = 0;
    expect_same_bits("nodes", [&edits](Retry& retry) {
        World w = winch_and_roller();
        for (int i = 0; i < 30; ++i) {
            const std::size_t before = w.bodies().size();
            retry.call(w, "step", step_once, i > 0 && i % 8 == 0);
            edits += w.bodies().size() != before ? 1 : 0;
        }
    });
    EXPECT_GT(edits, 0) << "or no node has come";
}

}  // namespace
}  // namespace hawser::test
