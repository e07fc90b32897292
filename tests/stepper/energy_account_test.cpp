// SPDX-License-Identifier: Apache-2.0
/// The account of the energy monitor: its measure of exchanged energy.
#include "monitor/energy_account.h"

#include <gtest/gtest.h>

namespace hawser::monitor {
using context::MonitorPart;
using context::MonitorState;

namespace {

/// Make a sample of a body of 50 J and a spring, with the spring's energy by three accounts.
MonitorPart shown(double by_rows, double by_length, double by_force) {
    MonitorPart p;
    p.kinetic = 50.0;
    p.elastic = by_rows;
    p.by_length = by_length;
    p.by_force = by_force;
    p.at_pose = 50.0 + by_rows;
    return p;
}

/// Return the exchanged energy after ten steps in which the spring alternates between a given
/// energy and 0.
double exchanged(const MonitorPart& most) {
    constexpr double kStep = 0.01;  // [s]
    MonitorState state;
    begin_energy(shown(0.0, 0.0, 0.0), {}, state);
    for (int i = 1; i <= 10; ++i)
        (void)follow_energy(i % 2 == 1 ? most : shown(0.0, 0.0, 0.0), {}, kStep, state);
    return state.exchanged;
}

/// A spring that oscillates in all accounts: half the change of 8 J in each of ten steps.
TEST(MonitorEnergy, CountsWhatSpringsExchange) {
    EXPECT_NEAR(exchanged(shown(8.0, 8.0, 8.0)), 40.0, 1e-12);
}

/// An under-resolved stiff spring shows, in one account, energy that it never exchanges. If it
/// counted, an error of a hundred joules would be relatively small.
TEST(MonitorEnergy, TakesTheAccountByWhichSpringsExchangeLeast) {
    EXPECT_EQ(exchanged(shown(1e6, 0.0, 1e6)), 0.0);
    EXPECT_EQ(exchanged(shown(1e6, 1e6, 0.0)), 0.0);
    EXPECT_EQ(exchanged(shown(0.0, 1e6, 1e6)), 0.0);
    EXPECT_NEAR(exchanged(shown(1e6, 2.0, 1e3)), 10.0, 1e-12);
}

}  // namespace
}  // namespace hawser::monitor
