// SPDX-License-Identifier: Apache-2.0
#include "support/cranes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace hawser {
namespace {

TEST(Lattice, Prints) {
    World w(WorldDef{.step = 1.0 / 60.0});
    const BodyId quay = w.add_body({.name = "quay", .kind = BodyKind::fixed});
    LatticeCraneDef def = test::lattice_crane(quay);
    const BodyId box = w.add_body({.name = "box", .kind = BodyKind::lump, .mass = 500e3});
    def.loads = {{.body = box, .eyes = {{0, 0, 0}}, .sling_length = 6, .sling_EA = 5e9}};
    def.take = 1;
    const CraneIds ids = w.add(def);
    w.set_pose(box, {.position = w.world_point(ids.hook, {0, 0, -1.5}) - Vec3(0, 0, 6.0)});
    for (int k = 0; k < 30; ++k) {
        for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
        std::printf("%5.1f r %.3f h %.3f load %.1f util %.3f alarm %g luff %.5f slew %.5f falls",
                    w.time(), w.system_signal("crane.radius"), w.system_signal("crane.height"),
                    w.system_signal("crane.load"), w.system_signal("crane.utilisation"),
                    w.system_signal("crane.alarm"), w.coordinate(w.find_interaction("crane/luff")),
                    w.coordinate(w.find_interaction("crane/slew")));
        for (const InteractionId f : ids.falls) std::printf(" %.1f", -w.force(f)[0] / 1e3);
        std::printf(" luffing %.1f\n", -w.force(w.find_interaction("crane/luffing/part3"))[0] / 1e3);
    }
}

}  // namespace
}  // namespace hawser
