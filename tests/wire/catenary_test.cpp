// SPDX-License-Identifier: Apache-2.0
// Shapes of wires at rest against closed forms, and limits without a bent shape.
#include <gtest/gtest.h>
#include <hawser/catenary.h>
#include <hawser/def.h>

#include <cmath>

namespace hawser {
namespace {

CatenaryDef wire(const Vec3& to, double length, int elements) {
    CatenaryDef def;
    def.to = to;
    def.sections = {{length, 98.1, 1e8, elements}};
    return def;
}

/// The largest sideways or vertical distance of an element's middle from a straight line is of
/// order 1/n²: the pulls of n elements converge to those of the smooth wire.
TEST(Catenary, tends_to_the_smooth_one) {
    // Inextensible: a = 33.820188 m, sag 26.543751 m, end tension 60.363939 w. The effect of EA is
    // 1e-4.
    for (const auto& [n, limit] :
         {std::pair(20, 1.5e-3), {40, 5e-4}, {100, 2e-4}, {1000, 1.5e-4}}) {
        const Catenary c = catenary(wire({80, 0, 0}, 100.0, n));
        ASSERT_EQ(c.status, CatenaryStatus::balanced);
        EXPECT_NEAR(c.pull_from.x() / 98.1, 33.820188, 33.8 * limit) << n;
        EXPECT_NEAR(-c.nodes[static_cast<std::size_t>(n) / 2].z(), 26.543751, 26.5 * limit) << n;
        const Vec3 end = c.pull_from - Vec3(0, 0, c.weight_from);
        EXPECT_NEAR(end.norm() / 98.1, 60.363939, 60.4 * limit) << n;
        EXPECT_NEAR(end.z(), -0.5 * 9810.0, 1e-6);
        EXPECT_FALSE(c.touches());
    }
}

/// Closed form used by MoorPy and others for a chain of 410 m on a bottom without friction.
/// Tensions at its ends are 1001.7 and 835.6 kN (M. Jonkman's line of 2007, w = 3323.25 N/m, EA =
/// 1.674e9 N).
TEST(Catenary, lies_on_the_seabed) {
    CatenaryDef def;
    def.from = {0, 0, -50};
    def.to = {400, 0, 0};
    def.sections = {{410.0, 3323.25, 1.674e9, 410}};
    def.seabed = FlatSeabed{-50.0, 0.0};
    const Catenary free = catenary(def);
    ASSERT_EQ(free.status, CatenaryStatus::balanced);
    EXPECT_NEAR((free.pull_to - Vec3(0, 0, free.weight_to)).norm(), 1001.7e3, 200.0);
    EXPECT_NEAR(free.pull_from.norm(), 835.6e3, 200.0);
    EXPECT_DOUBLE_EQ(free.laid_from, 0.0);
    // Friction reduces the tension by μ w per metre on the bottom.
    def.seabed->friction = 0.7;
    const Catenary held = catenary(def);
    ASSERT_EQ(held.status, CatenaryStatus::balanced);
    const double horizontal = -held.pull_to.x();
    EXPECT_NEAR(held.tension[0], horizontal - 0.7 * 3323.25 * held.laid_to, 0.7 * 3323.25 * 1.0);
    EXPECT_LT(held.tension[0], 0.4 * horizontal);
    def.seabed->friction = 3.0;
    EXPECT_EQ(catenary(def).tension[0], 0.0);
    EXPECT_EQ(catenary(def).status, CatenaryStatus::balanced);
}

TEST(Catenary, follows_any_gravity) {
    CatenaryDef def = wire({50, 0, 0}, 70.0, 20);
    const Catenary flat = catenary(def);
    def.to = {0, 50, 0};
    def.down = {2, 0, 0};
    const Catenary turned = catenary(def);
    for (std::size_t i = 0; i < flat.nodes.size(); ++i) {
        const Vec3& p = flat.nodes[i];
        EXPECT_LT((turned.nodes[i] - Vec3(-p.z(), p.x(), 0.0)).norm(), 1e-9);
    }
}

TEST(Catenary, is_taut_where_it_is_too_short) {
    CatenaryDef def = wire({30, 0, 40}, 49.0, 7);
    def.sections[0].weight = 0.0;
    const Catenary c = catenary(def);
    ASSERT_EQ(c.status, CatenaryStatus::balanced);
    for (const double t : c.tension) EXPECT_NEAR(t, 1e8 / 49.0, 1e-3);
    EXPECT_LT((c.nodes[3] - Vec3(30, 0, 40) * 3.0 / 7.0).norm(), 1e-9);
}

TEST(Catenary, folds_between_ends_on_one_vertical) {
    // 30 m between points 10 m apart: the bight hangs 10 m below the lower one.
    const Catenary c = catenary(wire({0, 0, -10}, 30.0, 30));
    EXPECT_NE(c.status, CatenaryStatus::unbalanced);
    double lowest = 0.0;
    for (const Vec3& p : c.nodes) {
        lowest = std::min(lowest, p.z());
        EXPECT_LT(std::hypot(p.x(), p.y()), 1e-9);
    }
    EXPECT_NEAR(lowest, -20.0, 0.01);
    EXPECT_NEAR(c.pull_from.z() + c.pull_to.z() - c.weight_from - c.weight_to, -30.0 * 98.1, 1e-6);
    // With an odd number, the element at the bottom has no tension.
    EXPECT_EQ(catenary(wire({0.2, 0, 0}, 31.0, 31)).status, CatenaryStatus::slack);
    // A loop from a point to itself.
    EXPECT_NE(catenary(wire({0, 0, 0}, 31.0, 30)).status, CatenaryStatus::unbalanced);
}

TEST(Catenary, hangs_free_and_lies_where_it_reaches) {
    CatenaryDef def = wire({1, 0, 0}, 40.0, 40);
    def.free = true;
    const Catenary hung = catenary(def);
    ASSERT_EQ(hung.status, CatenaryStatus::balanced);
    // Elongation w L²/2EA of a hanging wire.
    EXPECT_NEAR(hung.nodes.back().z(), -40.0 - 98.1 * 800.0 / 1e8, 1e-9);
    EXPECT_NEAR(hung.pull_from.z() - hung.weight_from, -98.1 * 40.0, 1e-6);
    def.seabed = FlatSeabed{-30.25, 0.0};
    const Catenary lies = catenary(def);
    EXPECT_EQ(lies.status, CatenaryStatus::slack);
    EXPECT_EQ(lies.nodes.back().z(), -30.25);
    EXPECT_GT(lies.nodes.back().x(), 9.0);
    EXPECT_NEAR(lies.pull_from.z() - lies.weight_from, -98.1 * 30.25, 98.1);
}

TEST(Catenary, lies_in_an_arc_where_it_is_too_long) {
    CatenaryDef def = wire({30, 0, 0}, 60.0, 30);
    def.seabed = FlatSeabed{0.0, 0.5};
    const Catenary flat = catenary(def);
    EXPECT_EQ(flat.status, CatenaryStatus::slack);
    EXPECT_DOUBLE_EQ(flat.laid_to - flat.laid_from, 60.0);
    for (std::size_t i = 0; i + 1 < flat.nodes.size(); ++i) {
        EXPECT_EQ(flat.nodes[i].z(), 0.0);
        EXPECT_NEAR((flat.nodes[i + 1] - flat.nodes[i]).norm(), 2.0, 1e-9);
        EXPECT_EQ(flat.tension[i], 0.0);
    }
    // Both ends are above the bottom: it drops, lies, and rises.
    def.seabed->height = -10.0;
    const Catenary lifted = catenary(def);
    EXPECT_EQ(lifted.status, CatenaryStatus::slack);
    EXPECT_NEAR(lifted.pull_from.z() - lifted.weight_from, -98.1 * 10.0, 98.1);
    EXPECT_NEAR(lifted.laid_to - lifted.laid_from, 40.0, 2.5);
}

TEST(Catenary, has_sections_of_several_line_types) {
    // A chain between two wires: the tension at the top carries the weight below it, up to the
    // lowest point.
    CatenaryDef def;
    def.to = {300, 0, -80};
    def.sections = {{120.0, 200.0, 3e8, 24}, {100.0, 1100.0, 6e8, 25}, {160.0, 200.0, 3e8, 16}};
    const Catenary c = catenary(def);
    ASSERT_EQ(c.status, CatenaryStatus::balanced);
    ASSERT_EQ(c.nodes.size(), 66U);
    const double weight = 120.0 * 200.0 + 100.0 * 1100.0 + 160.0 * 200.0;
    EXPECT_NEAR(c.pull_from.z() + c.pull_to.z() - c.weight_from - c.weight_to, -weight, 1e-4);
    EXPECT_NEAR(c.pull_from.x() + c.pull_to.x(), 0.0, 1e-4);
    // The same nodes, given by their material coordinates.
    CatenaryDef listed = def;
    for (CatenarySection& part : listed.sections) part.elements = 1;
    listed.nodes.assign(c.s.begin() + 1, c.s.end() - 1);
    const Catenary same = catenary(listed);
    for (std::size_t i = 0; i < c.nodes.size(); ++i)
        EXPECT_LT((same.nodes[i] - c.nodes[i]).norm(), 1e-9) << i;
    // An element across two line types.
    listed.nodes = {100.0, 130.0, 250.0};
    EXPECT_EQ(catenary(listed).status, CatenaryStatus::balanced);
}

TEST(Catenary, floats_where_it_weighs_less_than_nothing) {
    CatenaryDef def = wire({80, 0, 0}, 100.0, 40);
    const Catenary down = catenary(def);
    def.sections[0].weight *= -1.0;
    const Catenary up = catenary(def);
    ASSERT_EQ(up.status, CatenaryStatus::balanced);
    for (std::size_t i = 0; i < up.nodes.size(); ++i)
        EXPECT_NEAR(up.nodes[i].z(), -down.nodes[i].z(), 1e-9);
}

TEST(Catenary, says_what_it_cannot_do) {
    CatenaryDef def = wire({80, 0, 0}, 100.0, 40);
    def.seabed = FlatSeabed{10.0, 0.5};  // above its ends
    EXPECT_EQ(catenary(def).status, CatenaryStatus::below_seabed);
    // A float on the line of an anchor, pulled down to the bottom by the heavier parts.
    def.sections = {{40.0, 500.0, 1e8, 20}, {20.0, -100.0, 1e8, 10}, {60.0, 500.0, 1e8, 20}};
    def.seabed = FlatSeabed{-5.0, 0.5};
    const Catenary c = catenary(def);
    EXPECT_EQ(c.status, CatenaryStatus::unbalanced);
    for (const Vec3& p : c.nodes) EXPECT_TRUE(p.allFinite());
}

TEST(Catenary, refuses_what_is_no_wire) {
    const CatenaryDef good = wire({80, 0, 0}, 100.0, 10);
    EXPECT_NO_THROW((void)catenary(good));
    const auto refused = [&](auto change) {
        CatenaryDef def = good;
        change(def);
        EXPECT_THROW((void)catenary(def), DefError);
    };
    refused([](CatenaryDef& d) { d.sections.clear(); });
    refused([](CatenaryDef& d) { d.sections[0].length = 0.0; });
    refused([](CatenaryDef& d) { d.sections[0].EA = 0.0; });
    refused([](CatenaryDef& d) { d.sections[0].weight = NAN; });
    refused([](CatenaryDef& d) { d.sections[0].elements = 0; });
    refused([](CatenaryDef& d) { d.down = Vec3::Zero(); });
    refused([](CatenaryDef& d) { d.to.x() = INFINITY; });
    refused([](CatenaryDef& d) { d.nodes = {10.0, 10.0}; });
    refused([](CatenaryDef& d) { d.nodes = {10.0, 110.0}; });
    refused([](CatenaryDef& d) { d.tolerance = 0.0; });
    refused([](CatenaryDef& d) { d.seabed = FlatSeabed{NAN, 0.0}; });
    refused([](CatenaryDef& d) { d.seabed = FlatSeabed{0.0, -0.1}; });
}

}  // namespace
}  // namespace hawser
