// SPDX-License-Identifier: Apache-2.0
/// Warm steps in waves allocate nothing.
#include <hawser/hawser.h>

#include "stepper/allocation_counter.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

TEST(SeaAllocation, WarmStepsInWavesAllocateNothing) {
    for (const int threads : {1, 3}) {
        World w{WorldDef{.threads = threads}};
        const double mass = 205e3;
        const BodyId box =
            w.add_body({.name = "box",
                        .mass = mass,
                        .inertia = Vec3(10 * mass, 10 * mass, 17 * mass).asDiagonal()});
        const BodyId buoy = w.add_body(
            {.name = "buoy", .kind = BodyKind::lump, .position = {20, 0, 0}, .mass = 400.0});
        const WireId rope = w.wires().add({.name = "rope",
                                           .from = box,
                                           .from_point = {0, 0, -2},
                                           .elements = 30,
                                           .length = 40.0,
                                           .EA = 1e7,
                                           .mass_per_length = 10.0});
        SeaDef sea{.depth = 80.0};
        sea.waves.push_back({.kind = WaveKind::jonswap, .height = 2.0, .period = 7.0});
        sea.wind = {.speed = 12.0, .gusts = true};
        sea.hulls.push_back({.body = box, .mesh = box_hull({5, 5, 2}, 3, 3, 2)});
        sea.bodies.push_back({.body = buoy, .drag_area = Vec3::Constant(1.0), .volume = 0.8});
        sea.lines.push_back(
            {.wire = rope, .sections = {{30, {.diameter = 0.1}}}, .free_last = true});
        w.add(sea);
        for (int i = 0; i < 120; ++i) ASSERT_EQ(w.step(), Status::ok);
        if (!kCountsAllocations) return;
        const AllocationGuard guard;
        for (int i = 0; i < 120; ++i) ASSERT_EQ(w.step(), Status::ok);
        EXPECT_EQ(AllocationGuard::seen(), 0) << threads << " threads";
    }
}

}  // namespace
}  // namespace hawser::test
