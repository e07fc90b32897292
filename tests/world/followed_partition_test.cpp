// SPDX-License-Identifier: Apache-2.0
/// Partitions that continue from an earlier one.
#include "world/three_cables.h"

#include <hawser/experimental/splits.h>

#include <utility>

namespace hawser::test::regrouping {
namespace {

TEST(FollowedPartition, GoesOnFromTheOneBefore) {
    const Cables t(0);
    World w = t.recipe.make();
    run(w, kEvery);
    for (const PartitionUse use : {PartitionUse::cuts, PartitionUse::separators}) {
        PartitionRequest request{.use = use, .parts = 3, .exact_cost = false};
        const PartitionView first = w.splits().partition(request);
        EXPECT_FALSE(first.followed);
        request.before = &first;
        const PartitionView second = w.splits().partition(request);
        EXPECT_TRUE(second.followed);
        EXPECT_EQ(second.makespan_new, first.makespan_new);
        EXPECT_EQ(second.cuts.size(), first.cuts.size());
        EXPECT_EQ(second.separator.size(), first.separator.size());
        // At most one cut moves.
        std::set<std::pair<std::int32_t, std::int32_t>> moved;
        for (std::size_t b = 0; b < first.part_of_body.size(); ++b)
            if (first.part_of_body[b] != second.part_of_body[b])
                moved.emplace(first.part_of_body[b], second.part_of_body[b]);
        EXPECT_LE(moved.size(), use == PartitionUse::cuts ? 1U : 0U);
        request.parts = 2;  // with another number of parts none can be kept
        EXPECT_FALSE(w.splits().partition(request).followed);
        request.use = use == PartitionUse::cuts ? PartitionUse::separators : PartitionUse::cuts;
        EXPECT_THROW((void)w.splits().partition(request), DefError);
    }
}

/// The earlier partition comes from the caller: invalid parts are rejected.
TEST(FollowedPartition, ADamagedOneIsMadeAnew) {
    const Cables t(0);
    World w = t.recipe.make();
    run(w, 2);
    for (const PartitionUse use : {PartitionUse::cuts, PartitionUse::separators}) {
        PartitionRequest request{.use = use, .parts = 3, .exact_cost = false};
        const PartitionView good = w.splits().partition(request);
        for (const std::int32_t part : {3, 1'000'000'000, -3, -1'000'000'000}) {
            PartitionView damaged = good;
            damaged.part_of_body[5] = part;
            request.before = &damaged;
            const PartitionView made = w.splits().partition(request);
            EXPECT_FALSE(made.followed) << part;
            EXPECT_EQ(made.part_of_body, good.part_of_body) << part;
        }
        PartitionView brief = good;
        brief.part_of_body.pop_back();
        request.before = &brief;
        EXPECT_FALSE(w.splits().partition(request).followed);
    }
}

/// A ball touches a cable of another part and then one of a third. Separators keep them apart.
/// Nodes without a contact return to a part, and the others stay.
TEST(FollowedPartition, SeparatorsFollowContacts) {
    Cables t(0);
    const BodyId ball = t.recipe.lump({0, 0, 100}, 10.0);
    World w = t.recipe.make();
    run(w, 3);
    PartitionRequest request{.parts = 3, .exact_cost = false};
    const PartitionView first = w.splits().partition(request);
    const auto part = [](const PartitionView& v, BodyId x) {
        return v.part_of_body[static_cast<std::size_t>(x.index)];
    };
    // One of each other part, with neighbours in its part.
    std::vector<BodyId> others;
    for (std::int32_t p = 0; p < 3; ++p) {
        if (p == part(first, ball)) continue;
        BodyId found{};
        for (const auto& cable : t.cable)
            for (std::size_t i = 1; i + 1 < cable.size(); ++i)
                if (part(first, cable[i - 1]) == p && part(first, cable[i]) == p &&
                    part(first, cable[i + 1]) == p)
                    found = cable[i];
        if (found.valid()) others.push_back(found);
    }
    ASSERT_EQ(others.size(), 2U);
    for (const BodyId b : {ball, others[0], others[1]}) {
        ShapeDef shape;
        shape.kind = ShapeKind::sphere;
        shape.body = b;
        shape.radius = 0.4;
        w.add_shape(shape);
    }
    const auto touch = [&](BodyId b) {
        w.set_pose(ball, {w.pose(b).position + Vec3(0.0, 0.0, 0.805), Quat::Identity()});
        w.set_velocity(ball, {Vec3::Zero(), Vec3::Zero()});
        run(w, 1);
        ASSERT_EQ(w.contacts().size(), 1U);
    };
    // Nodes of separators may return to a part; of the others only touching ones change.
    const auto expect_rest_stays = [&](const PartitionView& v) {
        for (std::int32_t b = 0; b < w.body_count(); ++b) {
            const BodyId x{b};
            if (part(first, x) < 0 || x == ball || x == others[0] || x == others[1]) continue;
            EXPECT_EQ(part(v, x), part(first, x)) << b;
        }
    };
    touch(others[0]);
    request.before = &first;
    const PartitionView second = w.splits().partition(request);
    EXPECT_TRUE(second.followed);
    EXPECT_TRUE(part(second, ball) == -2 || part(second, others[0]) == -2);
    expect_rest_stays(second);
    w.set_pose(ball, {Vec3(0, 0, 100), Quat::Identity()});
    run(w, 130);  // the pair is forgotten when another one appears
    touch(others[1]);
    request.before = &second;
    const PartitionView third = w.splits().partition(request);
    EXPECT_TRUE(third.followed);
    EXPECT_EQ(part(third, others[0]), part(first, others[0]));
    EXPECT_TRUE(part(third, ball) == -2 || part(third, others[1]) == -2 ||
                part(third, ball) == part(third, others[1]));
    expect_rest_stays(third);
}

}  // namespace
}  // namespace hawser::test::regrouping
