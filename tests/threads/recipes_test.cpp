// SPDX-License-Identifier: Apache-2.0
/// Small worlds and one large island: the number of threads has no effect.
#include "support/small_recipes.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

class EachRecipe : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Recipes, EachRecipe, testing::ValuesIn(kSmallRecipes), name_of);

TEST_P(EachRecipe, SameHashForAnyNumberOfThreads) {
    const Recipe recipe = GetParam().make();
    World one = recipe.make();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(one.step(), Status::ok);
    for (int threads : {2, 3, 4, 8}) {
        WorldDef def = recipe.world;
        def.threads = threads;
        World many = recipe.make(def);
        for (int i = 0; i < 20; ++i) ASSERT_EQ(many.step(), Status::ok);
        EXPECT_EQ(many.state().hash(), one.state().hash()) << threads << " threads";
    }
}

/// Large enough for several tasks and chunks per thread.
TEST(Threads, SameHashForALargeIsland) {
    Recipe recipe = mixed(11, 150);
    World one = recipe.make();
    for (int i = 0; i < 5; ++i) ASSERT_EQ(one.step(), Status::ok);
    for (int threads : {2, 3, 4, 8}) {
        WorldDef def = recipe.world;
        def.threads = threads;
        World many = recipe.make(def);
        for (int i = 0; i < 5; ++i) ASSERT_EQ(many.step(), Status::ok);
        EXPECT_EQ(many.state().hash(), one.state().hash()) << threads << " threads";
    }
}

}  // namespace
}  // namespace hawser::test
