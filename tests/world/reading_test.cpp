// SPDX-License-Identifier: Apache-2.0
/// Reading in blocks: state(), contacts and snapshots in the client's memory, events with cursors.
#include <hawser/hawser.h>

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hawser::test {
namespace {

TEST(Reading, StateIsWhatPosesAndVelocitiesSay) {
    Recipe r = mixed(11);
    World world = r.make();
    for (int step = 0; step < 20; ++step) {
        ASSERT_EQ(world.step(), Status::ok);
        const StateView s = world.state().arrays();
        ASSERT_EQ(s.kinds.size(), static_cast<std::size_t>(world.body_count()));
        ASSERT_EQ(s.positions.size(), 3 * s.kinds.size());
        ASSERT_EQ(s.orientations.size(), 4 * s.kinds.size());
        EXPECT_EQ(s.time, world.time());
        std::size_t covered = 0;
        for (std::int32_t i = 0; i < world.body_count(); ++i) {
            const auto b = static_cast<std::size_t>(i);
            const Pose p = world.pose({i});
            const Twist v = world.velocity({i});
            const double q[4] = {p.orientation.w(), p.orientation.x(), p.orientation.y(),
                                 p.orientation.z()};
            EXPECT_TRUE(std::equal(q, q + 4, &s.orientations[4 * b]));
            EXPECT_TRUE(std::equal(p.position.data(), p.position.data() + 3, &s.positions[3 * b]));
            const BodyKind kind = world.body_def({i}).kind;
            EXPECT_EQ(s.kinds[b], kind);
            const double all[6] = {v.linear.x(),  v.linear.y(),  v.linear.z(),
                                   v.angular.x(), v.angular.y(), v.angular.z()};
            const std::size_t n = kind == BodyKind::rigid    ? 6
                                  : kind == BodyKind::lump   ? 3
                                  : kind == BodyKind::scalar ? 1
                                                             : 0;
            covered += n;
            if (n > 0)
                EXPECT_TRUE(std::equal(
                    all, all + n, &s.velocities[static_cast<std::size_t>(s.velocity_begin[b])]));
            else
                EXPECT_TRUE(std::equal(all, all + 6, &s.prescribed[6 * b]));
        }
        EXPECT_EQ(covered, s.velocities.size());
    }
}

TEST(Reading, PointsGoToABodyAndBack) {
    Recipe r = link_chain(2);
    World world = r.make();
    for (int i = 0; i < 30; ++i) ASSERT_EQ(world.step(), Status::ok);
    const Vec3 local(0.1, -0.2, 0.3);
    // Two rotations there and back.
    EXPECT_LT((world.local_point({2}, world.world_point({2}, local)) - local).norm(), 1e-14);
}

TEST(Reading, SnapshotsInTheCallersMemoryAreTheSame) {
    Recipe r = wire(8);
    World world = r.make();
    std::vector<std::byte> out(3);
    for (int i = 0; i < 5; ++i) {
        ASSERT_EQ(world.step(), Status::ok);
        world.state().save(out);
        EXPECT_EQ(out, world.state().save());
    }
    std::vector<ContactView> contacts(5);
    world.contacts(contacts);
    EXPECT_TRUE(contacts.empty());
}

/// A point mass on a short line, thrown up repeatedly: the line goes slack and comes taut.
struct Jumping {
    World world;
    BodyId lump;
    Jumping() {
        const BodyId g = world.add_body({.kind = BodyKind::fixed});
        lump = world.add_body({.kind = BodyKind::lump, .position = {0, 0, -1}, .mass = 1});
        world.add(StretchDef{.a = g, .b = lump, .EA = 1e4});
        InputDef def{.name = "f", .body = lump, .component = 2, .min = -1, .max = 1};
        world.add_input(def);
    }
    /// Make an event of known number: each value exceeds the range.
    void ask(double value) { world.set_input({0}, value); }
};

TEST(Reading, EachReaderOfEventsHasItsOwnPlace) {
    Jumping j;
    std::uint64_t early = 0, late = 0;
    std::vector<Event> events;
    EXPECT_EQ(j.world.events().since(early, events), 0U);
    EXPECT_TRUE(events.empty());
    j.ask(5.0);
    j.ask(6.0);
    EXPECT_EQ(j.world.events().since(early, events), 0U);
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].value, 5.0);
    EXPECT_EQ(events[1].value, 6.0);
    j.ask(7.0);
    EXPECT_EQ(j.world.events().since(early, events), 0U);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].value, 7.0);
    EXPECT_EQ(j.world.events().since(late, events), 0U);
    EXPECT_EQ(events.size(), 3U);
    EXPECT_EQ(early, late);
    EXPECT_EQ(j.world.events().cursor(), late);
    // Taking events does not affect cursors, nor vice versa.
    EXPECT_EQ(j.world.events().take().size(), 3U);
    late = 1;
    EXPECT_EQ(j.world.events().since(late, events), 0U);
    EXPECT_EQ(events.size(), 2U);
    late = 1'000'000;  // of another world
    EXPECT_EQ(j.world.events().since(late, events), 0U);
    EXPECT_TRUE(events.empty());
    EXPECT_EQ(late, j.world.events().cursor());
}

TEST(Reading, EventsOfAllKindsComeInTheirOrder) {
    Jumping j;
    std::uint64_t cursor = 0;
    std::vector<Event> part, all;
    for (int i = 0; i < 600; ++i) {
        if (i % 100 == 50) j.world.set_velocity(j.lump, {{0, 0, 3}, {0, 0, 0}});
        if (i % 7 == 0) j.ask(2.0 + i);
        ASSERT_EQ(j.world.step(), Status::ok);
        if (i % 50 != 0) continue;
        EXPECT_EQ(j.world.events().since(cursor, part), 0U);
        all.insert(all.end(), part.begin(), part.end());
    }
    EXPECT_EQ(j.world.events().since(cursor, part), 0U);
    all.insert(all.end(), part.begin(), part.end());
    const std::vector<Event> taken = j.world.events().take();
    ASSERT_EQ(all.size(), taken.size());
    ASSERT_GT(j.world.events().extremes(EventKind::slack).count, 2);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].kind, taken[i].kind);
        EXPECT_EQ(all[i].value, taken[i].value);
        EXPECT_EQ(all[i].time, taken[i].time);
    }
}

TEST(Reading, AReaderThatComesTooLateIsToldHowMuchItMissed) {
    Jumping j;
    constexpr int kAsked = 5000, kKept = 4096;
    for (int i = 0; i < kAsked; ++i) j.ask(2.0 + i);
    std::uint64_t cursor = 0;
    std::vector<Event> events;
    EXPECT_EQ(j.world.events().since(cursor, events), static_cast<std::uint64_t>(kAsked - kKept));
    ASSERT_EQ(events.size(), static_cast<std::size_t>(kKept));
    EXPECT_EQ(events.front().value, 2.0 + kAsked - kKept);
    EXPECT_EQ(events.back().value, 1.0 + kAsked);
}

}  // namespace
}  // namespace hawser::test
