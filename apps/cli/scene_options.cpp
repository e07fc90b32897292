// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include "commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::cli {

void SceneOptions::add_changes_to(CLI::App& command) {
    command.add_option("--step", step, "Time step [s]; default: settings.step of the scene")
        ->check(positive());
    command.add_option("--scale", scale, "Number of copies of the scene in one world")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        .add_option(
            "--set", set,
            "Change a value of the scene: path=value, such as bodies.rig.mass=2e7; repeatable")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void SceneOptions::add_to(CLI::App& command, bool required) {
    command.add_option("SCENE", file, "Scene file (JSON)")->required(required);
    add_changes_to(command);
    command.add_option("--form", form, "Form of the equations: auto, saddle or condensed")
        ->check(CLI::IsMember({"auto", "saddle", "condensed"}));
    command
        .add_option("--nonsmooth", nonsmooth,
                    "Solver of contacts with friction: newton, pivoting, split, pgs or convex")
        ->check(CLI::IsMember({"newton", "pivoting", "split", "pgs", "convex"}));
    command
        .add_option(
            "--coupling", coupling,
            "Coupling of groups of bodies: exact, kinematic, compliant, or deadline (exact; "
            "compliant if --budget requires it). --parts sets the groups of bodies without a group")
        ->check(CLI::IsMember({"exact", "kinematic", "compliant", "deadline"}));
    command
        .add_option("--predictor", predictor,
                    "Prediction of velocities across a cut: hold, forces or clique")
        ->check(CLI::IsMember({"hold", "forces", "clique"}));
    command
        .add_option("--parts", parts,
                    "Number of parts for display (4), or for the cuts of a coupling that is not "
                    "exact; settings.regroup_every renews the cuts")
        ->check(CLI::Range(1, 4096));
    command
        .add_option("--sweeps", sweeps, "Number of sweeps in a step of --nonsmooth split and pgs")
        ->check(CLI::Range(1, 100000));
    command
        .add_option("--sleep", sleep,
                    "Time at rest [s] after which an island sleeps until it is disturbed; 0: never")
        ->check(CLI::Range(0.0, 1e6));
    command.add_option("--threads", threads, "Worker threads; results do not depend on it")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
}

scene::Scene SceneOptions::load() const {
    std::vector<scene::SceneError> mistakes;
    std::optional<scene::Scene> scene = load(mistakes);
    if (scene) return std::move(*scene);
    scene::SceneError first = mistakes.front();
    if (mistakes.size() > 1)
        first = scene::SceneError(first.file, first.path,
                                  fmt::format("{} (and {} more: `hawser check` lists them)",
                                              first.message, mistakes.size() - 1));
    throw first;
}

std::optional<scene::Scene> SceneOptions::load(std::vector<scene::SceneError>& mistakes) const {
    return scene::load_file(file, options(), mistakes);
}

namespace {

bool is_json(const std::string& file) { return file.ends_with(".json"); }

std::string single_file(const std::vector<std::string>& files, bool json) {
    std::string out;
    for (const std::string& file : files) {
        if (is_json(file) != json) continue;
        if (!out.empty()) {
            std::string both = out + " and ";
            both += file;
            throw std::runtime_error("--control: " + both +
                                     ": give one CSV file and one JSON file at most");
        }
        out = file;
    }
    return out;
}

}  // namespace

void SceneOptions::add_control_to(CLI::App& command) {
    command
        .add_option("--control", controls,
                    "Input values over time (FILE.csv), or operations in the format of "
                    "\"timeline\" (FILE.json); at most one of each")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::string SceneOptions::control() const { return single_file(controls, false); }
std::string SceneOptions::operations() const { return single_file(controls, true); }

scene::Options SceneOptions::options() const {
    scene::Options options;
    options.operations = operations();
    options.scale = scale;
    options.set = set;
    if (nonsmooth) options.set.push_back("settings.nonsmooth=" + *nonsmooth);
    if (coupling) options.set.push_back("settings.coupling=" + *coupling);
    if (predictor) options.set.push_back("settings.predictor=" + *predictor);
    if (parts) options.set.push_back("settings.parts=" + std::to_string(*parts));
    if (sweeps) options.set.push_back("settings.nonsmooth_sweeps=" + std::to_string(*sweeps));
    if (sleep) options.set.push_back(fmt::format("settings.sleep_after={}", *sleep));
    options.step = step;
    options.threads = threads;
    options.budget = 1e-3 * budget_ms;
    options.budget_work = 1e6 * budget_mflop;
    if (form)
        options.form = *form == "saddle"      ? Form::saddle
                       : *form == "condensed" ? Form::condensed
                                              : Form::automatic;
    return options;
}

}  // namespace hawser::cli
