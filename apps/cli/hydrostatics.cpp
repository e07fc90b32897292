// SPDX-License-Identifier: Apache-2.0
#include "hydrostatics.h"

#include <fmt/format.h>

#include <cstdio>
#include <numbers>

namespace hawser::cli {
namespace {

void print_hull(const World& world, const SeaDef& sea, const WaterHull& hull) {
    const BodyDef& def = world.body_def(hull.body);
    fmt::print("{}\n", def.name);
    const HullStatics now = hull_statics(hull.mesh, world.pose(hull.body));
    fmt::print("  mesh             {} vertices, {} triangles\n", hull.mesh.vertices.size(),
               hull.mesh.triangles.size());
    fmt::print("  where it is      {:.6g} kg of water, {:.6g} m³, under z = 0\n",
               sea.density * now.volume, now.volume);
    if (def.kind != BodyKind::rigid) return;
    const Flotation at = float_hull(hull.mesh, def.mass, sea.density);
    if (!at.floats) {
        fmt::print("  afloat           it sinks: its mass is {:.6g} kg\n", def.mass);
        return;
    }
    fmt::print(
        "  afloat           {:.6g} kg at a draught of {:.9g} m, centre of mass at z = {:.9g} m\n",
        def.mass, at.draught, at.pose.position.z());
    fmt::print("  waterplane       {:.6g} m², centre at x = {:.6g} m, y = {:.6g} m\n",
               at.statics.plane_area, at.statics.plane_centre.x(), at.statics.plane_centre.y());
    fmt::print("  KB               {:.9g} m\n  BM               {:.9g} m, along {:.9g} m\n", at.kb,
               at.bm, at.bm_long);
    fmt::print("  KG               {:.9g} m\n  GM               {:.9g} m\n", at.kg, at.gm);
    fmt::print("  heel [deg]       GZ [m], draught [m]; trim stays\n");
    for (const int heel : {0, 5, 10, 15, 20, 25, 30, 40, 50, 60, 70, 80, 90}) {
        const double angle = heel * std::numbers::pi / 180.0;
        const Flotation f = float_hull(hull.mesh, def.mass, sea.density, angle);
        fmt::print("  {:>4}             {:>12.9f} {:>12.6f}\n", heel, -f.statics.buoyancy.y() + 0.0,
                   f.draught);
    }
}

}  // namespace

bool print_hydrostatics(const World& world) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr || sea->hulls.empty()) {
        fmt::print(stderr, "hawser: the scene has no hull; \"sea\" takes \"hulls\"\n");
        return false;
    }
    for (const WaterHull& hull : sea->hulls) print_hull(world, *sea, hull);
    return true;
}

}  // namespace hawser::cli
