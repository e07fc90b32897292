// SPDX-License-Identifier: Apache-2.0
// Drag-embedment anchors against their law, and against Aubeny and Chi's trajectory in clay.
#include <hawser/anchor.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kAnchorStep = 1.0 / 60.0, kAnchorDegree = kPi / 180.0;
constexpr double kAnchorMass = 15e3, kAnchorLine = 100.0;

/// An anchor, and a buoy that pulls at it by a line of one element in any direction.
struct Moored {
    World w{WorldDef{.step = kAnchorStep}};
    BodyId anchor{}, buoy{};
    Vec3 along;
    double force;

    Moored(AnchorDef def, double tension, double angle, double heading = 0.3)
        : along(std::cos(angle) * std::cos(heading), std::cos(angle) * std::sin(heading),
                std::sin(angle)),
          force(tension) {
        constexpr double kStiffEA = 1e9;  // EA [N]
        anchor = w.add_body({.name = "anchor",
                             .position = {0, 0, 0},
                             .mass = kAnchorMass,
                             .inertia = 4.0 * kAnchorMass * Mat3::Identity()});
        buoy = w.add_body({.name = "buoy",
                           .kind = BodyKind::lump,
                           .position = kAnchorLine * along,
                           .mass = 1e4,
                           .linear_damping = Vec3::Constant(4e5),
                           .gravity = false});
        def.wire = w.wires().add({.name = "line",
                                  .from = anchor,
                                  .to = buoy,
                                  .elements = 1,
                                  .length = kAnchorLine / (1.0 + tension / kStiffEA),
                                  .EA = kStiffEA,
                                  .mass_per_length = 1.0});
        def.name = "anchor";
        def.body = anchor;
        w.add(def);
        pull(tension);
    }
    void pull(double tension) { w.set_force(buoy, tension * along, Vec3::Zero()); }
    [[nodiscard]] double signal(const char* name) const {
        return w.system_signal(std::string("anchor.") + name);
    }
};

AnchorDef sand_anchor(double drag) {
    return {.soil = AnchorSoil::sand, .type = AnchorType::stevpris_mk6, .drag = drag, .set = true};
}

/// Return the capacity by the published law: UHC 904.21 kN t^-0.92, fluke (m/120)^(1/3), 4 flukes.
double sand_capacity(double drag) {
    const double uhc = 904.21e3 * std::pow(15.0, 0.92), fluke = std::cbrt(kAnchorMass / 120.0);
    return uhc * (0.072 + 0.928 * (1.0 - std::exp(-drag / (4.0 * fluke))));
}

void report_capacity(Report& report) {
    for (const double drag : {0.0, 1.0, 7.5, 30.0, 90.0}) {
        Moored m(sand_anchor(drag), 1e3, 0.0);
        advance(m.w, 2);
        report.compare(fmt::format("anchor, sand: capacity at {:g} m [N]", drag),
                       {sand_capacity(drag)}, {m.signal("capacity")}, 1e-6, "relative; the law");
    }
    constexpr double kUpliftFactors[][2] = {{0, 1},    {2.5, 0.875}, {5, 0.75},     {10, 0.625},
                                            {15, 0.5}, {30, 0.25},   {40, 1.0 / 12}};
    for (const auto& [angle, f] : kUpliftFactors) {
        Moored m(sand_anchor(30.0), 0.5 * f * sand_capacity(30.0), angle * kAnchorDegree);
        advance(m.w, 30);
        const double least = 0.5 * kAnchorMass * kGravity;
        report.compare(
            fmt::format("anchor, sand: capacity at a line angle of {:g} degrees [N]", angle),
            {std::max(f * sand_capacity(30.0), least)}, {m.signal("capacity")}, 1e-6,
            "relative; the table, at the angle of the line");
    }
}

void report_creep(Report& report) {
    for (const double angle : {0.0, 10.0}) {
        const double f = angle > 0.0 ? 0.625 : 1.0;
        Moored m(sand_anchor(30.0), 0.99 * f * sand_capacity(30.0), angle * kAnchorDegree);
        advance(m.w, 60);
        const Vec3 first = m.w.pose(m.anchor).position;
        double creep = 0.0;
        for (int i = 0; i < 600; ++i) {
            advance(m.w, 60);
            creep = std::max(creep, (m.w.pose(m.anchor).position - first).norm());
        }
        report.compare(
            fmt::format("anchor, 99 % of the capacity, {:g} degrees: way in 10 min [m]", angle),
            {0.0}, {creep}, 1e-6, "at rest", 1.0);
    }
}

/// Return the drag distance at which the capacity is `force` [m].
double sand_drag(double force) {
    const double full = sand_capacity(1e9), fluke = std::cbrt(kAnchorMass / 120.0);
    return -4.0 * fluke * std::log((1.0 - force / full) / 0.928);
}

void report_dragging(Report& report) {
    Moored m(sand_anchor(30.0), 0.9 * sand_capacity(30.0), 0.0);
    advance(m.w, 120);
    for (int i = 1; i <= 6000; ++i) {  // to 101 % in 100 s
        m.pull((0.9 + 0.11 * i / 6000.0) * sand_capacity(30.0));
        advance(m.w, 1);
    }
    advance(m.w, 6000);
    report.compare("anchor, 101 % of the capacity: drag until it holds [m]",
                   {sand_drag(1.01 * sand_capacity(30.0))}, {m.signal("drag")}, 5e-3,
                   "relative; the drag with that capacity, and what mass carries it beyond");
    const double drag = m.signal("drag");
    for (int i = -3000; i <= 3000; ++i) {  // down to 20 % and up again
        m.pull((0.2 + 0.808 * std::abs(i) / 3000.0) * sand_capacity(30.0));
        advance(m.w, 1);
    }
    report.compare("anchor, unloaded and loaded again: drag [m]", {drag}, {m.signal("drag")}, 1e-9,
                   "it stays", 1.0);
}

void report_break_out(Report& report) {
    for (const bool sand : {true, false}) {
        AnchorDef def = sand_anchor(30.0);
        if (!sand) def.soil = AnchorSoil::soft_clay;
        Moored m(def, 2e5, 0.0);
        advance(m.w, 60);
        const double expected = m.signal("breakout");
        double force = 0.0;
        while (m.signal("set") > 0.5 && force < 2.0 * expected) {
            force += 1e-3 * expected;
            m.w.set_force(m.anchor, {0.0, 0.0, force}, Vec3::Zero());
            advance(m.w, 1);
        }
        const double uhc = sand ? 904.21e3 * std::pow(15.0, 0.92) : 509.96e3 * std::pow(15.0, 0.93);
        const double fluke = std::cbrt(kAnchorMass / 120.0), length = (sand ? 4.0 : 20.0) * fluke;
        const double g = 0.072 + 0.928 * (1.0 - std::exp(-30.0 / length));
        report.compare(fmt::format("anchor, {}: vertical pull at the crown that breaks it out [N]",
                                   sand ? "sand" : "soft clay"),
                       {(sand ? 0.17 : 0.75) * uhc * g}, {force}, 5e-3, "relative; the law");
        report.compare("anchor, broken out: drag [m]", {0.0}, {m.signal("drag")}, 1e-12, "none",
                       1.0);
    }
    Moored m(sand_anchor(30.0), 0.05 * sand_capacity(30.0), 46.0 * kAnchorDegree);
    advance(m.w, 10);
    report.compare("anchor, line at 46 degrees: set", {0.0}, {m.signal("set")}, 0.0, "broken out",
                   1.0);
}

/// Aubeny and Chi (2010): 6 m² fluke, line of 73 mm, strength 1.5 + 1.75 z kPa.
struct Clay {
    double x, depth, force;
};
constexpr Clay kClayCases[] = {
    {1, 1.700, 241.7e3},    {5, 4.127, 471.0e3},    {10, 6.662, 710.5e3},  {20, 10.801, 1101.7e3},
    {30, 14.126, 1415.9e3}, {40, 16.898, 1677.9e3}, {60, 21.280, 2092.0e3}};

/// Haul the anchor slowly through clay. Return the signal `what` at each drag distance of
/// kClayCases.
std::vector<double> drag_through(const AnchorDef& def, const char* what) {
    Moored m(def, 1e4, 0.0);
    std::vector<double> out;
    double force = 1e4;
    while (out.size() < std::size(kClayCases) && m.w.time() < 4000.0) {
        force += 60.0 * kAnchorStep * 60.0;
        m.pull(force);
        const double drag = m.signal("drag"), value = m.signal(what);
        advance(m.w, 1);
        const double x = kClayCases[out.size()].x, now = m.signal("drag");
        if (now < x) continue;
        const double share = now > drag ? (x - drag) / (now - drag) : 1.0;
        out.push_back(value + share * (m.signal(what) - value));
    }
    return out;
}

void report_trajectory(Report& report) {
    AnchorDef dives{.soil = AnchorSoil::soft_clay,
                    .mass = 10e3,
                    .fluke_length = std::sqrt(6.0 / 1.25),
                    .law = AnchorLaw::trajectory,
                    .set = true};
    dives.clay = {.strength = 1.5e3, .gradient = 1.75e3, .fluke_area = 6.0, .chain_width = 0.073};
    AnchorDef grows = dives;
    grows.law = AnchorLaw::exponential;
    grows.uhc = 2708e3;
    const std::vector<double> pull = drag_through(dives, "tension"),
                              depth = drag_through(dives, "depth"),
                              other = drag_through(grows, "tension");
    for (std::size_t i = 0; i < std::size(kClayCases); ++i) {
        const auto at = [&](const std::vector<double>& v) { return i < v.size() ? v[i] : 0.0; };
        const double most = kClayCases[i].x < 5.0 ? 0.06 : 0.02;
        report.compare(fmt::format("anchor, clay: depth at {:g} m [m]", kClayCases[i].x),
                       {kClayCases[i].depth}, {at(depth)}, 2e-3, "relative; digits of the table");
        report.compare(fmt::format("anchor, clay: pull at {:g} m [N]", kClayCases[i].x),
                       {kClayCases[i].force}, {at(pull)}, 5e-3,
                       "relative; mass of anchor and buoy");
        report.compare(
            fmt::format("anchor, clay: pull at {:g} m, exponential law [N]", kClayCases[i].x),
            {kClayCases[i].force}, {at(other)}, most, "relative; a fit");
    }
}

}  // namespace

void case_vessel_anchors(Report& report) {
    report_capacity(report);
    report_creep(report);
    report_dragging(report);
    report_break_out(report);
    report_trajectory(report);
}

}  // namespace hawser::validate
