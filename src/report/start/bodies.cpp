// SPDX-License-Identifier: Apache-2.0
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::report::start {

namespace {

/// Range of plausible densities, from foamed plastic with much air around it to platinum [kg/m³].
constexpr double kMinDensity = 1.0, kMaxDensity = 25'000.0;
/// Range of plausible densities of a line [kg/m³]. Largest: a chain has 28,000 (22 kg/m for each
/// cm² of its bar, whose diameter is its nominal size). Least: floating hose of foam has 300; below
/// 100 a mass in t/m is likely.
constexpr double kLightestLine = 100.0, kDensestLine = 40'000.0;
/// Limits of an inertia that fits the body: the body twice as large, or all mass within a thirtieth
/// of it.
constexpr double kTooWide = 4.0, kTooNarrow = 1e-3;
/// Rotation in a step above which it is under-resolved [rad].
constexpr double kTurn = 0.5;

double volume_of(const ShapeDef& def) {
    constexpr double kPi = std::numbers::pi;
    const double r = def.radius;
    switch (def.kind) {
        case ShapeKind::sphere:
            return 4.0 / 3.0 * kPi * r * r * r;
        case ShapeKind::capsule:
            return def.body_b.valid() ? 0.0 : kPi * r * r * (2.0 * def.half_length + 4.0 / 3.0 * r);
        case ShapeKind::cylinder:
            return 2.0 * kPi * r * r * def.half_length;
        case ShapeKind::box:
            return 8.0 * def.half_size.prod();
        case ShapeKind::hull: {
            Vec3 low = def.vertices.front(), high = low;
            for (const Vec3& v : def.vertices) {
                low = low.cwiseMin(v);
                high = high.cwiseMax(v);
            }
            return (high - low)
                .prod();  // A hull does not fill its box, so the density is underestimated.
        }
        case ShapeKind::plane:
        case ShapeKind::heightfield:
        case ShapeKind::mesh:
            break;
    }
    return 0.0;
}

void check_density(const World& world, BodyId id, double shapes, Findings& out) {
    const BodyDef& def = world.body_def(id);
    const double box = 8.0 * def.half_size.prod();
    const double most = std::max(box, shapes),
                 least = box > 0.0 && shapes > 0.0 ? std::min(box, shapes) : most;
    if (!(most > 0.0)) return;
    const bool dense = def.mass / most > kMaxDensity;
    if (!dense && def.mass / least >= kMinDensity) return;
    const double volume = dense ? most : least, density = def.mass / volume;
    out.add(false, FindingKind::density, {record::body_label(world, id)}, density,
            fmt::format("{} has an implausible density of {:.3g} kg/m³ ({:.6g} kg in {:.3g} m³): "
                        "{}; check its mass in kg and its size in m (half sizes)",
                        record::name_in_quotes(record::body_label(world, id)), density, def.mass,
                        volume, dense ? "platinum has 21,450" : "air has 1.2"));
}

void check_inertia(const World& world, BodyId id, Findings& out) {
    const BodyDef& def = world.body_def(id);
    const std::string name = record::body_label(world, id);
    const double extent = def.half_size.norm();
    if (!(extent > 0.0)) return;
    // Half the trace is Σ m r² about the centre.
    const double spread = std::sqrt(0.5 * def.inertia.trace() / def.mass);
    const double ratio = spread * spread / (extent * extent);
    if (ratio <= kTooWide && ratio >= kTooNarrow) return;
    out.add(false, FindingKind::inertia, {name}, ratio,
            fmt::format("the inertia of {} does not fit its size: its mass would be {} from the "
                        "centre, but its box extends to {}",
                        record::name_in_quotes(name), record::with_unit(spread, "m"),
                        record::with_unit(extent, "m")));
}

void check_spin(const World& world, BodyId id, Findings& out) {
    const double turn = world.velocity(id).angular.norm() * world.settings().step;
    if (turn <= kTurn) return;
    const std::string name = record::body_label(world, id);
    out.add(false, FindingKind::spin_step, {name}, turn,
            fmt::format("{} turns by {:.3g} rad in a step; a step follows up to {:.3g} rad: use "
                        "steps of {:.2g} ms or less",
                        record::name_in_quotes(name), turn, kTurn,
                        1e3 * world.settings().step * kTurn / turn));
}

}  // namespace

void check_bodies(const World& world, Findings& out) {
    std::vector<double> shapes(static_cast<std::size_t>(world.body_count()), 0.0);
    for (const ShapeId s : world.shapes())
        shapes[static_cast<std::size_t>(world.shape_def(s).body.index)] +=
            volume_of(world.shape_def(s));
    for (const BodyId b : world.bodies()) {
        const BodyKind kind = world.body_def(b).kind;
        if (kind == BodyKind::rigid || kind == BodyKind::lump)
            check_density(world, b, shapes[static_cast<std::size_t>(b.index)], out);
        if (kind != BodyKind::rigid) continue;
        check_inertia(world, b, out);
        check_spin(world, b, out);
    }
}

void check_cable_density(const record::SceneInfo& scene, const World& world, Findings& out) {
    for (const record::CableInfo& cable : scene.cables) {
        if (cable.nodes.size() < 3 || !(cable.diameter > 0.0)) continue;
        const BodyDef& node = world.body_def(cable.nodes[cable.nodes.size() / 2]);
        if (node.kind != BodyKind::lump || cable.elements.empty()) continue;
        const double element = cable.length / static_cast<double>(cable.elements.size());
        const double area = 0.25 * std::numbers::pi * cable.diameter * cable.diameter;
        const double density = node.mass / (area * element);
        if (density >= kLightestLine && density <= kDensestLine) continue;
        out.add(false, FindingKind::density, {cable.name}, density,
                fmt::format("the cable {} has a density of {:.3g} kg/m³ ({:.4g} kg/m at a diameter "
                            "of {}), which is that of no rope, wire or chain",
                            record::name_in_quotes(cable.name), density, node.mass / element,
                            record::with_unit(cable.diameter, "m")));
    }
}

}  // namespace hawser::report::start
