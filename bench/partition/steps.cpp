// SPDX-License-Identifier: Apache-2.0
#include <hawser/experimental/splits.h>
#include <hawser/scene.h>

#include "partition/steps.h"

#include "coupling_simulated.h"
#include "index.h"
#include "linear/problem.h"
#include "linear/timing.h"
#include "partition/cases.h"
#include "partition/factors.h"
#include "partition/foreign.h"
#include "partition/scenes.h"
#include "verify/coupling.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace hawser::bench {
namespace {

using Json = nlohmann::json;

/// Make groups by METIS from the body graph: interactions and contacts, weighted by freedoms.
void group_by_metis(World& world, int parts) {
    const BodyGraph graph = body_graph(world);
    ForeignGraph g(graph.pattern);
    const std::vector<std::int32_t> part = metis_parts(g, g.weight, parts);
    for (std::int32_t b = 0; b < world.body_count(); ++b)
        if (graph.node[at(b)] >= 0)
            world.splits().set_group(BodyId{b},
                                     "part " + std::to_string(part[at(graph.node[at(b)])]));
}

struct SteppedWorld {
    const char* name;
    World world, traced;                ///< With two threads; with one.
    std::vector<double> wall{}, cpu{};  ///< [ms]
    bool lost = false;
    void run(int steps) {
        for (int i = 0; i < steps && !lost; ++i) {
            lost = world.step() != Status::ok || traced.step() != Status::ok;
            wall.push_back(1e3 * world.stats().step_seconds);
            cpu.push_back(1e3 * world.stats().solver_cpu_seconds);
        }
    }
};

constexpr int kExactFirst = 60;  ///< number of exact steps before worlds are split

World settled_world(const std::string& scene, const char* predictor, int threads) {
    scene::Options options;
    options.threads = threads;
    options.set = {std::string("settings.predictor=") + predictor};
    World world = scene::load_file("scenes/" + scene + ".json", options).world;
    for (int i = 0; i < kExactFirst; ++i)
        if (world.step() != Status::ok) throw std::runtime_error(scene + " does not step");
    return world;
}

Json compare_worlds(const std::string& scene, Coupling coupling, const char* predictor, int parts,
                    int rounds, const PoolCosts& costs) {
    const World two = settled_world(scene, predictor, 2), one = settled_world(scene, predictor, 1);
    SteppedWorld worlds[] = {{"exact", two.twin(Coupling::exact), one.twin(Coupling::exact)},
                             {"ours", two.twin(coupling), one.twin(coupling)},
                             {"METIS", two.twin(coupling), one.twin(coupling)}};
    for (World* w : {&worlds[1].world, &worlds[1].traced}) w->splits().set_groups(parts);
    for (World* w : {&worlds[2].world, &worlds[2].traced}) group_by_metis(*w, parts);
    for (SteppedWorld& w : worlds) w.traced.solver().start_trace(std::size_t{1} << 17);
    for (int k = 0; k < rounds; ++k)
        for (SteppedWorld& w : worlds) w.run(20);
    Json out = {
        {"scene", scene}, {"coupling", verify::to_string(coupling)}, {"predictor", predictor}};
    fmt::print("{}: whole steps, {} {}, {} parts [ms]\n", scene, verify::to_string(coupling),
               predictor, parts);
    std::array<split::SimulatedStep, std::size(worlds)> simulated;
    for (std::size_t i = 0; i < std::size(worlds); ++i) {
        SteppedWorld& w = worlds[i];
        simulated[i] = split::simulate_steps(w.traced, costs);
        int open = 0;
        for (const CutView& cut : w.world.splits().cuts()) open += cut.open ? 1 : 0;
        fmt::print(
            "  {:<6} 2 threads {:>7.3f}, cpu {:>7.3f}; SIMULATED 1 {:>7.3f}, 4 {:>7.3f}, 8 "
            "{:>7.3f}; "
            "{:>3} cuts, {:>3} in force, {:>2} islands{}\n",
            w.name, median(w.wall), median(w.cpu), simulated[i].ms[0], simulated[i].ms[2],
            simulated[i].ms[3], w.world.splits().cuts().size(), open, w.world.stats().islands,
            w.lost ? ", lost" : "");
        out[w.name] = {{"step_ms", median(w.wall)},
                       {"cpu_ms", median(w.cpu)},
                       {"simulated_ms", simulated[i].ms},
                       {"open", open},
                       {"lost", w.lost}};
    }
    const double step = median(worlds[1].wall) / median(worlds[2].wall),
                 cpu = median(worlds[1].cpu) / median(worlds[2].cpu),
                 four = simulated[1].ms[2] / simulated[2].ms[2];
    fmt::print(
        "  ours takes {:.2f} of METIS's step on two threads ({:.2f} of its cpu), {:.2f} "
        "simulated on four\n",
        step, cpu, four);
    out["ours_over_metis"] = {{"step", step}, {"cpu", cpu}, {"simulated_on_four", four}};
    return out;
}

}  // namespace

Json compare_steps(int parts, int rounds) {
    Json factors = Json::array(), steps = Json::array();
    std::vector<PartCase> cases{paper_case(false, 1), paper_case(true, 1)};
    for (const char* scene : {"anchor_lines", "anchor_contact"}) {
        cases.push_back(make_case(scene_system(std::string("scenes/") + scene + ".json", 1)));
        cases.back().name = scene;
    }
    for (const PartCase& c : cases) {
        Json row = factor_json(compare_factors(c, parts, 10 * rounds));
        if (row.empty()) continue;
        row["name"] = c.name;
        factors.push_back(std::move(row));
    }
    const PoolCosts costs = measure_pool_costs();
    for (const char* scene : {"anchor_lines", "anchor_contact"}) {
        steps.push_back(compare_worlds(scene, Coupling::kinematic, "clique", parts, rounds, costs));
        steps.push_back(compare_worlds(scene, Coupling::compliant, "hold", parts, rounds, costs));
    }
    return {{"factors", factors}, {"steps", steps}};
}

}  // namespace hawser::bench
