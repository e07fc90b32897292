// SPDX-License-Identifier: Apache-2.0
/// The form of the equations is a pivot order: it must not change the result.
#include "stepper/scenes.h"
#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace hawser {
namespace {

/// Largest velocity and distance from the origin in a world, and the largest difference of
/// velocities to another one.
struct Comparison {
    double scale = 0.0, extent = 0.0, difference = 0.0;
};

Comparison compare(const World& a, const World& b) {
    Comparison c;
    for (const BodyId id : a.bodies()) {
        const Twist u = a.velocity(id), v = b.velocity(id);
        c.extent = std::max(c.extent, a.pose(id).position.norm());
        c.scale = std::max({c.scale, u.linear.norm(), u.angular.norm()});
        c.difference =
            std::max({c.difference, (u.linear - v.linear).norm(), (u.angular - v.angular).norm()});
    }
    return c;
}

TEST(Forms, EveryFormGivesTheSameVelocities) {
    int skip = 0;
    for (const auto& file : test::scene_files()) {
        if (test::kSanitized && skip++ % 3 != 0) continue;
        // Solutions of contacts in two forms agree to the tolerance of their iterations.
        constexpr double kContacts = 1e-9;
        scene::Options tight;
        tight.set = {"settings.contact_tolerance=1e-10", "settings.solution_tolerance=1e-13"};
        scene::Scene reference = scene::load_file(file, tight);
        for (int i = 0; i < (test::kSanitized ? 5 : 30); ++i)
            ASSERT_EQ(reference.world.step(), Status::ok) << file;
        const std::vector<std::byte> state = reference.world.state().save();
        const Structure made_of = reference.world.state().structure();
        ASSERT_EQ(reference.world.step(), Status::ok);
        for (const Form form : {Form::saddle, Form::condensed}) {
            scene::Options options = tight;
            options.form = form;
            scene::Scene other = scene::load_file(file, options);
            other.world.state().restore(made_of, state);
            ASSERT_EQ(other.world.step(), Status::ok) << file;
            const Comparison c = compare(reference.world, other.world);
            // 1e-12 of the fastest body, or of h g if all are at rest: smaller values are rounding
            // errors of h g.
            const double floor = 9.81 * reference.world.settings().step;
            // The gap of a joint iterated at the end of a step is computed from poses of two
            // bodies: divided by the step, their rounding is a velocity.
            const double joints = reference.world.stats().completion_rounds > 0
                                      ? 2.0 * std::numeric_limits<double>::epsilon() * c.extent /
                                            reference.world.settings().step
                                      : 0.0;
            // Forces of water on ships, 1e7 N, have rounding errors that move nodes of 100 kg by
            // ten times that.
            const double plain = reference.world.find_system("sea") != nullptr ? 1e-11 : 1e-12;
            const double close = reference.world.stats().contacts > 0 ? kContacts : plain;
            EXPECT_LE(c.difference, close * std::max(c.scale, floor) + joints)
                << file << " form " << static_cast<int>(form);
        }
    }
}

}  // namespace
}  // namespace hawser
