// SPDX-License-Identifier: Apache-2.0
//
// The first half of docs/library.md: a world, a body, a rod, steps.
#include <hawser/hawser.h>

#include <cstdio>

double swing() {
    hawser::World world({.step = 1.0 / 60.0});
    const auto ground = world.add_body({.name = "ground", .kind = hawser::BodyKind::fixed});
    const auto bob = world.add_body(
        {.name = "bob", .kind = hawser::BodyKind::lump, .position = {1.0, 0.0, 0.0}, .mass = 2.0});
    const auto rod = world.add(hawser::DistanceDef{.name = "rod", .a = ground, .b = bob});

    while (world.time() < 10.0) {
        const hawser::Status status = world.step();
        if (status != hawser::Status::ok) {
            std::printf("%s at %.3f s\n", hawser::to_string(status), world.time());
            break;
        }
    }

    const hawser::Vec3 position = world.pose(bob).position;
    const double pull = -world.force(rod)[0];
    std::printf("the bob is at %.3f m, %.3f m; the rod pulls with %.2f N\n", position.x(),
                position.z(), pull);

    try {
        world.add_body({.name = "bob", .kind = hawser::BodyKind::lump, .mass = 1.0});
    } catch (const hawser::DefError& error) {
        std::printf("%s\n", error.what());
    }
    return position.norm();
}

int main() { return swing() > 0.0 ? 0 : 1; }
