// SPDX-License-Identifier: Apache-2.0
#include "vessel/stability_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hawser {

double towing_moment(double force, double alpha, double beta, double height, double y) noexcept {
    return force * (height * std::sin(alpha) * std::cos(beta) + y * std::sin(beta));
}

double worst_towing_angle(double force, double alpha, double height, double y,
                          double bollard_pull) noexcept {
    const double worst = std::atan2(y, height * std::sin(alpha));
    const double across = force * std::cos(alpha);
    const double share = across > 0.0 ? 1.5 * bollard_pull / across : 1.0;
    return share < 1.0 && bollard_pull > 0.0 ? std::max(worst, std::acos(share)) : worst;
}

}  // namespace hawser

namespace hawser::vessel {
namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;
constexpr double kSecondDisplacement =
    1.15;                          ///< Second displacement of the table, relative to the first.
constexpr int kAreaSamples = 180;  ///< Number of samples of the residual area, from 0 to 90°.

/// Return the value of a table from 0 to 90° by cubics through four neighbours.
template <std::size_t N>
double interpolate_cubic(const std::array<double, N>& y, double heel) {
    const double at = std::clamp(heel / kRightAngle, 0.0, 1.0) * (N - 1);
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(at), 1, N - 3);
    const double t = at - static_cast<double>(i);
    return -t * (t - 1.0) * (t - 2.0) / 6.0 * y[i - 1] + (t * t - 1.0) * (t - 2.0) / 2.0 * y[i] -
           t * (t + 1.0) * (t - 2.0) / 2.0 * y[i + 1] + t * (t * t - 1.0) / 6.0 * y[i + 2];
}

}  // namespace

StabilityCurve::StabilityCurve(const StabilityDef& def, const HullMesh& mesh, double density)
    : def_(def), has_mesh_(!mesh.triangles.empty()), half_breadth_(1e4) {
    for (int k = 0; k < kHeelAngles; ++k) {
        const double heel = kRightAngle * k / (kHeelAngles - 1);
        const auto i = static_cast<std::size_t>(k);
        light_[i] =
            has_mesh_ ? righting_lever(mesh, def_.mass, density, heel) : def_.gm * std::sin(heel);
        heavy_[i] = has_mesh_ ? righting_lever(mesh, kSecondDisplacement * def_.mass, density, heel)
                              : light_[i];
    }
    for (int k = 0; k <= kAreaSamples; ++k) {
        const double heel = kRightAngle * k / kAreaSamples, gz = lever(heel, 0.0);
        if (gz > most_[0]) most_ = {gz, heel};
    }
    while (half_angle_ < most_[1] && lever(half_angle_, 0.0) < 0.5 * most_[0])
        half_angle_ += 1e-3 * kRightAngle;
    if (!has_mesh_) return;
    half_breadth_ = 0.0;
    for (const Vec3& v : mesh.vertices) half_breadth_ = std::max(half_breadth_, std::abs(v.y()));
    if (!def_.stern.allFinite()) return;
    const Flotation afloat = float_hull(mesh, def_.mass, density);
    freeboard_ = afloat.pose.position.z() + def_.stern.z();
    const double gm = afloat.kb + afloat.bm_long - afloat.kg, x = afloat.statics.plane_centre.x();
    sinks_ = 1.0 / (density * afloat.statics.plane_area) +
             (x - def_.pin.x()) * (x - def_.stern.x()) / (def_.mass * gm);
}

double StabilityCurve::lever(double heel, double added) const noexcept {
    const double share = added / ((kSecondDisplacement - 1.0) * def_.mass);
    const double light = interpolate_cubic(light_, heel);
    const double mesh = light + share * (interpolate_cubic(heavy_, heel) - light);
    // The mesh has its centre of mass at the origin, the added weight at the pin's height.
    const double raised = added / (def_.mass + added) * def_.pin.z() * std::sin(heel);
    return has_mesh_ ? mesh - raised : mesh;
}

double StabilityCurve::towline_offset(double alpha) const noexcept {
    constexpr double kMaxTowAngle = 1.5;  // beyond, the wire leaves over the side
    const double across = std::min(std::abs(alpha), kMaxTowAngle);
    const double y =
        std::abs(def_.pin.y()) + std::max(def_.pin.x() - def_.stern_x, 0.0) * std::tan(across);
    return std::min(y, std::max(half_breadth_, std::abs(def_.pin.y())));
}

double StabilityCurve::free_stern(double added) const noexcept {
    return freeboard_ - sinks_ * added;
}

StabilityCurve::Residual StabilityCurve::residual(double wire, double added) const noexcept {
    const double last = std::isnan(def_.flooding) ? kRightAngle : def_.flooding;
    const double step = kRightAngle / kAreaSamples;
    Residual out{std::numeric_limits<double>::quiet_NaN(), 0.0,
                 -std::numeric_limits<double>::infinity()};
    double before = -wire, first = out.first;
    for (int k = 0; k <= kAreaSamples; ++k) {
        const double heel = k * step, over = lever(heel, added) - wire * std::cos(heel);
        out.lever = std::max(out.lever, heel <= last ? over : out.lever);
        const bool upright = std::isnan(first);
        if (upright && over >= 0.0) {
            const double share = k > 0 ? before / (before - over) : 0.0;
            first = k > 0 ? heel - (1.0 - share) * step : 0.0;
            if (k > 0 && heel <= last) out.area += 0.5 * over * (1.0 - share) * step;
        } else if (!upright && (over < 0.0 || heel > last + 1e-9)) {
            if (over < 0.0) out.area += 0.5 * before * before / (before - over) * step;
            break;
        } else if (!upright) {
            out.area += 0.5 * (before + over) * step;
        }
        before = over;
    }
    out.first = first;
    return out;
}

StabilityCheck StabilityCurve::check(double force, double alpha, double beta) const noexcept {
    const double down = std::clamp(beta, 0.0, kRightAngle);
    const double added = force * std::sin(down) / def_.gravity;
    StabilityCheck out;
    out.moment = towing_moment(force, std::abs(alpha), down, height(), towline_offset(alpha));
    const Residual r = residual(out.moment / ((def_.mass + added) * def_.gravity), added);
    out.static_heel = r.first;
    out.residual_area = r.area;
    out.residual_lever = r.lever;
    double most = std::min(half_angle_, def_.most_heel);
    if (!std::isnan(def_.deck_edge)) most = std::min(most, def_.deck_edge);
    const bool stern = has_mesh_ && def_.stern.allFinite();
    out.criterion = !(r.first <= most)                            ? 1
                    : r.area < def_.residual_area                 ? 2
                    : r.lever < def_.residual_lever               ? 3
                    : stern && free_stern(added) < def_.freeboard ? 4
                                                                  : 0;
    return out;
}

double StabilityCurve::permissible_tension_at(double alpha, double beta,
                                              int halvings) const noexcept {
    double low = 0.0, high = def_.mass * def_.gravity;
    if (check(low, alpha, beta).criterion != 0) return 0.0;
    if (check(high, alpha, beta).criterion == 0) return high;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (check(middle, alpha, beta).criterion == 0 ? low : high) = middle;
    }
    return low;
}

}  // namespace hawser::vessel
