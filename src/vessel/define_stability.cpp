// SPDX-License-Identifier: Apache-2.0
/// Make the curve and the system of a stability gauge from its definition.
#include <hawser/sea.h>
#include <hawser/world.h>

#include "base/number.h"
#include "vessel/stability_system.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace hawser {
namespace {

[[noreturn]] void throw_gauge_error(const StabilityDef& def, const char* field,
                                    const std::string& why) {
    throw DefError("stability '" + def.name + "': " + field + ": " + why);
}

void check_gauge_number(const StabilityDef& def, const char* field, double value, double least,
                        bool above, double most) {
    if (value <= most && (above ? value > least : value >= least)) return;
    throw_gauge_error(def, field,
                      number(value) + "; give a number " + (above ? "above " : "from ") +
                          number(least) + " up to " + number(most));
}

const WaterHull* hull_of_ship(const World& world, BodyId body) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr) return nullptr;
    for (const WaterHull& hull : sea->hulls)
        if (hull.body == body && !hull.mesh.triangles.empty()) return &hull;
    return nullptr;
}

void check_gauge_parts(World& world, const StabilityDef& def) {
    if (def.name.empty()) throw DefError("stability: name: it needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_gauge_error(def, "name", "the name is in use; names must be unique");
    if (!world.alive(def.body) || world.body_def(def.body).kind != BodyKind::rigid)
        throw_gauge_error(def, "body", "there is no such rigid body; give the ship");
    if (!world.alive(def.wire))
        throw_gauge_error(def, "wire", "there is no such wire; give the towline");
    const auto nodes = world.wires().nodes(def.wire);
    if (nodes.front() != def.body && nodes.back() != def.body)
        throw_gauge_error(def, "wire",
                          "no end of it is on the body '" + world.body_def(def.body).name +
                              "'; give the towline of this ship");
    for (const WireId other : def.others)
        if (!world.alive(other) || other == def.wire)
            throw_gauge_error(def, "others", "give wires that exist, other than the towline");
    if (!def.pin.allFinite() || def.pin.norm() > 1e4)
        throw_gauge_error(def, "pin", "give a point within 10 km");
}

void check_gauge_numbers(const StabilityDef& def) {
    check_gauge_number(def, "bollard_pull", def.bollard_pull, 0.0, false, 1e12);
    check_gauge_number(def, "most_heel", def.most_heel, 0.0, true, 1.5707963267948966);
    check_gauge_number(def, "residual_area", def.residual_area, 0.0, false, 1e3);
    check_gauge_number(def, "residual_lever", def.residual_lever, 0.0, false, 1e3);
    check_gauge_number(def, "gravity", def.gravity, 0.0, true, 1e3);
    check_gauge_number(def, "warn", def.warn, 0.0, true, 1.0);
    check_gauge_number(def, "hysteresis", def.hysteresis, 0.0, false, 0.5);
    for (const auto& [field, angle] :
         {std::pair<const char*, double>{"deck_edge", def.deck_edge}, {"flooding", def.flooding}})
        if (!std::isnan(angle))
            check_gauge_number(def, field, angle, 0.0, true, 1.5707963267948966);
}

/// Fill in the defaults from the mesh. @throws DefError
void complete_gauge(const World& world, StabilityDef& def, const WaterHull* hull, double density) {
    if (std::isnan(def.mass)) def.mass = world.body_def(def.body).mass;
    check_gauge_number(def, "mass", def.mass, 0.0, true, 1e15);
    if (std::isnan(def.stern_x)) def.stern_x = def.stern.allFinite() ? def.stern.x() : def.pin.x();
    check_gauge_number(def, "stern_x", def.stern_x, -1e4, false, 1e4);
    if (hull == nullptr) {
        if (std::isnan(def.gm))
            throw_gauge_error(
                def, "gm",
                "the body has no hull with a mesh in the sea; add one to \"hulls\" of the "
                "sea, or give \"gm\"");
        check_gauge_number(def, "gm", def.gm, 0.0, true, 1e3);
        if (std::isnan(def.thrust_height))
            throw_gauge_error(def, "thrust_height", "a ship without a mesh needs it");
        return;
    }
    const Flotation afloat = float_hull(hull->mesh, def.mass, density);
    if (!afloat.floats)
        throw_gauge_error(def, "mass", number(def.mass) + " kg: the hull does not float with it");
    const double keel = afloat.statics.lowest - afloat.pose.position.z();
    if (std::isnan(def.gm)) def.gm = afloat.gm;
    if (std::isnan(def.thrust_height)) def.thrust_height = keel + 0.5 * afloat.draught;
    double bow = -1e300, stern = 1e300;
    for (const Vec3& v : hull->mesh.vertices) {
        bow = std::max(bow, v.x());
        stern = std::min(stern, v.x());
    }
    if (std::isnan(def.freeboard)) def.freeboard = 0.005 * (bow - stern);
    check_gauge_number(def, "freeboard", def.freeboard, 0.0, false, 100.0);
}

const vessel::StabilityCurve& stability_curve(const World& world, std::string_view name) {
    const auto* gauge = dynamic_cast<const vessel::StabilitySystem*>(world.find_system(name));
    if (gauge == nullptr)
        throw DefError("stability: there is no gauge '" + std::string(name) + "'");
    return gauge->curve();
}

}  // namespace

StabilityCheck check_stability(const World& world, std::string_view name, double force,
                               double alpha, double beta) {
    return stability_curve(world, name).check(force, alpha, beta);
}

double permissible_tension(const World& world, std::string_view name, double alpha, double beta) {
    return stability_curve(world, name).permissible_tension_at(alpha, beta, 50);
}

std::vector<std::array<double, 2>> gz_curve(const World& world, std::string_view name) {
    const vessel::StabilityCurve& curve = stability_curve(world, name);
    std::vector<std::array<double, 2>> out;
    for (int k = 0; k <= 90; ++k) {
        const double heel = 0.017453292519943295 * k;
        out.push_back({heel, curve.lever(heel, 0.0)});
    }
    return out;
}

System* define(World& world, const StabilityDef& given) {
    check_gauge_parts(world, given);
    check_gauge_numbers(given);
    StabilityDef def = given;
    const SeaDef* sea = find_sea(world);
    const double density = sea != nullptr ? sea->density : 1025.0;
    const WaterHull* hull = hull_of_ship(world, def.body);
    complete_gauge(world, def, hull, density);
    static const HullMesh kNoMesh{};
    auto curve = std::make_shared<const vessel::StabilityCurve>(
        def, hull != nullptr ? hull->mesh : kNoMesh, density);
    return &world.add_system(std::make_unique<vessel::StabilitySystem>(std::move(curve)));
}

}  // namespace hawser
