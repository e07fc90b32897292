// SPDX-License-Identifier: Apache-2.0
/// Splits of a scene with contacts and friction: uncut joints and contacts are as exact as in any
/// step, for any cuts.
#include <hawser/experimental/splits.h>
#include <hawser/scene.h>

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Kinematic cuts with `forces` reach 70 m/s in 16 steps, those with `hold` 1.3: no tolerance below
/// depends on it.
constexpr int kContactCutSteps = kSanitized ? 8 : 16;

/// Make the scene. @param every  Steps between regroupings; 0: groups stay.
World anchor_contact(const char* coupling, const char* predictor, int threads, int every) {
    scene::Options options;
    options.threads = threads;
    options.set = {std::string("settings.coupling=") + coupling,
                   std::string("settings.predictor=") + predictor, "settings.parts=4",
                   "settings.regroup_every=" + std::to_string(every)};
    return scene::load_file("bench/scenes/frozen/anchor_contact.json", options).world;
}

struct ContactForces {
    double normal = 0.0, tangential = 0.0;  ///< Sums [N].
    double outside = 0.0;  ///< Largest tangential force beyond μ times the normal one [N].
    double pull = 0.0;     ///< Largest pull [N].
    int touching = 0, sliding = 0;
};

ContactForces contact_forces(const World& world) {
    ContactForces f;
    for (const ContactView& c : world.contacts()) {
        const double normal = c.force.dot(c.normal),
                     tangential = (c.force - normal * c.normal).norm();
        f.normal += normal;
        f.tangential += tangential;
        f.outside = std::max(f.outside, tangential - c.friction * normal);
        f.pull = std::max(f.pull, -normal);
        f.touching += normal > 0.0 ? 1 : 0;
        f.sliding += c.sliding ? 1 : 0;
    }
    return f;
}

/// Return the largest |g| over the stiff rows of the given interactions.
double violation(const World& world, const std::vector<InteractionId>& of) {
    double most = 0.0;
    for (const InteractionId id : of) {
        const InteractionDef def = world.interaction_def(id);
        const auto g = world.violation(id);
        for (std::size_t r = 0; r < g.size(); ++r)
            if (def.compliance[r] <= 1e-8) most = std::max(most, std::fabs(g[r]));
    }
    return most;
}

void expect_finite(const World& world) {
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        const Pose pose = world.pose(BodyId{b});
        const Twist twist = world.velocity(BodyId{b});
        ASSERT_TRUE(pose.position.allFinite() && pose.orientation.coeffs().allFinite()) << b;
        ASSERT_TRUE(twist.linear.allFinite() && twist.angular.allFinite()) << b;
    }
}

struct ContactWay {
    const char *coupling, *predictor;
};

class SplitContacts : public testing::TestWithParam<ContactWay> {};
INSTANTIATE_TEST_SUITE_P(
    Ways, SplitContacts,
    testing::Values(ContactWay{"kinematic", "hold"}, ContactWay{"kinematic", "forces"},
                    ContactWay{"kinematic", "clique"}, ContactWay{"compliant", "hold"},
                    ContactWay{"compliant", "forces"}, ContactWay{"compliant", "clique"}),
    [](const auto& way) { return std::string(way.param.coupling) + "_" + way.param.predictor; });

TEST_P(SplitContacts, LeaveContactsAndUncutRowsExact) {
    World world = anchor_contact(GetParam().coupling, GetParam().predictor, 1, 0);
    World exact = anchor_contact("exact", "hold", 1, 0);
    const std::vector<std::int32_t> group = world.splits().groups();
    std::set<std::int32_t> groups(group.begin(), group.end());
    groups.erase(-1);
    ASSERT_GE(groups.size(), 4U);
    std::vector<InteractionId> uncut;
    {
        std::set<std::int32_t> open;
        for (const CutView& c : world.splits().cuts())
            if (c.open) open.insert(c.interaction.index);
        ASSERT_FALSE(open.empty());
        for (std::int32_t i = 0; i < world.interaction_count(); ++i)
            if (open.count(i) == 0) uncut.push_back(InteractionId{i});
    }
    double defect = 0.0;
    int sliding = 0;
    for (int i = 0; i < kContactCutSteps; ++i) {
        ASSERT_EQ(world.step(), Status::ok) << i;
        ASSERT_EQ(exact.step(), Status::ok) << i;
        const StepStats& s = world.stats();
        ASSERT_GE(s.islands, 4) << i;
        ASSERT_GE(s.cuts, 20) << i;
        ASSERT_GE(s.contacts, 1000) << i;
        expect_finite(world);
        // Rows in the system include duplicated rows of cuts: only rounding of velocities up to 100
        // m/s.
        EXPECT_LE(s.constraint_residual, 1e-12) << i;
        EXPECT_LE(s.momentum_residual, 1e-12) << i;
        // Uncut joints are as closed as in the exact run: 6.7 mm is the gap of a stop.
        EXPECT_LE(violation(world, uncut), 1.01 * violation(exact, uncut) + 1e-5) << i;
        const ContactForces f = contact_forces(world);
        ASSERT_GT(f.touching, 500) << i;
        EXPECT_GT(f.tangential, 0.0) << i;
        EXPECT_LE(s.natural_map, 1e-6) << i;
        // The law is solved to 1e-6 of a contact's own scale, at most some times the average force
        // of contacts.
        EXPECT_LE(f.outside, 1e-5 * f.normal / f.touching) << i;
        EXPECT_LE(f.pull, 1e-5 * f.normal / f.touching) << i;
        defect = std::max(defect, s.momentum_defect);
        sliding += f.sliding;
        EXPECT_LE(exact.stats().momentum_defect, 1e-12) << i;
    }
    // The defect of cuts is reported, and is far above rounding.
    EXPECT_GT(defect, 1e-9);
    EXPECT_TRUE(std::isfinite(defect));
    // Soft cuts let wires come down: some contacts are at the edge of their cone.
    if (std::string(GetParam().coupling) == "compliant") {
        EXPECT_GT(sliding, 0);
    }
}

TEST_P(SplitContacts, AreTheSameForAnyNumberOfThreads) {
    // Groups move within these steps.
    World one = anchor_contact(GetParam().coupling, GetParam().predictor, 1, 5),
          two = anchor_contact(GetParam().coupling, GetParam().predictor, 2, 5),
          four = anchor_contact(GetParam().coupling, GetParam().predictor, 4, 5);
    const int steps = kSanitized ? 3 : kContactCutSteps;
    for (int i = 0; i < steps; ++i)
        for (World* w : {&one, &two, &four}) ASSERT_EQ(w->step(), Status::ok) << i;
    EXPECT_EQ(one.state().hash(), two.state().hash());
    EXPECT_EQ(one.state().hash(), four.state().hash());
    if (!kSanitized) {
        EXPECT_GT(one.stats().regroupings, 0);
    }
}

}  // namespace
}  // namespace hawser::test
