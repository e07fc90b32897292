// SPDX-License-Identifier: Apache-2.0
#include "draw/water.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hawser::draw {
namespace {

using Json = nlohmann::json;

/// Add the height of a plane that faces up, or the mean height of a ground of lines.
void add_outline(const record::Recording& recording, const record::RecordedOutline& o,
                 Water& water) {
    const record::RecordedBody& body = recording.bodies[static_cast<std::size_t>(o.body)];
    if (body.kind != BodyKind::fixed) return;
    const Quat turn = body.start.orientation.normalized();
    double z = 0.0;
    if (o.kind == record::OutlineKind::plane) {
        if ((turn * o.points[1]).z() < 0.95) return;
        z = (body.start.position + turn * o.points[0]).z();
    } else if (o.kind == record::OutlineKind::lines) {
        for (const Vec3& p : o.points) z += (body.start.position + turn * p).z();
        z /= static_cast<double>(o.points.size());
    } else {
        return;
    }
    // A deck is no seabed.
    if (!water.level || z >= *water.level - 1.0) return;
    water.seabed = std::max(z, water.seabed.value_or(z));
}

}  // namespace

Water water_of(const record::Recording& recording, const record::Frame& frame) {
    Water out;
    const Json root = Json::parse(recording.scene_text, nullptr, false);
    if (!root.is_object()) return out;
    if (const auto sea = root.find("sea"); sea != root.end() && sea->is_object()) {
        out.level = frame.water;
        if (const auto depth = sea->find("depth"); depth != sea->end() && depth->is_number())
            if (depth->get<double>() > 0.0) out.seabed = -depth->get<double>();
    }
    if (const auto list = root.find("interactions"); list != root.end() && list->is_array())
        for (const Json& one : *list)
            if (one.is_object() && one.value("kind", Json()) == "hydrostatic" && !out.level)
                out.level = 0.0;
    for (const record::RecordedOutline& o : recording.outlines) add_outline(recording, o, out);
    return out;
}

}  // namespace hawser::draw
