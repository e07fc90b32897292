// SPDX-License-Identifier: Apache-2.0
/// Losses of thrust: ventilation, races of other thrusters, the hull.
///
/// Sources: K. J. Minsaas, H. J. Thon and W. Kauczynski, "Estimation of required thruster capacity
/// for operation of offshore vessels under severe weather conditions", PRADS 1987. J. Dang and
/// H. Laheij, "Hydrodynamic aspects of steerable thrusters", Dynamic Positioning Conference, 2004.
#include "vessel/losses.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace hawser {
namespace {

constexpr double kMinDepth = -0.48, kMostDepth = 1.3;  ///< Range of the formula, over the radius.

}  // namespace

double ventilated_thrust(double ratio) noexcept {
    if (ratio < kMinDepth) return 0.0;
    if (ratio > kMostDepth) return 1.0;
    return std::clamp(1.0 - 0.675 * std::pow(std::max(0.0, 1.0 - 0.769 * ratio), 1.258), 0.0, 1.0);
}

double race_thrust(double distance, double angle) noexcept {
    const double t = 1.0 - std::pow(0.75, std::pow(std::max(0.0, distance), 2.0 / 3.0));
    const double degrees = std::abs(angle) * 180.0 / std::numbers::pi;
    const double cube = degrees * degrees * degrees;
    if (cube == 0.0) return t;
    return t + (1.0 - t) * cube / (130.0 / std::max(1e-9, t * t * t) + cube);
}

namespace vessel {
namespace {

double sea_input(const World& world, const char* name, double fallback) noexcept {
    for (const SystemSignal& s : world.system_signals())
        if (s.system == "sea" && s.name == name) return *s.value;
    return fallback;
}

}  // namespace

Surface::Surface(const World& world, const VesselDef& def) {
    const SeaDef* sea = find_sea(world);
    const bool ventilates = std::any_of(def.propulsors.begin(), def.propulsors.end(),
                                        [](const PropulsorDef& p) { return p.ventilates; });
    if (sea == nullptr || !ventilates) return;
    sea_ = std::make_shared<const Sea>(*sea, std::abs(world.settings().gravity.z()));
    moment_ = sea_->at(0.0);
}

void Surface::update(const World& world, double time) noexcept {
    if (find_sea(world) != nullptr) still_level_ = still_water(world);
    if (sea_ == nullptr) return;
    SeaInputs in = sea_->inputs();
    in.waves = sea_input(world, "waves", in.waves);
    in.level = sea_input(world, "level", in.level);
    sea_->at(time, in, moment_);
}

double Surface::height(double x, double y) const noexcept {
    return sea_ == nullptr ? still_level_ : sea_->elevation(moment_, x, y);
}

bool has_losses(const VesselDef& def) noexcept {
    return def.thruster_losses ||
           std::any_of(def.propulsors.begin(), def.propulsors.end(),
                       [](const PropulsorDef& p) { return p.ventilates || p.hull_loss > 0.0; });
}

void apply_race_losses(const std::vector<Propulsor>& propulsors,
                       std::vector<PropulsorState>& states, double density) noexcept {
    for (std::size_t j = 0; j < propulsors.size(); ++j) {
        const Propulsor& from = propulsors[j];
        const double d = from.diameter();
        if (from.def().kind == PropulsorKind::tunnel || !(d > 0.0) || states[j].thrust == 0.0)
            continue;
        const double side = states[j].thrust < 0.0 ? -1.0 : 1.0, a = from.direction(states[j]);
        const double x = -side * std::cos(a), y = -side * std::sin(a);
        const double load =
            std::sqrt(std::min(1.0, std::abs(states[j].thrust) / from.max_thrust(density)));
        for (std::size_t i = 0; i < propulsors.size(); ++i) {
            if (i == j || propulsors[i].def().kind == PropulsorKind::tunnel) continue;
            const double dx = propulsors[i].at().x() - from.at().x();
            const double dy = propulsors[i].at().y() - from.at().y();
            const double behind = dx * x + dy * y;
            if (!(behind > 0.0)) continue;
            const double angle = std::atan2(std::abs(dx * y - dy * x), behind);
            states[i].thrust_fraction *=
                1.0 - load * (1.0 - race_thrust(std::hypot(dx, dy) / d, angle));
        }
    }
}

double thrust_fraction_under_hull(const Propulsor& propulsor, const PropulsorState& s) noexcept {
    const double y = propulsor.at().y();
    if (propulsor.def().hull_loss <= 0.0 || y == 0.0) return 1.0;
    // The race of a thrust to starboard runs to port.
    const double race = -std::sin(propulsor.direction(s)) * (s.thrust < 0.0 ? -1.0 : 1.0);
    const double inboard = y > 0.0 ? -race : race;
    return 1.0 - propulsor.def().hull_loss * std::max(0.0, inboard);
}

}  // namespace vessel
}  // namespace hawser
