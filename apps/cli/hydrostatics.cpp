// SPDX-License-Identifier: Apache-2.0
#include "hydrostatics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace hawser::cli {
namespace {

/// Round a length to nanometres. A result of −0 becomes 0.
double rounded_length(double length) { return std::round(1e9 * length) / 1e9 + 0.0; }

void print_hull(const World& world, const SeaDef& sea, const WaterHull& hull) {
    const BodyDef& def = world.body_def(hull.body);
    fmt::print("{}\n", def.name);
    const double level = still_water(world);
    const HullStatics now = hull_statics(hull.mesh, world.pose(hull.body), level);
    fmt::print("  mesh             {} vertices, {} triangles\n", hull.mesh.vertices.size(),
               hull.mesh.triangles.size());
    fmt::print("  where it is      {:.6g} kg of water, {:.6g} m³, under z = {:.6g} m\n",
               sea.density * now.volume, now.volume, level);
    if (def.kind != BodyKind::rigid) return;
    const Flotation at = float_hull(hull.mesh, def.mass, sea.density);
    if (!at.floats) {
        fmt::print("  afloat           it sinks: its mass is {:.6g} kg\n", def.mass);
        return;
    }
    fmt::print(
        "  afloat           {:.6g} kg at a draught of {:.9g} m, centre of mass at z = {:.9g} m\n",
        def.mass, at.draught, level + at.pose.position.z());
    fmt::print("  waterplane       {:.6g} m², centre at x = {:.6g} m, y = {:.6g} m\n",
               at.statics.plane_area, at.statics.plane_centre.x(), at.statics.plane_centre.y());
    fmt::print("  KB               {:.9g} m\n  BM               {:.9g} m, along {:.9g} m\n", at.kb,
               at.bm, at.bm_long);
    fmt::print("  KG               {:.9g} m\n  GM               {:.9g} m\n", at.kg, at.gm);
    fmt::print("  heel [deg]       GZ [m], draught [m]; GZ [m] and trim [deg] where it trims\n");
    for (const int heel : {0, 5, 10, 15, 20, 25, 30, 40, 50, 60, 70, 80, 90}) {
        const double angle = heel * std::numbers::pi / 180.0;
        const Flotation f = float_hull(hull.mesh, def.mass, sea.density, angle);
        const Flotation t = float_hull(hull.mesh, def.mass, sea.density, angle, true);
        fmt::print("  {:>4}             {:>12.9f} {:>12.6f} {:>12.9f} {:>8.4f}\n", heel,
                   rounded_length(-f.statics.buoyancy.y()), f.draught,
                   rounded_length(-t.statics.buoyancy.y()), t.trim * 180.0 / std::numbers::pi);
    }
}

void print_radiation(const WaterHull& hull, const HullMemory& m) {
    const WaveCoefficients& c = *hull.coefficients;
    fmt::print("  coefficients     {} frequencies, {:.4g} to {:.4g} rad/s, {} directions\n",
               c.frequency.size(), c.frequency.front(), c.frequency.back(), c.heading.size());
    if (m.kind == RadiationKind::convolution)
        fmt::print("  memory           {} samples of {:.4g} s", m.past.size(), m.step);
    else if (m.kind == RadiationKind::state_space)
        fmt::print("  memory           {} states, off by {:.3g} of K(0) at most", m.states.size(),
                   m.fit_error);
    else
        return;
    double most = 0.0;
    for (int k = 0; k < 6; ++k)
        if (m.first(k, k) > 0.0) most = std::max(most, m.added(k, k) / m.first(k, k));
    fmt::print("; damping added for passivity {:.3g} s of K(0)\n", most);
    if (c.added_mass.empty()) return;
    const Matrix6 reported = infinite_added_mass(c);
    fmt::print("  A(inf)           by the damping, and as it is taken\n");
    for (int k = 0; k < 6; ++k)
        if (reported(k, k) != 0.0)
            fmt::print("    motion {}       {:>14.6g} {:>14.6g}\n", k + 1, reported(k, k),
                       c.infinite(k, k));
}

}  // namespace

bool print_hydrostatics(const World& world) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr || sea->hulls.empty()) {
        fmt::print(stderr, "hawser: the scene has no hull; \"sea\" takes \"hulls\"\n");
        return false;
    }
    for (std::size_t i = 0; i < sea->hulls.size(); ++i) {
        const WaterHull& hull = sea->hulls[i];
        if (hull.mesh.triangles.empty())
            fmt::print("{}\n  no mesh          linear about z = {:.6g} m\n",
                       world.body_def(hull.body).name, hull.linear.height);
        else
            print_hull(world, *sea, hull);
        if (hull.coefficients) print_radiation(hull, hull_memory(world, i));
    }
    return true;
}

}  // namespace hawser::cli
