// SPDX-License-Identifier: Apache-2.0
#include "golden/scene_run.h"

#include <hawser/hawser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace hawser::golden {

namespace {

constexpr double kDuration = 4.0;  // Duration of the run of a small scene [s].

/// Input that the run sets.
struct Lever {
    std::string name;
    double min = 0.0, max = 0.0;
    bool whole = false;  ///< Whole numbers only.
    double start = 0.0;  ///< Value at the start.
};

/// Range in which the run sets an input of a system, by the name of its signal.
struct SignalRange {
    std::string_view signal;
    double min, max;
    bool whole;
};

constexpr std::array<SignalRange, 11> kRanges{{{"mode", 0.0, 4.0, true},
                                               {"speed", -1.0, 1.0, false},
                                               {"tension", 0.0, 3e5, false},
                                               {"clutch", 0.0, 1.0, true},
                                               {"take", 0.0, 1.0, true},
                                               {"up", 0.0, 1.0, true},
                                               {"close", 0.0, 1.0, true},
                                               {"waves", 0.0, 2.0, false},
                                               {"current", -1.0, 1.0, false},
                                               {"wind", 0.0, 30.0, false},
                                               {"level", -1.0, 1.0, false}}};

Lever lever_of(const SystemSignal& signal) {
    Lever lever{signal.system + "." + signal.name, signal.min, signal.max, false, *signal.value};
    for (const SignalRange& range : kRanges) {
        if (range.signal != signal.name) continue;
        lever.min = std::max(lever.min, range.min);
        lever.max = std::min(lever.max, range.max);
        lever.whole = range.whole;
    }
    return lever;
}

/// True if a system of the world sets this input itself.
bool is_inner(const World& world, const std::string& input) {
    const auto& signals = world.system_signals();
    return std::any_of(signals.begin(), signals.end(),
                       [&](const SystemSignal& s) { return input.starts_with(s.system + "/"); });
}

std::vector<Lever> levers_of(const scene::Scene& scene) {
    std::vector<Lever> levers;
    constexpr double kWidest = 1e12;  // Wider ranges mean "any value".
    constexpr double kWay = 0.05;     // Largest change of a position [m or rad].
    const World& world = scene.world;
    for (const InputId id : world.inputs()) {
        const InputDef& def = world.input_def(id);
        if (is_inner(world, def.name) || def.max - def.min >= kWidest) continue;
        Lever lever{def.name, def.min, def.max, false, world.input(id)};
        if (def.param == "target") {  // No joint can follow a jump of its position.
            lever.min = std::max(lever.min, lever.start - kWay);
            lever.max = std::min(lever.max, lever.start + kWay);
        }
        levers.push_back(lever);
    }
    for (const scene::SignalInput& input : scene.signal_inputs)
        if (input.max - input.min < kWidest)
            levers.push_back({input.name, input.min, input.max, false, std::max(0.0, input.min)});
    for (const SystemSignal& signal : world.system_signals())
        if (const Lever lever = lever_of(signal); signal.input && lever.max - lever.min < kWidest)
            levers.push_back(lever);
    return levers;
}

/// Return value number `moment` of the sequence of a control; number 0 is its value at the start.
/// @param part  Fraction of the difference between the start and a random value in the range.
double value_of(const Lever& lever, std::size_t index, int moment, double part) {
    if (moment == 0) return lever.start;
    const double share = std::abs(weight(1000 + index, static_cast<std::uint64_t>(moment))) - 0.5;
    const double value = lever.min + share * (lever.max - lever.min);
    return lever.whole ? std::round(value) : lever.start + part * (value - lever.start);
}

/// Set all controls to their values at a time in units of moments. Values change linearly from
/// moment to moment; whole numbers change at moments.
void set_levers(Session& session, const std::vector<Lever>& levers, double time, double part) {
    const int moment = static_cast<int>(time);
    for (std::size_t i = 0; i < levers.size(); ++i) {
        const double from = value_of(levers[i], i, moment, part);
        const double to = value_of(levers[i], i, moment + 1, part);
        session.set_input(levers[i].name,
                          levers[i].whole ? to : from + (time - moment) * (to - from));
    }
}

std::vector<Pose> poses_of(const World& world) {
    std::vector<Pose> poses(static_cast<std::size_t>(world.body_count()));
    for (const BodyId id : world.bodies())
        poses[static_cast<std::size_t>(id.index)] = world.pose(id);
    return poses;
}

}  // namespace

int default_steps(const World& world) {
    constexpr double kBodySteps = 20000.0;
    const double bodies = std::max(1.0, static_cast<double>(world.bodies().size()));
    const double most = std::min(kDuration / world.settings().step, kBodySteps / bodies);
    return static_cast<int>(std::clamp(std::round(most), 5.0, 1000.0));
}

Figures run_scene(scene::Scene scene, int steps) {
    Figures figures;
    std::array<char, 17> hash{};
    std::snprintf(hash.data(), hash.size(), "%016llx", static_cast<unsigned long long>(scene.hash));
    figures.texts["scene"] = hash.data();

    const std::vector<Pose> start = poses_of(scene.world);
    const std::vector<Lever> levers = levers_of(scene);
    figures.counts["levers"] = static_cast<std::int64_t>(levers.size());
    Session session(std::move(scene));
    StepSums sums;
    const int first = (steps + 3) / 4, stride = std::max(1, steps / 8);
    // Shorter runs get smaller changes: no motor can follow the whole range in a few steps.
    const double part = std::min(1.0, steps * session.world().settings().step / kDuration);
    for (int k = 0; k < steps; ++k) {
        if (k >= first) set_levers(session, levers, static_cast<double>(k - first) / stride, part);
        if (session.step() != Status::ok) break;
        sums.add(session.world());
    }
    figures.counts["steps"] = session.world().step_count();
    sums.write(figures);
    write_state(session.world(), start, figures);
    return figures;
}

}  // namespace hawser::golden
