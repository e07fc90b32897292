// SPDX-License-Identifier: Apache-2.0
#include "partition/steps.h"

#include "coupling_simulated.h"
#include "factor/ordering.h"
#include "graph/partition.h"
#include "index.h"
#include "linear/problem.h"
#include "linear/timing.h"
#include "observe/coupling.h"
#include "partition/cases.h"
#include "partition/foreign.h"
#include "partition/measure.h"
#include "scene/scene.h"

#include <hawser/factor.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace hawser::bench {
namespace {

using Json = nlohmann::json;

/// A factorisation and a solution of a diagonal matrix: times depend on the pattern alone.
struct OrderedFactor {
    std::string name;
    BlockFactor factor;
    std::vector<double> values, x, seconds;

    OrderedFactor(std::string what, const BlockPattern& p, const std::vector<std::int32_t>& order,
                  int threads)
        : name(std::move(what)), factor(FactorOptions{.threads = threads}) {
        factor.analyse(p, order);
        values.assign(at(factor.value_count()), 0.0);
        for (std::size_t v = 0; v < p.size.size(); ++v)
            for (int i = 0; i < p.size[v]; ++i)
                values[at(factor.value_begin(static_cast<std::int32_t>(v))) +
                       at(i * (p.size[v] + 1))] = 1.0;
        x.assign(at(factor.info().scalars), 1.0);
    }
    void run(int times) {
        for (int i = 0; i < times; ++i) {
            const auto from = std::chrono::steady_clock::now();
            if (factor.factor(values) != Status::ok || factor.solve(x) != Status::ok)
                throw std::runtime_error("a unit matrix has no factor");
            seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count());
        }
    }
    /// The tenth of the samples that nothing disturbed: disturbances only lengthen them [s].
    [[nodiscard]] double best() const {
        std::vector<double> v = seconds;
        const auto k = static_cast<std::ptrdiff_t>(v.size() / 10);
        std::nth_element(v.begin(), v.begin() + k, v.end());
        return v[static_cast<std::size_t>(k)];
    }
};

/// Ours, balanced by exact flops: the most even of five rounds.
std::vector<std::int32_t> our_order(const PartCase& c, int parts, const FactorCounts& amd) {
    graph::Partitioner p;
    graph::Partition out;
    std::vector<std::int64_t> exact;
    std::vector<std::int32_t> best;
    double least = 0.0;
    for (int k = 0; k < 5; ++k) {
        p.read(c.graph(exact));
        p.separate({parts}, out);
        const std::vector<std::int32_t> order = order_parts(c.pattern, out.part);
        const PartRow row = measure_parts("", c, out.part, parts, amd);
        exact = row.counts.node;
        if (best.empty() || (k > 0 && row.imbalance < least)) {
            best = order;
            least = row.imbalance;
        }
    }
    return best;
}

Json compare_factors(const PartCase& c, int parts, int rounds) {
    BlockPattern p;
    p.size = c.pattern.size;
    p.sign = c.pattern.sign;
    for (std::int32_t v = 0; v < c.pattern.nodes(); ++v)
        for (const std::int32_t u : c.pattern.neighbours(v))
            if (u < v) p.edges.push_back({v, u});
    ForeignGraph g(c.pattern);
    std::vector<std::int32_t> part = metis_parts(g, g.weight, parts);
    if (part.empty()) return {};
    cover_cuts(c.pattern, part);
    const std::vector<std::int32_t> theirs = order_parts(c.pattern, part),
                                    amd = factor::order_nodes(c.pattern),
                                    ours = our_order(c, parts, count_factor(c.pattern, amd));
    Json out = {{"name", c.name}};
    fmt::print("{}: factorisation and solution, separators of {} parts last [us]\n", c.name, parts);
    for (const int threads : {1, 2}) {
        OrderedFactor a("ours", p, ours, threads), b("METIS", p, theirs, threads),
            none("AMD", p, amd, threads);
        for (int k = 0; k < 10 * rounds; ++k)
            for (OrderedFactor* f : {&a, &b, &none}) f->run(20);
        fmt::print(
            "  {} thread(s): ours {:>7.1f}, METIS {:>7.1f}: ours takes {:.2f} of it; AMD "
            "{:>7.1f}\n",
            threads, 1e6 * a.best(), 1e6 * b.best(), a.best() / b.best(), 1e6 * none.best());
        out[std::to_string(threads)] = {{"ours_seconds", a.best()},
                                        {"metis_seconds", b.best()},
                                        {"amd_seconds", none.best()},
                                        {"ours_over_metis", a.best() / b.best()}};
    }
    return out;
}

/// Groups by METIS from the body graph: interactions and what touches, weighted by freedoms.
void group_by_metis(World& world, int parts) {
    std::vector<std::int32_t> node(at(world.body_count()), -1);
    std::vector<std::int8_t> size;
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        const BodyKind kind = world.body_def(BodyId{b}).kind;
        if (kind == BodyKind::fixed || kind == BodyKind::kinematic) continue;
        node[at(b)] = static_cast<std::int32_t>(size.size());
        size.push_back(kind == BodyKind::rigid ? 6 : kind == BodyKind::lump ? 3 : 1);
    }
    std::vector<std::int32_t> from, to;
    const auto join = [&](BodyId a, BodyId b) {
        if (!a.valid() || !b.valid() || node[at(a.index)] < 0 || node[at(b.index)] < 0) return;
        from.push_back(node[at(a.index)]);
        to.push_back(node[at(b.index)]);
    };
    for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
        const InteractionDef d = world.interaction_def(InteractionId{i});
        for (std::size_t k = 0; k < d.body.size(); ++k)
            for (std::size_t l = 0; l < k; ++l) join(d.body[k], d.body[l]);
    }
    for (const ContactView& contact : world.contacts())
        join(world.shape_def(contact.shape[0]).body, world.shape_def(contact.shape[1]).body);
    const factor::Pattern pattern =
        factor::make_pattern(size, std::vector<std::int8_t>(size.size(), 1), from, to);
    ForeignGraph g(pattern);
    const std::vector<std::int32_t> part = metis_parts(g, g.weight, parts);
    for (std::int32_t b = 0; b < world.body_count(); ++b)
        if (node[at(b)] >= 0)
            world.set_group(BodyId{b}, "part " + std::to_string(part[at(node[at(b)])]));
}

struct SteppedWorld {
    const char* name;
    World world, traced;                ///< Of two threads, of one.
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

constexpr int kExactFirst = 60;  ///< Exact steps before worlds are split.

World settled(const std::string& scene, const char* predictor, int threads) {
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
    const World two = settled(scene, predictor, 2), one = settled(scene, predictor, 1);
    SteppedWorld worlds[] = {{"exact", two.twin(Coupling::exact), one.twin(Coupling::exact)},
                             {"ours", two.twin(coupling), one.twin(coupling)},
                             {"METIS", two.twin(coupling), one.twin(coupling)}};
    for (World* w : {&worlds[1].world, &worlds[1].traced}) w->set_groups(parts);
    for (World* w : {&worlds[2].world, &worlds[2].traced}) group_by_metis(*w, parts);
    for (SteppedWorld& w : worlds) w.traced.start_trace(std::size_t{1} << 17);
    for (int k = 0; k < rounds; ++k)
        for (SteppedWorld& w : worlds) w.run(20);
    Json out = {
        {"scene", scene}, {"coupling", observe::to_string(coupling)}, {"predictor", predictor}};
    fmt::print("{}: whole steps, {} {}, {} parts [ms]\n", scene, observe::to_string(coupling),
               predictor, parts);
    std::array<split::SimulatedStep, std::size(worlds)> simulated;
    for (std::size_t i = 0; i < std::size(worlds); ++i) {
        SteppedWorld& w = worlds[i];
        simulated[i] = split::simulate_steps(w.traced, costs);
        int open = 0;
        for (const CutView& cut : w.world.cuts()) open += cut.open ? 1 : 0;
        fmt::print(
            "  {:<6} 2 threads {:>7.3f}, cpu {:>7.3f}; SIMULATED 1 {:>7.3f}, 4 {:>7.3f}, 8 "
            "{:>7.3f}; "
            "{:>3} cuts, {:>3} in force, {:>2} islands{}\n",
            w.name, median(w.wall), median(w.cpu), simulated[i].ms[0], simulated[i].ms[2],
            simulated[i].ms[3], w.world.cuts().size(), open, w.world.stats().islands,
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
    for (const PartCase& c : cases) factors.push_back(compare_factors(c, parts, rounds));
    const PoolCosts costs = measure_pool_costs();
    for (const char* scene : {"anchor_lines", "anchor_contact"}) {
        steps.push_back(compare_worlds(scene, Coupling::kinematic, "clique", parts, rounds, costs));
        steps.push_back(compare_worlds(scene, Coupling::compliant, "hold", parts, rounds, costs));
    }
    return {{"factors", factors}, {"steps", steps}};
}

}  // namespace hawser::bench
