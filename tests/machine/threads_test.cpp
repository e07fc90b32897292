// SPDX-License-Identifier: Apache-2.0
/// Worker threads that cannot be started.
#include "machine/failing.h"
#include "support/recipe.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

TEST(WorkerThreads, ThatCannotStartAreNamedAndNoneIsLeft) {
    for (const int most : {0, 1, 5}) {
        WorldDef def;
        def.threads = 8;
        try {
            const failing::Threads few(most);
            const World w(def);
            FAIL() << "a world with 7 workers where " << most << " can start";
        } catch (const ThreadError& e) {
            EXPECT_EQ(e.wanted(), 7);
            EXPECT_EQ(e.started(), most);
            const std::string text = e.what();
            EXPECT_NE(text.find(std::to_string(most) + " of 7"), std::string::npos) << text;
            EXPECT_NE(text.find("at most " + std::to_string(most + 1) + " threads"),
                      std::string::npos)
                << text;
        }
    }
    // If enough threads can be started, the world works afterwards.
    const failing::Threads enough(7);
    WorldDef def;
    def.threads = 8;
    World w = link_chain(4).make(def);
    EXPECT_EQ(w.step(), Status::ok);
}

}  // namespace
}  // namespace hawser::test
