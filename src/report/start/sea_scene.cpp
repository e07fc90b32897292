// SPDX-License-Identifier: Apache-2.0
/// Warn about a scene in the sea: depth and seabed, wires without drag, hulls in short waves, and
/// truncated memory functions.
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hawser::report::start {
namespace {

/// Return the smallest difference of two depths that is reported [m]. A smaller difference may be
/// rounding or the thickness of a wire.
double depth_digits(double depth) { return std::max(0.1, 0.005 * depth); }

/// Ratio of wavelength to hull length, below which added mass and damping need coefficients that
/// depend on frequency.
constexpr double kShortWaves = 3.0;

/// Allowed fraction of K(0) at the end of a memory function.
constexpr double kMemoryLeft = 0.01;

/// Depth below still water from which a wire counts as in the sea [m].
constexpr double kInTheSea = 0.5;

/// Call f(height, name) for each level plane of the world and each seabed of a cable.
template <class F>
void each_bottom(const record::SceneInfo& scene, const World& world, const F& f) {
    for (const ShapeId id : world.shapes()) {
        const ShapeDef& shape = world.shape_def(id);
        if (shape.kind != ShapeKind::plane || !shape.body.valid()) continue;
        if (world.body_def(shape.body).kind != BodyKind::fixed) continue;
        const Vec3 up = world.pose(shape.body).orientation * (shape.orientation * Vec3::UnitZ());
        if (up.z() < 0.999) continue;
        f(world.world_point(shape.body, shape.position).z(),
          "the plane of " + record::name_in_quotes(record::body_label(world, shape.body)),
          record::body_label(world, shape.body));
    }
    const auto text = nlohmann::json::parse(scene.text, nullptr, false);
    if (!text.is_object() || !text.contains("cables")) return;
    for (const auto& cable : text["cables"]) {
        if (!cable.is_object() || !cable.contains("seabed") || !cable.contains("name")) continue;
        const auto& height = cable["seabed"]["height"];
        if (!height.is_number()) continue;
        const auto name = cable["name"].get<std::string>();
        f(height.get<double>(), "the seabed of the cable " + record::name_in_quotes(name), name);
    }
}

void check_depth(const record::SceneInfo& scene, const World& world, const SeaDef& sea,
                 Findings& out) {
    each_bottom(scene, world, [&](double z, const std::string& what, const std::string& name) {
        const double off = z + sea.depth;
        if (std::abs(off) <= depth_digits(sea.depth)) return;
        out.add(false, FindingKind::depth, {name}, std::abs(off),
                fmt::format("{} is at z = {:.6g} m, but the bottom of the sea is at z = {:.6g} m "
                            "(its \"depth\" of {:.6g} m below z = 0): give both the same height",
                            what, z, -sea.depth, sea.depth));
    });
}

/// True if the scene specifies a linear drag for the cable.
bool has_linear_drag(const World& world, const record::CableInfo& cable) {
    return std::any_of(cable.nodes.begin(), cable.nodes.end(), [&](BodyId id) {
        const BodyDef& def = world.body_def(id);
        return def.kind == BodyKind::lump && !def.linear_damping.isZero(0.0);
    });
}

bool is_wire(const World& world, const record::CableInfo& cable) {
    return std::any_of(cable.elements.begin(), cable.elements.end(), [&](InteractionId id) {
        return kind_info(world.interaction_def(id).kind).is(kWireElement);
    });
}

void check_drag(const record::SceneInfo& scene, const World& world, const SeaDef& sea,
                Findings& out) {
    const double level = still_water(world);
    for (const record::CableInfo& cable : scene.cables) {
        if (!is_wire(world, cable) || has_linear_drag(world, cable)) continue;
        double deepest = 0.0;
        for (const BodyId id : cable.nodes)
            if (world.body_def(id).kind != BodyKind::scalar)
                deepest = std::max(deepest, level - world.pose(id).position.z());
        if (!(deepest > kInTheSea)) continue;
        const WireId wire = world.wires().find(cable.name);
        const auto line = std::find_if(sea.lines.begin(), sea.lines.end(),
                                       [&](const WaterLine& l) { return l.wire == wire; });
        const bool wet = wire.valid() && line != sea.lines.end();
        if (wet && std::any_of(line->sections.begin(), line->sections.end(), [](const auto& s) {
                return s.water.cd_normal > 0.0 || s.water.cd_tangential > 0.0;
            }))
            continue;
        const std::string name = record::name_in_quotes(cable.name);
        out.add(false, FindingKind::dry, {cable.name}, cable.length,
                wet ? fmt::format("the cable {} has no drag in the sea: its line type has "
                                  "\"cd_normal\" 0; rope and wire have 1.2, chain 2.4",
                                  name)
                    : fmt::format("the cable {} starts up to {} under water, and the sea does not "
                                  "act on it: it has its weight in air and no drag; give its line "
                                  "type \"cd_normal\" (rope and wire 1.2, chain 2.4)",
                                  name, record::with_unit(deepest, "m")));
    }
}

double length_of(const HullMesh& mesh) {
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& v : mesh.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    return std::max(high.x() - low.x(), high.y() - low.y());
}

void check_short_waves(const World& world, const SeaDef& sea, Findings& out) {
    const double gravity = world.settings().gravity.norm();
    for (const WaterHull& hull : sea.hulls) {
        if (hull.coefficients || hull.mesh.vertices.empty()) continue;
        const double length = length_of(hull.mesh);
        double shortest = HUGE_VAL, period = 0.0;
        for (const WaveDef& wave : sea.waves) {
            const double omega = 2.0 * std::numbers::pi / wave.period;
            const double lambda = 2.0 * std::numbers::pi / wave_number(omega, sea.depth, gravity);
            if (lambda >= shortest) continue;
            shortest = lambda;
            period = wave.period;
        }
        if (!(shortest < kShortWaves * length)) continue;
        const std::string name = record::body_label(world, hull.body);
        out.add(false, FindingKind::short_waves, {name}, shortest / length,
                fmt::format("waves of {:.3g} s are {:.3g} m long, {:.3g} of the length of the hull "
                            "of {}: below {:.2g} its added_mass and damping of one frequency are "
                            "an approximation, with waves that the hull does not scatter; give "
                            "\"coefficients\" with \"excitation\" (WAMIT, NEMOH, Capytaine)",
                            period, shortest, shortest / length, record::name_in_quotes(name),
                            kShortWaves));
    }
}

void check_memories(const World& world, const SeaDef& sea, Findings& out) {
    for (const WaterHull& hull : sea.hulls) {
        if (!hull.coefficients || hull.radiation != RadiationKind::convolution) continue;
        const MemoryEnd end = memory_end(*hull.coefficients, hull.memory, kMemoryLeft);
        if (!(end.ratio > kMemoryLeft)) continue;
        const std::string name = record::body_label(world, hull.body);
        const std::string remedy =
            std::isnan(end.enough)
                ? fmt::format(
                      "K does not fall below {:.2g} % in {:.3g} s: its frequencies are too far "
                      "apart; give a finer table, or \"radiation\": \"state_space\"",
                      100.0 * kMemoryLeft, 20.0 * hull.memory)
                : fmt::format(
                      "give \"memory\" of {:.3g} s or more, or \"radiation\": "
                      "\"state_space\"",
                      std::ceil(end.enough));
        out.add(false, FindingKind::memory, {name}, end.ratio,
                fmt::format("the memory of the hull of {} ends after {:.3g} s, where K(T)/K(0) is "
                            "still {:.2g} % (at most {:.2g} %): {}",
                            record::name_in_quotes(name), hull.memory, 100.0 * end.ratio,
                            100.0 * kMemoryLeft, remedy));
    }
}

}  // namespace

void check_sea_scene(const record::SceneInfo& scene, const World& world, Findings& out) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr) return;
    check_depth(scene, world, *sea, out);
    check_drag(scene, world, *sea, out);
    check_short_waves(world, *sea, out);
    check_memories(world, *sea, out);
}

}  // namespace hawser::report::start
