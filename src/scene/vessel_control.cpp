// SPDX-License-Identifier: Apache-2.0
#include "scene/vessel_control.h"

#include "scene/field_reader.h"

#include <numbers>
#include <string>

namespace hawser::scene {
namespace {

constexpr double kControlDegree = std::numbers::pi / 180.0;

/// Return a name if the vessel has a propulsor with this name. @throws SceneError
std::string propulsor_name(const Json& json, const std::vector<PropulsorDef>& propulsors,
                           const SourceLocation& location) {
    const std::string name = json.get<std::string>();
    std::vector<std::string> known;
    for (const PropulsorDef& p : propulsors) {
        if (p.name == name) return name;
        known.push_back(p.name);
    }
    throw_error(location, "there is no propulsor " + in_quotes(name) + suggestion(name, known));
}

/// Return the element of a line at the body: an interaction, or the end of a cable.
InteractionId line_at(const Description& out, const Scope& scope, const std::string& name,
                      BodyId body, const SourceLocation& location) {
    if (const Cable* cable = out.find_cable(scope.prefix + name); cable != nullptr) {
        if (!cable->nodes.empty() && !cable->stretch.empty()) {
            if (cable->nodes.front() == body) return cable->stretch.front();
            if (cable->nodes.back() == body) return cable->stretch.back();
        }
        throw_error(location, "the cable " + in_quotes(name) + " does not end at the vessel");
    }
    return resolve_interaction(out, scope, name, location);
}

}  // namespace

VesselControl read_vessel_control(Description& out, const Scope& scope, const Json& json,
                                  BodyId body, const std::vector<PropulsorDef>& propulsors,
                                  const SourceLocation& location) {
    VesselControl c;
    c.active = true;
    read_fields(c, json, ControlTable::kNumbers);
    if (const auto mode = json.find("mode"); mode != json.end())
        for (int i = 0; i < kControlModes; ++i)
            if (mode->get<std::string>() == to_string(static_cast<ControlMode>(i)))
                c.mode = static_cast<ControlMode>(i);
    c.bandwidth = vector_or(json, "bandwidth", c.bandwidth);
    if (const auto flag = json.find("observer"); flag != json.end()) c.observer = flag->get<bool>();
    if (const auto flag = json.find("wind"); flag != json.end()) c.wind = flag->get<bool>();
    if (const auto list = json.find("lines"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i)
            c.lines.push_back(
                line_at(out, scope, (*list)[i].get<std::string>(), body, location / "lines" / i));
    if (const auto target = json.find("target"); target != json.end())
        c.target = resolve_body(out, scope, target->get<std::string>(), location / "target");
    if (const auto list = json.find("zones"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& each = (*list)[i];
            c.zones.push_back({propulsor_name(each["propulsor"], propulsors,
                                              location / "zones" / i / "propulsor"),
                               each["from_deg"].get<double>() * kControlDegree,
                               each["to_deg"].get<double>() * kControlDegree});
        }
    if (const auto list = json.find("failures"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& each = (*list)[i];
            ControlFailure f{each["name"].get<std::string>(), {}};
            const Json& names = each["propulsors"];
            for (std::size_t k = 0; k < names.size(); ++k)
                f.propulsors.push_back(propulsor_name(
                    names[k], propulsors, location / "failures" / i / "propulsors" / k));
            c.failures.push_back(std::move(f));
        }
    return c;
}

}  // namespace hawser::scene
