// SPDX-License-Identifier: Apache-2.0
// hawser-bench roofline: Hawser's factorisation and substitution compared with the limits of the
// processor.
#include <hawser/factor.h>
#include <hawser/world.h>

#include "commands.h"
#include "index.h"
#include "linear/form.h"
#include "linear/problem.h"
#include "linear/timing.h"
#include "roofline/limits.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace hawser::bench {
namespace {

/// The pattern of a form through the public interface, and values: times do not depend on them, so
/// that any quasi-definite ones are sufficient.
struct Work {
    explicit Work(const ProblemSource& source) {
        const Problem problem(source.system());
        const factor::Pattern& p = problem.form[1].pattern;
        pattern.size = p.size;
        pattern.sign = p.sign;
        for (int a = 0; a < p.nodes(); ++a)
            for (const std::int32_t b : p.neighbours(a))
                if (b < a) pattern.edges.push_back({a, b});
        factor.analyse(pattern);
        fill();
        x.assign(at(factor.info().scalars), 1.0);
    }

    /// Make it diagonally dominant.
    void fill() {
        values.assign(at(factor.value_count()), 1e-3);
        for (std::size_t node = 0; node < pattern.size.size(); ++node) {
            const int n = pattern.size[node];
            double* block = &values[at(factor.value_begin(static_cast<std::int32_t>(node)))];
            for (int i = 0; i < n; ++i) block[i * n + i] = 100.0 * pattern.sign[node];
        }
    }

    BlockPattern pattern;
    BlockFactor factor;
    std::vector<double> values, x;
};

struct Row {
    std::string name;
    int scale = 1;
    double megabytes = 0.0;            ///< Size of L.
    double factor = 0.0, solve = 0.0;  ///< Medians [s].
    double flops = 0.0, factor_bytes = 0.0, solve_bytes = 0.0;
    Bandwidth limit{};  ///< Through as many bytes as L has.
};

double median_time(int rounds, const auto& once) {
    std::vector<double> times;
    once();
    for (int k = 0; k < rounds; ++k) {
        const double from = thread_seconds();
        once();
        times.push_back(thread_seconds() - from);
    }
    return median(times);
}

Row measure(const ProblemSource& source, int rounds) {
    Work w(source);
    const FactorInfo info = w.factor.info();
    Row row;
    row.name = source.name;
    row.scale = source.scale;
    const double entries = sizeof(double) * static_cast<double>(info.factor_nnz);
    row.megabytes = 1e-6 * entries;
    row.flops = static_cast<double>(info.flops);
    // Each value is read, each entry of L is written and read at least once; a substitution reads L
    // twice, and its vector.
    row.factor_bytes = sizeof(double) * static_cast<double>(w.values.size()) + 2.0 * entries;
    row.solve_bytes = 2.0 * entries + 4.0 * sizeof(double) * static_cast<double>(info.scalars);
    row.limit = bandwidth(static_cast<std::size_t>(entries));
    row.factor = median_time(rounds, [&] {
        if (w.factor.factor(w.values) != Status::ok) throw std::runtime_error("wrong pivots");
    });
    row.solve = median_time(rounds, [&] {
        std::fill(w.x.begin(), w.x.end(), 1.0);
        if (w.factor.solve(w.x) != Status::ok) throw std::runtime_error("not finite");
    });
    return row;
}

/// Return the limit by flops and bytes [flop/s].
double roofline_limit(const Row& r, double peak) {
    return std::min(peak, r.flops / r.factor_bytes * r.limit.update);
}

void print(const std::vector<Row>& rows, double peak) {
    fmt::print("one thread, {}: {:.1f} GFLOP/s of multiply-adds in registers\n\n",
               instruction_set(), 1e-9 * peak);
    fmt::print("{:<28} {:>8}  {:>38}  {:>28}\n", "", "", "factorisation", "substitution");
    fmt::print("{:<28} {:>8}  {:>8} {:>7} {:>8} {:>6} {:>5}  {:>8} {:>6} {:>6} {:>5}\n", "matrix",
               "L [MB]", "time", "flop/B", "GFLOP/s", "roof", "%", "time", "GB/s", "roof", "%");
    for (const Row& r : rows) {
        const double rate = r.flops / r.factor, most = roofline_limit(r, peak);
        const double speed = r.solve_bytes / r.solve;
        fmt::print(
            "{:<28} {:>8.2f}  {:>5.2f} ms {:>7.2f} {:>8.1f} {:>6.1f} {:>5.0f}  {:>5.2f} ms "
            "{:>6.1f} {:>6.1f} {:>5.0f}\n",
            r.name, r.megabytes, 1e3 * r.factor, r.flops / r.factor_bytes, 1e-9 * rate, 1e-9 * most,
            100.0 * rate / most, 1e3 * r.solve, 1e-9 * speed, 1e-9 * r.limit.read,
            100.0 * speed / r.limit.read);
    }
    fmt::print(
        "\nroof: the least of the multiply-adds in registers and flop/B times the bandwidth of "
        "an update in place\nthrough as much memory as L takes; of the substitution: the "
        "bandwidth of a sum through as much.\nBytes are the least that has to move. Medians "
        "of processor time.\n");
}

nlohmann::json to_json(const Row& r, double peak) {
    return {{"matrix", r.name},
            {"scale", r.scale},
            {"l_megabytes", r.megabytes},
            {"flops", r.flops},
            {"factor_seconds", r.factor},
            {"factor_bytes", r.factor_bytes},
            {"factor_roof_flops", roofline_limit(r, peak)},
            {"solve_seconds", r.solve},
            {"solve_bytes", r.solve_bytes},
            {"read_bandwidth", r.limit.read},
            {"update_bandwidth", r.limit.update}};
}

}  // namespace

int roofline_command(int argc, char** argv) {
    CLI::App app(
        "GFLOP/s of our factorisation and GB/s of our substitution, beside what this processor\n"
        "can do at most in the same run: multiply-adds in registers, and bandwidth through as\n"
        "much memory as the factor takes. Condensed form, values copied from an array.",
        "hawser-bench roofline");
    std::vector<int> scales{1, 10};
    std::vector<std::string> only{"paper", "chain", "net"};
    std::string scene = "bench/scenes/frozen/anchor_lines.json", json;
    int rounds = 60;
    app.add_option("--scale", scales, "Copies of the paper's scene and of SCENE")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--only", only, "Matrices whose name contains one of these")
        ->capture_default_str();
    app.add_option("--scene", scene, "Scene whose matrix is among them")->capture_default_str();
    app.add_option("--rounds", rounds, "Samples")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    app.add_option("--json", json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);
    const double peak = peak_flops();
    std::vector<Row> rows;
    for (const ProblemSource& p : standard_problems(scales, scene))
        if (std::any_of(only.begin(), only.end(), [&](const std::string& part) {
                return p.name.find(part) != std::string::npos;
            }))
            rows.push_back(measure(p, rounds));
    print(rows, peak);
    if (json.empty()) return 0;
    nlohmann::json all = nlohmann::json::array();
    for (const Row& r : rows) all.push_back(to_json(r, peak));
    std::ofstream(json) << nlohmann::json{{"instruction_set", instruction_set()},
                                          {"peak_flops", peak},
                                          {"matrices", all}}
                               .dump(2)
                        << '\n';
    return 0;
}

}  // namespace hawser::bench
