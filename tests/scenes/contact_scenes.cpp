// SPDX-License-Identifier: Apache-2.0
// Scenes of contact with known results: bodies that stand, stay or drag. Those with closed forms of
// a motion are cases of `hawser validate`.

#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace hawser {
namespace {

/// Guarantee of the solver for every step (WorldDef::contact_tolerance).
constexpr double kCertified = 1e-6;

struct Watched {
    scene::Scene scene;
    double worst_map = 0.0, violation = 0.0;
    int contacts_min = 1 << 30, contacts_max = 0;

    explicit Watched(const std::string& name)
        : scene(scene::load_file("scenes/" + name + ".json")) {}

    World& world() { return scene.world; }
    Vec3 position(const std::string& name) {
        return world().pose(world().find_body(name)).position;
    }
    /// Run to a time. @return false if a step fails.
    bool to(double time) {
        while (world().time() < time - 1e-9) {
            if (world().step() != Status::ok) return false;
            const StepStats& stats = world().stats();
            worst_map = std::max(worst_map, stats.natural_map);
            violation = std::max(violation, stats.violation_max);
            contacts_min = std::min(contacts_min, stats.contacts);
            contacts_max = std::max(contacts_max, stats.contacts);
        }
        return true;
    }
};

TEST(ContactScenes, ArchStands) {
    Watched run("arch");
    const Vec3 crown = run.position("stone6");
    ASSERT_TRUE(run.to(3.0));
    // A thrust of about 50 kN compresses each of 14 joints of 4e9 N/m by 1e-5 m; the crown sinks by
    // a few times their sum. A mechanism would move it by metres.
    EXPECT_LT((run.position("stone6") - crown).norm(), 2e-3);
    const Vec3 settled = run.position("stone6");
    ASSERT_TRUE(run.to(5.0));
    EXPECT_LT((run.position("stone6") - settled).norm(), 1e-9);  // At rest: nothing creeps.
    EXPECT_LE(run.worst_map, kCertified);
}

/// The wall with contacts up to a hundred times as stiff, pushed from the first step on, before
/// there are earlier impulses.
TEST(ContactScenes, StiffContactsStartCold) {
    for (const char* stiffness : {"1e9", "1e10"}) {
        scene::Options options;
        options.set = {std::string("material_pairs.0.stiffness=") + stiffness,
                       "material_pairs.0.tangential=5"};
        World world = scene::load_file("scenes/wall_648.json", options).world;
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(world.step(), Status::ok);
            EXPECT_LE(world.stats().natural_map, kCertified) << stiffness << ", step " << k;
            EXPECT_EQ(world.stats().flips_left, 0);
        }
    }
}

/// Pivoting factors only the blocks that its contacts changed. (Newton's method does so if few of
/// many contacts change, tests/world/block_test.cpp. On this wall the changes of an iteration take
/// four fifths of the work at the median, and the whole is factored.)
TEST(ContactScenes, PivotingOnTheWallFactorsWhatChanged) {
    scene::Options options;
    options.set = {"settings.nonsmooth=pivoting"};
    World world = scene::load_file("scenes/wall_648.json", options).world;
    std::int64_t all = 0, partial = 0;
    for (int k = 0; k < 20; ++k) {
        ASSERT_EQ(world.step(), Status::ok);
        const StepStats& stats = world.stats();
        all += stats.factorisations;
        partial += stats.partial_factorisations;
        ASSERT_LT(stats.partial_factorisations, stats.factorisations) << "the first is whole";
    }
    EXPECT_GT(2 * partial, all);
}

TEST(ContactScenes, WedgeJams) {
    Watched run("wedge");
    World& world = run.world();
    const InputId push = world.find_input("push");
    const auto squeeze = [&] {  // normal forces [N]
        double sum = 0.0;
        for (const ContactView& c : world.contacts()) sum += std::abs(c.force.dot(c.normal));
        return sum;
    };
    ASSERT_TRUE(run.to(1.0));
    const double before = squeeze();
    world.set_input(push, -5.0 * 981.0);
    ASSERT_TRUE(run.to(2.0));
    const double pushed = run.position("wedge").z();
    world.set_input(push, 0.0);
    ASSERT_TRUE(run.to(3.0));
    // With friction above the half angle, the wedge stays between the walls that it has pressed
    // apart. Without friction the squeeze would return to its earlier value.
    EXPECT_GT(squeeze(), 2.0 * before);
    const double let_go = run.position("wedge").z();
    EXPECT_LT(let_go - pushed, 1e-4);
    ASSERT_TRUE(run.to(5.0));
    EXPECT_NEAR(run.position("wedge").z(), let_go, 1e-9);
    EXPECT_LE(run.worst_map, kCertified);
}

TEST(ContactScenes, AnchorIsDraggedByItsFriction) {
    Watched run("anchor_drag");
    const auto& chain = run.scene.cables.at(0);
    ASSERT_TRUE(run.to(4.0));
    double sum = 0.0;
    int count = 0;
    while (run.world().time() < 12.0) {
        ASSERT_TRUE(run.to(run.world().time() + run.world().settings().step));
        sum += -run.world().force(chain.stretch.back())[0];
        ++count;
    }
    // mu W of the anchor, and of the chain except half an element at each end, which bodies carry.
    const double weight = 0.87 * 9.81;
    const double exact = 0.8 * 15000.0 * weight + 0.7 * 126.5 * (120.0 - 2.0) * weight;
    EXPECT_NEAR(sum / count / exact, 1.0, 0.01);  // The anchor rocks; mean over 8 s.
    EXPECT_LE(run.worst_map, kCertified);
}

TEST(ContactScenes, PileOfChainComesToRest) {
    Watched run("chain_pile");
    World& world = run.world();
    ASSERT_TRUE(run.to(4.0));
    double highest = 0.0, fastest = 0.0;
    for (const BodyId node : run.scene.cables.at(0).nodes) {
        highest = std::max(highest, world.pose(node).position.z());
    }
    ASSERT_TRUE(run.to(5.0));
    for (const BodyId node : run.scene.cables.at(0).nodes) {
        fastest = std::max(fastest, world.velocity(node).linear.norm());
    }
    EXPECT_LT(highest, 0.2);   // Two thicknesses: one layer across the other.
    EXPECT_LT(fastest, 1e-3);  // Spans between flakes vibrate by 0.1 mm, undamped.
    EXPECT_LE(run.worst_map, kCertified);
}

/// Spare lines lie on deck at their rest length, slack or taut by rounding, 1e-7 N. Slides of
/// guides have a millionth of a node's mass. Relative to these, each such switch needed a
/// factorisation.
TEST(ContactScenes, LinesThatLieAboutSwitchNothingBesideSlides) {
    Watched run("anchor_adaptive");
    int more = 0;
    while (run.world().stats().step < 60) {
        ASSERT_EQ(run.world().step(), Status::ok);
        more += run.world().stats().step > 10 && run.world().stats().factorisations > 1 ? 1 : 0;
    }
    EXPECT_LE(more, 5);  // of 50
}

TEST(ContactScenes, SeabedHoldsTheMooring) {
    Watched run("mooring_seabed");
    ASSERT_TRUE(run.to(2.0));
    // The comparison of engines states 650 to 850 for this scene.
    EXPECT_GE(run.contacts_min, 650);
    EXPECT_LE(run.contacts_max, 850);
    EXPECT_LE(run.violation, 1e-5);
    EXPECT_LE(run.worst_map, kCertified);
    EXPECT_EQ(run.world().stats().islands, 1);
}

}  // namespace
}  // namespace hawser
