// SPDX-License-Identifier: Apache-2.0
// hawser-bench peers: searches each peer's smallest number of substeps that holds, then runs all
// engines alternated in blocks of frames and prints what was measured.
#include "commands.h"
#include "peers/peers.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

namespace hawser::bench {
namespace {

using nlohmann::json;

struct Options {
    std::vector<std::string> scenes{"all"};
    std::vector<std::string> engines;
    SearchOptions search;
    int substeps = 0;
    std::string json_file;
    std::string save_tension;
    std::string reference = HAWSER_BENCH_REFERENCE;
    bool verbose = false;
};

std::string cell(const std::optional<double>& v, double scale = 1.0) {
    return v ? fmt::format("{:.2g}", scale * *v) : "-";
}

void print_header(const Scene& scene) {
    fmt::print("\n{} ({}), {} bodies, {} joints, one thread\n", scene.name, scene.code,
               scene.bodies.size(), scene.joints.size());
    fmt::print("{:<22}{:>5}{:>11}{:>10}{:>10}{:>11}{:>10}{:>11}  {}\n", "engine", "sub", "ms/frame",
               "p99", "gap [m]", "tension %", "energy %", "path [m]", "holds");
}

void print_row(const PeerResult& r) {
    std::string verdict = r.holds ? "yes" : "no: " + r.why_not;
    if (!r.unchecked.empty()) verdict += " (" + r.unchecked + " not checked: no reference)";
    if (!r.holds) verdict += fmt::format(", {:.2f} s simulated", r.simulated);
    fmt::print("{:<22}{:>5}{:>11.3f}{:>10.3f}{:>10.2g}{:>11}{:>10}{:>11}  {}\n", r.engine,
               r.substeps, r.ms_per_frame, r.ms_p99, r.measures.gap,
               cell(r.measures.tension_error, 100.0), cell(r.measures.energy_drift, 100.0),
               cell(r.measures.block_error), verdict);
    std::fflush(stdout);
}

json number(const std::optional<double>& v) {
    return v && std::isfinite(*v) ? json(*v) : json(nullptr);
}

json to_json(const PeerResult& r) {
    const Measures& m = r.measures;
    return {{"engine", r.engine},
            {"scene", r.scene},
            {"settings", r.settings},
            {"substeps", r.substeps},
            {"holds", r.holds},
            {"why_not", r.why_not},
            {"unchecked", r.unchecked},
            {"simulated_s", r.simulated},
            {"ms_per_frame", r.ms_per_frame},
            {"ms_p99", r.ms_p99},
            {"gap_m", number(m.gap)},
            {"tension_error", number(m.tension_error)},
            {"tension_error_substeps", number(m.substep_ripple)},
            {"tension_mean_error", number(m.tension_mean)},
            {"tension_ripple", number(m.tension_ripple)},
            {"tension_worst", number(m.tension_worst)},
            {"energy_drift", number(m.energy_drift)},
            {"energy_drift_end", number(m.energy_end)},
            {"block_error_m", number(m.block_error)},
            {"mode_amplitude", number(m.mode_amplitude)},
            {"frame_ms", r.frame_ms},
            {"tension_times_s", r.tension_times},
            {"tensions_N", r.tensions}};
}

Options parse(int argc, char** argv) {
    Options o;
    CLI::App app{
        "Ours against other engines: each peer at its smallest number of substeps that\n"
        "holds (gap <= 1 mm, tension error <= 2 % rms, energy drift <= 1 %, path error\n"
        "<= 0.1 m over the whole run), all alternated in one run.",
        "hawser-bench peers"};
    std::string known;
    for (const Engine& e : engines()) known += "\n  " + e.name + ": " + e.description;
    app.add_option("--scene", o.scenes, "heavy_hook, tow_zigzag, mooring or all")->delimiter(',');
    app.add_option("--engines", o.engines,
                   "comma-separated, default all; NAME@2 takes the second tree layout:" + known)
        ->delimiter(',');
    app.add_option("--duration", o.search.duration, "simulated time [s], default the scene's")
        ->check(CLI::PositiveNumber);
    app.add_option("--max-substeps", o.search.max_substeps, "end of the search")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    app.add_option("--substeps", o.substeps, "no search: every peer takes this many")
        ->check(CLI::Range(1, 10000));
    app.add_option("--budget", o.search.budget, "wall time of one run of the search [s]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--reference", o.reference, "folder of reference trajectories")
        ->capture_default_str();
    app.add_option("--json", o.json_file, "write all measures and every frame's time here");
    app.add_option("--save-tension", o.save_tension,
                   "write FOLDER/<scene>.csv, the tow tensions of the first engine as a reference");
    app.add_flag("--verbose", o.verbose, "print every attempt of the search");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::exit(app.exit(e) == 0 ? 0 : 2);
    }
    if (o.scenes == std::vector<std::string>{"all"})
        o.scenes = {"heavy_hook", "tow_zigzag", "mooring"};
    if (o.engines.empty())
        for (const Engine& e : engines()) o.engines.push_back(e.name);
    return o;
}

std::vector<PeerResult> compare(const Scene& scene, const Options& o) {
    const Reference reference = load_reference(o.reference, scene);
    const double duration = o.search.duration > 0.0 ? o.search.duration : scene.duration;
    std::vector<PeerResult> failed;
    std::vector<std::unique_ptr<Trial>> trials;
    for (const std::string& name : o.engines) {
        const Engine engine = engine_by_name(name);
        if (!engine.make(scene, 1)) {
            fmt::print("{:<22}  not in this build\n", name);
            continue;
        }
        int substeps = engine.ours ? 1 : o.substeps;
        if (substeps == 0) {
            const auto tell = [&](const PeerResult& r) {
                if (o.verbose) print_row(r);
            };
            const PeerResult r = smallest_that_holds(engine, scene, reference, o.search, tell);
            if (!r.holds) {
                failed.push_back(r);
                continue;
            }
            substeps = r.substeps;
        }
        trials.push_back(std::make_unique<Trial>(engine, scene, reference, substeps, duration));
    }
    alternate(trials);
    std::vector<PeerResult> results;
    for (const auto& t : trials) results.push_back(t->result());
    results.insert(results.end(), failed.begin(), failed.end());
    return results;
}

/// Tensions as a reference file (reference.h). Seven digits: 0.1 N of 500 kN.
void save_tension(const PeerResult& r, const std::string& folder) {
    const std::string path = folder + "/" + r.scene + ".csv";
    std::ofstream out(path);
    out << "t";
    for (std::size_t k = 0; k < r.tensions.size(); ++k) out << ",tension_" << k + 1;
    for (std::size_t i = 0; i < r.tension_times.size(); ++i) {
        out << fmt::format("\n{:.9f}", r.tension_times[i]);
        for (const auto& series : r.tensions) out << fmt::format(",{:.7g}", series[i]);
    }
    out << '\n';
    if (!out) throw std::runtime_error("cannot write " + path);
}

void print_verdict(const std::vector<PeerResult>& results) {
    const PeerResult *ours = nullptr, *best = nullptr;
    for (const PeerResult& r : results) {
        if (r.engine == "hawser")
            ours = &r;
        else if (r.holds && (!best || r.ms_per_frame < best->ms_per_frame))
            best = &r;
    }
    if (best)
        fmt::print("fastest peer that holds: {} with {} substeps ({}), {:.3f} ms per frame\n",
                   best->engine, best->substeps, best->settings, best->ms_per_frame);
    if (best && ours)
        fmt::print("ours: {:.3f} ms, {:.2f} times {}\n", ours->ms_per_frame,
                   ours->ms_per_frame < best->ms_per_frame
                       ? best->ms_per_frame / ours->ms_per_frame
                       : ours->ms_per_frame / best->ms_per_frame,
                   ours->ms_per_frame < best->ms_per_frame ? "faster" : "slower");
}

}  // namespace

int peers_command(int argc, char** argv) {
    const Options o = parse(argc, argv);
    json all = json::array();
    for (const std::string& name : o.scenes) {
        const Scene scene = scene_by_name(name);
        print_header(scene);
        const std::vector<PeerResult> results = compare(scene, o);
        for (const PeerResult& r : results) {
            print_row(r);
            all.push_back(to_json(r));
        }
        print_verdict(results);
        if (!o.save_tension.empty() && !results.empty() && !scene.towed.empty())
            save_tension(results.front(), o.save_tension);
    }
    if (!o.json_file.empty()) {
        std::ofstream out(o.json_file);
        out << all.dump(1) << '\n';
        if (!out) {
            std::cerr << "hawser-bench peers: cannot write " << o.json_file << '\n';
            return 1;
        }
    }
    return 0;
}

}  // namespace hawser::bench
