// SPDX-License-Identifier: Apache-2.0
/// Check that the scene has everything that an exercise names.
#include <hawser/hawser.h>

#include "exercise/names.h"
#include "exercise/reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace hawser::exercise {
namespace {

using scene::Json;
using scene::SourceLocation;

class Checker {
  public:
    Checker(const scene::Scene& scene, SourceLocation location)
        : scene_(scene),
          location_(std::move(location)),
          inputs_(input_names(scene)),
          outputs_(output_names(scene.world)) {}

    void input(const std::string& name, const SourceLocation& location) const {
        check_name(name, location, "input", inputs_);
    }
    void output(const std::string& name, const SourceLocation& location) const {
        check_name(name, location, "output", outputs_);
    }
    void trigger(const Trigger& when, const SourceLocation& location) const {
        for (std::size_t i = 0; i < when.conditions.size(); ++i)
            output(when.conditions[i].output, location / "when" / i / "output");
    }
    template <class T>
    void triggers(const std::vector<T>& list, const char* key) const {
        for (std::size_t i = 0; i < list.size(); ++i) trigger(list[i].when, location_ / key / i);
    }
    void fault(const Fault& f, const SourceLocation& location) const {
        switch (f.kind) {
            case FaultKind::line_parts:
                return wire(f, location);
            case FaultKind::motor_loses_force:
                return check_acting_target(f, location / "motor", "drives");
            case FaultKind::brake_slips:
                return check_acting_target(f, location / "brake", "rubs");
            case FaultKind::input_stuck:
            case FaultKind::input_late:
                return input(f.target, location / "input");
            case FaultKind::output_frozen:
                return output(f.target, location / "output");
        }
    }

  private:
    static void check_name(const std::string& name, const SourceLocation& location,
                           const std::string& what, const std::vector<std::string>& names) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            scene::throw_error(location, "there is no " + what + " " + scene::in_quotes(name) +
                                             scene::suggestion(name, names));
    }

    void wire(const Fault& f, const SourceLocation& location) const {
        const World& world = scene_.world;
        if (const WireId id = world.wires().find(f.target); id.valid()) {
            if (!std::isnan(f.s) && f.s > world.wires().length(id))
                scene::throw_error(location / "s", "the wire is shorter");
            return;
        }
        if (const InteractionId id = world.find_interaction(f.target); id.valid()) {
            if (kind_info(world.interaction_def(id).kind).is(kWireElement)) return;
            scene::throw_error(location / "wire",
                               scene::in_quotes(f.target) + " is no element of a line");
        }
        std::vector<std::string> names;
        for (const WireId id : world.wires().ids()) names.push_back(world.wires().name(id));
        check_name(f.target, location / "wire", "wire", names);
    }

    /// Check that the target is a winch, or an interaction of the right kind that no system drives.
    void check_acting_target(const Fault& f, const SourceLocation& location,
                             const char* what) const {
        const World& world = scene_.world;
        if (is_winch(world, f.target)) {
            if (f.kind == FaultKind::motor_loses_force && f.share > 0.0)
                scene::throw_error(location,
                                   "the motor of a winch always fails completely; \"share\" is for "
                                   "motors of the scene only");
            return;
        }
        const std::string front = f.target.substr(0, f.target.rfind('/'));
        const InteractionId id = world.find_interaction(f.target);
        if (id.valid() && world.find_system(front) != nullptr)
            scene::throw_error(location, "it belongs to " + scene::in_quotes(front) +
                                             ", which commands it: name a winch, or for a crane an "
                                             "input that is stuck");
        if (id.valid() && !fault_params(f.kind, world, id).empty()) return;
        std::vector<std::string> names;
        for (const SystemSignal& s : world.system_signals())
            if (s.input && s.name == "mode" && is_winch(world, s.system)) names.push_back(s.system);
        for (const InteractionId each : world.interactions())
            if (!fault_params(f.kind, world, each).empty())
                names.push_back(world.interaction_def(each).name);
        scene::throw_error(location, scene::in_quotes(f.target) +
                                         " is no winch, and nothing that " + what +
                                         scene::suggestion(f.target, names));
    }

    const scene::Scene& scene_;
    SourceLocation location_;
    std::vector<std::string> inputs_, outputs_;
};

}  // namespace

void check_names(const Exercise& exercise, const scene::Scene& scene,
                 const SourceLocation& location) {
    const Checker check(scene, location);
    for (std::size_t i = 0; i < exercise.stations.size(); ++i)
        for (std::size_t k = 0; k < exercise.stations[i].inputs.size(); ++k)
            check.input(exercise.stations[i].inputs[k], location / "stations" / i / "inputs" / k);
    for (std::size_t i = 0; i < exercise.displays.size(); ++i)
        check.output(exercise.displays[i], location / "displays" / i);
    for (std::size_t i = 0; i < exercise.faults.size(); ++i)
        check.fault(exercise.faults[i], location / "faults" / i);
    check.triggers(exercise.alarms, "alarms");
    check.triggers(exercise.goals, "goals");
    check.triggers(exercise.penalties, "penalties");
    check.triggers(exercise.ends, "ends");
}

Json missing_inputs(const Exercise& exercise, const World& world) {
    Json out = Json::array();
    for (const Fault& f : exercise.faults) {
        if (f.kind != FaultKind::motor_loses_force && f.kind != FaultKind::brake_slips) continue;
        const InteractionId id = world.find_interaction(f.target);
        if (is_winch(world, f.target) || !id.valid()) continue;
        for (const std::string& param : fault_params(f.kind, world, id)) {
            // Names of inputs must not contain '/', but names from templates do.
            std::string name = "fault." + f.target + "." + param;
            std::replace(name.begin(), name.end(), '/', '.');
            const bool listed = std::any_of(out.begin(), out.end(),
                                            [&](const Json& j) { return j["name"] == name; });
            if (!driving_input(world, id, param).valid() && !listed)
                out.push_back({{"name", name}, {"interaction", f.target}, {"param", param}});
        }
    }
    return out;
}

}  // namespace hawser::exercise
