// SPDX-License-Identifier: Apache-2.0
#include "verify/anchor_soil.h"

#include <hawser/anchor.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {
namespace {

constexpr double kSoilDegree = 3.14159265358979323846 / 180.0;

/// Strength and depth of the soil at an anchor.
struct SoilAt {
    double pull, depth;
};

double line_bearing(const AnchorClay& c, double z) {
    return c.chain_width * c.chain_bearing * (c.strength * z + 0.5 * c.gradient * z * z);
}

/// Integrate the trajectory by the rule of the midpoint.
SoilAt integrate_trajectory(const AnchorDef& def, double drag) {
    const AnchorClay& c = def.clay;
    const auto pull = [&](double z) {
        const double t = c.bearing * c.fluke_area * (c.strength + c.gradient * z);
        return std::isnan(def.uhc) ? t : std::min(t, def.uhc);
    };
    const auto slope = [&](double z) {
        return std::max(std::tan(c.fluke_angle - std::sqrt(2.0 * line_bearing(c, z) / pull(z))),
                        0.0);
    };
    const double way = std::min(drag, 500.0);
    const int steps = 1 + static_cast<int>(way / 0.02);
    const double h = way / steps;
    double z = c.first_depth;
    for (int i = 0; i < steps; ++i) z += h * slope(z + 0.5 * h * slope(z));
    return {pull(z), z};
}

SoilAt soil_at(const AnchorDef& def, double drag) {
    if (def.law == AnchorLaw::trajectory) return integrate_trajectory(def, drag);
    const double left = std::exp(-drag / def.drag_length);
    return {def.uhc * (1.0 - (1.0 - def.first) * left), def.full_depth * (1.0 - left)};
}

/// Return f by its table.
double uplift(double angle) {
    const double degrees = std::max(angle, 0.0) / kSoilDegree;
    if (degrees < 5.0) return 1.0 - 0.05 * degrees;
    if (degrees < 15.0) return 0.75 - 0.025 * (degrees - 5.0);
    return std::max(0.5 - (degrees - 15.0) / 60.0, 0.0);
}

double along_line(const AnchorView& a, const SoilAt& soil, double angle) {
    const double floor = a.def.friction * a.def.weight;
    if (!a.set) return a.grounded ? floor : 0.0;
    const double f = uplift(angle), pull = soil.pull * f, mu = a.def.clay.chain_friction;
    double curve = 0.0;
    if (mu > 0.0 && pull > 0.0)
        curve =
            std::min(std::sqrt(angle * angle + 2.0 * line_bearing(a.def.clay, soil.depth) / pull),
                     90.0 * kSoilDegree) -
            angle;
    return std::max(pull * std::exp(mu * std::max(curve, 0.0)), floor);
}

}  // namespace

std::string anchor_fault(const World& world) {
    constexpr double kTable = 1e-5;  // the trajectory comes from a table
    for (const AnchorView& a : anchors_of(world)) {
        const double level = std::hypot(a.pull.x(), a.pull.y()), tension = a.pull.norm();
        const bool tight = tension > a.def.friction * a.def.weight;
        const double angle = tight ? std::max(std::atan2(a.pull.z(), level), 0.0) : 0.0;
        const SoilAt soil = soil_at(a.def, a.drag_before);
        const double holds =
            along_line(a, soil, angle) * std::cos(std::min(angle, 45.0 * kSoilDegree));
        const double most[] = {
            level <= holds ? std::sqrt(std::max(holds * holds - a.pull.y() * a.pull.y(), 0.0))
                           : holds * std::abs(a.pull.x()) / level,
            level <= holds ? std::sqrt(std::max(holds * holds - a.pull.x() * a.pull.x(), 0.0))
                           : holds * std::abs(a.pull.y()) / level,
            a.set ? std::max(a.def.breakout * soil.pull, 2.0 * a.def.weight) : a.bound[2]};
        const double scale = std::max({holds, most[2], 1.0});
        for (int i = 0; i < 3; ++i) {
            const double set = world.interaction_def(a.slide[i]).get("force");
            if (std::abs(set - most[i]) <= kTable * scale && set == a.bound[i]) continue;
            return fmt::format(
                "anchor \"{}\": the soil's row {} is bounded by {:.9g} N, the law gives {:.9g} N",
                a.def.name, "xyz"[i], set, most[i]);
        }
    }
    return {};
}

}  // namespace hawser::verify
