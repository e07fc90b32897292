// SPDX-License-Identifier: Apache-2.0
/// Positions and ranges that displays of vessels need.
#include "live/scene_text.h"

#include <hawser/system.h>
#include <hawser/vessel.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace hawser::live {
namespace {

constexpr const char* kPropulsorNames[] = {"shaft", "azimuth", "tunnel", "cycloidal"};

/// Return the thrust ahead of a ship at rest with a full order [N], within the limits of power.
double full_thrust(const PropulsorDef& p, double density) {
    if (p.propeller.diameter <= 0.0) return p.thrust;
    const double pitch = p.propeller.pitch;
    const PropellerForce full = propeller_force(p.propeller, pitch, p.most_rps, 0.0, density);
    const double power = 2.0 * std::numbers::pi * p.most_rps * full.torque;
    const double thrust = p.most_power > 0.0 && power > p.most_power
                              ? at_power(p.propeller, p.most_power, 0.0, density).thrust
                              : full.thrust;
    return (1.0 - p.thrust_deduction) * thrust;
}

Json propulsors_json(const VesselDef& def) {
    Json out = Json::array();
    for (const PropulsorDef& p : def.propulsors)
        out.push_back({{"name", p.name},
                       {"kind", kPropulsorNames[static_cast<std::size_t>(p.kind)]},
                       {"point", lengths(p.point)},
                       {"thrust", shorter(full_thrust(p, def.density), 1.0)}});
    return out;
}

Json rudders_json(const VesselDef& def) {
    Json out = Json::array();
    for (const RudderDef& r : def.rudders)
        out.push_back({{"name", r.name},
                       {"point", lengths(r.point)},
                       {"most_angle", shorter(r.most_angle, 1e-6)}});
    return out;
}

Json boards_json(const VesselDef& def) {
    Json out = Json::array();
    for (const SwitchboardDef& board : def.power.boards) {
        double power = 0.0;
        Json generators = Json::array();
        for (const GeneratorDef& g : board.generators) {
            power += g.power;
            generators.push_back({{"name", g.name}, {"power", g.power}});
        }
        out.push_back(
            {{"name", board.name}, {"power", power}, {"generators", std::move(generators)}});
    }
    return out;
}

}  // namespace

Json vessels_json(const World& world) {
    Json out = Json::array();
    for (const VesselDef* def : vessels_of(world))
        out.push_back({{"name", def->name},
                       {"body", def->body.index},
                       {"origin", lengths(def->origin)},
                       {"propulsors", propulsors_json(*def)},
                       {"rudders", rudders_json(*def)},
                       {"boards", boards_json(*def)},
                       {"position_alarm", def->control.position_alarm},
                       {"heading_alarm", shorter(def->control.heading_alarm, 1e-6)}});
    return out;
}

Json gauges_json(const World& world) {
    Json out = Json::array();
    for (const SystemSignal& s : world.system_signals()) {
        if (s.input || s.name != "permissible") continue;
        HoldTable held;
        if (const System* gauge = world.find_system(s.system)) gauge->holds(held);
        if (!held.bodies.empty())
            out.push_back({{"name", s.system}, {"body", held.bodies.front().index}});
    }
    return out;
}

}  // namespace hawser::live
