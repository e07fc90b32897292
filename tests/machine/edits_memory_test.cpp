// SPDX-License-Identifier: Apache-2.0
/// Allocation fails during edits between steps: the world is unchanged, and the repeated call gives
/// the same bits.
#include "machine/retry.h"
#include "support/yard.h"

#include <string>

namespace hawser::test {
namespace {

constexpr const char* kLongName = "a wire with a name that is longer than a short string";

void expect_steps(Retry& retry, World& w, int count) {
    for (int i = 0; i < count; ++i) retry.call(w, "step", step_once, i > 0);
}

TEST(MemoryEnds, WhereThingsComeAndGo) {
    expect_same_bits("edits", [](Retry& retry) {
        WorldDef def;
        def.sleep_after = 0.5;
        Yard yard(def);
        const BodyId ground = yard.fixed();
        yard.plane(ground);
        std::vector<BodyId> boxes;
        for (int i = 0; i < 4; ++i)
            boxes.push_back(yard.box({1.5 * i, 0, 0.52}, 10.0, {.5, .5, .5}));
        World& w = yard.world;
        expect_steps(retry, w, 6);
        retry.call(w, "remove_body", throwing([&](World& to) { (void)to.remove_body(boxes[1]); }));
        WireDef wire{.name = kLongName, .from = boxes[0], .to = boxes[2]};
        wire.from_point = wire.to_point = {0, 0, 0.5};
        wire.elements = 5;
        wire.EA = 1e5;
        wire.mass_per_length = 1.0;
        wire.EI = 1.0;
        wire.radius = 0.02;
        retry.call(w, "add_wire", throwing([&](World& to) { (void)to.wires().add(wire); }));
        expect_steps(retry, w, 4);
        retry.call(w, "part",
                   throwing([](World& to) { to.wires().part(to.wires().find(kLongName), 1.0); }));
        const InputDef input{.name = "an input with a name that is longer than a short string",
                             .body = boxes[3]};
        retry.call(w, "add_input", throwing([&](World& to) { (void)to.add_input(input); }));
        const ShapeId shape = w.shapes().back();
        retry.call(w, "remove_shape", throwing([&](World& to) { (void)to.remove_shape(shape); }));
        expect_steps(retry, w, 3);
        retry.call(w, "remove_wire", throwing([](World& to) {
                       (void)to.wires().remove(to.wires().find(kLongName));
                   }));
        retry.call(w, "remove_input",
                   throwing([&](World& to) { (void)to.remove_input(to.find_input(input.name)); }));
        expect_steps(retry, w, 3);
        EXPECT_EQ(w.bodies().size(), 4U);
        EXPECT_TRUE(w.wires().ids().empty());
    });
}

TEST(MemoryEnds, WhereAWireIsWoundUp) {
    expect_same_bits("wind_up", [](Retry& retry) {
        Yard yard{WorldDef{}};
        World& w = yard.world;
        WireDef wire{.name = kLongName, .from = yard.fixed()};
        wire.length = 8.0;
        wire.elements = 4;
        wire.EA = 1e5;
        wire.mass_per_length = 1.0;
        const WireId id = w.wires().add(wire);
        const BodyId drum = w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 10.0});
        expect_steps(retry, w, 2);
        retry.call(w, "wind_up",
                   throwing([&](World& to) { (void)to.wires().spool(id, 0, drum, 0.3); }));
        const InteractionId first = w.wires().elements(id).front();
        EXPECT_EQ(w.find_interaction(std::string(kLongName) + "/s0"), first);
        EXPECT_EQ(w.interaction_def(first).kind, InteractionKind::WinchStretch);
        EXPECT_TRUE(w.intact(first));
        EXPECT_EQ(w.interactions().size(), 4U);
        expect_steps(retry, w, 3);
    });
}

}  // namespace
}  // namespace hawser::test
