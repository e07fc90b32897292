// SPDX-License-Identifier: Apache-2.0
/// Check the control of a vessel, and read the lines that it feeds forward.
#include <hawser/world.h>

#include "base/number.h"
#include "vessel/checks.h"
#include "vessel/control.h"
#include "vessel/control_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hawser::vessel {
namespace {

[[noreturn]] void fail_control(const VesselDef& def, const std::string& field,
                               const std::string& why) {
    throw DefError("vessel '" + def.name + "': control/" + field + ": " + why);
}

void control_range(const VesselDef& def, const char* field, double value, double low, double high) {
    if (!(value >= low && value <= high))
        fail_control(def, field,
                     number(value) + "; give a number from " + number(low) + " to " + number(high));
}

const PropulsorDef& find_propulsor(const VesselDef& def, const std::string& name,
                                   const std::string& field) {
    std::string known;
    for (const PropulsorDef& p : def.propulsors) {
        if (p.name == name) return p;
        known.append(known.empty() ? "" : ", ").append(p.name);
    }
    fail_control(def, field,
                 "there is no propulsor '" + name + "'; " +
                     (known.empty() ? "the vessel has none" : "give one of " + known));
}

void check_lists(const VesselDef& def) {
    const VesselControl& c = def.control;
    for (std::size_t i = 0; i < c.zones.size(); ++i) {
        const std::string field = "zones/" + std::to_string(i);
        const ControlZone& z = c.zones[i];
        if (find_propulsor(def, z.propulsor, field + "/propulsor").kind != PropulsorKind::azimuth)
            fail_control(def, field + "/propulsor", "'" + z.propulsor + "' is no azimuth");
        if (!(z.to > z.from && z.to - z.from < 2.0 * std::numbers::pi))
            fail_control(def, field, "give a zone from a smaller to a larger angle, below 360 deg");
    }
    for (std::size_t i = 0; i < c.failures.size(); ++i)
        for (std::size_t k = 0; k < c.failures[i].propulsors.size(); ++k)
            (void)find_propulsor(
                def, c.failures[i].propulsors[k],
                "failures/" + std::to_string(i) + "/propulsors/" + std::to_string(k));
}

void check_names_of_signals(const VesselDef& def) {
    const auto& own = Control::signal_names();
    const auto taken = [&](const std::string& name) {
        return std::find(own.begin(), own.end(), name) != own.end();
    };
    for (const PropulsorDef& p : def.propulsors)
        if (taken(p.name))
            throw DefError("vessel '" + def.name + "': propulsors: the name '" + p.name +
                           "' is a signal of the control");
    for (const RudderDef& r : def.rudders)
        if (taken(r.name))
            throw DefError("vessel '" + def.name + "': rudders: the name '" + r.name +
                           "' is a signal of the control");
}

}  // namespace

void check_control(const World& world, const VesselDef& def) {
    const VesselControl& c = def.control;
    if (!c.active) return;
    for (const double w : c.bandwidth) control_range(def, "bandwidth", w, 1e-4, 10.0);
    control_range(def, "damping", c.damping, 0.01, 10.0);
    control_range(def, "integral", c.integral, 0.0, 1.0);
    control_range(def, "filter", c.filter, 0.0, 1e4);
    control_range(def, "wave_period", c.wave_period, 1.0, 60.0);
    control_range(def, "wind_filter", c.wind_filter, 0.0, 1e4);
    control_range(def, "position_alarm", c.position_alarm, 0.01, 1e4);
    control_range(def, "heading_alarm", c.heading_alarm, 1e-4, 3.2);
    control_range(def, "consequence_alarm", c.consequence_alarm, 1e-4, 1.0);
    control_range(def, "azimuth_cost", c.azimuth_cost, 1e-3, 1e3);
    if (2 * def.propulsors.size() > static_cast<std::size_t>(QuadraticProgram::kMaxVariables))
        throw DefError("vessel '" + def.name + "': propulsors: with control at most " +
                       std::to_string(QuadraticProgram::kMaxVariables / 2));
    check_lists(def);
    check_names_of_signals(def);
    for (std::size_t i = 0; i < c.lines.size(); ++i)
        if (!world.alive(c.lines[i]))
            fail_control(def, "lines/" + std::to_string(i), "there is no such interaction");
    if (!(c.target == BodyId{}) && !world.alive(c.target))
        fail_control(def, "target", "there is no such body");
    const Control trial(def, Vec3(1.0, 1.0, 1.0));
    if (const char* why = trial.rejection_reason(c.mode); *why != '\0')
        fail_control(def, "mode", why);
    if (const char* why = trial.rejection_reason(ControlMode::heading); *why != '\0')
        throw DefError("vessel '" + def.name + "': control: " + why);
}

std::vector<FedLine> fed_lines(const World& world, const VesselDef& def) {
    std::vector<FedLine> out;
    if (!def.control.active) return out;
    for (std::size_t i = 0; i < def.control.lines.size(); ++i) {
        const InteractionDef& line = world.interaction_def(def.control.lines[i]);
        FedLine fed;
        fed.element = def.control.lines[i];
        const int side = line.body[0] == def.body ? 0 : line.body[1] == def.body ? 1 : -1;
        if (side < 0)
            fail_control(def, "lines/" + std::to_string(i), "it does not end at the vessel");
        const auto near = static_cast<std::size_t>(side), far = 1 - near;
        fed.other = line.body[far];
        fed.ship_point = line.point[near];
        fed.other_point = line.point[far];
        out.push_back(fed);
    }
    return out;
}

Vec3 line_load(const World& world, const VesselDef& def, const std::vector<FedLine>& lines,
               const Mat3& axes, const Vec3& origin) noexcept {
    Vec3 out = Vec3::Zero();
    for (const FedLine& line : lines) {
        if (!world.alive(line.element)) continue;
        const double tension = -world.force(line.element)[0];
        const Vec3 ship_point = world.world_point(def.body, line.ship_point);
        const Vec3 other_point = world.alive(line.other)
                                     ? world.world_point(line.other, line.other_point)
                                     : line.other_point;
        const Vec3 separation = other_point - ship_point;
        const double length = separation.norm();
        if (!(length > 0.0) || !(tension > 0.0)) continue;
        const Vec3 force = axes.transpose() * Vec3(tension / length * separation);
        const Vec3 arm = axes.transpose() * Vec3(ship_point - origin);
        out += Vec3(force.x(), force.y(), arm.x() * force.y() - arm.y() * force.x());
    }
    return out;
}

}  // namespace hawser::vessel
