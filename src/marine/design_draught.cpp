// SPDX-License-Identifier: Apache-2.0
/// Find the draughts to which drag and wind areas of hulls refer (hawser/water_hull.h).
#include "marine/design_draught.h"

#include <hawser/hull.h>

#include "base/held_together.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hawser::marine {
namespace {

double mesh_volume(const HullMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const auto at = [&](std::size_t k) {
            return mesh.vertices[static_cast<std::size_t>(t[k])];
        };
        sum += at(0).dot(at(1).cross(at(2))) / 6.0;
    }
    return sum;
}

}  // namespace

void set_design_draughts(const World& world, SeaDef& def, double level) {
    const auto needs = [](const WaterHull& h) {
        return std::isnan(h.design_draught) && !h.mesh.triangles.empty();
    };
    if (std::none_of(def.hulls.begin(), def.hulls.end(), needs)) return;
    const base::LinkedGroups held(world);
    for (WaterHull& hull : def.hulls) {
        if (!needs(hull)) continue;
        const std::size_t group = held.group(hull.body);
        double mass = 0.0, volume = 0.0;
        bool free = true;
        for (const BodyId id : world.bodies()) {
            if (held.group(id) != group) continue;
            const BodyDef& body = world.body_def(id);
            if (body.kind == BodyKind::scalar) continue;
            free = free && body.kind != BodyKind::fixed && body.kind != BodyKind::kinematic;
            mass += body.mass;
        }
        for (const WaterHull& other : def.hulls)
            if (!other.mesh.triangles.empty() && held.group(other.body) == group)
                volume += mesh_volume(other.mesh);
        double low = hull.mesh.vertices.front().z(), high = low;
        double lowest = HUGE_VAL;
        const Pose pose = world.pose(hull.body);
        for (const Vec3& v : hull.mesh.vertices) {
            low = std::min(low, v.z());
            high = std::max(high, v.z());
            lowest = std::min(lowest, (pose.position + pose.orientation * v).z());
        }
        double draught = level - lowest;
        if (free && mass > 0.0) {
            const double fraction = mesh_volume(hull.mesh) / volume;
            const Flotation at = float_hull(hull.mesh, fraction * mass, def.density, 0.0, false);
            if (at.floats) draught = at.draught;
        }
        const double height = high - low;
        hull.design_draught = draught > 0.0 && draught < height ? draught : height;
    }
}

}  // namespace hawser::marine
