// SPDX-License-Identifier: Apache-2.0
#include "live/event_reports.h"

#include <gtest/gtest.h>

#include <string>

namespace hawser::test {

// An event of energy for clients has direction, figure and remedy.
TEST(LiveEventWords, SayWhetherEnergyWasLostOrGained) {
    const std::string lost = live::event_words("-", EventKind::energy_created, -2500.0);
    EXPECT_NE(lost.find("the whole world lost 2.5 kJ"), std::string::npos) << lost;
    EXPECT_NE(lost.find("use a smaller step"), std::string::npos) << lost;
    const std::string gained = live::event_words("-", EventKind::energy_created, 2500.0);
    EXPECT_NE(gained.find("gained 2.5 kJ"), std::string::npos) << gained;
}

}  // namespace hawser::test
