// SPDX-License-Identifier: Apache-2.0
/// Bounds on contacts and memory: reached before they are exceeded, and reported.
#include "support/recipe.h"
#include "support/yard.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

namespace hawser::test {
namespace {

/// Make balls at one point: n (n − 1)/2 contacts.
World balls(int count, const WorldDef& def) {
    Yard yard(def);
    for (int i = 0; i < count; ++i) yard.ball({0.01 * i, 0.003 * (i % 7), 0.0}, 1.0, 1.0);
    return std::move(yard.world);
}

TEST(Bounds, OnContactsEndsTheStepAndSaysSo) {
    WorldDef def;
    def.max_contacts = 100;
    World few = balls(14, def), many = balls(16, def);  // 91 and 120 contacts
    EXPECT_EQ(few.step(), Status::ok);
    many.prepare();
    const std::uint64_t before = many.state().hash();
    EXPECT_EQ(many.step(), Status::over_bound);
    EXPECT_EQ(many.state().hash(), before);
    const BoundMet met = many.stats().bound_met;
    EXPECT_EQ(met.bound, Bound::contacts);
    EXPECT_EQ(met.value, 120.0);
    EXPECT_EQ(met.limit, 100.0);
    EXPECT_NE(to_string(met).find("max_contacts = 100"), std::string::npos) << to_string(met);
    // Moved apart, they have fewer contacts.
    for (int b = 0; b < 8; ++b) many.set_pose(BodyId{b}, {{10.0 * b, 0, 50}, Quat::Identity()});
    EXPECT_EQ(many.step(), Status::ok);
    EXPECT_EQ(many.stats().bound_met.bound, Bound::none);
}

TEST(Bounds, OnPairsEndsTheStepWhileTheyAreCounted) {
    WorldDef def;
    def.max_contacts = 100;
    World w = balls(300, def);  // 44,850 pairs
    EXPECT_EQ(w.step(), Status::over_bound);
    EXPECT_EQ(w.stats().bound_met.bound, Bound::pairs);
    EXPECT_GT(w.stats().bound_met.value, 800.0);
    EXPECT_EQ(w.stats().bound_met.limit, 800.0);
}

TEST(Bounds, OnMemoryIsCheckedBeforeItIsAskedFor) {
    // Far fewer bytes than the factorisation of this chain needs: about 5 kB per link.
    Recipe recipe = link_chain(2000);
    recipe.world.max_memory = 2e6;
    World w = recipe.make();
    const std::uint64_t before = w.state().hash();
    try {
        w.prepare();
        FAIL() << "2000 links in 2 MB";
    } catch (const LimitError& e) {
        EXPECT_EQ(e.met().bound, Bound::memory);
        EXPECT_GT(e.met().value, 2e6);
        EXPECT_NE(std::string(e.what()).find("max_memory = 2000000"), std::string::npos)
            << e.what();
    }
    EXPECT_EQ(w.step(), Status::over_bound);
    EXPECT_EQ(w.stats().bound_met.bound, Bound::memory);
    EXPECT_EQ(w.state().hash(), before);
    // The reported number is near the need; tables of addresses are added to it.
    const double wanted = w.stats().bound_met.value;
    recipe.world.max_memory = 1.01 * wanted;
    World enough = recipe.make();
    EXPECT_EQ(enough.step(), Status::ok);
    const auto held = static_cast<double>(enough.solver().memory_bytes());
    std::printf("foreseen %.3g bytes, held %.3g\n", wanted, held);
    EXPECT_LT(held, 1.25 * wanted);
    EXPECT_GT(held, 0.8 * wanted) << "or the estimate refuses what would fit";
}

}  // namespace
}  // namespace hawser::test
