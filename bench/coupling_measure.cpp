// SPDX-License-Identifier: Apache-2.0
#include "coupling_measure.h"

#include <hawser/experimental/splits.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser::bench::split {
namespace {

/// Cut a chain of links into stretches of equal length. The partitioner only cuts wires of point
/// masses.
void cut_chains(scene::Scene& scene, int parts) {
    for (const scene::Cable& cable : scene.cables)
        for (std::size_t i = 0; i < cable.nodes.size(); ++i)
            scene.world.splits().set_group(
                cable.nodes[i],
                "part " + std::to_string(i * static_cast<std::size_t>(parts) / cable.nodes.size()));
}

/// True if a velocity exceeds those of the scenes, or is NaN.
bool has_diverged(const World& world) {
    for (std::int32_t b = 0; b < world.body_count(); ++b)
        if (!(world.velocity(BodyId{b}).linear.norm() < 100.0)) return true;
    return false;
}

double accounted_energy(const Energy& e) {
    return e.mechanical() - e.applied - e.driven - e.edited + e.dissipated + e.friction +
           e.contact + e.damped;
}

}  // namespace

std::string Mode::name() const {
    using verify::to_string;
    return coupling == Coupling::exact
               ? "exact"
               : fmt::format("{} {}", to_string(coupling), to_string(predictor));
}

scene::Scene load_split(const std::string& file, const Mode& mode, int parts, int threads) {
    using verify::to_string;
    scene::Options options;
    options.threads = threads;
    // The same split makes the groups of all modes, which stay. Solutions are refined until the
    // momentum residual is that of the coupling.
    options.set = {"settings.coupling=kinematic",
                   fmt::format("settings.predictor={}", to_string(mode.predictor)),
                   "settings.parts=0", "settings.solution_tolerance=1e-12"};
    scene::Scene scene = scene::load_file(file, options);
    scene.world.splits().set_groups(parts);
    if (scene.world.splits().cuts().empty()) cut_chains(scene, parts);
    if (mode.coupling != Coupling::kinematic)
        for (const CutView& cut : scene.world.splits().cuts())
            scene.world.splits().set_coupling(cut.interaction, mode.coupling);
    return scene;
}

Quality measure_quality(World& world, int steps) {
    Quality q;
    verify::CouplingObserver observer(world);
    double start = 0.0, low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < steps; ++i) {
        observer.before_step(world);
        if (world.step() != Status::ok || has_diverged(world)) {
            q.time_of_loss = world.time();
            break;
        }
        observer.after_step(world);
        const Energy e = world.energy();
        if (i == 0) start = accounted_energy(e);
        low = std::min(low, e.kinetic);
        high = std::max(high, e.kinetic);
        q.energy_drift = accounted_energy(e) - start;
    }
    q.energy_exchanged = high - low;
    q.figures = observer.result(world, q.time_of_loss < 0.0);
    q.islands = world.stats().islands;
    q.cuts = world.stats().cuts;
    return q;
}

void Timed::run(int steps) {
    for (int i = 0; i < steps && !failed_or_diverged; ++i) {
        failed_or_diverged = world.step() != Status::ok || has_diverged(world);
        if (failed_or_diverged) break;
        wall.push_back(1e3 * world.stats().step_seconds);
        cpu.push_back(1e3 * world.stats().solver_cpu_seconds);
    }
}

}  // namespace hawser::bench::split
