// SPDX-License-Identifier: Apache-2.0
#include "live/scene_text.h"

#include <hawser/sea.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace hawser::live {
namespace {

constexpr double kLengthResolution = 1e-4;     // [m] resolution of a picture
constexpr double kDirectionResolution = 1e-7;  // [1] for components of unit vectors

Json heights_of(const std::vector<double>& heights) {
    Json out = Json::array();
    for (const double h : heights) out.push_back(shorter(h, kLengthResolution));
    return out;
}

Json waves_of(const Sea& sea) {
    Json out = Json::array();
    for (const WaveComponent& c : sea.components())
        out.push_back({shorter(c.amplitude, 1e-6), c.wave_number, shorter(c.direction, 1e-6),
                       c.frequency, shorter(c.phase, 1e-6)});
    return out;
}

}  // namespace

double shorter(double value, double unit) {
    // Dividing by a power of ten gives the nearest double, which is written with few digits.
    return std::isfinite(value) ? std::round(value / unit) / std::round(1.0 / unit) : 0.0;
}

Json lengths(const Vec3& v) {
    return {shorter(v.x(), kLengthResolution), shorter(v.y(), kLengthResolution),
            shorter(v.z(), kLengthResolution)};
}

Json turn(const Quat& q) {
    return {shorter(q.w(), kDirectionResolution), shorter(q.x(), kDirectionResolution),
            shorter(q.y(), kDirectionResolution), shorter(q.z(), kDirectionResolution)};
}

Json limit(double value) {
    constexpr double kNone = 1e29;
    return std::isfinite(value) && std::abs(value) < kNone ? Json(value) : Json(nullptr);
}

Json vertices_of(const std::vector<Vec3>& points) {
    Json out = Json::array();
    for (const Vec3& p : points)
        for (int k = 0; k < 3; ++k) out.push_back(shorter(p[k], kLengthResolution));
    return out;
}

Json triangles_of(const std::vector<std::array<std::int32_t, 3>>& triangles) {
    Json out = Json::array();
    for (const auto& t : triangles)
        for (const std::int32_t i : t) out.push_back(i);
    return out;
}

Json shape_json(const World& world, ShapeId id) {
    const ShapeDef& def = world.shape_def(id);
    Json out{{"body", def.body.index},
             {"kind", to_string(def.kind)},
             {"name", def.name},
             {"position", lengths(def.position)},
             {"orientation", turn(def.orientation)}};
    switch (def.kind) {
        case ShapeKind::capsule:
        case ShapeKind::cylinder:
            out["half_length"] = def.half_length;
            out["radius"] = def.radius;
            break;
        case ShapeKind::sphere:
            out["radius"] = def.radius;
            break;
        case ShapeKind::box:
            out["half_size"] = lengths(def.half_size);
            break;
        case ShapeKind::plane:
            break;
        case ShapeKind::heightfield:
            out["rows"] = def.rows;
            out["columns"] = def.columns;
            out["cell"] = def.cell;
            out["heights"] = heights_of(def.heights);
            break;
        case ShapeKind::mesh:
            out["triangles"] = triangles_of(def.triangles);
            [[fallthrough]];
        case ShapeKind::hull:
            out["vertices"] = vertices_of(def.vertices);
            break;
    }
    return out;
}

void add_sea(const World& world, Json& out) {
    out["sea"] = nullptr;
    out["hulls"] = Json::array();
    const SeaDef* def = find_sea(world);
    if (!def) return;
    const Sea sea(*def, world.settings().gravity.norm());
    double factor = 1.0;
    for (const SystemSignal& s : world.system_signals()) {
        if (s.system != "sea") continue;
        if (s.name == "waves") factor = *s.value;
    }
    const SeaCurrent surface = def->current.empty() ? SeaCurrent{} : def->current.front();
    out["sea"] = {{"depth", sea.depth()},
                  {"level", still_water(world)},
                  {"waves_factor", factor},
                  {"gauge", def->gauge},
                  {"current", {{"speed", surface.speed}, {"direction", surface.direction}}},
                  {"components", waves_of(sea)}};
    for (const WaterHull& hull : def->hulls)
        out["hulls"].push_back({{"body", hull.body.index},
                                {"vertices", vertices_of(hull.mesh.vertices)},
                                {"triangles", triangles_of(hull.mesh.triangles)}});
}

std::string text_of(const Json& message) {
    return message.dump(-1, ' ', false, Json::error_handler_t::replace).substr(1);
}

}  // namespace hawser::live
