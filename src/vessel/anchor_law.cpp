// SPDX-License-Identifier: Apache-2.0
#include "vessel/anchor_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <span>

namespace hawser {
namespace {

constexpr double kNewtonPerKip = 4448.2216152605;  ///< [N].
constexpr double kAnchorGravity = 9.80665;

constexpr const char* kAnchorSoilNames[] = {"none", "soft_clay", "medium_clay", "sand"};
constexpr const char* kAnchorTypeNames[] = {
    "given",      "stevpris_mk6", "stevpris",        "bruce_twin_shank",
    "bruce_cast", "danforth",     "navmoor",         "stato",
    "stevmud",    "stevin",       "stockless_fixed", "stockless_movable"};

/// Capacity H_R [kip] at an air weight of 10 kip, and its exponent; 0: not published.
struct NavyLine {
    double clay = 0.0, clay_power = 0.0, sand = 0.0, sand_power = 0.0;
};
/// Table in the order of AnchorType, from stevpris on. Source: NCEL Techdata Sheet 83-08R.
constexpr NavyLine kNavyTable[] = {{189.0, 0.92, 210.0, 0.94}, {189.0, 0.92, 210.0, 0.94},
                                   {32.0, 0.92, 250.0, 0.80},  {87.0, 0.92, 126.0, 0.80},
                                   {210.0, 0.94, 270.0, 0.94}, {210.0, 0.94, 250.0, 0.94},
                                   {250.0, 0.92, 0.0, 0.0},    {139.0, 0.92, 165.0, 0.80},
                                   {46.0, 0.92, 70.0, 0.80},   {24.0, 0.92, 0.0, 0.0}};
static_assert(std::size(kNavyTable) + 2 == std::size(kAnchorTypeNames));

double vryhof_uhc(AnchorSoil soil, double mass) noexcept {
    constexpr double kFactor[] = {0.0, 509.96, 701.49, 904.21}, kPower[] = {0.0, 0.93, 0.93, 0.92};
    const auto i = static_cast<std::size_t>(soil);
    return 1e3 * kFactor[i] * std::pow(1e-3 * mass, kPower[i]);
}

}  // namespace

std::span<const char* const> anchor_soils() noexcept { return kAnchorSoilNames; }
std::span<const char* const> anchor_types() noexcept { return kAnchorTypeNames; }

double anchor_uhc(AnchorType type, AnchorSoil soil, double mass) noexcept {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (type == AnchorType::given || soil == AnchorSoil::none) return kNone;
    if (type == AnchorType::stevpris_mk6) return vryhof_uhc(soil, mass);
    const NavyLine& line = kNavyTable[static_cast<std::size_t>(type) - 2];
    if (soil == AnchorSoil::medium_clay) return kNone;
    const bool sand = soil == AnchorSoil::sand;
    const double at_ten = sand ? line.sand : line.clay;
    if (!(at_ten > 0.0)) return kNone;
    const double weight = mass * kAnchorGravity / (10.0 * kNewtonPerKip);
    return kNewtonPerKip * at_ten * std::pow(weight, sand ? line.sand_power : line.clay_power);
}

double anchor_uplift(double angle) noexcept {
    constexpr double kDegree = std::numbers::pi / 180.0;
    constexpr std::array<std::array<double, 2>, 4> kTable{
        {{0.0, 1.0}, {5.0 * kDegree, 0.75}, {15.0 * kDegree, 0.5}, {45.0 * kDegree, 0.0}}};
    if (!(angle > 0.0)) return 1.0;
    for (std::size_t i = 1; i < kTable.size(); ++i) {
        if (angle >= kTable[i][0]) continue;
        const double share = (angle - kTable[i - 1][0]) / (kTable[i][0] - kTable[i - 1][0]);
        return kTable[i - 1][1] + share * (kTable[i][1] - kTable[i - 1][1]);
    }
    return 0.0;
}

}  // namespace hawser

namespace hawser::vessel {
namespace {

constexpr double kTrajectoryStep = 0.1;   ///< Distance between entries of the table [m].
constexpr int kTrajectoryEntries = 5001;  ///< Drags up to 500 m; the depth stays beyond.

}  // namespace

AnchorCapacity::AnchorCapacity(const AnchorDef& def) : def_(def) {
    if (def_.law == AnchorLaw::trajectory) integrate();
}

/// Return the pull T of the anchor at a depth [N].
double AnchorCapacity::pull_at(double z) const noexcept {
    const AnchorClay& c = def_.clay;
    const double pull = c.bearing * (c.strength + c.gradient * z) * c.fluke_area;
    return std::isnan(def_.uhc) ? pull : std::min(pull, def_.uhc);
}

/// Return the resistance of the line in the clay above the anchor, E_n N_c b z (s_u0 + k z/2) [N].
double AnchorCapacity::bearing_above(double z) const noexcept {
    const AnchorClay& c = def_.clay;
    return c.chain_width * c.chain_bearing * z * (c.strength + 0.5 * c.gradient * z);
}

double AnchorCapacity::slope_at(double z) const noexcept {
    const double line = std::sqrt(2.0 * bearing_above(z) / pull_at(z));
    return std::max(std::tan(def_.clay.fluke_angle - line), 0.0);
}

/// Integrate the trajectory by the fourth-order Runge-Kutta method.
void AnchorCapacity::integrate() {
    depth_.reserve(kTrajectoryEntries);
    depth_.push_back(def_.clay.first_depth);
    constexpr double h = kTrajectoryStep;
    while (depth_.size() < kTrajectoryEntries) {
        const double z = depth_.back();
        const double a = slope_at(z), b = slope_at(z + 0.5 * h * a), c = slope_at(z + 0.5 * h * b);
        depth_.push_back(z + h / 6.0 * (a + 2.0 * b + 2.0 * c + slope_at(z + h * c)));
    }
}

double AnchorCapacity::depth(double drag) const noexcept {
    if (depth_.empty()) return def_.full_depth * -std::expm1(-drag / def_.drag_length);
    const double at = std::clamp(drag, 0.0, 1e6) / kTrajectoryStep;
    const auto i = static_cast<std::size_t>(at);
    if (i + 1 >= depth_.size()) return depth_.back();
    // Cubic Hermite interpolation, with the slopes of the equation.
    const double t = at - static_cast<double>(i), z0 = depth_[i], z1 = depth_[i + 1];
    const double m0 = kTrajectoryStep * slope_at(z0), m1 = kTrajectoryStep * slope_at(z1);
    const double rest = 1.0 - t;
    return z0 * (1.0 + 2.0 * t) * rest * rest + m0 * t * rest * rest +
           z1 * t * t * (3.0 - 2.0 * t) - m1 * t * t * rest;
}

double AnchorCapacity::strength_at(double drag) const noexcept {
    if (!depth_.empty()) return pull_at(depth(drag));
    return def_.uhc * (def_.first - (1.0 - def_.first) * std::expm1(-drag / def_.drag_length));
}

double AnchorCapacity::line_factor(double drag, double angle) const noexcept {
    const AnchorClay& c = def_.clay;
    const double pull = strength_at(drag) * anchor_uplift(angle);
    if (!(c.chain_friction > 0.0) || !(pull > 0.0)) return 1.0;
    const double at_anchor = std::sqrt(angle * angle + 2.0 * bearing_above(depth(drag)) / pull);
    const double curve = std::min(at_anchor, 0.5 * std::numbers::pi) - angle;
    return std::exp(c.chain_friction * std::max(curve, 0.0));
}

double AnchorCapacity::capacity(double drag, double angle) const noexcept {
    const double theta = std::max(angle, 0.0);
    const double soil = strength_at(drag) * anchor_uplift(theta) * line_factor(drag, theta);
    return std::max(soil, def_.friction * def_.weight);
}

}  // namespace hawser::vessel
