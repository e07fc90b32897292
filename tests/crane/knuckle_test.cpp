// SPDX-License-Identifier: Apache-2.0
/// Knuckle-boom cranes against closed forms.
#include "support/cranes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace hawser {
namespace {

using test::kG;

struct KnuckleYard {
    World w;
    BodyId quay, box;
    CraneIds ids;

    explicit KnuckleYard(double mass = 20e3, double efficiency = 1.0, int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        quay = w.add_body({.name = "quay", .kind = BodyKind::fixed});
        KnuckleCraneDef def = test::knuckle_crane(quay);
        def.hoist.efficiency = efficiency;
        // Below the hook, its eye as far from it as the sling is long.
        box = w.add_body({.name = "box", .kind = BodyKind::lump, .mass = mass});
        def.loads = {{.body = box, .eyes = {{0, 0, 0}}, .sling_length = 1, .sling_EA = 5e8}};
        def.take = 1;
        ids = w.add(def);
        const Vec3 hook = w.world_point(ids.hook, {0, 0, -0.6});
        w.set_pose(box, {.position = hook - Vec3(0, 0, 1.0)});
    }
    void run(double seconds) {
        for (long i = std::lround(seconds * 60.0); i > 0; --i) ASSERT_EQ(w.step(), Status::ok);
    }
};

TEST(Crane, Prints) {
    KnuckleYard y;
    for (int k = 0; k < 20; ++k) {
        y.run(1.0);
        std::printf("%5.1f r %.3f h %.3f load %.1f util %.3f alarm %g held %g luff %.5f F %.4g knuckle %.5f F %.4g\n",
                    y.w.time(), y.w.system_signal("crane.radius"), y.w.system_signal("crane.height"), y.w.system_signal("crane.load"),
                    y.w.system_signal("crane.utilisation"), y.w.system_signal("crane.alarm"), y.w.system_signal("crane.held"),
                    y.w.coordinate(y.w.find_interaction("crane/luff")), y.w.motor_force(y.w.find_interaction("crane/luff/motor")),
                    y.w.coordinate(y.w.find_interaction("crane/knuckle")), y.w.motor_force(y.w.find_interaction("crane/knuckle/motor")));
    }
}

}  // namespace
}  // namespace hawser
