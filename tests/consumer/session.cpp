// SPDX-License-Identifier: Apache-2.0
//
// Test program of an installed Hawser: a scene is run, controlled, edited and recorded through the
// public headers. A controller keeps the tension of a tow wire, a crane drops its load, a line is
// added, another one breaks. Usage: session SCENE RECORDING
#include <hawser/scene.h>
#include <hawser/session.h>
#include <hawser/systems/pid.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

namespace {

/// Record the largest error of a tension from a given time on.
struct Error : hawser::Observer {
    hawser::OutputId tension;
    double target = 0.0, from = 0.0, largest = 0.0;  ///< [N], [s], [N]
    void after_step(const hawser::World& world, std::span<const hawser::Event>) override {
        if (world.time() > from)
            largest = std::fmax(largest, std::abs(world.output(tension) - target));
    }
};

/// Let the winch of a tow wire pull a tenth more than at the start.
double hold_tension(hawser::World& world, Error& error) {
    const auto elements = world.wires().elements(world.wires().find("tow1"));
    error.tension = world.add_output({.name = "tow1",
                                      .kind = hawser::OutputKind::tension,
                                      .line = {elements.begin(), elements.end()},
                                      .component = "first"});
    error.target = 1.1 * world.output(error.tension);
    world.add_system(std::make_unique<hawser::Pid>(
        hawser::PidDef{.name = "tow",
                       .measured = elements.front(),
                       .driven = world.find_input("ahts1/tow_speed"),
                       .target = error.target,
                       .gain = -8e-6,  // pays out if the tension is too large
                       .reset = 2.0,
                       .low = -0.8,
                       .high = 0.8}));
    return error.target;
}

void add_line(hawser::World& world) {
    hawser::WireDef line{
        .name = "spring", .from = world.find_body("ahts1/hull"), .to = world.find_body("rig")};
    line.from_point = {30, 0, 3};
    line.to_point = {0, 0, 10};
    line.elements = 12;
    line.length = 1.001 * (world.world_point(line.from, line.from_point) -
                           world.world_point(line.to, line.to_point))
                              .norm();
    line.EA = 2e7;
    line.mass_per_length = 12.0;
    line.drag = 20.0;
    world.wires().add(line);
}

int run(const char* file, const char* recording) {
    hawser::Session session({.scene = file});
    hawser::World& world = session.world();
    if (session.step() != hawser::Status::ok) return 2;  // tensions are known after the first step
    session.record(recording);
    Error error;
    error.from = 8.0;
    const double target = hold_tension(world, error);
    session.observe(error);
    session.set_input("ahts2/thrust_y", 5e4);
    int events = 0;
    while (session.time() < 10.0 - 1e-9) {
        const auto now = world.step_count();
        if (now == 120)
            (void)world.remove_interaction(
                world.wires().elements(world.wires().find("rig_crane_port/wire")).back());
        if (now == 180) add_line(world);
        if (now == 240) world.wires().part(world.wires().find("tow2"), 200.0);
        if (session.step() != hawser::Status::ok) {
            std::printf("ended at %.4g s: %s %s\n", session.time(),
                        hawser::to_string(world.stats().status), session.objection().c_str());
            return 2;
        }
        for (const hawser::Event& event : session.events())
            events += event.kind == hawser::EventKind::line_break ? 1 : 0;
    }
    const hawser::record::Ending ending = session.finish();

    const auto run = hawser::record::Recording::open(recording);
    const double fallen = -world.velocity(world.find_body("rig_crane_port/hook")).linear.z();
    std::printf(
        "%s: %zu bodies, %zu frames, %zu settings of inputs, %zu changes; tension within "
        "%.2g %% of %.4g kN after %g s; hook falls at %.3g m/s; new line %.4g kN\n",
        session.scene().name.c_str(), world.bodies().size(), run.frame_count(), run.inputs.size(),
        run.changes.size(), 100.0 * error.largest / target, 1e-3 * target, error.from, fallen,
        1e-3 * world.wires().tension(world.wires().find("spring"), 1.0));
    const bool held = error.largest < 0.02 * target;
    const bool fell = std::abs(fallen - 9.81 * 8.0) < 0.1 * 9.81 * 8.0;  // margin for the drag of
                                                                         // the hook
    const bool same = run.end_hash == world.state().motion_hash();
    return ending == hawser::record::Ending::finished && same && held && fell && events == 1 &&
                   run.changes.size() == 3
               ? 0
               : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 1;
    try {
        return run(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
}
