// SPDX-License-Identifier: Apache-2.0
/// Drum, element, motor, brake and system from the definition of a winch.
#include <hawser/lines.h>
#include <hawser/winch.h>
#include <hawser/world.h>

#include "wire/define_gypsy.h"
#include "wire/drum_geometry.h"
#include "wire/winch_checks.h"
#include "wire/winch_system.h"

#include <cmath>
#include <memory>
#include <span>
#include <string>

namespace hawser {
namespace {

using wire::check_number;
using wire::is_gypsy;
using wire::throw_def_error;

void check_numbers(const WinchDef& def) {
    struct Row {
        const char* what;
        double value;
        bool above;
    };
    for (const Row& row :
         {Row{"stored", def.stored, true}, Row{"inertia", def.inertia, true},
          Row{"power", def.power, true}, Row{"max_speed", def.max_speed, true},
          Row{"mass_per_length", def.mass_per_length, false},
          Row{"motor_inertia", def.motor_inertia, false},
          Row{"torque_haul", def.torque_haul, false}, Row{"torque_pay", def.torque_pay, false},
          Row{"tension", def.tension, false}, Row{"deadband", def.deadband, false},
          Row{"brake_static", def.brake_static, false},
          Row{"band_friction", def.band_friction, false}, Row{"band_angle", def.band_angle, false},
          Row{"release_delay", def.release_delay, false},
          Row{"release_load", def.release_load, false}, Row{"dead_wraps", def.dead_wraps, false},
          Row{"wrap_friction", def.wrap_friction, false}, Row{"weak_link", def.weak_link, false}})
        check_number(def, row.what, row.value, 0.0, row.above);
    if (!(std::abs(def.speed) <= 100.0))
        throw_def_error(def, "speed = " + number(def.speed) + " m/s; give -100 to 100");
    if (static_cast<int>(def.mode) > 6) throw_def_error(def, "there is no such mode");
    wire::check_aids(def);
    if (std::isnan(def.brake_dynamic)) return;
    check_number(def, "brake_dynamic", def.brake_dynamic, 0.0, false);
    if (def.brake_dynamic > def.brake_static)
        throw_def_error(def,
                        "brake_dynamic is above brake_static: a slipping band cannot hold more");
}

/// Return the geometry of the drum.
/// @throws DefError if its capacity is less than the stored length.
wire::DrumGeometry drum_geometry(const WinchDef& def) {
    constexpr double kMinimum = 2.5;  // radius over diameter of the wire
    check_number(def, "core_radius", def.core_radius, 0.0, true);
    check_number(def, "width", def.width, 0.0, true);
    check_number(def, "wire_diameter", def.wire_diameter, 0.0, true);
    wire::DrumGeometry drum{.core_radius = def.core_radius,
                            .width = def.width,
                            .wire_diameter = def.wire_diameter,
                            .layer_pitch = def.layer_pitch,
                            .flange_radius = def.flange_radius};
    if (def.core_radius < kMinimum * def.wire_diameter)
        throw_def_error(
            def, "core_radius = " + number(def.core_radius) + " m is below " + number(kMinimum) +
                     " diameters of its wire, too small to wind it; give a larger drum");
    if (std::isnan(drum.layer_pitch)) drum.layer_pitch = def.wire_diameter;
    check_number(def, "layer_pitch", drum.layer_pitch, 0.0, true);
    if (drum.wraps_a_layer() < 1)
        throw_def_error(def, "width = " + number(def.width) +
                                 " m: no wrap of its wire fits between the "
                                 "flanges");
    if (std::isnan(def.flange_radius)) {
        constexpr int kMaxLayer = 1000;
        const int layer = drum.wire_end(def.stored).layer;
        if (layer > kMaxLayer)
            throw_def_error(def, "stored = " + number(def.stored) + " m: it takes " +
                                     std::to_string(layer) + " layers");
        drum.flange_radius = drum.radius(layer) + 0.5 * drum.wire_diameter;
    }
    if (drum.layers() < 1)
        throw_def_error(
            def, "flange_radius = " + number(def.flange_radius) + " m: no layer fits below it");
    // Drums usually keep the default number. A short wire may have less.
    const WinchDef usual;
    if (const double wraps = drum.wire_end(def.stored).wraps;
        def.dead_wraps > usual.dead_wraps && def.dead_wraps > wraps)
        throw_def_error(def, "dead_wraps = " + number(def.dead_wraps) + ", but stored = " +
                                 number(def.stored) + " m are " + number(wraps) +
                                 " wraps: the motor could not pay out any wire; give fewer");
    if (def.stored > drum.capacity())
        throw_def_error(def, "stored = " + number(def.stored) + " m, but the drum holds " +
                                 number(drum.capacity()) + " m in " +
                                 std::to_string(drum.layers()) + " layers");
    return drum;
}

/// Check that an existing scalar body has the inertia of the winch.
/// @throws DefError
void check_scalar(const World& world, const WinchDef& def, BodyId body, const char* what,
                  double inertia) {
    if (!world.alive(body) || world.body_def(body).kind != BodyKind::scalar)
        throw_def_error(def, std::string("its ") + what + " must be a scalar body");
    const double mass = world.body_def(body).mass;
    if (mass != inertia)
        throw_def_error(def, "inertia = " + number(inertia) + " kg m^2, but its " + what +
                                 "'s mass is " + number(mass) + "; give the same");
}

/// Return the element by which an existing drum pays out the wire's end.
/// @throws DefError
InteractionId wound_end(const World& world, const WinchDef& def) {
    check_scalar(world, def, def.drum, "drum", drum_mass(def));
    if (is_gypsy(def)) check_scalar(world, def, def.chain, "chain", gypsy_chain_inertia(def));
    const auto elements = world.wires().elements(def.wire);
    const InteractionId id = def.end == 0 ? elements.front() : elements.back();
    if (!world.alive(id) || !kind_info(world.interaction_def(id).kind).is(kWoundUp) ||
        world.interaction_def(id).body[2] != (is_gypsy(def) ? def.chain : def.drum))
        throw_def_error(
            def, "this end of its wire is not on its drum; leave out the drum to create both");
    return id;
}

/// Return the length of the elements that the winch inserts [m]; 0: it inserts no nodes. @throws
/// DefError
double feed_element_length(const World& world, const WinchDef& def) {
    const auto elements = world.wires().elements(def.wire);
    const InteractionId at_drum = def.end == 0 ? elements.front() : elements.back();
    double mass = 0.0;  // of an element with own mass
    for (const InteractionId id : elements)
        if (world.alive(id) && !kind_info(world.interaction_def(id).kind).is(kWoundUp))
            mass = std::max(mass, world.interaction_def(id).get("mass"));
    const bool has_element_length = !std::isnan(def.element);
    if (has_element_length && def.element == 0.0) return 0.0;
    if (has_element_length) check_number(def, "element", def.element, 0.0, true);
    if (has_element_length && def.element < def.wire_diameter)
        throw_def_error(
            def, "element = " + number(def.element) + " m is shorter than its wire is thick, " +
                     number(def.wire_diameter) +
                     " m, and would create one node for each; give the length of an element, or "
                     "0 for an element that grows");
    const bool wound = kind_info(world.interaction_def(at_drum).kind).is(kWoundUp);
    const bool single = wound && elements.size() == 1;  // the drum's element is the whole wire
    if ((!(mass > 0.0) && !(has_element_length && single)) || !(def.mass_per_length > 0.0)) {
        if (!has_element_length) return 0.0;
        throw_def_error(
            def,
            mass > 0.0 || single
                ? "element: new nodes need the mass_per_length of its wire; give it"
                : "element: the elements of its wire have no mass for new nodes (consistent_mass)");
    }
    if (elements.size() == 1 && def.end == 1)
        throw_def_error(
            def,
            "a wire of one element is wound up from its first end; name its ends the other "
            "way round, or give it two elements");
    return has_element_length ? def.element : world.interaction_def(at_drum).get("length");
}

/// An input that the system drives: its field, the interaction, its parameter and its name.
struct DrivenInput {
    InputId wire::WinchInputs::* input;
    InteractionId WinchIds::* of;
    const char* param;
    const char* name;
};
constexpr DrivenInput kDrivenInputs[] = {
    {&wire::WinchInputs::speed, &WinchIds::motor, "speed", "/motor/speed"},
    {&wire::WinchInputs::low, &WinchIds::motor, "force_min", "/motor/force_min"},
    {&wire::WinchInputs::high, &WinchIds::motor, "force_max", "/motor/force_max"},
    {&wire::WinchInputs::hold, &WinchIds::brake, "force", "/friction/force"},
    {&wire::WinchInputs::back, &WinchIds::brake, "back", "/friction/back"},
    {&wire::WinchInputs::radius, &WinchIds::line, "radius", "/radius"},
    {&wire::WinchInputs::length, &WinchIds::line, "length", "/length"},
    {&wire::WinchInputs::drum_zero, &WinchIds::line, "drum_zero", "/drum_zero"}};

/// Further inputs of a gypsy.
constexpr DrivenInput kDrivenOfGypsies[] = {
    {&wire::WinchInputs::grip_speed, &WinchIds::grip, "speed", "/grip/speed"},
    {&wire::WinchInputs::grip_low, &WinchIds::grip, "force_min", "/grip/force_min"},
    {&wire::WinchInputs::grip_high, &WinchIds::grip, "force_max", "/grip/force_max"},
    {&wire::WinchInputs::end, &WinchIds::bitter_end, "force", "/bitter_end/force"}};

std::span<const DrivenInput> of_gypsy(const WinchDef& def) {
    return is_gypsy(def) ? std::span<const DrivenInput>(kDrivenOfGypsies)
                         : std::span<const DrivenInput>();
}

wire::WinchInputs add_inputs(World& world, const WinchDef& def, const WinchIds& ids) {
    wire::WinchInputs in;
    const auto add = [&](const DrivenInput& d) {
        in.*d.input = world.add_input(
            {.name = def.name + d.name, .interaction = ids.*d.of, .param = d.param});
    };
    for (const DrivenInput& d : kDrivenInputs) add(d);
    for (const DrivenInput& d : of_gypsy(def)) add(d);
    return in;
}

void check_names(const World& world, const WinchDef& def) {
    const auto check = [&](const DrivenInput& d) {
        if (world.find_input(def.name + d.name).valid())
            throw_def_error(def,
                            "there is an input '" + def.name + d.name + "' already; rename one");
    };
    for (const DrivenInput& d : kDrivenInputs) check(d);
    for (const DrivenInput& d : of_gypsy(def)) check(d);
}

/// Add the drum, and the chain of a gypsy.
/// @throws DefError
void add_wheel(World& world, const WinchDef& def, WinchIds& ids) {
    ids.drum = world.add_body({.name = def.name + "/drum",
                               .kind = BodyKind::scalar,
                               .mass = drum_mass(def),
                               .gravity = false});
    if (!is_gypsy(def)) return;
    try {
        ids.chain = world.add_body({.name = def.name + "/chain",
                                    .kind = BodyKind::scalar,
                                    .mass = gypsy_chain_inertia(def),
                                    .gravity = false});
    } catch (...) {
        (void)world.remove_body(ids.drum);
        throw;
    }
}

}  // namespace

WinchIds define(World& world, const WinchDef& given_def) {
    WinchDef def = given_def;
    if (def.name.empty()) throw DefError("a winch needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique");
    check_numbers(def);
    wire::WinchWheel wheel;
    if (is_gypsy(def))
        wheel.gypsy = wire::complete_gypsy(def);
    else
        wheel.drum = drum_geometry(def);
    if (!world.alive(def.wire)) throw_def_error(def, "its wire is missing; give one");
    const Nonsmooth method = world.settings().nonsmooth;
    if (method == Nonsmooth::pgs || method == Nonsmooth::split)
        throw_def_error(def,
                        "nonsmooth = pgs and split do not support loads of systems; choose newton");
    check_names(world, def);
    if (def.end != 0 && def.end != 1) throw_def_error(def, "end must be 0, the first one, or 1");
    def.element = feed_element_length(world, def);
    WinchIds ids;
    const bool has_drum = def.drum.valid();
    if (has_drum) {
        ids.line = wound_end(world, def);
        ids.drum = def.drum;
        ids.chain = def.chain;
    } else {
        add_wheel(world, def, ids);
    }
    try {
        const DrumIds parts = world.add(DrumDef{.name = def.name,
                                                .drum = ids.drum,
                                                .motor = AxisMotor{.power = def.power},
                                                .friction = AxisFriction{.bound = 0.0}});
        ids.motor = parts.motor;
        ids.brake = parts.friction;
        const BodyId wound = wheel.gypsy ? ids.chain : ids.drum;
        if (wheel.gypsy) {
            wheel.gypsy->zero = world.pose(wound).position.x() - world.pose(ids.drum).position.x();
            wire::add_gypsy_parts(world, def, *wheel.gypsy, ids);
        }
        const double radius =
            wheel.gypsy ? wheel.gypsy->radius : wheel.drum.leaving_radius(def.stored);
        if (!has_drum) ids.line = world.wires().spool(def.wire, def.end, wound, radius);
        const wire::WinchInputs inputs = add_inputs(world, def, ids);
        if (has_drum) {
            world.set_input(inputs.drum_zero, world.pose(wound).position.x());
            world.set_input(inputs.radius, radius);
        }
        const double at_drum = world.interaction_def(ids.line).get("length");
        world.add_system(std::make_unique<wire::WinchSystem>(def, wheel, ids, inputs, at_drum));
    } catch (...) {
        if (!has_drum) (void)world.remove_body(ids.drum);
        if (!has_drum && ids.chain.valid()) (void)world.remove_body(ids.chain);
        throw;
    }
    return ids;
}

}  // namespace hawser
