// SPDX-License-Identifier: Apache-2.0
// hawser-bench friction: the methods for contacts with friction beside each other.
#include "commands.h"
#include "friction_loads.h"
#include "scene/scene.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace hawser::bench {
namespace {

using Json = nlohmann::json;

constexpr Method kMethods[] = {
    {"newton", Nonsmooth::newton, 50},     {"split", Nonsmooth::split, 50},
    {"pgs 50", Nonsmooth::pgs, 50},        {"pgs 500", Nonsmooth::pgs, 500},
    {"pivoting", Nonsmooth::pivoting, 50}, {"convex", Nonsmooth::convex, 50},
};
constexpr const char* kWords[] = {"newton", "pivoting", "split", "pgs", "convex"};

/// A step counts as certified below this natural-map residual.
constexpr double kCertified = 1e-6;

double share(std::vector<double> v, double p) {
    if (v.empty()) return std::nan("");
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
}

/// What one method did on one scene.
struct Run {
    std::vector<double> work, map, cpu_ms, iterations;
    std::vector<double> contacts, momentum;
    int uncertified = 0, failed = 0, flops_equations = 0;

    void take(const StepStats& s) {
        work.push_back(s.factor_work);
        map.push_back(s.natural_map);
        cpu_ms.push_back(1e3 * s.solver_cpu_seconds);
        iterations.push_back(s.newton_iterations);
        contacts.push_back(s.contacts);
        momentum.push_back(s.momentum_residual);
        if (!(s.natural_map <= kCertified)) ++uncertified;
        flops_equations = s.equations;
    }
};

Run run_scene(const std::string& file, const Method& method, int skip, int steps) {
    scene::Options options;
    options.set = {
        fmt::format("settings.nonsmooth={}", kWords[static_cast<std::size_t>(method.nonsmooth)]),
        fmt::format("settings.nonsmooth_sweeps={}", method.sweeps)};
    scene::Scene scene = scene::load_file(file, options);
    Run run;
    for (int i = 0; i < skip + steps; ++i) {
        if (scene.world.step() != Status::ok) {
            ++run.failed;
            break;
        }
        if (i >= skip) run.take(scene.world.stats());
    }
    return run;
}

Json figures(const Run& r) {
    return {
        {"steps", r.work.size()},
        {"failed", r.failed},
        {"contacts", {{"median", share(r.contacts, 0.5)}, {"max", share(r.contacts, 1.0)}}},
        {"factorisations",
         {{"median", share(r.work, 0.5)},
          {"p90", share(r.work, 0.9)},
          {"max", share(r.work, 1.0)}}},
        {"iterations", {{"median", share(r.iterations, 0.5)}, {"max", share(r.iterations, 1.0)}}},
        {"natural_map",
         {{"p50", share(r.map, 0.5)}, {"p95", share(r.map, 0.95)}, {"max", share(r.map, 1.0)}}},
        {"uncertified_steps", r.uncertified},
        {"momentum_residual_max", share(r.momentum, 1.0)},
        {"solver_cpu_ms", {{"median", share(r.cpu_ms, 0.5)}, {"p90", share(r.cpu_ms, 0.9)}}}};
}

void print_scene(const std::string& name, const Json& methods) {
    fmt::print("\n{}, one thread\n", name);
    fmt::print("{:<9}{:>6}{:>9}{:>9} |{:>7}{:>7}{:>7} |{:>9}{:>9}{:>9}{:>8}{:>7}\n", "method",
               "steps", "contacts", "cpu ms", "factor", "p90", "max", "map p50", "p95", "max",
               "> 1e-6", "failed");
    for (const Method& m : kMethods) {
        if (!methods.contains(m.name)) continue;
        const Json& f = methods[m.name];
        const Json &work = f["factorisations"], &map = f["natural_map"];
        fmt::print(
            "{:<9}{:>6}{:>9.0f}{:>9.3g} |{:>7.3g}{:>7.3g}{:>7.3g} |{:>9.1e}{:>9.1e}{:>9.1e}"
            "{:>8}{:>7}\n",
            m.name, f["steps"].get<int>(), f["contacts"]["median"].get<double>(),
            f["solver_cpu_ms"]["median"].get<double>(), work["median"].get<double>(),
            work["p90"].get<double>(), work["max"].get<double>(), map["p50"].get<double>(),
            map["p95"].get<double>(), map["max"].get<double>(), f["uncertified_steps"].get<int>(),
            f["failed"].get<int>());
        std::fflush(stdout);
    }
}

Json print_loads(const std::vector<Method>& methods, double duration) {
    Json out;
    fmt::print(
        "\nloads at 60 Hz: drift of a block at 80 % of the friction limit from 1 s to {:g} "
        "s; share of its load\nthat the top of a chain of 100 links carries, the load 1e4 "
        "times a link\n{:<9}{:>14}{:>14}{:>12}\n",
        duration, "method", "creep [m]", "first step", "after 1 s");
    for (const Method& m : methods) {
        const double moved = creep(m, duration);
        const Carried carried = chain_load(m);
        fmt::print("{:<9}{:>14.2e}{:>14.6f}{:>12.6f}\n", m.name, moved, carried.first,
                   carried.second);
        std::fflush(stdout);
        out[m.name] = {{"creep_m", moved},
                       {"chain_first_step", carried.first},
                       {"chain_after_1_s", carried.second}};
    }
    return out;
}

}  // namespace

int friction_command(int argc, char** argv) {
    CLI::App app("Methods for contacts with friction: work, residual, creep, load carried.",
                 "hawser-bench friction");
    std::vector<std::string> files{"scenes/wall_648.json", "scenes/wall_976.json",
                                   "scenes/anchor_contact.json"};
    std::vector<std::string> names;
    std::string json_file;
    int skip = 10, steps = 110;
    double duration = 100.0;
    app.add_option("SCENES", files, "Scene files; those that do not exist are left out")
        ->capture_default_str();
    app.add_option("--method", names, "Only these, by their names in the table");
    app.add_option("--skip", skip, "Steps before anything counts: the start is cold")
        ->capture_default_str();
    app.add_option("--steps", steps, "Steps that count")->capture_default_str();
    app.add_option("--creep", duration, "Time that the block rests [s]")->capture_default_str();
    app.add_option("--json", json_file, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);

    std::vector<Method> methods;
    for (const Method& m : kMethods)
        if (names.empty() || std::find(names.begin(), names.end(), m.name) != names.end())
            methods.push_back(m);
    Json out;
    for (const std::string& file : files) {
        if (!std::filesystem::exists(file)) {
            fmt::print("{}: not there, left out\n", file);
            continue;
        }
        Json scene;
        for (const Method& m : methods) {
            fmt::print(stderr, "{}: {} …\n", file, m.name);
            scene[m.name] = figures(run_scene(file, m, skip, steps));
        }
        const std::string name = std::filesystem::path(file).stem().string();
        print_scene(name, scene);
        out["scenes"][name] = scene;
    }
    out["loads"] = print_loads(methods, duration);
    fmt::print(
        "\nfactor: flops of all factorisations and substitutions of a step over those of one LDL^T "
        "of its matrix.\nmap: largest relative residual of Coulomb's exact law over the contacts "
        "of "
        "a step, whatever the method's own\nlaw is. cpu ms: median of the solver's CPU time.\n");
    if (!json_file.empty()) std::ofstream(json_file) << out.dump(2) << '\n';
    return 0;
}

}  // namespace hawser::bench
