// SPDX-License-Identifier: Apache-2.0
/// Make the system of a sea from its definition.
#include <hawser/sea.h>
#include <hawser/world.h>

#include "marine/bodies.h"
#include "marine/checks.h"
#include "marine/design_draught.h"
#include "marine/sea_system.h"

#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

namespace hawser {
namespace {

using marine::check_range;
using marine::entry;

void check_areas(const std::string& field, const Vec3& areas) {
    for (const double a : areas) check_range(field, a, 0.0, 1e9, false, "m^2");
}

void check_water_body(const World& world, const WaterBody& b, const std::string& at) {
    if (!world.alive(b.body)) throw SeaError(at + "/body", "there is no such body");
    const BodyKind kind = world.body_def(b.body).kind;
    if (kind == BodyKind::scalar)
        throw SeaError(at + "/body", "a scalar body has no position in the water");
    check_areas(at + "/drag_area", b.drag_area);
    check_areas(at + "/wind_area", b.wind_area);
    check_range(at + "/volume", b.volume, 0.0, 1e9, false, "m^3");
    for (const double a : b.added_mass) check_range(at + "/added_mass", a, 0.0, 1e6, false, "");
    check_range(at + "/height", b.height, 0.0, 1e4, false, "m");
    if (!(marine::height_of(b) > 0.0))
        throw SeaError(at + "/height", "a body without volume needs it");
}

void check_water_hull(const World& world, const WaterHull& h, const std::string& at) {
    if (!world.alive(h.body)) throw SeaError(at + "/body", "there is no such body");
    const BodyKind kind = world.body_def(h.body).kind;
    if (kind == BodyKind::lump || kind == BodyKind::scalar)
        throw SeaError(at + "/body", "a hull needs a rigid body");
    if (h.linear.on && h.mesh.triangles.empty()) {
        if (h.wave_pressure && h.excitation == ExcitationKind::scattering)
            throw SeaError(at + "/mesh",
                           "scattering needs the wave pressure on a mesh in addition");
    } else if (const std::string fault = hull_fault(h.mesh); !fault.empty()) {
        throw SeaError(at + "/mesh", fault);
    }
    for (const double a : h.added_mass) check_range(at + "/added_mass", a, 0.0, 1e18, false, "");
    for (const double d : h.damping) check_range(at + "/damping", d, 0.0, 1e18, false, "");
    marine::check_coefficients(world, h, at);
    check_areas(at + "/drag_area", h.drag_area);
    check_areas(at + "/wind_area", h.wind_area);
    if (!std::isnan(h.design_draught))
        check_range(at + "/design_draught", h.design_draught, 0.0, 1e4, true, "m");
}

void check_water_rod(const World& world, const WaterRod& r, const std::string& at) {
    if (!world.alive(r.body)) throw SeaError(at + "/body", "there is no such body");
    const BodyKind kind = world.body_def(r.body).kind;
    if (kind == BodyKind::lump || kind == BodyKind::scalar)
        throw SeaError(at + "/body",
                       "a rod needs a rigid body; a point mass belongs in \"bodies\", or in "
                       "\"lines\" as a node of a line");
    for (const Vec3* end : {&r.from, &r.to})
        for (const double x : *end)
            check_range(at + (end == &r.from ? "/from" : "/to"), x, -1e4, 1e4, false, "m");
    if (!((r.to - r.from).norm() > 0.0))
        throw SeaError(at + "/to", "it is at the same point as \"from\"; a rod needs a length");
    marine::check_line_water(at, marine::with_volume(r.water));
    check_range(at + "/segments", r.segments, 1.0, kMaxRodSegments, false, "");
}

/// Reject wave components with less than two steps per period, because the world would sample them
/// as another wave (aliasing).
void check_aliasing(const World& world, const SeaDef& def) {
    const double h = world.settings().step;
    for (std::size_t i = 0; i < def.waves.size(); ++i) {
        const WaveDef& w = def.waves[i];
        const bool regular = w.kind == WaveKind::regular;
        const double shortest = regular ? w.period : w.period / w.highest;
        if (shortest < 2.0 * h)
            throw SeaError(entry("waves", i) + (regular ? "/period" : "/highest"),
                           "components of " + number(shortest) + " s alias with a step of " +
                               number(h) + " s; give periods of two steps or more");
    }
}

double gravity_of(const World& world) {
    const Vec3 g = world.settings().gravity;
    if (g.x() != 0.0 || g.y() != 0.0 || !(g.z() < 0.0))
        throw SeaError("gravity", "the sea needs one that points along -z");
    return -g.z();
}

}  // namespace

System* define(World& world, const SeaDef& def) {
    if (world.find_system("sea") != nullptr)
        throw DefError("sea: a world has one; there is a system 'sea' already");
    const double gravity = gravity_of(world);
    marine::check_sea(def, gravity);
    check_aliasing(world, def);
    for (std::size_t i = 0; i < def.bodies.size(); ++i)
        check_water_body(world, def.bodies[i], entry("bodies", i));
    for (std::size_t i = 0; i < def.hulls.size(); ++i)
        check_water_hull(world, def.hulls[i], entry("hulls", i));
    for (std::size_t i = 0; i < def.rods.size(); ++i)
        check_water_rod(world, def.rods[i], entry("rods", i));
    marine::SeaSystem::Start start;
    start.step = world.settings().step;
    for (const WaterHull& hull : def.hulls) {
        start.heading.push_back(marine::heading_of(world.pose(hull.body).orientation));
        start.weight.push_back(world.body_def(hull.body).mass * gravity);
    }
    SeaDef own = def;
    marine::set_design_draughts(world, own, Sea(def, gravity).tide(world.time()));
    return &world.add_system(std::make_unique<marine::SeaSystem>(
        own, gravity, marine::line_table(world, def), std::move(start)));
}

const SeaDef* find_sea(const World& world) noexcept {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    return sea == nullptr ? nullptr : &sea->def();
}

double still_water(const World& world) noexcept {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    return sea == nullptr ? std::numeric_limits<double>::quiet_NaN()
                          : sea->still_water(world.time());
}

std::vector<LoadView> sea_loads(const World& world) {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    return sea == nullptr ? std::vector<LoadView>() : sea->loads();
}

SeaAccuracy sea_accuracy(const World& world) {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    return sea == nullptr ? SeaAccuracy{} : sea->accuracy();
}

HullMemory hull_memory(const World& world, std::size_t i) {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    if (sea == nullptr) throw DefError("hull_memory: the world has no sea");
    return sea->memory(i);
}

}  // namespace hawser
