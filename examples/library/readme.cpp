// SPDX-License-Identifier: Apache-2.0
//
// The program of README.md: a point mass swings on a rod.
// clang-format off
#include <hawser/hawser.h>

#include <cstdio>

int main() {
    hawser::World world({.step = 1.0 / 60.0});
    const auto ground = world.add_body({.name = "ground", .kind = hawser::BodyKind::fixed});
    const auto bob = world.add_body({.name = "bob", .kind = hawser::BodyKind::lump,
                                     .position = {1.0, 0.0, 0.0}, .mass = 2.0});
    world.add(hawser::DistanceDef{.name = "rod", .a = ground, .b = bob});
    while (world.time() < 10.0)
        if (world.step() != hawser::Status::ok) return 1;
    std::printf("z = %.3f m\n", world.pose(bob).position.z());
    return 0;
}
