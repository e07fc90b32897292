// SPDX-License-Identifier: Apache-2.0
/// Edits allocate nothing once memory is large enough for them.
#include "stepper/allocation_counter.h"
#include "stepper/scenes.h"
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

struct Edit {
    const char* name;
    std::function<void()> make;
};

/// Objects added to and removed from a world with two rigid bodies. Names are short: memory of
/// longer ones belongs to the caller.
class Coming {
  public:
    explicit Coming(World& w) : w_(w) {
        for (const BodyId b : w.bodies())
            if (w.body_def(b).kind == BodyKind::rigid) hulls_.push_back(b);
        wire_.name = "w";
        wire_.from = hulls_.at(0);
        wire_.length = 30.0;
        wire_.EA = 1e6;
        wire_.EI = 10.0;
        wire_.radius = 0.05;
        wire_.mass_per_length = 20.0;
        push_.name = "push";
        push_.body = hulls_.at(0);
        push_.min = -10.0;
        push_.max = 10.0;
        reel_ = {.name = "reel", .param = "length", .min = 1.0, .max = 1000.0};
    }

    [[nodiscard]] std::vector<Edit> edits() {
        return {
            {"a lump and a line added", [this] { add_lump(); }},
            {"a lump removed", [this] { (void)w_.remove_body(lump_); }},
            {"a line added", [this] { line_ = w_.add_interaction(line(hulls_[0], hulls_[1])); }},
            {"an input added", [this] { add_reel(); }},
            {"an input set", [this] { w_.set_input(set_, 1.5 * w_.input(set_)); }},
            {"a line removed", [this] { (void)w_.remove_interaction(line_); }},
            {"a force added", [this] { set_ = w_.add_input(push_); }},
            {"a force set", [this] { w_.set_input(set_, 5.0); }},
            {"a force removed", [this] { (void)w_.remove_input(set_); }},
            {"a shape added", [this] { add_shape(); }},
            {"a shape removed", [this] { (void)w_.remove_shape(shape_); }},
            {"a wire added", [this] { id_ = w_.wires().add(wire_); }},
            {"a wire parted", [this] { w_.wires().part(id_, 12.0); }},
            {"a wire removed", [this] { (void)w_.wires().remove(id_); }}};
    }

  private:
    [[nodiscard]] InteractionDef line(BodyId a, BodyId b) const {
        InteractionDef d{.kind = InteractionKind::Stretch, .body = {a, b}};
        const double separation = (w_.pose(a).position - w_.pose(b).position).norm();
        return d.set("EA", 1e5).set("length", 1.01 * separation);
    }
    void add_lump() {
        lump_ = w_.add_body({.name = "l",
                             .kind = BodyKind::lump,
                             .position = w_.pose(hulls_[0]).position - Vec3(0, 0, 15),
                             .mass = 100.0});
        (void)w_.add_interaction(line(hulls_[0], lump_));
    }
    void add_reel() {
        reel_.interaction = line_;
        set_ = w_.add_input(reel_);
    }
    void add_shape() {
        shape_ = w_.add_shape(
            {.name = "s", .kind = ShapeKind::sphere, .body = hulls_[0], .radius = 0.5});
    }

    World& w_;
    std::vector<BodyId> hulls_;
    WireDef wire_;
    InputDef push_, reel_;
    BodyId lump_{};
    InteractionId line_{};
    InputId set_{};
    ShapeId shape_{};
    WireId id_{};
};

/// Expect no allocations. @param max_grown  Number of steps that may grow because of more contacts
/// than ever before.
void expect_none(World& w, int warm, int rounds, int max_grown) {
    Coming coming(w);
    const std::vector<Edit> edits = coming.edits();
    int grown = 0;
    std::int64_t planned = 0;
    for (int round = 0; round < warm + rounds; ++round)
        for (const Edit& edit : edits) {
            const std::int64_t growths = w.stats().growths, plans = w.stats().plans;
            const std::size_t held = w.solver().memory_bytes();
            long in_edit = 0, seen = 0;
            Status status = Status::ok;
            {
                const AllocationGuard guard;
                edit.make();
                in_edit = AllocationGuard::seen();
                status = w.step();
                seen = AllocationGuard::seen();
            }
            ASSERT_EQ(status, Status::ok) << edit.name;
            if (round < warm) continue;
            planned += w.stats().plans - plans;
            if (w.stats().growths != growths) {
                ++grown;
                continue;
            }
            EXPECT_EQ(in_edit, 0) << edit.name << ", round " << round;
            EXPECT_EQ(seen - in_edit, 0) << "in the step after: " << edit.name << ", " << round;
            EXPECT_EQ(w.solver().memory_bytes(), held) << edit.name;
        }
    EXPECT_LE(grown, max_grown);
    // A wire is more than an eighth of a small world.
    if (w.body_count() > 1000) {
        EXPECT_EQ(planned, 0);
    }
}

/// Make two hulls on a floor, rigid links and a wire between them, and a wire that lies.
World small_yard(int threads) {
    WorldDef def;
    def.threads = threads;
    World w(def);
    const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    w.add_shape({.kind = ShapeKind::plane, .body = ground});
    BodyId hull[2];
    for (int i = 0; i < 2; ++i) {
        hull[i] = w.add_body({.name = i == 0 ? "" : "hull",
                              .kind = BodyKind::rigid,
                              .position = {40.0 * i, 0.0, 1.0},
                              .mass = 1e4,
                              .inertia = 1e4 * Mat3::Identity()});
        w.add_shape({.kind = ShapeKind::box, .body = hull[i], .half_size = {2.0, 1.0, 1.0}});
    }
    WireDef wire{.name = "between", .from = hull[0], .to = hull[1], .elements = 20};
    wire.EA = 1e6;
    wire.mass_per_length = 10.0;
    wire.radius = 0.05;
    wire.length = 41.0;
    w.wires().add(wire);
    BodyId last = hull[0];
    for (int i = 0; i < 10; ++i) {
        const Vec3 x(-3.0 - i, 0.0, 1.0);
        const BodyId now = w.add_body({.kind = BodyKind::rigid,
                                       .position = x,
                                       .mass = 50.0,
                                       .inertia = 10.0 * Mat3::Identity()});
        InteractionDef joint = between(InteractionKind::Ball, {last, now});
        joint.point[0] = x + Vec3(0.5, 0, 0) - w.pose(last).position;
        joint.point[1] = {0.5, 0.0, 0.0};
        w.add_interaction(joint);
        w.add_shape({.kind = ShapeKind::sphere, .body = now, .radius = 0.3});
        last = now;
    }
    const BodyId bare = w.add_body({.name = "bare",
                                    .kind = BodyKind::rigid,
                                    .position = {40.0, 0.0, 4.0},
                                    .mass = 50.0,
                                    .inertia = 10.0 * Mat3::Identity()});
    InteractionDef joint = between(InteractionKind::Ball, {hull[1], bare});
    joint.point[0] = {0.0, 0.0, 3.0};
    w.add_interaction(joint);
    return w;
}

TEST(EditAllocation, NoneOnceWarm) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    for (const int threads : {1, 2}) {
        SCOPED_TRACE(threads);
        World w = small_yard(threads);
        for (int i = 0; i < 200; ++i) ASSERT_EQ(w.step(), Status::ok);
        expect_none(w, 6, 4, 2);
    }
}

TEST(EditAllocation, NoneOnceWarmInACommittedScene) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    for (const int threads : {1, 2}) {
        SCOPED_TRACE(threads);
        scene::Options options;
        options.threads = threads;
        scene::Scene s = scene::load_file("scenes/anchor_contact.json", options);
        for (int i = 0; i < 5; ++i) ASSERT_EQ(s.world.step(), Status::ok);
        expect_none(s.world, 6, 3, 4);
    }
}

/// A wire with a load gets nodes and loses them again, like by a winch or a resolution.
TEST(EditAllocation, NoneWhereNodesComeAndGo) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    for (const int threads : {1, 2}) {
        SCOPED_TRACE(threads);
        World w({.step = 0.01, .threads = threads});
        const BodyId top = w.add_body(
            {.name = "top of a crane", .kind = BodyKind::fixed, .position = {0, 0, 100}});
        const BodyId load = w.add_body(
            {.name = "a load that hangs", .mass = 1000.0, .inertia = 1000.0 * Mat3::Identity()});
        const WireId wire = w.wires().add({.name = "a wire of a long name",
                                           .from = top,
                                           .to = load,
                                           .elements = 40,
                                           .length = 100.0,
                                           .EA = 1e7,
                                           .mass_per_length = 5.0,
                                           .EI = 50.0,
                                           .drag = 20.0,
                                           .radius = 0.0,
                                           .consistent_mass = true});
        for (int i = 0; i < 300; ++i) ASSERT_EQ(w.step(), Status::ok);  // until it hangs still
        // Slots of removed objects are reused after some time: this number of rounds is warm.
        constexpr int kWarm = 14, kRounds = 10, kNodes = 5;
        BodyId put[kNodes];
        int grown = 0, edits = 0;
        std::int64_t planned = 0;
        for (int round = 0; round < kWarm + kRounds; ++round)
            for (int k = 0; k < 2 * kNodes; ++k) {
                const std::int64_t growths = w.stats().growths, plans = w.stats().plans;
                const InteractionId element =
                    w.wires().elements(wire)[static_cast<std::size_t>(2 + 3 * (k % kNodes))];
                long in_edit = 0, seen = 0;
                Status status = Status::ok;
                {
                    const AllocationGuard guard;
                    if (k < kNodes)
                        put[k] = w.wires().insert_node(element, 0.5);
                    else
                        ASSERT_TRUE(w.wires().remove_node(put[k - kNodes], 3.0));
                    in_edit = AllocationGuard::seen();
                    status = w.step();
                    seen = AllocationGuard::seen();
                }
                ASSERT_EQ(status, Status::ok);
                if (round < kWarm) continue;
                ++edits;
                planned += w.stats().plans - plans;
                EXPECT_EQ(in_edit, 0) << "edit " << k << " of round " << round;
                if (w.stats().growths != growths)
                    ++grown;
                else
                    EXPECT_EQ(seen, in_edit) << "step after " << k << " of round " << round;
            }
        EXPECT_EQ(planned, 0);
        EXPECT_LE(grown, edits / 20) << "of " << edits << " edits";
    }
}

/// Adding and removing shapes does not change the system, whether its body has other shapes or not.
/// A step gives the bits of a restored world, which repeats the last analysis.
TEST(EditAllocation, ShapesAloneAnalyseNothing) {
    World w = small_yard(1);
    const BodyId bodies[2] = {w.find_body("hull"), w.find_body("bare")};
    ShapeId shape[2];
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    const auto count = [&] { return w.stats().repairs + w.stats().plans; };
    const auto before = count();
    for (int i = 0; i < 120; ++i) {
        const int k = i % 2;
        if (i / 2 % 2 == 0)
            shape[k] = w.add_shape({.kind = ShapeKind::sphere,
                                    .body = bodies[k],
                                    .position = {1.9, 0.9, -0.9},
                                    .radius = 0.3});
        else
            (void)w.remove_shape(shape[k]);
        World again = small_yard(1);
        again.state().restore(w.state().structure(), w.state().save());
        for (int step = 0; step < 2; ++step) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(again.step(), Status::ok);
            ASSERT_EQ(again.state().hash(), w.state().hash()) << i << ", " << step;
        }
    }
    // If two bodies touch for the first time, links are repaired.
    EXPECT_LE(count(), before + 10);
}

}  // namespace
}  // namespace hawser::test
