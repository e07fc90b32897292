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
using scene::Place;

class Checker {
  public:
    Checker(const scene::Scene& scene, Place place)
        : scene_(scene),
          place_(std::move(place)),
          inputs_(input_names(scene)),
          outputs_(output_names(scene.world)) {}

    void input(const std::string& name, const Place& place) const {
        known(name, place, "input", inputs_);
    }
    void output(const std::string& name, const Place& place) const {
        known(name, place, "output", outputs_);
    }
    void trigger(const Trigger& when, const Place& place) const {
        for (std::size_t i = 0; i < when.conditions.size(); ++i)
            output(when.conditions[i].output, place / "when" / i / "output");
    }
    template <class T>
    void triggers(const std::vector<T>& list, const char* key) const {
        for (std::size_t i = 0; i < list.size(); ++i) trigger(list[i].when, place_ / key / i);
    }
    void fault(const Fault& f, const Place& place) const {
        switch (f.kind) {
            case FaultKind::line_parts:
                return wire(f, place);
            case FaultKind::motor_loses_force:
                return acting(f, place / "motor", "drives");
            case FaultKind::brake_slips:
                return acting(f, place / "brake", "rubs");
            case FaultKind::input_stuck:
            case FaultKind::input_late:
                return input(f.target, place / "input");
            case FaultKind::output_frozen:
                return output(f.target, place / "output");
        }
    }

  private:
    static void known(const std::string& name, const Place& place, const std::string& what,
                      const std::vector<std::string>& names) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            scene::refuse(place, "there is no " + what + " " + scene::in_quotes(name) +
                                     scene::suggestion(name, names));
    }

    void wire(const Fault& f, const Place& place) const {
        const World& world = scene_.world;
        if (const WireId id = world.wires().find(f.target); id.valid()) {
            if (!std::isnan(f.s) && f.s > world.wires().length(id))
                scene::refuse(place / "s", "the wire is shorter");
            return;
        }
        if (const InteractionId id = world.find_interaction(f.target); id.valid()) {
            if (kind_info(world.interaction_def(id).kind).is(kWireElement)) return;
            scene::refuse(place / "wire", scene::in_quotes(f.target) + " is no element of a line");
        }
        std::vector<std::string> names;
        for (const WireId id : world.wires().ids()) names.push_back(world.wires().name(id));
        known(f.target, place / "wire", "wire", names);
    }

    /// Check that the target is a winch, or an interaction of the right kind that no system drives.
    void acting(const Fault& f, const Place& place, const char* what) const {
        const World& world = scene_.world;
        if (is_winch(world, f.target)) {
            if (f.kind == FaultKind::motor_loses_force && f.share > 0.0)
                scene::refuse(place,
                              "the motor of a winch always fails completely; \"share\" is for "
                              "motors of the scene only");
            return;
        }
        const std::string front = f.target.substr(0, f.target.rfind('/'));
        const InteractionId id = world.find_interaction(f.target);
        if (id.valid() && world.find_system(front) != nullptr)
            scene::refuse(place, "it belongs to " + scene::in_quotes(front) +
                                     ", which commands it: name a winch, or for a crane an "
                                     "input that is stuck");
        if (id.valid() && !fault_params(f.kind, world, id).empty()) return;
        std::vector<std::string> names;
        for (const SystemSignal& s : world.system_signals())
            if (s.input && s.name == "mode" && is_winch(world, s.system)) names.push_back(s.system);
        for (const InteractionId each : world.interactions())
            if (!fault_params(f.kind, world, each).empty())
                names.push_back(world.interaction_def(each).name);
        scene::refuse(place, scene::in_quotes(f.target) + " is no winch, and nothing that " + what +
                                 scene::suggestion(f.target, names));
    }

    const scene::Scene& scene_;
    Place place_;
    std::vector<std::string> inputs_, outputs_;
};

}  // namespace

void check_names(const Exercise& exercise, const scene::Scene& scene, const Place& place) {
    const Checker check(scene, place);
    for (std::size_t i = 0; i < exercise.stations.size(); ++i)
        for (std::size_t k = 0; k < exercise.stations[i].inputs.size(); ++k)
            check.input(exercise.stations[i].inputs[k], place / "stations" / i / "inputs" / k);
    for (std::size_t i = 0; i < exercise.displays.size(); ++i)
        check.output(exercise.displays[i], place / "displays" / i);
    for (std::size_t i = 0; i < exercise.faults.size(); ++i)
        check.fault(exercise.faults[i], place / "faults" / i);
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
            if (!driver_of(world, id, param).valid() && !listed)
                out.push_back({{"name", name}, {"interaction", f.target}, {"param", param}});
        }
    }
    return out;
}

}  // namespace hawser::exercise
