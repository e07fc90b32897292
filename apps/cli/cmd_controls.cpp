// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>
#include "commands.h"
#include "outputs.h"
#include "record/commands.h"
#include "record/names.h"
#include "record/random_control.h"
#include "scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::cli {

namespace {

constexpr const char* kControlsFooter = R"(Examples:
  hawser controls scenes/tackle.json --seed 7 --duration 60 -o inputs.csv
  hawser run scenes/tackle.json --duration 60 --control inputs.csv
  hawser controls scenes/tow_payout.json --signals --range winch.speed=-2:2 -o inputs.csv
  hawser controls exercises/tow_out.json --seed 3 -o inputs.csv     # its stations' inputs

Values stay within the declared ranges of the scene. An input without a range is omitted with a
message, unless it has a nominal value or --range sets one. Equal seed, scene and options give equal
files.

Exit codes: 0 written, 1 wrong option or file, or no input.)";

constexpr double kNoLimit = 1e29;  // InputDef::max is 1e30 by default, SystemSignal::max 1e300.

struct ControlsOptions {
    SceneOptions scene;
    record::RandomControlDef def;
    std::optional<double> duration;
    std::string out;
    std::vector<std::string> ranges;
    bool signals = false;
};

struct Candidate {
    record::RandomInput input;
    double nominal = 0.0;
};

/// True if a system rounds the signal to a whole number or compares it with 0.5.
bool is_whole_signal(std::string_view signal) {
    constexpr std::array<std::string_view, 4> kWholeSignals = {"mode", "take", "close", "up"};
    const std::string_view name = signal.substr(signal.rfind('.') + 1);
    return std::find(kWholeSignals.begin(), kWholeSignals.end(), name) != kWholeSignals.end();
}

const SystemSignal* find_signal(const World& world, const std::string& name) {
    for (const SystemSignal& s : world.system_signals())
        if (s.input && s.system + "." + s.name == name) return &s;
    return nullptr;
}

Candidate random_input_from(const World& world, InputId id) {
    const InputDef& def = world.input_def(id);
    return {{.name = def.name,
             .min = def.min,
             .max = def.max,
             .start = world.input(id),
             .rest = def.spring.value_or(world.input(id))},
            def.nominal};
}

/// Return the range of the signal divided by the factor, restricted to the range of the input.
Candidate random_input_from(const World& world, const scene::SignalInput& lever) {
    Candidate out{{.name = lever.name,
                   .min = lever.min,
                   .max = lever.max,
                   .whole = lever.factor == 1.0 && is_whole_signal(lever.signal)},
                  lever.nominal};
    const SystemSignal* signal = find_signal(world, lever.signal);
    if (signal == nullptr || lever.factor == 0.0) return out;
    const double a = signal->min / lever.factor, b = signal->max / lever.factor;
    out.input.min = std::max(out.input.min, std::min(a, b));
    out.input.max = std::min(out.input.max, std::max(a, b));
    out.input.start = *signal->value / lever.factor;
    out.input.rest = lever.spring.value_or(out.input.start);
    return out;
}

Candidate random_input_from(const SystemSignal& signal) {
    return {{.name = signal.system + "." + signal.name,
             .min = signal.min,
             .max = signal.max,
             .start = *signal.value,
             .rest = *signal.value,
             .whole = is_whole_signal(signal.name)},
            0.0};
}

std::vector<Candidate> random_inputs_from(const scene::Scene& scene, bool with_signals) {
    const World& world = scene.world;
    std::vector<Candidate> out;
    for (const InputId id : world.inputs())
        if (!record::is_inner_input(world, world.input_def(id).name))
            out.push_back(random_input_from(world, id));
    for (const scene::SignalInput& lever : scene.signal_inputs)
        out.push_back(random_input_from(world, lever));
    if (!with_signals) return out;
    for (const SystemSignal& signal : world.system_signals()) {
        const std::string name = signal.system + "." + signal.name;
        const bool set = std::any_of(scene.signal_inputs.begin(), scene.signal_inputs.end(),
                                     [&](const auto& lever) { return lever.signal == name; });
        if (signal.input && !set) out.push_back(random_input_from(signal));
    }
    return out;
}

/// Return the inputs of the exercise's stations. `hawser exercise` rejects others.
std::vector<Candidate> random_inputs_from(const exercise::Loaded& loaded) {
    std::vector<Candidate> all = random_inputs_from(loaded.scene, true);
    std::erase_if(all, [&](const Candidate& c) {
        const auto& stations = loaded.exercise.stations;
        return std::none_of(stations.begin(), stations.end(), [&](const auto& station) {
            return std::find(station.inputs.begin(), station.inputs.end(), c.input.name) !=
                   station.inputs.end();
        });
    });
    return all;
}

double read_limit(const std::string& option, const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value))
        throw std::runtime_error(fmt::format(
            "--range {}: expected NAME=MIN:MAX with two numbers, e.g. winch.speed=-2:2", option));
    return value;
}

/// Apply --range, which narrows the range of an input and never widens it.
void apply_range(const std::string& option, std::vector<Candidate>& candidates) {
    const std::size_t equals = option.rfind('='), colon = option.rfind(':');
    if (equals == std::string::npos || colon == std::string::npos || colon < equals)
        throw std::runtime_error(
            fmt::format("--range {}: expected NAME=MIN:MAX, e.g. winch.speed=-2:2", option));
    const std::string name = option.substr(0, equals);
    const double min = read_limit(option, option.substr(equals + 1, colon - equals - 1));
    const double max = read_limit(option, option.substr(colon + 1));
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return c.input.name == name; });
    if (found == candidates.end()) {
        std::vector<std::string> names;
        for (const Candidate& c : candidates) names.push_back(c.input.name);
        throw std::runtime_error(
            fmt::format("--range {}: there is no input \"{}\"; nearest: \"{}\"", option, name,
                        record::nearest_name(name, names)));
    }
    record::RandomInput& input = found->input;
    if (!(min <= max) || min < input.min || max > input.max)
        throw std::runtime_error(
            fmt::format("--range {}: not within the range of \"{}\", {:.6g} "
                        "to {:.6g}",
                        option, name, input.min, input.max));
    input.min = min;
    input.max = max;
}

/// Return the inputs with a finite range; name the others on standard error.
std::vector<record::RandomInput> finite_inputs(const std::vector<Candidate>& candidates,
                                               const std::string& file) {
    std::vector<record::RandomInput> out;
    for (const Candidate& c : candidates) {
        record::RandomInput input = c.input;
        const bool open = input.min < -kNoLimit || input.max > kNoLimit;
        if (open && c.nominal > 0.0) {
            input.min = std::max(input.min, -c.nominal);
            input.max = std::min(input.max, c.nominal);
        } else if (open) {
            fmt::print(stderr,
                       "{}: the input \"{}\" has no range and is left out; declare \"min\" and "
                       "\"max\", or give --range {}=MIN:MAX\n",
                       file, input.name, input.name);
            continue;
        }
        out.push_back(std::move(input));
    }
    return out;
}

/// Return the inputs of a scene. Signals of its systems are included on request, and if the scene
/// defines no input itself.
std::vector<Candidate> random_inputs_from(const ControlsOptions& options,
                                          const scene::Scene& scene) {
    std::vector<Candidate> own = random_inputs_from(scene, options.signals);
    if (options.signals || !own.empty()) return own;
    std::vector<Candidate> signals = random_inputs_from(scene, true);
    if (!signals.empty())
        fmt::print(stderr, "{}: the scene defines no inputs; {} signals of its systems are used\n",
                   scene.path, signals.size());
    return signals;
}

int write_controls(ControlsOptions& options) {
    const bool exercise = exercise::is_exercise(options.scene.file);
    exercise::Loaded loaded;
    if (exercise)
        loaded = exercise::load_file(options.scene.file, options.scene.options());
    else
        loaded.scene = options.scene.load();
    const scene::Scene& scene = loaded.scene;
    check_outputs({{"the scene", options.scene.file}}, {{"-o", options.out}});
    std::vector<Candidate> candidates =
        exercise ? random_inputs_from(loaded) : random_inputs_from(options, scene);
    for (const std::string& range : options.ranges) apply_range(range, candidates);
    const std::vector<record::RandomInput> inputs = finite_inputs(candidates, scene.path);
    if (inputs.empty())
        throw std::runtime_error(scene.path +
                                 ": the scene has no inputs that can be set at random");
    options.def.duration =
        options.duration.value_or(exercise ? loaded.exercise.duration : scene.duration);
    write_output(options.out, record::random_control(inputs, options.def), "the control file");
    return kOk;
}

}  // namespace

void add_controls(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ControlsOptions>();
    CLI::App* command = app.add_subcommand(
        "controls", "Write random steps and ramps of a scene's inputs, for run --control");
    command->footer(kControlsFooter);
    command->add_option("SCENE", options->scene.file, "Scene or exercise file (JSON)")->required();
    options->scene.add_changes_to(*command);
    command->add_option("--seed", options->def.seed, "Seed of the random numbers")
        ->capture_default_str();
    command
        ->add_option("--duration", options->duration,
                     "End of the changes [s]; default: duration of the scene")
        ->check(positive());
    command
        ->add_option("--period", options->def.period, "Mean time between changes of an input [s]")
        ->check(positive())
        ->capture_default_str();
    command->add_option("--interval", options->def.interval, "Time between lines of a ramp [s]")
        ->check(positive())
        ->capture_default_str();
    command
        ->add_option("--range", options->ranges,
                     "NAME=MIN:MAX: narrower range of an input; repeatable")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_flag(
        "--signals", options->signals,
        "Include signals of systems, such as winch.speed, that no input sets; default "
        "for a scene without inputs");
    command->add_option("-o,--output", options->out, "File to write (CSV)")->required();
    command->callback(
        [&chosen, options] { chosen = [options] { return write_controls(*options); }; });
}

}  // namespace hawser::cli
