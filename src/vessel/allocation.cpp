// SPDX-License-Identifier: Apache-2.0
#include "vessel/allocation.h"

#include "base/dense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace hawser::vessel {
namespace {

constexpr double kForceErrorWeight = 1e6;  ///< q for X and Y.
constexpr double kMeetMoment = 4e6;        ///< q for N.
constexpr double kKeepSector =
    0.95;  ///< Relative cost below which a thruster leaves its present sector.
constexpr double kNoForce =
    1e-6;  ///< Fraction of the capacity below which a force has no direction.
constexpr double kAllocationPi = std::numbers::pi;

}  // namespace

Allocation::Allocation(std::vector<AllocatedThruster> thrusters)
    : thrusters_(std::move(thrusters)) {
    double sum = 0.0, arm = 1.0;
    std::size_t constraints = 0;
    for (const AllocatedThruster& t : thrusters_) {
        first_.push_back(variables_);
        variables_ += t.is_azimuth ? 2 : 1;
        sum += std::max(t.ahead, t.astern);
        arm = std::max({arm, std::abs(t.x), std::abs(t.y)});
        constraints += kSides + 4;
    }
    force_ = std::max(sum, 1.0);
    moment_ = force_ * arm;
    forces_.assign(2 * thrusters_.size(), 0.0);
    trial_sectors_.assign(thrusters_.size(), -1);
    effect_.setZero(3, variables_);
    for (std::size_t i = 0; i < thrusters_.size(); ++i) {
        const AllocatedThruster& t = thrusters_[i];
        if (t.is_azimuth) {
            effect_.col(first_[i]) = lever(i, 1.0, 0.0);
            effect_.col(first_[i] + 1) = lever(i, 0.0, 1.0);
        } else {
            effect_.col(first_[i]) = lever(i, std::cos(t.axis), std::sin(t.axis));
        }
    }
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        const double a = (2.0 * static_cast<double>(k) + 1.0) * kAllocationPi / kSides;
        sides_[k] = {std::cos(a), std::sin(a)};
    }
    program_.reserve(constraints);
    program_.begin(variables_);
}

/// Return the scaled column S B of thruster i for a unit force (x, y).
Vec3 Allocation::lever(std::size_t i, double x, double y) const noexcept {
    const AllocatedThruster& t = thrusters_[i];
    return {x / force_, y / force_, (t.x * y - t.y * x) / moment_};
}

double Allocation::scaled_norm(const Vec3& tau) const noexcept {
    return Vec3(tau[0] / force_, tau[1] / force_, tau[2] / moment_).norm();
}

int Allocation::sector_index(std::size_t i, double x, double y, double available) const noexcept {
    const AllocatedThruster& t = thrusters_[i];
    if (std::hypot(x, y) <= kNoForce * t.ahead) return 0;
    const double angle = std::atan2(y, x);
    for (std::size_t k = 0; k < t.sectors.size(); ++k) {
        const ThrustSector& s = t.sectors[k];
        const double off = std::remainder(angle - s.from - 0.5 * s.width, 2.0 * kAllocationPi);
        const double thrust_max = available * (s.reversed ? t.astern : t.ahead);
        if (std::abs(off) <= 0.5 * s.width + 1e-9 && std::hypot(x, y) <= thrust_max * (1.0 + 1e-9))
            return static_cast<int>(k);
    }
    return -1;
}

/// Add the limits of a thruster. Variables are in units of the capacity.
/// @param available  Fraction of the capacity. @param sector  −1: whole disc.
void Allocation::add_limits(std::size_t i, double available, std::int32_t sector) noexcept {
    const AllocatedThruster& t = thrusters_[i];
    const std::int32_t v = first_[i];
    if (!t.is_azimuth) {
        program_.add({v, -1, 1.0, 0.0, available * t.ahead / force_});
        program_.add({v, -1, -1.0, 0.0, available * t.astern / force_});
        return;
    }
    if (available <= 0.0) {
        for (const std::int32_t at : {v, v + 1})
            for (const double side : {1.0, -1.0}) program_.add({at, -1, side, 0.0, 0.0});
        return;
    }
    double radius = t.ahead / force_;
    if (sector >= 0) {
        const ThrustSector& s = t.sectors[static_cast<std::size_t>(sector)];
        if (s.reversed) radius = t.astern / force_;
        const double a = s.from, b = s.from + s.width;
        program_.add({v, v + 1, std::sin(a), -std::cos(a), 0.0});
        program_.add({v, v + 1, -std::sin(b), std::cos(b), 0.0});
    }
    const double inner = available * radius * std::cos(kAllocationPi / kSides);
    for (const auto& [x, y] : sides_) program_.add({v, v + 1, x, y, inner});
}

/// Set the cost function. The variables are forces divided by `force_`.
void Allocation::set_cost(const Vec3& tau, int variables) noexcept {
    const Vec3 target(tau[0] / force_, tau[1] / force_, tau[2] / moment_);
    const Vec3 weight(kForceErrorWeight, kForceErrorWeight, kMeetMoment);
    auto& h = program_.hessian();
    auto& g = program_.gradient();
    for (int i = 0; i < variables; ++i) {
        for (int j = 0; j < variables; ++j)
            h(i, j) = force_ * force_ *
                      effect_.col(i).dot(Vec3(weight.cwiseProduct(Vec3(effect_.col(j)))));
        g[i] = -force_ * effect_.col(i).dot(Vec3(weight.cwiseProduct(target)));
    }
}

double Allocation::program(const Vec3& tau, const double* available,
                           const std::int32_t* sectors) noexcept {
    program_.begin(variables_);
    set_cost(tau, variables_);
    auto& h = program_.hessian();
    for (std::size_t i = 0; i < thrusters_.size(); ++i) {
        const AllocatedThruster& t = thrusters_[i];
        const double unit = force_ / std::max({t.ahead, t.astern, 1e-9 * force_});
        const double cost = t.cost * unit * unit;
        h(first_[i], first_[i]) += cost;
        if (t.is_azimuth) h(first_[i] + 1, first_[i] + 1) += cost;
        add_limits(i, available != nullptr ? available[i] : 1.0, sectors[i]);
    }
    if (!program_.solve()) return std::numeric_limits<double>::infinity();
    const auto& x = program_.solution();
    total_.setZero();
    for (std::size_t i = 0; i < thrusters_.size(); ++i) {
        const AllocatedThruster& t = thrusters_[i];
        const double a = force_ * x[first_[i]];
        forces_[2 * i] = t.is_azimuth ? a : a * std::cos(t.axis);
        forces_[2 * i + 1] = t.is_azimuth ? force_ * x[first_[i] + 1] : a * std::sin(t.axis);
        total_[0] += forces_[2 * i];
        total_[1] += forces_[2 * i + 1];
        total_[2] += t.x * forces_[2 * i + 1] - t.y * forces_[2 * i];
    }
    // Add the constant |S τ|², so that costs can be compared.
    const Vec3 target(tau[0] / force_, tau[1] / force_, tau[2] / moment_);
    const double constant = kForceErrorWeight * (target[0] * target[0] + target[1] * target[1]) +
                            kMeetMoment * target[2] * target[2];
    return x.dot(h.topLeftCorner(variables_, variables_) * x) + 2.0 * program_.gradient().dot(x) +
           constant;
}

void Allocation::allocate(const Vec3& tau, const double* available,
                          std::int32_t* sectors) noexcept {
    for (std::int32_t& s : trial_sectors_) s = -1;
    (void)program(tau, available, trial_sectors_.data());
    bool solved = true;  // The forces are those of `trial_sectors_`.
    for (std::size_t i = 0; i < thrusters_.size(); ++i) {
        const AllocatedThruster& t = thrusters_[i];
        if (t.sectors.empty()) continue;
        const double fraction = available != nullptr ? available[i] : 1.0;
        const bool stopped = fraction <= 0.0;
        const int inside = sector_index(i, forces_[2 * i], forces_[2 * i + 1], fraction);
        if (stopped ||
            (inside >= 0 && std::hypot(forces_[2 * i], forces_[2 * i + 1]) > kNoForce * t.ahead)) {
            if (!stopped) {
                trial_sectors_[i] = inside;
                solved = false;
            }
            continue;
        }
        const std::int32_t present = sectors[i];
        double least_cost = std::numeric_limits<double>::infinity();
        std::int32_t best = -1;
        const auto count = static_cast<std::int32_t>(t.sectors.size());
        for (std::int32_t k = 0; k < count; ++k) {
            trial_sectors_[i] = k;
            double cost = program(tau, available, trial_sectors_.data());
            if (k == present) cost *= kKeepSector;
            if (cost < least_cost) {
                least_cost = cost;
                best = k;
            }
        }
        trial_sectors_[i] = best;
        (void)program(tau, available, trial_sectors_.data());
        solved = true;
    }
    if (!solved) (void)program(tau, available, trial_sectors_.data());
    for (std::size_t i = 0; i < thrusters_.size(); ++i) sectors[i] = trial_sectors_[i];
}

void Allocation::thrust_at_fixed_angles(const Vec3& tau, const ThrusterNow* now,
                                        double* thrusts) noexcept {
    const int count = static_cast<int>(thrusters_.size());
    program_.begin(count);
    const Vec3 target(tau[0] / force_, tau[1] / force_, tau[2] / moment_);
    const Vec3 weight(kForceErrorWeight, kForceErrorWeight, kMeetMoment);
    auto& h = program_.hessian();
    auto& g = program_.gradient();
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const AllocatedThruster& t = thrusters_[at];
        const Vec3 a = force_ * lever(at, std::cos(now[at].angle), std::sin(now[at].angle));
        for (int j = 0; j < count; ++j) {
            const auto other = static_cast<std::size_t>(j);
            const Vec3 b =
                force_ * lever(other, std::cos(now[other].angle), std::sin(now[other].angle));
            h(i, j) = a.dot(Vec3(weight.cwiseProduct(b)));
        }
        g[i] = -a.dot(Vec3(weight.cwiseProduct(target)));
        const double unit = force_ / std::max({t.ahead, t.astern, 1e-9 * force_});
        h(i, i) += t.cost * unit * unit;
        program_.add({i, -1, 1.0, 0.0, now[at].thrust_max / force_});
        program_.add({i, -1, -1.0, 0.0, -now[at].thrust_min / force_});
    }
    const bool solved = program_.solve();
    total_.setZero();
    for (std::size_t i = 0; i < thrusters_.size(); ++i) {
        const double solved_thrust =
            solved ? force_ * program_.solution()[static_cast<Eigen::Index>(i)] : 0.0;
        thrusts[i] = std::clamp(solved_thrust, now[i].thrust_min, now[i].thrust_max);
        const double fx = thrusts[i] * std::cos(now[i].angle);
        const double fy = thrusts[i] * std::sin(now[i].angle);
        total_ += Vec3(fx, fy, thrusters_[i].x * fy - thrusters_[i].y * fx);
    }
}

Vec3 Allocation::largest_axis_forces() const noexcept {
    Vec3 out = Vec3::Zero();
    for (const AllocatedThruster& t : thrusters_) {
        const double c = std::abs(std::cos(t.axis)), s = std::abs(std::sin(t.axis));
        out[0] += t.ahead * (t.is_azimuth ? 1.0 : c);
        out[1] += t.ahead * (t.is_azimuth ? 1.0 : s);
        out[2] +=
            t.ahead * (t.is_azimuth ? std::hypot(t.x, t.y)
                                    : std::abs(t.x * std::sin(t.axis) - t.y * std::cos(t.axis)));
    }
    return out;
}

int Allocation::independent_axes() const {
    if (variables_ == 0) return 0;
    const Eigen::Matrix3d square = force_ * force_ * Eigen::Matrix3d(effect_ * effect_.transpose());
    const Vec3 eigenvalues = base::symmetric_eigenvalues(square);
    int rank = 0;
    for (int i = 0; i < 3; ++i)
        if (eigenvalues[i] > 1e-8 * eigenvalues[2]) ++rank;
    return rank;
}

}  // namespace hawser::vessel
