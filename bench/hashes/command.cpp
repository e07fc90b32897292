// SPDX-License-Identifier: Apache-2.0
// hawser-bench hashes: equal bits for any number of threads and after a restore.
#include <hawser/world.h>

#include "commands.h"
#include "hashes/compare.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hawser::bench {
namespace {

nlohmann::json figures_of(const HashComparison& c, const std::string& method) {
    nlohmann::json runs = nlohmann::json::array();
    for (const HashRun& r : c.runs)
        runs.push_back({{"threads", r.threads},
                        {"restored_from", r.restored_from},
                        {"saved_after", r.steps_to_saved},
                        {"first_difference", r.first_difference}});
    return {{"scene", c.scene},
            {"nonsmooth", method},
            {"steps", c.steps},
            {"saved_after", c.steps_to_saved},
            {"status", to_string(c.status)},
            {"hash", fmt::format("{:016x}", c.hash)},
            {"contacts_max", c.contacts_max},
            {"sliding_max", c.sliding_max},
            {"sliding_steps", c.sliding_steps},
            {"edited_steps", c.edited_steps},
            {"equal", c.equal()},
            {"runs", runs}};
}

void print_line(const HashComparison& c, const std::string& method) {
    fmt::print("{:<18} {:<9} {:>6} {:>9} {:>8} {:>8} {:>6} {:>5} {:016x}  {}\n", c.scene, method,
               c.steps, c.contacts_max, c.sliding_max, c.sliding_steps, c.edited_steps,
               to_string(c.status), c.hash, c.equal() ? "equal" : "DIFFERENT");
    for (const HashRun& r : c.runs) {
        if (r.first_difference == 0) continue;
        fmt::print("    {} thread(s), {}: first difference after step {}\n", r.threads,
                   r.restored_from == 0 ? std::string("from the start")
                                        : fmt::format("from step {} of {} thread(s)",
                                                      r.steps_to_saved, r.restored_from),
                   r.first_difference);
    }
    std::fflush(stdout);
}

}  // namespace

int hashes_command(int argc, char** argv) {
    CLI::App app(
        "Compare state hashes step by step between numbers of threads, from the start and from a "
        "state that a world with another number of threads saved half way. Timelines of scenes are "
        "done.",
        "hawser-bench hashes");
    std::vector<std::string> files, methods{"newton"};
    HashOptions options;
    std::string json;
    app.add_option(
        "SCENE", files,
        "Scene files; default: all of scenes/ with contacts, or friction, ranges or motors "
        "of joints");
    app.add_option("--steps", options.steps, "Steps of each run")
        ->check(CLI::Range(2, 10'000'000))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "Numbers of threads to compare")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    app.add_option("--nonsmooth", methods, "Methods for contacts; 'all': every one")
        ->check(CLI::IsMember({"all", "newton", "pivoting", "split", "pgs", "convex"}))
        ->capture_default_str();
    app.add_option("--restores", options.restores,
                   "Go on from so many states more, at random steps and just before edits")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    app.add_option("--json", json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);

    const bool chosen = !files.empty();
    if (!chosen) files = nonsmooth_scenes("scenes");
    if (methods.front() == "all") methods = {"newton", "pivoting", "split", "pgs", "convex"};
    fmt::print("hashes after every step, {} thread(s), saved half way; {}\n",
               fmt::join(options.threads, ", "), instruction_set());
    fmt::print("{:<18} {:<9} {:>6} {:>9} {:>8} {:>8} {:>6} {:>5} {:<16}\n", "scene", "method",
               "steps", "contacts", "sliding", "in steps", "edited", "", "hash");
    nlohmann::json rows = nlohmann::json::array();
    int different = 0;
    for (const std::string& file : files)
        for (const std::string& method : methods) {
            options.set = {"settings.nonsmooth=" + method};
            try {
                const HashComparison c = compare_hashes(file, options);
                print_line(c, method);
                rows.push_back(figures_of(c, method));
                if (!c.equal()) ++different;
            } catch (const std::runtime_error& refused) {
                // Not every method accepts every scene; a requested scene must be accepted.
                if (chosen || method == "newton") throw;
                fmt::print("{:<18} {:<9} left out: {}\n",
                           std::filesystem::path(file).stem().string(), method, refused.what());
            }
        }
    fmt::print("{} of {} equal\n", rows.size() - static_cast<std::size_t>(different), rows.size());
    if (!json.empty()) std::ofstream(json) << rows.dump(2) << '\n';
    return different == 0 ? 0 : 1;
}

}  // namespace hawser::bench
