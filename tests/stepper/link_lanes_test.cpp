// SPDX-License-Identifier: Apache-2.0
/// Consecutive links run in batches of eight, others one by one: the motion is equal.
#include "support/random.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace hawser::test {
namespace {

/// Make the same bodies in reverse order: no link precedes the next one of its chain.
Recipe backwards(const Recipe& r) {
    Recipe b = r;
    std::reverse(b.bodies.begin(), b.bodies.end());
    const auto last = static_cast<std::int32_t>(r.bodies.size()) - 1;
    for (InteractionDef& d : b.interactions)
        for (std::size_t k = 0; k < static_cast<std::size_t>(kind_info(d.kind).bodies); ++k)
            d.body[k].index = last - d.body[k].index;
    return b;
}

class LinkLanes : public testing::TestWithParam<std::tuple<Form, bool>> {};
INSTANTIATE_TEST_SUITE_P(Forms, LinkLanes,
                         testing::Combine(testing::Values(Form::condensed, Form::saddle),
                                          testing::Bool()));

/// If some links touch the ground, the solution starts at 0, and contacts push.
TEST_P(LinkLanes, MoveAsOneByOne) {
    const auto [form, touching] = GetParam();
    // With contacts the seeds are fixed: in some of a hundred random scenes rounding decides
    // whether the constraint iteration of a step converges (step/completion.h), and the motions
    // differ.
    const std::vector<std::uint32_t> fixed{1, 2, 3, 4};
    for (const std::uint32_t seed : touching ? fixed : seeds(1, 2, 8, 60)) {
        SCOPED_TRACE(seed);
        Recipe r = chains(seed, 3, 21);
        r.world.form = form;
        r.world.solution_tolerance = 1e-13;
        r.world.contact_tolerance = 1e-12;
        World row = r.make(), other = backwards(r).make();
        const int n = row.body_count();
        auto twin = [&](int k) { return BodyId{n - 1 - k}; };
        for (World* w : {&row, &other}) {
            if (!touching) break;
            auto body = [&](int k) { return w == &row ? BodyId{k} : twin(k); };
            ShapeDef ground{.kind = ShapeKind::plane, .body = body(0)};
            // The lowest link overlaps the ground by 5 cm. Deeper links would be thrown out by
            // metres a step, and rounding would decide their motion. Links with a joint to the
            // ground do not collide with it.
            std::vector<bool> joined(static_cast<std::size_t>(n), false);
            for (const InteractionDef& d : r.interactions)
                if (d.body[0].index == 0 || d.body[1].index == 0)
                    joined[static_cast<std::size_t>(std::max(d.body[0].index, d.body[1].index))] =
                        true;
            double lowest = std::numeric_limits<double>::infinity();
            for (int k = 1; k < n; ++k)
                if (!joined[static_cast<std::size_t>(k)])
                    lowest = std::min(lowest, row.pose(BodyId{k}).position.z());
            ground.position.z() = lowest - 0.15;
            w->add_shape(ground);
            for (int k = 1; k < n; ++k)
                w->add_shape({.body = body(k), .radius = 0.2, .group = 2, .touches = 1});
        }
        // Rounding of one step grows with every rotating joint: 1e-9 in a dozen. Contacts move
        // links so fast that position projection closes the joints, with unrefined solutions
        // (step/closing.h): about 1e-6 of moves of a centimetre along free directions.
        const double close = touching ? 1e-6 : 1e-9;
        int contacts = 0;
        for (int step = 0; step < (touching ? 3 : 12); ++step) {
            ASSERT_EQ(row.step(), Status::ok);
            ASSERT_EQ(other.step(), Status::ok);
            contacts += row.stats().contacts;
        }
        EXPECT_EQ(contacts > 0, touching);
        for (int k = 1; k < n; ++k) {
            const Twist v = row.velocity(BodyId{k}), u = other.velocity(twin(k));
            EXPECT_LE((row.pose(BodyId{k}).position - other.pose(twin(k)).position).norm(), close)
                << k;
            EXPECT_LE((v.linear - u.linear).norm(), 10.0 * close * (1.0 + v.linear.norm())) << k;
            EXPECT_LE((v.angular - u.angular).norm(), 10.0 * close * (1.0 + v.angular.norm())) << k;
        }
    }
}

/// If the number of joints equals the capacity, nothing after the last one may be read: the address
/// sanitizer detects it. Bodies after the chain allow batches for its last joints, too.
TEST(LinkEnds, AreNotLeft) {
    for (const int links : {8, 16, 32, 64, 128}) {
        World world;
        BodyDef body{.mass = 1.0, .inertia = 0.1 * Mat3::Identity()};
        std::vector<BodyId> chain;
        for (int k = 0; k <= links; ++k) {
            body.position = Vec3(k, 0, 0);
            chain.push_back(world.add_body(body));
        }
        for (int k = 0; k < 3; ++k) {
            body.position = Vec3(0, 50 + 10 * k, 0);
            world.add_body(body);
        }
        for (int k = 0; k < links; ++k)
            world.add_interaction({.kind = InteractionKind::Ball,
                                   .body = {chain[static_cast<std::size_t>(k)],
                                            chain[static_cast<std::size_t>(k) + 1]},
                                   .point = {Vec3(0.5, 0, 0), Vec3(-0.5, 0, 0)}});
        for (int step = 0; step < 3; ++step) ASSERT_EQ(world.step(), Status::ok);
        // All have the same fall.
        const Vec3 fall = world.velocity(chain.front()).linear;
        EXPECT_LT(fall.z(), -0.4);
        for (const BodyId b : chain) EXPECT_LE((world.velocity(b).linear - fall).norm(), 1e-12);
    }
}

/// Inertias off their bodies' axes are matrices, others three moments: the choice of axes changes
/// no motion. Without drag, which acts along axes.
TEST(LinkAxes, MoveNothing) {
    Random random(7);
    Recipe along = chains(5, 2, 21);
    for (BodyDef& b : along.bodies) b.linear_damping = b.angular_damping = Vec3::Zero();
    along.world.solution_tolerance = 1e-13;
    Recipe across = along;
    std::vector<Quat> axes;  // across in along
    for (BodyDef& b : across.bodies) {
        axes.push_back(b.kind == BodyKind::rigid ? random.rotation() : Quat::Identity());
        const Mat3 turn = axes.back().toRotationMatrix();
        b.orientation = b.orientation * axes.back();
        b.inertia = turn.transpose() * b.inertia * turn;
        b.inertia = (0.5 * (b.inertia + b.inertia.transpose())).eval();
    }
    for (InteractionDef& d : across.interactions)
        for (std::size_t k = 0; k < 2; ++k)
            d.point[k] = axes[static_cast<std::size_t>(d.body[k].index)].conjugate() * d.point[k];
    World one = along.make(), other = across.make();
    for (int step = 0; step < 12; ++step) {
        ASSERT_EQ(one.step(), Status::ok);
        ASSERT_EQ(other.step(), Status::ok);
    }
    // Rounding of one step grows with every rotating joint.
    for (int k = 1; k < one.body_count(); ++k) {
        const Twist v = one.velocity(BodyId{k}), u = other.velocity(BodyId{k});
        EXPECT_LE((one.pose(BodyId{k}).position - other.pose(BodyId{k}).position).norm(), 1e-9)
            << k;
        EXPECT_LE((v.linear - u.linear).norm(), 1e-8 * (1.0 + v.linear.norm())) << k;
        EXPECT_LE((v.angular - u.angular).norm(), 1e-8 * (1.0 + v.angular.norm())) << k;
    }
}

}  // namespace
}  // namespace hawser::test
