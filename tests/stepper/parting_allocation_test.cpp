// SPDX-License-Identifier: Apache-2.0
/// A wire that breaks at its breaking load, and recoils, allocates nothing.
#include "stepper/allocation_counter.h"

#include <hawser/hawser.h>

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

TEST(Allocation, NoneWhereAWireParts) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    World w({.gravity = Vec3::Zero()});
    WireDef def{.name = "wire", .from = w.add_body({.kind = BodyKind::fixed})};
    def.to = w.add_body({.kind = BodyKind::fixed, .position = Vec3(200, 0, 0)});
    def.elements = 40;
    def.length = 199.2;
    def.EA = 2.33e8;
    def.mass_per_length = 23.0;
    const WireId wire = w.wires().add(def);
    // A weak element parallel to the last one, slack until the wire has been stepped for some time.
    InteractionDef weak = w.interaction_def(w.wires().elements(wire)[20]);
    weak.name = "weak";
    weak.set("breaking_load", 1e3);
    weak.set("length", 5.001);
    (void)w.add_interaction(weak);
    const BodyId lump = w.wires().nodes(wire)[20];
    for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_TRUE(w.intact(w.find_interaction("weak")));
    w.set_force(lump, Vec3(-2e6, 0, 0), Vec3::Zero());
    long seen = 0;
    {
        const AllocationGuard guard;
        for (int i = 0; i < 20; ++i) (void)w.step();
        w.wires().part(w.wires().elements(wire)[3]);
        for (int i = 0; i < 20; ++i) (void)w.step();
        seen = AllocationGuard::seen();
    }
    EXPECT_FALSE(w.intact(w.find_interaction("weak")));
    EXPECT_EQ(seen, 0);
    EXPECT_EQ(w.stats().status, Status::ok);
}

}  // namespace
}  // namespace hawser::test
