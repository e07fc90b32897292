// SPDX-License-Identifier: Apache-2.0
//
// The second half of docs/library.md: a crane with a driven boom and a winch. A controller keeps
// the height of the load while the boom rises.
#include <hawser/hawser.h>

#include <algorithm>
#include <cstdio>
#include <vector>

/// A controller of the application, independent of Hawser.
struct Pid {
    double p, i, d;
    double sum = 0.0, before = 0.0;
    double operator()(double error, double h) {
        const double rate = (error - before) / h;
        sum += error * h;
        before = error;
        return p * error + i * sum + d * rate;
    }
};

struct CraneEnd {
    double angle, height, tension, worst;
    bool same_after_restore;
};

CraneEnd lift() {
    hawser::World world({.step = 1.0 / 60.0});
    const auto deck = world.add_body({.name = "deck", .kind = hawser::BodyKind::fixed});
    const double length = 30.0, mass = 12'000.0;
    const double across = mass * length * length / 12.0;
    const auto boom = world.add_body({.name = "boom",
                                      .position = {0.5 * length, 0.0, 10.0},
                                      .mass = mass,
                                      .inertia = hawser::Vec3(4e3, across, across).asDiagonal()});

    const hawser::JointIds luff = world.add(hawser::HingeDef{
        .name = "luff",
        .a = deck,
        .b = boom,
        .point = {0.0, 0.0, 10.0},
        .axis = {0.0, -1.0, 0.0},  // by the right-hand rule, so that up is positive
        .limit = hawser::AxisLimit{.min = -0.2, .max = 1.3},
        .motor = hawser::AxisMotor{.speed = 0.0, .force_min = -8e6, .force_max = 8e6},
        .friction = hawser::AxisFriction{.bound = 2e4, .own_load = 0.002}});

    const auto drum = world.add_body(
        {.name = "drum", .kind = hawser::BodyKind::scalar, .mass = 800.0, .gravity = false});
    const auto load = world.add_body({.name = "load",
                                      .kind = hawser::BodyKind::lump,
                                      .position = {length, 0.0, 0.0},
                                      .mass = 5'000.0});
    const auto winch = world.add(hawser::DrumDef{
        .name = "winch",
        .drum = drum,
        .motor = hawser::AxisMotor{.speed = 0.0, .force_min = -1e5, .force_max = 1e5}});
    const auto fall = world.add(hawser::WinchStretchDef{.name = "fall",
                                                        .a = boom,
                                                        .b = load,
                                                        .point_a = {0.5 * length, 0.0, 0.0},
                                                        .drum = drum,
                                                        .radius = 0.4,
                                                        .EA = 5e7,
                                                        .breaking_load = 5e5});

    const auto luff_speed = world.add_input({.name = "luff speed",
                                             .interaction = luff.motor,
                                             .param = "speed",
                                             .min = -0.05,
                                             .max = 0.05,
                                             .unit = "rad/s",
                                             .group = "crane",
                                             .spring = 0.0});
    const auto pay_out = world.add_input({.name = "pay out",
                                          .interaction = winch.motor,
                                          .param = "speed",
                                          .min = -6.0,
                                          .max = 6.0,
                                          .unit = "rad/s",
                                          .group = "crane",
                                          .spring = 0.0});

    const auto angle = world.add_output({.name = "luff angle",
                                         .kind = hawser::OutputKind::coordinate,
                                         .interaction = luff.joint,
                                         .group = "crane"});
    const auto height = world.add_output({.name = "load height",
                                          .kind = hawser::OutputKind::pose,
                                          .body = load,
                                          .component = "z",
                                          .group = "crane"});
    const auto tension = world.add_output({.name = "fall tension",
                                           .kind = hawser::OutputKind::tension,
                                           .line = {fall},
                                           .component = "largest",
                                           .group = "crane",
                                           .nominal = 5e4});

    Pid pid{.p = 2.5, .i = 1.0, .d = 0.0};
    const double wanted = world.output(height), h = world.settings().step;
    double worst = 0.0;
    const auto control = [&] {
        world.set_input(luff_speed, world.output(angle) < 0.6 ? 0.05 : 0.0);
        world.set_input(pay_out, pid(world.output(height) - wanted, h) / 0.4);
    };
    while (world.time() < 30.0) {
        control();
        if (world.step() != hawser::Status::ok) break;
        worst = std::max(worst, std::abs(world.output(height) - wanted));
    }

    for (const hawser::OutputId id : world.output_ids()) {
        const hawser::OutputDef& output = world.output_def(id);
        std::printf("%-14s %10.3f %s\n", output.name.c_str(), world.output(id),
                    output.unit.c_str());
    }
    std::printf("motor of the boom: %.0f N m\n", world.motor_force(luff.motor));

    std::vector<hawser::Event> events;
    std::uint64_t cursor = 0;
    if (world.events().since(cursor, events) > 0)
        std::printf("some events came too fast to be kept\n");
    for (const hawser::Event& event : events)
        std::printf("%.2f s: %s\n", event.time, hawser::to_string(event.kind));

    const CraneEnd end{world.output(angle), world.output(height), world.output(tension), worst,
                       false};
    std::vector<std::byte> saved;
    world.state().save(saved);
    const auto two_seconds = [&] {
        for (int i = 0; i < 120; ++i)
            if (world.step() != hawser::Status::ok) break;
        return world.state().hash();
    };
    const std::uint64_t first = two_seconds();
    world.state().restore(saved);
    const bool same = two_seconds() == first;

    const std::uint64_t identity = world.state().identity();
    const hawser::Structure made_of = world.state().structure();
    world.state().save(saved);
    (void)two_seconds();
    if (world.state().identity() == identity)
        world.state().restore(saved);
    else
        world.state().restore(made_of, saved);
    return {end.angle, end.height, end.tension, end.worst, same};
}

int main() { return lift().same_after_restore ? 0 : 1; }
