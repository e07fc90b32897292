// SPDX-License-Identifier: Apache-2.0
/// Parts of a world: effects of forces and velocities on the choice of cuts.
#include "world/three_cables.h"

#include <hawser/experimental/splits.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

namespace hawser::test {
namespace {

enum class Role { accelerating, steady, slack };

/// They differ only in their motion and pull. Accelerating: it rotates about the hull. Steady: its
/// end is pulled. Slack: neither.
struct ThreeCables : regrouping::Cables {
    explicit ThreeCables(const std::array<Role, 3>& roles) : Cables(0) {
        recipe.world.coupling = Coupling::exact;
        world = std::make_unique<World>(recipe.make());
        for (std::size_t c = 0; c < 3; ++c) {
            if (roles[c] == Role::accelerating) turn(*world, c);
            if (roles[c] == Role::steady) pull(*world, c);
        }
        // Oscillations of the start decay: the damping time of rows is some steps.
        for (int k = 0; k < 120; ++k) EXPECT_EQ(world->step(), Status::ok);
    }
    [[nodiscard]] std::set<std::size_t> cut_cables(const PartitionView& view) const {
        return Cables::cut_cables(*world, view);
    }

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
        request.exact_cost = false;  // equal for all three
        const PartitionView view = t.world->splits().partition(request);
        ASSERT_FALSE(view.cuts.empty());
        EXPECT_LT(view.imbalance, 1.1);
        const std::set<std::size_t> cut = t.cut_cables(view);
        for (const std::size_t c : cut) EXPECT_NE(roles[c], Role::accelerating) << c;
        // Tension is no criterion: it is 5 kN in the steady cable.
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
    EXPECT_EQ(slack.cut_cables(slack.world->splits().partition(request)).size(),
              taut.cut_cables(taut.world->splits().partition(request)).size());
}

TEST(WorldPartition, SeparatorsSeparate) {
    const ThreeCables t({Role::accelerating, Role::steady, Role::slack});
    PartitionRequest request;
    for (const int parts : {1, 2, 4, 7}) {
        request.parts = parts;
        const PartitionView view = t.world->splits().partition(request);
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
    EXPECT_THROW((void)t.world->splits().partition(request), DefError);
}

TEST(WorldPartition, GroupsByHandAreKept) {
    const ThreeCables t({Role::slack, Role::slack, Role::slack});
    PartitionRequest request;
    request.use = PartitionUse::cuts;
    request.parts = 3;
    request.group.assign(static_cast<std::size_t>(t.world->body_count()), -1);
    for (const BodyId b : t.cable[1]) request.group[static_cast<std::size_t>(b.index)] = 2;
    const PartitionView view = t.world->splits().partition(request);
    for (const BodyId b : t.cable[1])
        EXPECT_EQ(view.part_of_body[static_cast<std::size_t>(b.index)], 2);
}

}  // namespace
}  // namespace hawser::test
