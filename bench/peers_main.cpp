// SPDX-License-Identifier: Apache-2.0
// hawser-bench peers: searches each peer's smallest number of substeps that holds, then runs all
// engines alternated in blocks of frames and prints the measurements.
#include "commands.h"
#include "peers/make_reference.h"
#include "peers/report.h"

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
    bool make_reference = false;
    bool verbose = false;
};

Options parse(int argc, char** argv) {
    Options o;
    CLI::App app{
        "Ours against other engines: each peer at its smallest number of substeps that\n"
        "holds (gap <= 1 mm, tension error <= 2 % rms, energy drift <= 1 %, path error\n"
        "<= 0.1 m over the whole run), all alternated in one run. In scenes with contacts\n"
        "(mooring_seabed, box_stack, box_stack_1e6) each peer runs with 1, 4, 16\n"
        "and 64 substeps, as far as --budget goes; stacks hold if their top moves by at\n"
        "most 1 mm. What ours is to reach there is checked and printed: exit code 1 if it\n"
        "misses any. All scenes take about 15 minutes, mooring_seabed ten of them;\n"
        "--engines hawser takes seconds.",
        "hawser-bench peers"};
    std::string known, scenes;
    for (const Scene& s : all_scenes()) scenes += (scenes.empty() ? "" : ", ") + s.name;
    for (const Engine& e : engines()) known += "\n  " + e.name + ": " + e.description;
    app.add_option("--scene", o.scenes, "comma-separated, all or of: " + scenes)->delimiter(',');
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
    app.add_flag("--make-reference", o.make_reference,
                 "instead: our engine with 1 to 32 substeps, and write the finest tow tensions to\n"
                 "the folder of --reference; with one --scene, such as mooring_seabed");
    app.add_flag("--verbose", o.verbose, "print every attempt of the search");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::exit(app.exit(e) == 0 ? 0 : 2);
    }
    if (o.scenes == std::vector<std::string>{"all"})
        for (o.scenes.clear(); const Scene& s : all_scenes()) o.scenes.push_back(s.name);
    if (o.engines.empty())
        for (const Engine& e : engines()) o.engines.push_back(e.name);
    return o;
}

/// Run a scene with contacts, in which few peers hold, with increasing numbers of substeps, as each
/// result is of interest. Prints each result at once.
std::vector<PeerResult> raise_substeps(const Scene& scene, const Reference& reference,
                                       const Options& o) {
    std::vector<PeerResult> rows;
    for (const std::string& name : o.engines) {
        const Engine engine = engine_by_name(name);
        if (!engine.make(scene, 1)) {
            fmt::print("{:<22}  left out: not in this build, or without such contacts\n", name);
            continue;
        }
        for (const int n : {1, 4, 16, 64}) {
            if (n > std::max(1, o.search.max_substeps)) break;
            const int substeps = engine.ours || o.substeps == 0 ? n : o.substeps;
            std::fprintf(stderr, "%s: %s, %d substeps ...\n", scene.name.c_str(), name.c_str(),
                         substeps);
            const double wall =
                measure_time([&] {
                    rows.push_back(run_peer(engine, scene, substeps, reference, o.search, false));
                }).wall;
            print_row(scene, rows.back());
            // Four times the substeps take four times as long.
            if (engine.ours || o.substeps > 0 || 4.0 * wall > o.search.budget) break;
        }
    }
    return rows;
}

std::vector<PeerResult> compare(const Scene& scene, const Options& o) {
    const Reference reference = load_reference(o.reference, scene);
    if (scene.touching) return raise_substeps(scene, reference, o);
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
                if (o.verbose) print_row(scene, r);
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
    run_in_turns(trials);
    std::vector<PeerResult> results;
    for (const auto& t : trials) results.push_back(t->result());
    results.insert(results.end(), failed.begin(), failed.end());
    return results;
}

/// Write tensions as a reference file (reference.h). Seven digits: 0.1 N of 500 kN.
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

void write_json(const json& all, const std::string& file) {
    std::ofstream out(file);
    out << all.dump(1) << '\n';
    if (!out) throw std::runtime_error("cannot write " + file);
}

}  // namespace

int peers_command(int argc, char** argv) {
    const Options o = parse(argc, argv);
    json all = json::array();
    bool met = true;
    for (const std::string& name : o.scenes) {
        const Scene scene = scene_by_name(name);
        if (o.make_reference) {
            const double duration = o.search.duration > 0.0 ? o.search.duration : scene.duration;
            make_reference(scene, duration, o.reference);
            continue;
        }
        print_header(scene);
        const std::vector<PeerResult> results = compare(scene, o);
        for (const PeerResult& r : results) {
            if (!scene.touching) print_row(scene, r);
            all.push_back(to_json(scene, r));
        }
        met = print_verdict(scene, results) && met;
        if (!o.json_file.empty()) write_json(all, o.json_file);  // keeps finished results
        if (!o.save_tension.empty() && !results.empty() && !scene.towed.empty())
            save_tension(results.front(), o.save_tension);
    }
    return met ? 0 : 1;
}

}  // namespace hawser::bench
