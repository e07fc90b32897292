// SPDX-License-Identifier: Apache-2.0
/// Parts of a world: what forces and velocities do to the choice of cuts.
#include "support/recipe.h"

#include <hawser/partition.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace hawser::test {
namespace {

enum class Role { accelerating, steady, slack };

constexpr int kNodes = 40;
constexpr double kApart = 1.0;  // m

/// A hull from which three equal cables stick out in a plane, without gravity. They differ in how
/// they move and are pulled, and in nothing else.
struct ThreeCables {
    explicit ThreeCables(const std::array<Role, 3>& roles) {
        recipe.world.gravity = Vec3::Zero();
        hull = recipe.rigid({0, 0, 0}, Quat::Identity(), 1e6, {1e7, 1e7, 1e7});
        for (std::size_t c = 0; c < 3; ++c) add_cable(c);
        world = std::make_unique<World>(recipe.make());
        for (std::size_t c = 0; c < 3; ++c) play(c, roles[c]);
        // What starting set swinging dies out: the rows' damping time is some steps.
        for (int k = 0; k < 120; ++k) EXPECT_EQ(world->step(), Status::ok);
    }

    [[nodiscard]] Vec3 direction(std::size_t c) const {
        const double turn = 2.0 * 3.14159265358979 * static_cast<double>(c) / 3.0;
        return {std::cos(turn), std::sin(turn), 0.0};
    }

    void add_cable(std::size_t c) {
        std::vector<BodyId> row{hull};
        for (int i = 1; i <= kNodes; ++i)
            row.push_back(recipe.lump(direction(c) * (kApart * i), 10.0));
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            InteractionDef d = between(InteractionKind::Distance, {row[i], row[i + 1]});
            d.compliance[0] = 1e-7;
            d.damping_time[0] = 0.1;
            recipe.add(d.set("length", kApart));
        }
        cable[c].assign(row.begin() + 1, row.end());
    }

    /// Accelerating: it turns about the hull, so that every node is pulled inwards. Steady: its end
    /// is pulled, so that the tension is the same all along. Slack: nothing.
    void play(std::size_t c, Role role) {
        const Vec3 across = Vec3(0, 0, 1).cross(direction(c));
        for (int i = 0; role == Role::accelerating && i < kNodes; ++i)
            world->set_velocity(cable[c][static_cast<std::size_t>(i)],
                                {across * (1.0 * kApart * (i + 1)), Vec3::Zero()});
        if (role == Role::steady)
            world->set_force(cable[c].back(), direction(c) * 5e3, Vec3::Zero());
    }

    /// Cables with a cut interaction.
    [[nodiscard]] std::set<std::size_t> cut_cables(const PartitionView& view) const {
        std::set<std::size_t> result;
        for (const CutInteraction& cut : view.cuts)
            for (std::size_t c = 0; c < 3; ++c)
                for (const BodyId b : world->interaction_def(cut.interaction).body)
                    if (std::any_of(cable[c].begin(), cable[c].end(),
                                    [&](BodyId x) { return x.index == b.index; }))
                        result.insert(c);
        return result;
    }

    Recipe recipe;
    BodyId hull{};
    std::array<std::vector<BodyId>, 3> cable;
    std::unique_ptr<World> world;
};

TEST(WorldPartition, TheAcceleratingCableStaysWhole) {
    std::array<Role, 3> roles{Role::accelerating, Role::steady, Role::slack};
    for (std::size_t turn = 0; turn < 3; ++turn) {
        SCOPED_TRACE(turn);
        const ThreeCables t(roles);
        PartitionRequest request;
        request.use = PartitionUse::cuts;
        request.parts = 2;
        request.exact_cost = false;  // the same for all three
        const PartitionView view = t.world->partition(request);
        ASSERT_FALSE(view.cuts.empty());
        EXPECT_LT(view.imbalance, 1.1);
        const std::set<std::size_t> cut = t.cut_cables(view);
        for (const std::size_t c : cut) EXPECT_NE(roles[c], Role::accelerating) << c;
        // Tension is no reason: it is 5 kN where it is steady.
        for (const CutInteraction& c : view.cuts) EXPECT_LT(c.net_force, 10.0);
        std::rotate(roles.begin(), roles.begin() + 1, roles.end());
    }
}

TEST(WorldPartition, TensionAloneMovesNoCut) {
    const ThreeCables slack({Role::slack, Role::slack, Role::slack});
    const ThreeCables taut({Role::steady, Role::steady, Role::steady});
    PartitionRequest request;
    request.use = PartitionUse::cuts;
    request.exact_cost = false;
    request.parts = 2;
    EXPECT_GT(std::abs(taut.world->force(InteractionId{10})[0]), 4e3);
    EXPECT_EQ(slack.cut_cables(slack.world->partition(request)).size(),
              taut.cut_cables(taut.world->partition(request)).size());
}

TEST(WorldPartition, SeparatorsSeparate) {
    const ThreeCables t({Role::accelerating, Role::steady, Role::slack});
    PartitionRequest request;
    for (const int parts : {1, 2, 4, 7}) {
        request.parts = parts;
        const PartitionView view = t.world->partition(request);
        for (int i = 0; i < t.world->interaction_count(); ++i) {
            int part = -1;
            for (const BodyId b : t.world->interaction_def(InteractionId{i}).body) {
                if (!b.valid()) continue;
                const int p = view.part_of_body[static_cast<std::size_t>(b.index)];
                if (p < 0) continue;
                EXPECT_TRUE(part < 0 || part == p);
                part = p;
            }
        }
        EXPECT_LT(view.imbalance, 1.3);
    }
    request.parts = 0;
    EXPECT_THROW((void)t.world->partition(request), DefError);
}

TEST(WorldPartition, GroupsByHandAreKept) {
    const ThreeCables t({Role::slack, Role::slack, Role::slack});
    PartitionRequest request;
    request.use = PartitionUse::cuts;
    request.parts = 3;
    request.group.assign(static_cast<std::size_t>(t.world->body_count()), -1);
    for (const BodyId b : t.cable[1]) request.group[static_cast<std::size_t>(b.index)] = 2;
    const PartitionView view = t.world->partition(request);
    for (const BodyId b : t.cable[1])
        EXPECT_EQ(view.part_of_body[static_cast<std::size_t>(b.index)], 2);
}

}  // namespace
}  // namespace hawser::test
