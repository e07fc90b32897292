// SPDX-License-Identifier: Apache-2.0
/// Snapshots with changed contents and a valid checksum. Each is rejected and leaves the world
/// unchanged, or is accepted and the world continues without harm.
#include "base/hash.h"
#include "files/mutate.h"
#include "support/sleep_yard.h"
#include "support/small_recipes.h"
#include "support/yard.h"
#include "world/three_cables.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstring>

namespace hawser::test {
namespace {

constexpr std::size_t kHead = 12 * 8;  ///< Size of the header: magic, two hashes, nine counts
                                       ///< [bytes].
constexpr std::size_t kCounts = 24;    ///< Offset of the counts; the last one counts bytes.

void sign(std::vector<std::byte>& bytes) {
    const std::span<std::byte> all(bytes);
    write_at(all, bytes.size() - 8, base::checksum(bytes.data(), bytes.size() - 8));
}

/// Change a count of the header by one, and insert or remove bytes anywhere.
void resize(std::vector<std::byte>& bytes, Random& random) {
    const std::size_t count = kCounts + 8 * static_cast<std::size_t>(random.integer(0, 8));
    const auto n = read_at<std::uint64_t>(bytes, count);
    write_at(std::span(bytes), count, n + static_cast<std::uint64_t>(random.integer(-1, 1)));
    const auto size = static_cast<std::ptrdiff_t>(
        pick<int>(random, {0, 4, 5, 6, 8, 16, 88, 128, 152, 168, random.integer(0, 200)}));
    const auto at = static_cast<std::ptrdiff_t>(
        random.integer(static_cast<int>(kHead), static_cast<int>(bytes.size()) - 8));
    if (random.chance(0.5))
        bytes.insert(bytes.begin() + at, static_cast<std::size_t>(size), std::byte{0});
    else
        bytes.erase(bytes.begin() + at,
                    bytes.begin() + std::min<std::ptrdiff_t>(at + size, std::ssize(bytes) - 8));
    if (random.chance(0.8))
        write_at<std::uint64_t>(std::span(bytes), kHead - 8, bytes.size() - kHead - 8);
}

std::vector<std::byte> forged(const std::vector<std::byte>& good, Random& random) {
    std::vector<std::byte> bad = good;
    for (int i = random.integer(1, 3); i > 0; --i) {
        // In the state; sometimes in the counts before it.
        const std::size_t from = random.chance(0.05) ? kCounts : kHead;
        mutate(std::span(bad).subspan(from, bad.size() - from - 8), random);
    }
    if (random.chance(0.05)) resize(bad, random);
    sign(bad);
    return bad;
}

/// Results of a run of forged snapshots.
struct Tally {
    int taken = 0, refused = 0, failed = 0;  ///< `failed`: a step of a world that accepted one
                                             ///< failed.
};

/// Change snapshots of a world and restore them.
void attack(World& world, const std::vector<std::vector<std::byte>>& good, int inputs,
            std::uint64_t seed, Tally& tally) {
    Random random(seed);
    world.state().restore(good.front());
    auto hash = world.state().hash();
    for (int i = 0; i < inputs; ++i) {
        const auto& from = good[static_cast<std::size_t>(i) % good.size()];
        const std::vector<std::byte> bad = forged(from, random);
        try {
            world.state().restore(bad);
        } catch (const DefError& e) {
            ++tally.refused;
            ASSERT_NE(std::string(e.what()).find("snapshot"), std::string::npos) << e.what();
            ASSERT_EQ(world.state().hash(), hash)
                << "input " << i << " was refused and left a trace";
            continue;
        }
        ++tally.taken;
        // A snapshot of a world that accepted a forged one is accepted again.
        const std::vector<std::byte> own = world.state().save();
        ASSERT_NO_THROW(world.state().restore(own)) << "input " << i;
        for (int k = 0; k < 2; ++k) tally.failed += world.step() == Status::ok ? 0 : 1;
        (void)world.energy();
        (void)world.contacts();
        world.state().restore(from);
        hash = world.state().hash();
    }
}

std::vector<std::vector<std::byte>> snapshots_of(World& world, std::initializer_list<int> steps) {
    std::vector<std::vector<std::byte>> out;
    for (const int count : steps) {
        for (int i = 0; i < count; ++i) EXPECT_EQ(world.step(), Status::ok);
        out.push_back(world.state().save());
    }
    return out;
}

void tell(const char* what, const Tally& tally) {
    std::printf("%s: %d forged snapshots, %d refused, %d taken, of their steps %d failed\n", what,
                tally.taken + tally.refused, tally.refused, tally.taken, tally.failed);
    // Both happen, otherwise one of them is not tested.
    EXPECT_GT(tally.taken, 0) << what;
    EXPECT_GT(tally.refused, 0) << what;
}

/// Return a number of sixteenths of the inputs: each input of a world with groups takes ten times
/// as long.
int share(int sixteenths) { return inputs_of(1000, 10'000, 500'000) * sixteenths / 16; }

TEST(ForgedSnapshots, OfContactsSleepAndFriction) {
    WorldDef def;
    def.sleep_after = 0.5;
    SleepYard yard(def);
    yard.w.prepare();
    Tally tally;
    const auto good = snapshots_of(yard.w, {3, 20, 300});
    attack(yard.w, good, share(6), first_seed(1), tally);
    tell("contacts, sleep, friction", tally);
}

/// Replace each word of a snapshot in turn by an index far beyond the end of any array.
TEST(ForgedSnapshots, EveryWordAsAFarIndex) {
    Yard yard;
    yard.friction(0.5);
    yard.plane(yard.fixed());
    for (int i = 0; i < 3; ++i)
        yard.box({0.1 * i, 0.05 * i, 0.5 + 0.99 * i}, 100.0, {0.5, 0.5, 0.5});
    const std::vector<std::byte> good = snapshots_of(yard.world, {5}).front();
    const auto hash = yard.world.state().hash();
    Tally tally;
    for (std::size_t at = kHead; at + 8 < good.size(); at += 4) {
        std::vector<std::byte> bad = good;
        write_at<std::int32_t>(std::span(bad), at, 1'000'000'000);
        sign(bad);
        try {
            yard.world.state().restore(bad);
            ++tally.taken;
            (void)yard.world.step();
            yard.world.state().restore(good);
        } catch (const DefError&) {
            ++tally.refused;
        }
        ASSERT_EQ(yard.world.state().hash(), hash) << "byte " << at;
    }
    tell("a far index", tally);
}

TEST(ForgedSnapshots, OfAHeapThatIsLinked) {
    Yard yard;
    yard.friction(0.5);
    yard.plane(yard.fixed());
    for (int i = 0; i < 6; ++i)
        yard.box({0.1 * i, 0.05 * i, 0.5 + 0.99 * i}, 100.0, {0.5, 0.5, 0.5});
    Tally tally;
    const auto good = snapshots_of(yard.world, {2, 30});
    attack(yard.world, good, share(5), first_seed(2), tally);
    tell("a heap", tally);
}

TEST(ForgedSnapshots, OfWiresLinksAndEveryJoint) {
    Tally tally;
    std::uint64_t seed = 3;
    const int recipes = static_cast<int>(std::size(kSmallRecipes));
    for (const Case& recipe : kSmallRecipes) {
        World world = recipe.make().make();
        const auto good = snapshots_of(world, {1, 10});
        attack(world, good, share(4) / recipes, first_seed(++seed), tally);
    }
    tell("wires, links, joints", tally);
}

/// Point masses do not rotate, and their ghost bodies at cuts have the same orientation. A state
/// with another orientation was once accepted, and the world's next snapshot was rejected.
TEST(ForgedSnapshots, RotationsOfLumps) {
    const regrouping::Cables cables(2);
    World world = cables.recipe.make();
    cables.turn(world, 1);
    const std::vector<std::byte> good = snapshots_of(world, {5}).front();
    const std::array<double, 9> numbers = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::array<std::byte, sizeof numbers> upright;
    std::memcpy(upright.data(), numbers.data(), upright.size());
    int refused = 0, taken = 0;
    for (std::size_t at = kHead; at + upright.size() + 8 <= good.size(); ++at) {
        if (std::memcmp(good.data() + at, upright.data(), upright.size()) != 0) continue;
        std::vector<std::byte> bad = good;
        const double other = 0.5;
        std::memcpy(bad.data() + at + 8, &other, 8);
        sign(bad);
        try {
            world.state().restore(bad);
        } catch (const DefError&) {
            ++refused;
            continue;
        }
        ++taken;  // word of an analysis that only starts the next one
        ASSERT_NO_THROW(world.state().restore(world.state().save())) << "byte " << at;
    }
    // Consecutive orientations 1 0 0 0 resemble rotations and are rejected as invalid.
    EXPECT_GE(refused, 2 * world.body_count() - 2);
    std::printf("%d rotations refused, %d taken\n", refused, taken);
}

TEST(ForgedSnapshots, OfGroupsThatFollow) {
    const regrouping::Cables cables(2);
    World world = cables.recipe.make();
    cables.turn(world, 1);
    Tally tally;
    const auto good = snapshots_of(world, {5, 60});
    attack(world, good, share(1), first_seed(40), tally);
    tell("groups", tally);
}

}  // namespace
}  // namespace hawser::test
