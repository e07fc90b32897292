// SPDX-License-Identifier: Apache-2.0
/// Make the rows and the system of an anchor from its definition.
#include <hawser/sea.h>
#include <hawser/world.h>

#include "base/number.h"
#include "vessel/anchor_system.h"

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {
namespace {

[[noreturn]] void throw_anchor_error(const AnchorDef& def, const char* field,
                                     const std::string& why) {
    throw DefError("anchor '" + def.name + "': " + field + ": " + why);
}

void check_anchor_number(const AnchorDef& def, const char* field, double value, double least,
                         bool above, double most) {
    if (value <= most && (above ? value > least : value >= least)) return;
    throw_anchor_error(def, field,
                       number(value) + "; give a number " + (above ? "above " : "from ") +
                           number(least) + " up to " + number(most));
}

void check_anchor_body(World& world, const AnchorDef& def) {
    if (def.name.empty()) throw DefError("anchor: name: it needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_anchor_error(def, "name", "the name is in use; names must be unique");
    if (!world.alive(def.body)) throw_anchor_error(def, "body", "there is no such body; give one");
    const BodyKind kind = world.body_def(def.body).kind;
    if (kind != BodyKind::rigid)
        throw_anchor_error(def, "body",
                           "it is no rigid body; give one, with the line at its shackle");
    if (def.wire.valid()) {
        const auto nodes =
            world.alive(def.wire) ? world.wires().nodes(def.wire) : std::span<const BodyId>();
        if (nodes.empty() || (nodes.front() != def.body && nodes.back() != def.body))
            throw_anchor_error(def, "wire",
                               "no end of it is on the body '" + world.body_def(def.body).name +
                                   "'; give the line of this anchor");
    }
    if (!def.point.allFinite() || def.point.norm() > 1e4)
        throw_anchor_error(def, "point", "give a point within 10 km");
    for (const AnchorView& other : anchors_of(world))
        if (other.def.body == def.body)
            throw_anchor_error(def, "body",
                               "the anchor '" + other.def.name + "' has this body; one each");
    for (const char* part : {"/x", "/y", "/z", "/rx", "/ry", "/rz"})
        if (world.find_interaction(def.name + part).valid())
            throw_anchor_error(def, "name",
                               "the interaction '" + def.name + part + "' exists already");
}

/// Return the weight of the body minus that of the water displaced according to the sea [N].
double submerged_weight(const World& world, const AnchorDef& def) {
    const double g = world.settings().gravity.norm();
    double mass = world.body_def(def.body).gravity ? world.body_def(def.body).mass : 0.0;
    if (const SeaDef* sea = find_sea(world); sea != nullptr) {
        for (const WaterBody& wet : sea->bodies)
            if (wet.body == def.body) mass -= sea->density * wet.volume;
        for (const WaterHull& hull : sea->hulls)
            if (hull.body == def.body && !hull.mesh.triangles.empty())
                mass -= sea->density * hull_statics(hull.mesh, Pose{}, 1e6).volume;
    }
    return std::max(mass, 0.0) * g;
}

double seabed_height(const World& world, const AnchorDef& def) {
    const SeaDef* sea = find_sea(world);
    return sea != nullptr ? -sea->depth : world.world_point(def.body, def.point).z();
}

void check_anchor_clay(const AnchorDef& def) {
    const AnchorClay& c = def.clay;
    check_anchor_number(def, "clay/strength", c.strength, 0.0, false, 1e9);
    check_anchor_number(def, "clay/gradient", c.gradient, 0.0, false, 1e9);
    check_anchor_number(def, "clay/chain_width", c.chain_width, 0.0, false, 10.0);
    check_anchor_number(def, "clay/chain_bearing", c.chain_bearing, 0.0, true, 1e3);
    check_anchor_number(def, "clay/chain_friction", c.chain_friction, 0.0, false, 2.0);
    const bool any = c.strength + c.gradient > 0.0;
    if (c.chain_friction > 0.0 && !any)
        throw_anchor_error(
            def, "clay/strength",
            "the friction of the line needs a strength of the soil; give \"strength\" or "
            "\"gradient\"");
    if (def.law != AnchorLaw::trajectory) return;
    check_anchor_number(def, "clay/fluke_area", c.fluke_area, 0.0, true, 1e4);
    check_anchor_number(def, "clay/bearing", c.bearing, 0.0, true, 100.0);
    check_anchor_number(def, "clay/fluke_angle", c.fluke_angle, 0.0, true, 1.4);
    check_anchor_number(def, "clay/first_depth", c.first_depth, 0.0, true, 1e3);
    if (!any)
        throw_anchor_error(def, "clay/strength",
                           "the trajectory needs a strength of the soil; give "
                           "\"strength\" or \"gradient\"");
}

/// Fill in the defaults. @throws DefError
void complete_anchor(const World& world, AnchorDef& def) {
    if (def.soil == AnchorSoil::none)
        throw_anchor_error(def, "soil",
                           "an anchor needs a soil; give soft_clay, medium_clay or sand");
    const auto fill = [](double& value, double fallback) {
        if (std::isnan(value)) value = fallback;
    };
    fill(def.mass, world.body_def(def.body).mass);
    check_anchor_number(def, "mass", def.mass, 0.0, true, 1e9);
    const bool diver = def.law == AnchorLaw::trajectory;
    if (def.type != AnchorType::given && std::isnan(def.uhc) && !diver) {
        def.uhc = anchor_uhc(def.type, def.soil, def.mass);
        const auto i = static_cast<std::size_t>(def.type);
        if (std::isnan(def.uhc))
            throw_anchor_error(def, "soil",
                               std::string("no capacity of ") + anchor_types()[i] + " in " +
                                   anchor_soils()[static_cast<std::size_t>(def.soil)] +
                                   " is published; give \"uhc\" or another soil");
    }
    if (std::isnan(def.uhc) && !diver)
        throw_anchor_error(def, "uhc", "an anchor needs its capacity; give \"uhc\" or \"type\"");
    if (!std::isnan(def.uhc)) check_anchor_number(def, "uhc", def.uhc, 0.0, true, 1e12);
    const bool sand = def.soil == AnchorSoil::sand;
    constexpr double kFlukeDensity = 120.0, kClayLengths = 20.0, kSandLengths = 4.0;
    fill(def.fluke_length, std::cbrt(def.mass / kFlukeDensity));
    check_anchor_number(def, "fluke_length", def.fluke_length, 0.0, true, 100.0);
    fill(def.drag_length, (sand ? kSandLengths : kClayLengths) * def.fluke_length);
    check_anchor_number(def, "drag_length", def.drag_length, 0.0, true, 1e5);
    fill(def.breakout, sand ? 0.17 : 0.75);
    check_anchor_number(def, "breakout", def.breakout, 0.0, true, 10.0);
    check_anchor_number(def, "first", def.first, 0.0, false, 1.0);
    check_anchor_number(def, "friction", def.friction, 0.0, false, 10.0);
    fill(def.weight, submerged_weight(world, def));
    check_anchor_number(def, "weight", def.weight, 0.0, false, 1e12);
    fill(def.seabed, seabed_height(world, def));
    check_anchor_number(def, "seabed", def.seabed, -2e4, false, 2e4);
    fill(def.set_after, 0.5 * def.fluke_length);
    check_anchor_number(def, "set_after", def.set_after, 0.0, false, 1e4);
    check_anchor_number(def, "touch", def.touch, 0.0, false, 100.0);
    check_anchor_number(def, "full_depth", def.full_depth, 0.0, false, 1e3);
    check_anchor_number(def, "drag", def.drag, 0.0, false, 1e5);
    if (def.drag > 0.0 && !def.set)
        throw_anchor_error(def, "drag",
                           number(def.drag) +
                               " m, but the anchor is free at the start; give "
                               "\"set\": true, or no drag");
    check_anchor_clay(def);
}

/// Return a rotation of the z axis to axis i.
Quat to_axis(int i) {
    Vec3 axis = Vec3::Zero();
    axis[i] = 1.0;
    return turn_between(Vec3::UnitZ(), axis);
}

/// Add one row between the soil and the anchor, with the input of its bound.
InteractionId add_soil_row(World& world, const AnchorDef& def, BodyId soil, int axis,
                           bool rotational, double first, InputId& bound) {
    constexpr const char* kNames[] = {"/x", "/y", "/z", "/rx", "/ry", "/rz"};
    const char* param = rotational ? "torque" : "force";
    InteractionDef row;
    row.name = def.name + kNames[axis + (rotational ? 3 : 0)];
    row.kind = rotational ? InteractionKind::HingeFriction : InteractionKind::SlideFriction;
    row.body = {soil, def.body};
    row.point[1] = def.point;
    row.frame[0] = to_axis(axis);
    row.frame[1] = (world.pose(def.body).orientation.conjugate() * row.frame[0]).normalized();
    row.set(param, first);
    const InteractionId id = world.add_interaction(row);
    bound = world.add_input(
        {.name = row.name + "/" + param, .interaction = id, .param = param, .min = 0.0});
    return id;
}

bool has_shapes(const World& world, BodyId body) {
    for (const ShapeId id : world.shapes())
        if (world.shape_def(id).body == body) return true;
    return false;
}

/// Call f(system) for each anchor. A const world has no list of systems, so they are found by the
/// names of their signals.
template <class F>
void over_anchors(const World& world, F&& f) {
    std::string_view last;
    for (const SystemSignal& s : world.system_signals()) {
        if (s.system == last) continue;
        last = s.system;
        if (const auto* found = dynamic_cast<const vessel::AnchorSystem*>(world.find_system(last)))
            f(*found);
    }
}

}  // namespace

std::vector<AnchorView> anchors_of(const World& world) {
    std::vector<AnchorView> out;
    over_anchors(world, [&](const vessel::AnchorSystem& one) { out.push_back(one.view()); });
    return out;
}

System* define(World& world, const AnchorDef& given) {
    check_anchor_body(world, given);
    AnchorDef def = given;
    complete_anchor(world, def);
    const Nonsmooth method = world.settings().nonsmooth;
    if (method == Nonsmooth::pgs || method == Nonsmooth::split)
        throw_anchor_error(def, "name",
                           "nonsmooth = pgs and split keep no bounds exactly; choose newton");
    vessel::AnchorRows rows;
    rows.mass = world.body_def(def.body).mass;
    rows.carried = has_shapes(world, def.body);
    const double above = world.world_point(def.body, def.point).z() - def.seabed;
    rows.grounded = def.set || above <= def.touch;
    const vessel::AnchorBounds first = vessel::first_bounds(def, rows.carried, rows.grounded);
    const BodyId soil = world.add_body({.name = def.name + "/soil",
                                        .kind = BodyKind::fixed,
                                        .position = world.world_point(def.body, def.point)});
    try {
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            rows.slide[k] = add_soil_row(world, def, soil, i, false, i < 2 ? first.level : first.up,
                                         rows.slide_bound[k]);
            rows.turn[k] = add_soil_row(world, def, soil, i, true, first.turn, rows.turn_bound[k]);
        }
        return &world.add_system(std::make_unique<vessel::AnchorSystem>(def, rows));
    } catch (...) {
        (void)world.remove_body(soil);
        throw;
    }
}

}  // namespace hawser
