// SPDX-License-Identifier: Apache-2.0
// hawser-bench friction: comparison of methods for contacts with friction.
#include <hawser/scene.h>

#include "commands.h"
#include "friction_loads.h"

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
    {"pgs-50", Nonsmooth::pgs, 50},        {"pgs-500", Nonsmooth::pgs, 500},
    {"pivoting", Nonsmooth::pivoting, 50}, {"convex", Nonsmooth::convex, 50},
};
constexpr const char* kWords[] = {"newton", "pivoting", "split", "pgs", "convex"};

constexpr const char* kDescription =
    "Methods for contacts with friction beside each other: work, residual, creep, load\n"
    "carried. Takes about two minutes on one core, most of it projected Gauss-Seidel\n"
    "with 500 sweeps; --quick takes twenty seconds. Exit code 1 if newton needs more\n"
    "than 5 factorisations a step in the median or 10 in the 90th percentile, or leaves\n"
    "a step with a residual above 1e-6. Each row is told when it is known.";

constexpr const char* kLegend =
    "\nfactor: flops of all factorisations and substitutions of a step over those of one LDL^T "
    "of its matrix.\nmap: largest relative residual of Coulomb's exact law over the contacts of "
    "a step, whatever the method's\nown law is. cpu ms: median of the solver's CPU time.\n";

/// A step counts as certified below this natural-map residual.
constexpr double kCertified = 1e-6;

double quantile_of(std::vector<double> v, double p) {
    if (v.empty()) return std::nan("");
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
}

/// Results of one method for one scene.
struct Run {
    std::vector<double> work, map, cpu_ms, iterations;
    std::vector<double> contacts, momentum;
    int uncertified = 0, failed = 0, flops_equations = 0;

    void add_sample(const StepStats& s) {
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
        if (i >= skip) run.add_sample(scene.world.stats());
    }
    return run;
}

Json figures(const Run& r) {
    return {{"steps", r.work.size()},
            {"failed", r.failed},
            {"contacts",
             {{"median", quantile_of(r.contacts, 0.5)}, {"max", quantile_of(r.contacts, 1.0)}}},
            {"factorisations",
             {{"median", quantile_of(r.work, 0.5)},
              {"p90", quantile_of(r.work, 0.9)},
              {"max", quantile_of(r.work, 1.0)}}},
            {"iterations",
             {{"median", quantile_of(r.iterations, 0.5)}, {"max", quantile_of(r.iterations, 1.0)}}},
            {"natural_map",
             {{"p50", quantile_of(r.map, 0.5)},
              {"p95", quantile_of(r.map, 0.95)},
              {"max", quantile_of(r.map, 1.0)}}},
            {"uncertified_steps", r.uncertified},
            {"momentum_residual_max", quantile_of(r.momentum, 1.0)},
            {"solver_cpu_ms",
             {{"median", quantile_of(r.cpu_ms, 0.5)}, {"p90", quantile_of(r.cpu_ms, 0.9)}}}};
}

void print_header(const std::string& name) {
    fmt::print("\n{}, one thread\n", name);
    fmt::print("{:<9}{:>6}{:>9}{:>9} |{:>7}{:>7}{:>7} |{:>9}{:>9}{:>9}{:>8}{:>7}\n", "method",
               "steps", "contacts", "cpu ms", "factor", "p90", "max", "map p50", "p95", "max",
               "> 1e-6", "failed");
}

void print_row(const char* method, const Json& f) {
    const Json &work = f["factorisations"], &map = f["natural_map"];
    fmt::print(
        "{:<9}{:>6}{:>9.0f}{:>9.3g} |{:>7.3g}{:>7.3g}{:>7.3g} |{:>9.1e}{:>9.1e}{:>9.1e}"
        "{:>8}{:>7}\n",
        method, f["steps"].get<int>(), f["contacts"]["median"].get<double>(),
        f["solver_cpu_ms"]["median"].get<double>(), work["median"].get<double>(),
        work["p90"].get<double>(), work["max"].get<double>(), map["p50"].get<double>(),
        map["p95"].get<double>(), map["max"].get<double>(), f["uncertified_steps"].get<int>(),
        f["failed"].get<int>());
    std::fflush(stdout);
}

/// Check the limits of `newton` in warm steps and print the result. @return true if they are met.
bool check_limits(const Json& f) {
    constexpr double kMedian = 5.0, kP90 = 10.0;
    const double median = f["factorisations"]["median"].get<double>();
    const double p90 = f["factorisations"]["p90"].get<double>();
    const int uncertified = f["uncertified_steps"].get<int>(), failed = f["failed"].get<int>();
    const bool ok = median <= kMedian && p90 <= kP90 && uncertified == 0 && failed == 0;
    fmt::print(
        "newton: {}: median {:.3g} (limit {:g}), p90 {:.3g} (limit {:g}) factorisations, "
        "{} steps uncertified, {} failed\n",
        ok ? "ok" : "FAIL", median, kMedian, p90, kP90, uncertified, failed);
    return ok;
}

void save(const Json& out, const std::string& file) {
    if (file.empty()) return;
    std::ofstream stream(file);
    stream << out.dump(2) << '\n';
    if (!stream) throw std::runtime_error("cannot write " + file);
}

/// Measure creep and load of each method into `out`; calls `tell` after each.
template <class Tell>
void print_loads(const std::vector<Method>& methods, double duration, Json& out, Tell tell) {
    fmt::print(
        "\nloads at 60 Hz: drift of a block at 80 % of the friction limit from 1 s to {:g} "
        "s; share of its load\nthat the top of a chain of 100 links carries, the load 1e4 "
        "times a link\n{:<9}{:>14}{:>14}{:>12}\n",
        duration, "method", "creep [m]", "first step", "after 1 s");
    for (const Method& m : methods) {
        fmt::print(stderr, "creep and chain: {} …\n", m.name);
        const double moved = creep(m, duration);
        const Carried carried = chain_load(m);
        fmt::print("{:<9}{:>14.2e}{:>14.6f}{:>12.6f}\n", m.name, moved, carried.first,
                   carried.second);
        std::fflush(stdout);
        out[m.name] = {{"creep_m", moved},
                       {"chain_first_step", carried.first},
                       {"chain_after_1_s", carried.second}};
        tell();
    }
}

}  // namespace

int friction_command(int argc, char** argv) {
    CLI::App app(kDescription, "hawser-bench friction");
    std::vector<std::string> files{"scenes/wall_648.json", "scenes/wall_976.json",
                                   "bench/scenes/frozen/anchor_contact.json"};
    std::vector<std::string> names, known;
    std::string json_file;
    int skip = 10, steps = 110;
    double duration = 100.0;
    bool quick = false;
    for (const Method& m : kMethods) known.emplace_back(m.name);
    app.add_option("SCENES", files, "Scene files; those that do not exist are left out")
        ->capture_default_str();
    app.add_option("--method", names, "Only these")->check(CLI::IsMember(known));
    app.add_option("--skip", skip, "Steps before anything counts: the start is cold")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--steps", steps, "Steps that count")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    app.add_option("--creep", duration, "Time that the block rests [s]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_flag("--quick", quick, "20 steps and 5 s of rest, whatever else is said");
    app.add_option("--json", json_file, "Write the figures to this file, anew after each method");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    if (quick) {
        steps = 20;
        duration = 5.0;
    }

    std::vector<Method> methods;
    for (const Method& m : kMethods)
        if (names.empty() || std::find(names.begin(), names.end(), m.name) != names.end())
            methods.push_back(m);
    Json out;
    bool ok = true;
    for (const std::string& file : files) {
        if (!std::filesystem::exists(file)) {
            fmt::print("{}: not there, left out\n", file);
            continue;
        }
        const std::string name = std::filesystem::path(file).stem().string();
        print_header(name);
        Json& scene = out["scenes"][name];
        for (const Method& m : methods) {
            fmt::print(stderr, "{}: {} …\n", file, m.name);
            scene[m.name] = figures(run_scene(file, m, skip, steps));
            print_row(m.name, scene[m.name]);
            save(out, json_file);
        }
        if (scene.contains("newton")) ok = check_limits(scene["newton"]) && ok;
    }
    print_loads(methods, duration, out["loads"], [&] { save(out, json_file); });
    fmt::print("{}", kLegend);
    return ok ? 0 : 1;
}

}  // namespace hawser::bench
