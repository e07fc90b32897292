// SPDX-License-Identifier: Apache-2.0
#include "vessel/dp_star.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hawser {
namespace {

constexpr double kStarPi = std::numbers::pi, kTurn = 2.0 * std::numbers::pi;
constexpr double kMiscellaneousFactor = 0.9;  ///< β_misc.
/// Angle between vertices in the dip of a skeg [rad].
constexpr double kDipArc = std::numbers::pi / 180;
constexpr double kMaxFanWidth = std::numbers::pi;  ///< Maximum width of a fan [rad].

/// Return the equivalent angle in 0 … 2π.
double positive_angle(double a) noexcept {
    const double out = std::fmod(a, kTurn);
    return out < 0.0 ? out + kTurn : out;
}

bool is_intact(const std::vector<bool>& failed, std::size_t i) noexcept {
    return failed.empty() || !failed[i];
}

/// Piecewise linear factor over direction: 1 outside, decreasing to `least` at `middle`.
struct SkegDip {
    bool has_dip = false;
    double first = 0.0, middle = 0.0, last = 0.0, least = 1.0;
    bool mirrored = false;  ///< True: thruster to starboard.
};

SkegDip skeg_dip(const DpThruster& t, const DpSkeg& skeg) noexcept {
    SkegDip out;
    if (t.kind == DpThrusterKind::tunnel || !(t.point.z() > 0.0)) return out;
    const double dx = skeg.x - t.point.x(), dy = skeg.y - t.point.y();
    if (dy == 0.0) return out;
    const double distance = dx > 0.0 ? std::hypot(dx, dy) : std::abs(dy);
    const double reach = t.propeller == DpPropeller::ducted ? 8.0 : 15.0;
    if (!(distance < reach * t.diameter)) return out;
    out.has_dip = true;
    out.mirrored = dy > 0.0;
    const double half_width = std::atan(0.6 * t.diameter / distance);
    const double centre = std::atan2(std::abs(dy), -dx);
    out.middle = std::min(std::max(centre + half_width, 0.5 * kStarPi), kStarPi);
    out.first = std::max(centre - half_width, 0.0);
    out.last = std::min(out.middle + 4.0 * half_width, kStarPi);
    out.least = 2.0 * out.middle / kStarPi - 1.0;
    return out;
}

double dip_factor(const SkegDip& d, double direction) noexcept {
    double a = std::remainder(direction, kTurn);
    if (d.mirrored) a = -a;
    // −π is π: the end of the dip.
    if (a <= -kStarPi) a = kStarPi;
    if (!d.has_dip || a <= d.first) return 1.0;
    if (a == d.middle) return d.least;
    if (a >= d.last) return 1.0;
    if (a <= d.middle) return 1.0 + (d.least - 1.0) * (a - d.first) / (d.middle - d.first);
    return d.least + (1.0 - d.least) * (a - d.middle) / (d.last - d.middle);
}

/// Notch of the star behind a failed thruster: straight lines from both edges to the middle.
struct Notch {
    double middle = 0.0, half_width = 0.0, least = 1.0;
};

/// Return the radius of a notch in the thrust diagram, divided by that of the circle, at an angle
/// from the middle of the notch.
double notch_factor(const Notch& n, double direction) noexcept {
    const double off = std::abs(std::remainder(direction - n.middle, kTurn));
    if (off >= n.half_width) return 1.0;
    // Line from (cos half, sin half) to (least, 0) at the angle `off`.
    const double ex = std::cos(n.half_width), ey = std::sin(n.half_width);
    const double dx = ex - n.least, dy = ey;
    return n.least * dy / (std::cos(off) * dy - std::sin(off) * dx);
}

std::vector<Notch> notches(const DpShip& ship, std::size_t i, const std::vector<bool>& failed) {
    std::vector<Notch> out;
    const DpThruster& t = ship.thrusters[i];
    const bool ducted = t.propeller == DpPropeller::ducted;
    for (std::size_t j = 0; j < ship.thrusters.size(); ++j) {
        const DpThruster& other = ship.thrusters[j];
        if (j == i || is_intact(failed, j) || other.kind == DpThrusterKind::tunnel) continue;
        const double dx = t.point.x() - other.point.x(), dy = t.point.y() - other.point.y();
        const double s = std::hypot(dx, dy);
        if (!(s < (ducted ? 4.0 : 8.0) * t.diameter) || !(s > 0.0)) continue;
        const double r = s / t.diameter;
        out.push_back({std::atan2(dy, dx), std::atan((ducted ? 0.35 : 0.6) / r),
                       1.0 - 1.0 / (0.02 * r * r + 0.25 * r + 1.2)});
    }
    return out;
}

}  // namespace

double dp_skeg_factor(const DpShip& ship, const DpThruster& thruster, double direction) noexcept {
    double out = 1.0;
    for (const DpSkeg& s : ship.skegs) out *= dip_factor(skeg_dip(thruster, s), direction);
    return out;
}

std::vector<DpSector> dp_forbidden_zones(const DpShip& ship, std::size_t thruster,
                                         const std::vector<bool>& failed) {
    const DpThruster& t = ship.thrusters[thruster];
    std::vector<DpSector> out = t.forbidden;
    if (t.kind == DpThrusterKind::tunnel) return out;
    for (std::size_t j = 0; j < ship.thrusters.size(); ++j) {
        const DpThruster& other = ship.thrusters[j];
        if (j == thruster || !is_intact(failed, j) || other.kind == DpThrusterKind::tunnel)
            continue;
        const double dx = t.point.x() - other.point.x(), dy = t.point.y() - other.point.y();
        const double s = std::hypot(dx, dy);
        if (!(s < 15.0 * t.diameter) || !(s > 0.0)) continue;
        const double middle = std::atan2(dy, dx), half_width = std::atan(0.1 + t.diameter / s);
        out.push_back({middle - half_width, middle + half_width});
    }
    return out;
}

namespace vessel {
namespace {

/// Return the directions outside all zones, as sectors in ascending order; the last may extend
/// beyond 2π.
std::vector<DpSector> free_sectors(const std::vector<DpSector>& zones) {
    std::vector<DpSector> blocked;
    for (const DpSector& z : zones) {
        const double width = z.to - z.from;
        if (!(width > 0.0)) continue;
        if (width >= kTurn) return {};
        const double from = positive_angle(z.from);
        if (from + width <= kTurn) {
            blocked.push_back({from, from + width});
        } else {
            blocked.push_back({from, kTurn});
            blocked.push_back({0.0, from + width - kTurn});
        }
    }
    if (blocked.empty()) return {{0.0, kTurn}};
    std::sort(blocked.begin(), blocked.end(),
              [](const DpSector& a, const DpSector& b) { return a.from < b.from; });
    std::vector<DpSector> out;
    double end = 0.0;
    for (const DpSector& b : blocked) {
        if (b.from > end) out.push_back({end, b.from});
        end = std::max(end, b.to);
    }
    if (end < kTurn) out.push_back({end, kTurn});
    // Join the sectors on both sides of direction 0.
    if (out.size() > 1 && out.front().from == 0.0 && out.back().to == kTurn) {
        out.back().to = kTurn + out.front().to;
        out.erase(out.begin());
    }
    return out;
}

double cross(const Force2& a, const Force2& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

/// Cut a chain of boundary points, in ascending direction, into convex fans.
void cut_fans(const std::vector<Force2>& chain, std::vector<Fan>& out) {
    Fan fan;
    double turned = 0.0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const Force2& p = chain[i];
        if (!fan.vertices.empty()) {
            const Force2& last = fan.vertices.back();
            const double step = std::atan2(cross(last, p), last.dot(p));
            bool concave = false;
            if (fan.vertices.size() > 1) {
                const Force2& before = fan.vertices[fan.vertices.size() - 2];
                const Force2 a = last - before, b = p - last;
                concave = cross(a, b) < -1e-9 * a.norm() * b.norm();
            }
            if (concave || turned + step > kMaxFanWidth) {
                out.push_back(fan);
                fan.vertices = {last};
                turned = 0.0;
            }
            turned += step;
        }
        fan.vertices.push_back(p);
    }
    if (!fan.vertices.empty()) out.push_back(fan);
}

/// Append the convex fans of an azimuth thruster's thrust diagram: arcs of its circle with dips and
/// notches.
void turning_fans(const DpShip& ship, std::size_t i, double radius, const std::vector<bool>& failed,
                  double arc, std::vector<Fan>& out) {
    const DpThruster& t = ship.thrusters[i];
    const std::vector<Notch> cuts = notches(ship, i, failed);
    std::vector<double> corners;
    for (const DpSkeg& s : ship.skegs)
        if (const SkegDip d = skeg_dip(t, s); d.has_dip)
            for (const double a : {d.first, d.middle, d.last})
                corners.push_back(positive_angle(d.mirrored ? -a : a));
    for (const Notch& n : cuts)
        for (const double a : {n.middle - n.half_width, n.middle, n.middle + n.half_width})
            corners.push_back(positive_angle(a));
    const double dip = std::min(arc, kDipArc);
    for (const DpSector& s : free_sectors(dp_forbidden_zones(ship, i, failed))) {
        std::vector<double> at{s.from, s.to};
        for (int k = static_cast<int>(std::ceil(s.from / arc)); k * arc < s.to; ++k)
            if (k * arc > s.from) at.push_back(k * arc);
        for (int k = static_cast<int>(std::ceil(s.from / dip)); k * dip < s.to; ++k)
            if (k * dip > s.from && dp_skeg_factor(ship, t, k * dip) < 1.0) at.push_back(k * dip);
        for (const double c : corners)
            for (const double a : {c, c + kTurn})
                if (a > s.from && a < s.to) at.push_back(a);
        std::sort(at.begin(), at.end());
        at.erase(
            std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < 1e-12; }),
            at.end());
        std::vector<Force2> chain;
        for (const double a : at) {
            double r = radius * dp_skeg_factor(ship, t, a);
            for (const Notch& n : cuts) r *= notch_factor(n, a);
            chain.emplace_back(r * std::cos(a), r * std::sin(a));
        }
        cut_fans(chain, out);
    }
}

/// Return true if a direction lies inside a forbidden sector.
bool in_forbidden_sector(const std::vector<DpSector>& zones, double direction) noexcept {
    return std::any_of(zones.begin(), zones.end(), [&](const DpSector& z) {
        return positive_angle(direction - z.from) < z.to - z.from;
    });
}

/// Append the convex fans of a shaft line's thrust diagram: ahead with the rudder to both sides,
/// and astern.
void shaft_fans(const DpShip& ship, std::size_t i, double ahead, double astern,
                const std::vector<bool>& failed, std::vector<Fan>& out) {
    const DpThruster& t = ship.thrusters[i];
    const std::vector<DpSector> zones = dp_forbidden_zones(ship, i, failed);
    const auto factor = [&](double direction) {
        double r = dp_skeg_factor(ship, t, direction);
        for (const Notch& n : notches(ship, i, failed)) r *= notch_factor(n, direction);
        return r;
    };
    if (!in_forbidden_sector(zones, 0.0)) {
        const double thrust = ahead * factor(0.0);
        std::vector<Force2> chain;
        constexpr int kRudderSteps = 60;
        if (t.rudder.area > 0.0) {
            for (int k = -kRudderSteps; k <= kRudderSteps; ++k) {
                const DpRudderForce f = dp_rudder_force(t, kStarPi / 6.0 * k / kRudderSteps);
                chain.emplace_back(thrust * f.x, thrust * f.y);
            }
        } else {
            chain.emplace_back(thrust, 0.0);
        }
        cut_fans(chain, out);
    }
    if (!in_forbidden_sector(zones, kStarPi))
        out.push_back(Fan{{Force2(-astern * factor(kStarPi), 0.0)}});
}

}  // namespace

double utilisation_factor(const Fan& fan, const Force2& f) noexcept {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto& v = fan.vertices;
    const double size = f.norm();
    if (size == 0.0) return 0.0;
    constexpr double kParallelTolerance = 1e-9;
    if (v.size() == 1 || (v.size() == 2 && std::abs(cross(v[0], v[1])) <=
                                               kParallelTolerance * v[0].norm() * v[1].norm())) {
        double best = kNone;
        for (const Force2& p : v)
            if (p.norm() > 0.0 && p.dot(f) > 0.0 &&
                std::abs(cross(p, f)) <= kParallelTolerance * p.norm() * size)
                best = std::min(best, size / p.norm());
        return best;
    }
    double best = kNone;
    for (std::size_t k = 1; k < v.size(); ++k) {
        const Force2 &a = v[k - 1], &b = v[k];
        const double area = cross(a, b);
        if (!(area > 0.0)) continue;
        const double wa = cross(f, b) / area, wb = cross(a, f) / area;
        const double slack = kParallelTolerance * size / std::max(a.norm(), b.norm());
        if (wa >= -slack && wb >= -slack)
            best = std::min(best, std::max(wa, 0.0) + std::max(wb, 0.0));
    }
    return best;
}

double utilisation_factor(const Star& star, const Force2& f) noexcept {
    double best = std::numeric_limits<double>::infinity();
    if (f.norm() == 0.0) return 0.0;
    for (const Fan& fan : star.fans) best = std::min(best, utilisation_factor(fan, f));
    return best;
}

Star capacity_star(const DpShip& ship, std::size_t thruster, const DpCondition& at, double from,
                   const std::vector<bool>& failed, double arc_step) {
    const DpThruster& t = ship.thrusters[thruster];
    Star out;
    out.power = t.power;
    out.x = t.point.x();
    out.y = t.point.y();
    for (std::size_t b = 0; b < ship.switchboards.size(); ++b)
        for (const std::string& name : ship.switchboards[b].thrusters)
            if (name == t.name) out.board = static_cast<int>(b);
    if (!is_intact(failed, thruster)) return out;
    const auto capacity = [&](bool astern) {
        return kMiscellaneousFactor * dp_nominal_thrust(t, astern) *
               dp_ventilation(ship, t, at, from, astern);
    };
    const double ahead = capacity(false);
    if (t.kind == DpThrusterKind::tunnel)
        out.fans = {Fan{{Force2(0.0, -ahead), Force2(0.0, ahead)}}};
    else if (t.kind == DpThrusterKind::shaft)
        shaft_fans(ship, thruster, ahead, capacity(true), failed, out.fans);
    else
        turning_fans(ship, thruster, ahead, failed, arc_step, out.fans);
    return out;
}

}  // namespace vessel
}  // namespace hawser
