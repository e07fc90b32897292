// SPDX-License-Identifier: Apache-2.0
// hawser-bench factor: benchmark matrices, factored and solved by Hawser and by libraries in turns.
#include <hawser/world.h>

#include "commands.h"
#include "draw/svg.h"
#include "linear/edits.h"
#include "linear/report.h"
#include "linear/schedule.h"
#include "linear/shares.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace hawser::bench {
namespace {

struct FactorOptions {
    std::vector<int> scales{1};
    std::vector<std::string> only;
    std::string scene = "bench/scenes/frozen/anchor_lines.json", matrix, blocks, json, picture;
    int threads = 2, edits = 0;
    bool sweep = false, list = false, schedule = false, saddle = false, shares = false;
    int reference_limit = 3'000'000;
    TrialOptions trial;
};

constexpr int kHuge = 3'000'000;  ///< Number of scalars from which solvers run one after the other.

std::vector<ProblemSource> choose(const FactorOptions& o) {
    if (!o.matrix.empty()) {
        ProblemSource p{o.matrix};
        p.file = o.matrix;
        p.blocks = o.blocks;
        return {p};
    }
    std::vector<ProblemSource> chosen;
    for (const ProblemSource& p :
         standard_problems(o.sweep ? std::vector<int>{1, 2, 5, 10, 20, 50} : o.scales, o.scene)) {
        const bool named = std::any_of(o.only.begin(), o.only.end(), [&](const std::string& part) {
            return p.name.find(part) != std::string::npos;
        });
        const bool any = o.only.empty() && (!p.named_only || o.list);
        if (o.sweep ? p.name.find("paper rigid") == 0 : any || named) chosen.push_back(p);
    }
    return chosen;
}

ProblemReport run(const ProblemSource& source, const FactorOptions& o) {
    Problem problem(source.system());
    ProblemReport report;
    report.name = source.name;
    report.scale = source.scale;
    report.bodies = problem.system.bodies;
    report.scalars = problem.system.scalars();
    report.nnz_saddle = static_cast<double>(problem.matrix[0]->lower.nonZeros());
    report.nnz_condensed = static_cast<double>(problem.matrix[1]->lower.nonZeros());
    if (report.scalars <= o.reference_limit) {
        problem.reference = solve_reference(problem.system);
        report.reference_correction = problem.reference->last_correction;
    }
    TrialOptions trial = o.trial;
    if (report.scalars > 300'000) trial.rounds = std::min(trial.rounds, 3);
    trial.quick_choice |= report.scalars > kHuge;
    trial.run_in_turns = report.scalars <= kHuge;
    for (const int threads : {1, o.threads}) {
        if (threads == 1 && !report.best.empty()) break;  // --threads 1
        trial.updates = threads == 1;
        std::vector<Result> r = compare(problem, source, threads, trial, report.tried);
        report.best.insert(report.best.end(), r.begin(), r.end());
    }
    return report;
}

CLI::App* add_options(CLI::App& app, FactorOptions& o) {
    app.add_option("--scale", o.scales, "Copies of the paper's scene and of SCENE")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--only", o.only,
                   "Matrices whose name contains one of these; the solid only so");
    app.add_flag("--list", o.list, "Print the names of the matrices and end");
    app.add_option("--matrix", o.matrix, "A Matrix Market file instead (coordinate, symmetric)")
        ->check(CLI::ExistingFile);
    app.add_option("--blocks", o.blocks, "File of its block sizes, 1-6; default: detected")
        ->check(CLI::ExistingFile);
    app.add_option("--scene", o.scene, "Scene whose matrix is among them")->capture_default_str();
    app.add_option("--solvers", o.trial.libraries, "Solvers whose name contains one of these");
    app.add_option("--threads", o.threads, "Measure one thread and this many")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--rounds", o.trial.rounds, "Turns of each solver, 3 samples a turn")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_flag("--public", o.trial.through_public,
                 "Ours through hawser/factor.h, too (hawser blocks)");
    app.add_flag("--sweep", o.sweep, "The rigid scene at scales 1 to 50: who gains from threads?");
    app.add_option("--edits", o.edits,
                   "Repair our analysis of the paper's scene through so many steps instead")
        ->check(CLI::Range(4, 100'000));
    app.add_flag("--schedule", o.schedule,
                 "Ours alone: measured on 1 and 2 threads, simulated on up to 64");
    app.add_flag("--shares", o.shares,
                 "Ours alone: what each part of a solution and of an update takes");
    app.add_flag("--saddle", o.saddle, "With --schedule: rows kept; else they are eliminated");
    app.add_option("--reference-limit", o.reference_limit,
                   "No long double reference above this many scalars")
        ->capture_default_str();
    app.add_option("--json", o.json, "Write all figures to this file");
    app.add_option("--picture", o.picture, "Write a bar chart of the ratios (SVG)");
    return &app;
}

/// OpenBLAS 0.3.21 takes newer machines for a Prescott of 2004 and is then several times slower. It
/// selects its kernels when it is loaded: start again with a better selection.
void require_fast_blas(char** argv) {
    const std::string isa = instruction_set(), core = blas_core();
    if (getenv("OPENBLAS_CORETYPE") != nullptr || core != "OpenBLAS Prescott" || isa == "sse2")
        return;
    setenv("OPENBLAS_CORETYPE", isa == "avx512" ? "SKYLAKEX" : "HASWELL", 1);
    execv("/proc/self/exe", argv);  // continues with the old one if this fails
}

int run_schedules(const std::vector<ProblemSource>& sources, const FactorOptions& o) {
    PoolCosts costs = measure_pool_costs();
    costs.wake = 0.0;  // the timed part follows a solution that is not timed
    nlohmann::json all = nlohmann::json::array();
    print_schedule_head(costs);
    std::vector<ScheduleReport> reports;
    for (const ProblemSource& p : sources) {
        reports.push_back(measure_schedule(p, !o.saddle, o.trial.rounds, costs));
        print_schedule(reports.back());
        all.push_back(to_json(reports.back()));
    }
    fmt::print(
        "x: speed-up, measured on 2 threads and simulated on more. serial: outside loops; path:\n"
        "with endless threads that cost nothing; both over the time of one thread. *: other "
        "programs kept\ntwo threads from having two processors in most samples.\n");
    for (const ScheduleReport& r : reports) {
        fmt::print("\n{}, {}\n", r.name, r.form);
        print_schedule_loops(r);
    }
    if (!o.json.empty())
        std::ofstream(o.json) << nlohmann::json{{"instruction_set", instruction_set()},
                                                {"start_us", 1e6 * costs.start},
                                                {"join_us", 1e6 * costs.join},
                                                {"deal_us", 1e6 * costs.deal},
                                                {"matrices", all}}
                                     .dump(2)
                              << '\n';
    return 0;
}

}  // namespace

int factor_command(int argc, char** argv) {
    CLI::App app(
        "Condense, refactor, solve and refine once: ours against libraries, in turns, each in\n"
        "the form (saddle or condensed) and order in which it is fastest. The error is that\n"
        "against a long double solution.",
        "hawser-bench factor");
    FactorOptions o;
    add_options(app, o);
    CLI11_PARSE(app, argc, argv);
    if (o.edits > 0) {
        for (const int scale : o.scales) {
            print_edits(o.edits, scale);
            print_parts(scale);
        }
        return 0;
    }
    require_fast_blas(argv - 1);  // argv[0] is the subcommand, preceded by the program
    const std::vector<ProblemSource> sources = choose(o);
    if (o.list) {
        for (const ProblemSource& p : sources) fmt::print("{}\n", p.name);
        return 0;
    }
    if (o.schedule) return run_schedules(sources, o);
    if (o.shares) {
        fmt::print("kernels {}, one thread; medians of {} rounds, wall time\n", instruction_set(),
                   o.trial.rounds);
        for (const ProblemSource& p : sources) print_fractions(p, o.trial.rounds);
        return 0;
    }
    fmt::print("kernels {}, BLAS {}; one thread: processor time, more: wall time\n",
               instruction_set(), blas_core());
    std::vector<ProblemReport> reports;
    nlohmann::json all = nlohmann::json::array();
    for (const ProblemSource& p : sources) {
        reports.push_back(run(p, o));
        print_report(reports.back());
        all.push_back(to_json(reports.back()));
    }
    if (o.threads > 1) print_thread_gain(reports);
    if (!o.json.empty())
        std::ofstream(o.json) << nlohmann::json{{"instruction_set", instruction_set()},
                                                {"blas", blas_core()},
                                                {"matrices", all}}
                                     .dump(2)
                              << '\n';
    if (!o.picture.empty()) std::ofstream(o.picture) << draw::to_svg(ratio_picture(reports));
    return 0;
}

}  // namespace hawser::bench
