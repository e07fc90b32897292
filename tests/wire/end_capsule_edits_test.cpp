// SPDX-License-Identifier: Apache-2.0
/// Capsules of wires that extend to the attachments, while elements are inserted, removed and
/// exchanged at drums, guides and ends; bits.
#include <hawser/hawser.h>

#include "support/bits.h"
#include "wire/capsule_wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::test {
namespace {

/// Expect that the segments of a wire are those of its elements with a node, each once, at their
/// attachments.
void expect_capsules(const World& w, WireId wire, const std::string& what) {
    std::size_t wanted = 0;
    for (const InteractionId id : w.wires().elements(wire)) {
        const InteractionDef& d = w.interaction_def(id);
        if (!w.intact(id)) continue;
        const bool lump[2] = {w.body_def(d.body[0]).kind == BodyKind::lump,
                              w.body_def(d.body[1]).kind == BodyKind::lump};
        int found = 0;
        for (const ShapeId s : w.shapes()) {
            const ShapeDef& shape = w.shape_def(s);
            if (shape.body != d.body[0] || shape.body_b != d.body[1]) continue;
            ++found;
            if (lump[0] && lump[1]) {
                EXPECT_TRUE(shape.position.isZero(0.0)) << what;
            }
        }
        const int expected = lump[0] || lump[1] ? 1 : 0;
        EXPECT_EQ(found, expected) << what << ": " << d.name;
        wanted += lump[0] || lump[1] ? 1U : 0U;
    }
    std::size_t there = 0;
    const auto nodes = w.wires().nodes(wire);
    for (const ShapeId s : w.shapes()) {
        const ShapeDef& shape = w.shape_def(s);
        if (!shape.body_b.valid()) continue;
        const BodyId lump =
            w.body_def(shape.body).kind == BodyKind::lump ? shape.body : shape.body_b;
        there += std::find(nodes.begin(), nodes.end(), lump) != nodes.end() ? 1U : 0U;
    }
    EXPECT_EQ(there, wanted) << what;
}

/// A wire from a winch on a ship over a stern roller to an anchor, and one across it.
struct Stern {
    World w;
    BodyId ship{}, anchor{};
    WireId wire{}, across{};

    explicit Stern(int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads, .contact_margin = 0.1}) {
        ship = w.add_body({.name = "ship",
                           .kind = BodyKind::kinematic,
                           .position = {0, 0, 0},
                           .half_size = {20, 5, 2}});
        anchor = w.add_body({.name = "anchor",
                             .position = {30, 0, -9.2},
                             .mass = 6e3,
                             .inertia = Mat3::Identity() * 6e3,
                             .angular_damping = Vec3::Constant(2e4)});
        WireDef def = capsule_wire("wire");
        def.from = ship;
        def.from_point = {0, 0, 1};
        def.to = anchor;
        def.to_point = {0, 0, 1.2};
        def.path = {{5, 0, 1}, {10, 0, 1}, {15, 0, 1}, {20, 0, 1}, {25, 0, 1}, {30, 0, -3}};
        def.elements = 7;
        def.length = 37.0;
        def.drag = 100.0;
        wire = w.wires().add(def);
        w.add(GuideDef{.name = "roller",
                       .wire = wire,
                       .body = ship,
                       .point = {27, 0, 0.5},
                       .axis = {0, 1, 0},
                       .radius = 0.5,
                       .friction = 0.2});
        w.add(WinchDef{.name = "winch",
                       .wire = wire,
                       .core_radius = 0.6,
                       .width = 2.4,
                       .flange_radius = 1.4,
                       .wire_diameter = 0.076,
                       .mass_per_length = kCapsuleMass,
                       .stored = 500.0,
                       .inertia = 4e4,
                       .mode = WinchMode::speed});
        WireDef other = def;
        other.name = "across";
        other.from =
            w.add_body({.name = "p", .kind = BodyKind::kinematic, .position = {2, -6, 1.3}});
        other.to = w.add_body({.name = "q", .kind = BodyKind::kinematic, .position = {2, 6, 1.3}});
        other.from_point = {0.1, 0, 0};
        other.to_point = {0.1, 0, 0};
        other.path.clear();
        other.elements = 4;
        other.length = 12.3;
        across = w.wires().add(other);
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i)
            ASSERT_EQ(w.step(), Status::ok) << w.time() << " " << to_string(w.bad_load(), w);
    }
};

TEST(EndCapsuleEdits, FollowElementsAtDrumsAndGuides) {
    Stern d;
    expect_capsules(d.w, d.wire, "at the start");
    for (const double speed : {1.0, -1.0}) {
        const std::size_t had = d.w.wires().elements(d.wire).size();
        d.w.set_system_signal("winch.speed", speed);
        bool changed = false;
        for (int i = 0; i < 12; ++i) {
            d.run(60);
            expect_capsules(d.w, d.wire, "at " + std::to_string(d.w.time()) + " s");
            changed = changed || d.w.wires().elements(d.wire).size() != had;
        }
        EXPECT_TRUE(changed) << "elements came or went";
    }
    // The wire across the element at the drum presses on it.
    double force = 0.0;
    for (const ContactView& c : d.w.contacts())
        for (const ShapeId s : c.shape)
            if (d.w.shape_def(s).body == d.ship) force += c.force.norm();
    EXPECT_GT(force, 100.0) << "its weight is 2.7 kN";
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

TEST(EndCapsuleEdits, FollowWhatIsCutJoinedHeldAndLetGo) {
    Stern d;
    d.run(30);
    (void)d.w.wires().insert_node(d.w.wires().elements(d.across).front(), 0.4);
    expect_capsules(d.w, d.across, "a node on the first element");
    const BodyId last = d.w.wires().insert_node(d.w.wires().elements(d.across).back(), 0.6);
    expect_capsules(d.w, d.across, "a node on the last element");
    EXPECT_TRUE(d.w.wires().remove_node(last, 3.2));
    expect_capsules(d.w, d.across, "taken away again");
    d.run(10);
    d.w.wires().detach(d.across, 1);
    expect_capsules(d.w, d.across, "let go");
    d.run(10);
    (void)d.w.wires().attach(d.across, 1, d.w.find_body("q"), {0, 0, 0}, {.reach = 5.0});
    expect_capsules(d.w, d.across, "held");
    d.run(10);
    const WireId piece = d.w.wires().cut(d.across, 4.0);
    expect_capsules(d.w, d.across, "cut");
    expect_capsules(d.w, piece, "the other piece");
    (void)d.w.wires().join(d.across, 1, piece, 0, {.reach = 5.0});
    expect_capsules(d.w, d.across, "spliced");
    d.run(10);
    // Join two first or two last ends: one wire is reversed.
    const WireId other = d.w.wires().cut(d.across, 5.0);
    (void)d.w.wires().detach(other, 1);
    (void)d.w.wires().join(d.across, 1, other, 1, {.reach = 50.0});
    expect_capsules(d.w, d.across, "turned round");
    d.w.wires().detach(d.wire, 0);
    expect_capsules(d.w, d.wire, "off its drum");
    d.run(10);
    d.w.wires().remove(d.wire);
    for (const ShapeId s : d.w.shapes()) {
        const ShapeDef& shape = d.w.shape_def(s);
        EXPECT_TRUE(shape.body != d.ship && shape.body_b != d.ship && shape.body_b != d.anchor);
    }
}

TEST(EndCapsuleEdits, RepeatBitForBit) {
    const auto drive = [](Stern& d, int i) {
        if (i == 20) d.w.set_system_signal("winch.speed", 1.0);
        if (i == 300) d.w.set_system_signal("winch.speed", -1.0);
    };
    expect_same_bits(
        {.steps = 500, .restored = {1, 60, 260, 420}}, [](int threads) { return Stern(threads); },
        drive, [](const Stern& d) { EXPECT_NE(d.w.verdict().grade, Grade::wrong); });
}

}  // namespace
}  // namespace hawser::test
