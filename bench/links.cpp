// SPDX-License-Identifier: Apache-2.0
// hawser-bench links: whole steps of a very large world, by default a million rigid links.
#include "commands.h"
#include "scene/catenary.h"

#include <hawser/hawser.h>

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace hawser::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
}

struct LinksOptions {
    int links = 1'076'748, chains = 108, floats = 9, steps = 60, threads = 1;
    std::vector<int> refinements{1, 0};
    double length = 0.25;  ///< Length of a link [m].
    std::string json;
};

/// Attachment of a chain: a point of a body.
struct End {
    BodyId body;
    Vec3 local, world;
};

/// Floats in a row, with a chain between neighbours. All other chains lead down to anchors in the
/// seabed around each float. One island.
class Moorings {
  public:
    Moorings(World& world, const LinksOptions& options) : world_(world), o_(options) {
        ground_ = world.add_body({.name = "seabed", .kind = BodyKind::fixed});
        count_ = o_.links / o_.chains;
        const int first = o_.links % o_.chains;  // number of chains with one link more
        for (int f = 0; f < o_.floats; ++f) add_float(f);
        std::vector<int> of_float(static_cast<std::size_t>(o_.floats), 0);
        for (int c = 0; c < o_.chains; ++c) {
            const int n = count_ + (c < first ? 1 : 0);
            const int f = c % o_.floats;
            if (c + 1 < o_.floats)
                add_chain(side(c, 0.0, 0.0), side(c + 1, std::numbers::pi, 0.0), n);
            else
                add_moored(f, of_float[static_cast<std::size_t>(f)]++, n);
        }
    }

  private:
    static constexpr double kRadius = 20.0;  // of a float [m]
    static constexpr double kMass = 25.0;    // of a link [kg]
    static constexpr double kSlack = 1.02;   // length over distance
    static constexpr double kGravity = 9.81;

    [[nodiscard]] double reach() const { return count_ * o_.length / kSlack; }
    [[nodiscard]] double depth() const { return std::min(300.0, 0.4 * reach()); }  // of the sea [m]

    void add_float(int f) {
        BodyDef def{.name = fmt::format("float{}", f)};
        def.position = Vec3(f * (reach() + 2.0 * kRadius), 0.0, 0.0);
        def.mass = 2e7;
        def.inertia = Vec3(4e9, 4e9, 4e9).asDiagonal();
        def.gravity = false;
        floats_.push_back(world_.add_body(def));
        // Half of each chain's weight hangs on a float; water carries it at the initial height.
        const double chains = static_cast<double>(o_.chains) / o_.floats;
        const double weight = 0.5 * chains * count_ * kMass * kGravity, stiffness = 1e7;
        InteractionDef water{.kind = InteractionKind::Hydrostatic, .body = {floats_.back()}};
        water.set("heave_stiffness", stiffness).set("roll_stiffness", 1e10);
        water.set("pitch_stiffness", 1e10).set("heave_damping", 2e7).set("roll_damping", 1e10);
        water.set("pitch_damping", 1e10).set("rest_height", weight / stiffness);
        world_.add_interaction(water);
    }

    [[nodiscard]] End side(int f, double angle, double down) const {
        const Vec3 local(kRadius * std::cos(angle), kRadius * std::sin(angle), -down);
        const BodyId body = floats_[static_cast<std::size_t>(f)];
        return {body, local, world_.pose(body).position + local};
    }

    void add_moored(int f, int index, int links) {
        const int of_this = (o_.chains - f + o_.floats - 1) / o_.floats - (f + 1 < o_.floats);
        const double angle = 2.0 * std::numbers::pi * (index + 0.5) / std::max(1, of_this);
        const End top = side(f, angle, 5.0);
        const double flat = std::sqrt(std::max(0.0, reach() * reach() - depth() * depth()));
        const Vec3 foot =
            top.world + Vec3(flat * std::cos(angle), flat * std::sin(angle), -depth());
        add_chain(top, {ground_, foot, foot}, links);
    }

    void add_chain(const End& from, const End& to, int links) {
        const auto nodes = scene::hanging_nodes(from.world, to.world, links * o_.length, links,
                                                Vec3(0.0, 0.0, -1.0));
        if (!nodes)
            throw std::runtime_error(
                "a chain does not reach its ends: give more --links, or fewer "
                "--chains");
        BodyId before = from.body;
        Vec3 hold = from.local;
        const Vec3 half(0.5 * o_.length, 0.0, 0.0);
        for (int i = 0; i < links; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const Vec3 a = (*nodes)[k], b = (*nodes)[k + 1];
            BodyDef link;
            link.position = 0.5 * (a + b);
            link.orientation = turn_between(Vec3::UnitX(), b - a);
            link.mass = kMass;
            const double thin = kMass * 0.05 * 0.05, flat = kMass * o_.length * o_.length / 12.0;
            link.inertia = Vec3(thin, thin + flat, thin + flat).asDiagonal();
            const BodyId body = world_.add_body(link);
            join(before, hold, body, -half);
            before = body;
            hold = half;
        }
        join(before, hold, to.body, to.local);
    }

    void join(BodyId a, const Vec3& at_a, BodyId b, const Vec3& at_b) {
        InteractionDef ball{.kind = InteractionKind::Ball, .body = {a, b}};
        ball.point[0] = at_a;
        ball.point[1] = at_b;
        world_.add_interaction(ball);
    }

    World& world_;
    const LinksOptions& o_;
    BodyId ground_{};
    std::vector<BodyId> floats_;
    int count_ = 0;
};

double median_of(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

/// Run one world from the start. Prints and returns the measurements.
nlohmann::json run_links(const LinksOptions& o, int refinements) {
    World world({.refinements = refinements, .threads = o.threads});
    Clock::time_point begin = Clock::now();
    fmt::print(stderr, "building {} links in {} chains …\n", o.links, o.chains);
    const Moorings moorings(world, o);
    const double build = since(begin);
    fmt::print(stderr, "analysing …\n");
    begin = Clock::now();
    world.prepare();
    const double analyse = since(begin);
    std::vector<double> times;
    std::array<std::vector<double>, kStageCount> stages;
    double gap = 0.0, momentum = 0.0;
    for (int i = 0; i < o.steps; ++i) {
        if (world.step() != Status::ok)
            throw std::runtime_error(
                fmt::format("step {} failed: {}", i, to_string(world.stats().status)));
        const StepStats& s = world.stats();
        times.push_back(s.step_seconds);
        for (std::size_t k = 0; k < kStageCount; ++k) stages[k].push_back(s.stage_seconds[k]);
        gap = std::max(gap, s.violation_max);
        momentum = std::max(momentum, s.momentum_residual);
        fmt::print(stderr, "\rstep {}/{}: {:.3f} s, gap {:.2g} m ", i + 1, o.steps, s.step_seconds,
                   s.violation_max);
    }
    const StepStats& s = world.stats();
    const double middle = median_of(times),
                 bytes = static_cast<double>(world.solver().memory_bytes());
    fmt::print(stderr, "\n");
    fmt::print("{} bodies, {} interactions, {} equations, {} island(s); {} thread(s), {}\n",
               s.bodies, s.interactions, s.equations, s.islands, o.threads, instruction_set());
    if (refinements > 0)
        fmt::print("solutions refined where the residual is above {:.0e}\n",
                   world.settings().solution_tolerance);
    else
        fmt::print("solutions not refined\n");
    fmt::print("  step        median {:.3f} s, best {:.3f} s, worst {:.3f} s: {:.0f} ns a link\n",
               middle, *std::min_element(times.begin(), times.end()),
               *std::max_element(times.begin(), times.end()), 1e9 * middle / o.links);
    for (std::size_t k = 0; k < kStageCount; ++k)
        if (const double t = median_of(stages[k]); t > 0.001 * middle)
            fmt::print("    {:<10}{:.3f} s\n", to_string(static_cast<Stage>(k)), t);
    fmt::print("  gap         {:.3g} m at the end, at most {:.3g} m in {} steps\n", s.violation_max,
               gap, o.steps);
    fmt::print("  momentum    residual at most {:.2g}\n", momentum);
    fmt::print("  factor      {} nonzeros in L, {:.4g} Mflop\n", s.factor_nnz,
               1e-6 * static_cast<double>(s.factor_flops));
    fmt::print(
        "  memory      {:.3f} GB in state and solver, {:.0f} B a link; {:.1f} GB/s if each "
        "byte moved once a step\n",
        1e-9 * bytes, bytes / o.links, 1e-9 * bytes / middle);
    fmt::print("  set-up      {:.1f} s to build, {:.1f} s to analyse\n", build, analyse);
    return {{"links", o.links},         {"chains", o.chains},
            {"floats", o.floats},       {"threads", o.threads},
            {"steps", o.steps},         {"step_s", middle},
            {"step_s_all", times},      {"gap_m", s.violation_max},
            {"gap_max_m", gap},         {"momentum_residual", momentum},
            {"bytes", bytes},           {"analyse_s", analyse},
            {"islands", s.islands},     {"equations", s.equations},
            {"isa", instruction_set()}, {"refinements", refinements}};
}

}  // namespace

int links_command(int argc, char** argv) {
    CLI::App app(
        "Whole steps of floats moored by chains of rigid links with ball joints, one island. The "
        "best published time for a million links is 0.904 s a step on one processor thread.",
        "hawser-bench links");
    LinksOptions o;
    app.add_option("--links", o.links, "Rigid links in all")
        ->capture_default_str()
        ->check(CLI::Range(1000, 3'900'000));
    app.add_option("--chains", o.chains, "Chains they make")
        ->capture_default_str()
        ->check(CLI::Range(1, 10'000));
    app.add_option("--floats", o.floats, "Floats")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
    app.add_option("--link-length", o.length, "Length of a link [m]")
        ->capture_default_str()
        ->check(CLI::Range(0.05, 10.0));
    app.add_option("--steps", o.steps, "Steps of 1/60 s")
        ->capture_default_str()
        ->check(CLI::Range(1, 100'000));
    app.add_option("--threads", o.threads, "Threads")
        ->capture_default_str()
        ->check(CLI::Range(1, 256));
    app.add_option("--refinements", o.refinements,
                   "Refinements of a solution where its residual asks; a run for each number")
        ->capture_default_str()
        ->delimiter(',')
        ->check(CLI::Range(0, 4));
    app.add_option("--json", o.json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);
    if (o.chains < o.floats) throw std::runtime_error("fewer chains than floats");

    nlohmann::json runs = nlohmann::json::array();
    for (const int refinements : o.refinements) runs.push_back(run_links(o, refinements));
    if (!o.json.empty()) std::ofstream(o.json) << runs.dump(2) << '\n';
    return 0;
}

}  // namespace hawser::bench
