// SPDX-License-Identifier: Apache-2.0
/// Output of hawser check and hawser run for vessels.
#include <hawser/hawser.h>
#include <hawser/vessel_ships.h>

#include "record/scene_info.h"
#include "report/start/check.h"
#include "report/summary.h"

#include <gtest/gtest.h>

#include <string>

namespace hawser::test {
namespace {

TEST(ReportVessels, CheckNamesCoefficientsOfAnotherScale) {
    for (const bool spoilt : {false, true}) {
        World world;
        PublishedShip ship = kvlcc2(KvlccScale::full);
        ship.vessel.body = world.add_body(ship.body);
        if (spoilt) ship.vessel.mmg = kvlcc2(KvlccScale::l7).vessel.mmg;
        world.add(ship.vessel);
        const auto found = report::start::check_start(record::SceneInfo{}, world);
        int vessels = 0;
        for (const auto& f : found.list)
            if (f.kind == report::start::FindingKind::vessel) {
                ++vessels;
                EXPECT_FALSE(f.error);
                EXPECT_NE(f.text.find("vessel \"kvlcc2\": "), std::string::npos) << f.text;
            }
        EXPECT_EQ(vessels > 0, spoilt);
    }
}

TEST(ReportVessels, EventsOfActuatorsAreNoForces) {
    World world;
    PublishedShip ship = kvlcc2(KvlccScale::full);
    ship.vessel.body = world.add_body(ship.body);
    world.add(ship.vessel);
    world.set_system_signal("kvlcc2.rudder", 0.5);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(world.step(), Status::ok);
    const auto figures = report::event_figures(world);
    ASSERT_EQ(figures.size(), 1u);
    EXPECT_EQ(figures[0].kind, EventKind::saturation);
    EXPECT_TRUE(figures[0].vessels);
    EXPECT_STREQ(figures[0].unit, "");
}

}  // namespace
}  // namespace hawser::test
