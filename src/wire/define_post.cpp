// SPDX-License-Identifier: Apache-2.0
#include <hawser/guide.h>
#include <hawser/post.h>
#include <hawser/world.h>

#include "base/number.h"
#include "wire/lay_on.h"
#include "wire/post_system.h"

#include <exception>
#include <memory>
#include <new>
#include <string>

namespace hawser {
namespace {

[[noreturn]] void throw_def_error(const PostDef& def, const std::string& why) {
    throw DefError("post '" + def.name + "': " + why);
}

void check(World& world, const PostDef& def) {
    if (def.name.empty()) throw DefError("a post needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique");
    if (!world.alive(def.shape))
        throw_def_error(def, "the shape for the wires is missing; give one");
    const ShapeDef& shape = world.shape_def(def.shape);
    if (shape.kind != ShapeKind::cylinder && shape.kind != ShapeKind::capsule)
        throw_def_error(def, "its shape is neither a cylinder nor a capsule");
    if (shape.body_b.valid() || world.body_def(shape.body).kind == BodyKind::lump)
        throw_def_error(def, "its shape belongs to a wire or a point mass; give a shape of a body");
    const Nonsmooth method = world.settings().nonsmooth;
    if (method == Nonsmooth::pgs || method == Nonsmooth::split)
        throw_def_error(def,
                        "nonsmooth = pgs and split do not support loads of systems; choose newton");
    if (!(def.friction >= 0.0 && def.friction <= 100.0))
        throw_def_error(def, "friction = " + number(def.friction) + "; give 0 to 100");
    if (!(def.efficiency > 0.0 && def.efficiency <= 1.0))
        throw_def_error(
            def, "efficiency = " + number(def.efficiency) + "; give a number above 0 up to 1");
    if (!(def.inertia >= 0.0 && def.inertia <= 1e12))
        throw_def_error(def, "inertia = " + number(def.inertia) + " kg m^2; give 0 or more");
    if (def.wires < 1 || def.wires > 16)
        throw_def_error(def, "wires = " + std::to_string(def.wires) + "; give 1 to 16");
    if (def.element_length == def.element_length &&
        !(def.element_length >= 0.0 && def.element_length <= 1e6))
        throw_def_error(def, "element_length = " + number(def.element_length) +
                                 " m; give 0 to 1e6 (0: no node runs through)");
}

}  // namespace

void define(World& world, const PostDef& def) { wire::add_post(world, def, {}); }

void wire::add_post(World& world, const PostDef& def, BodyId carrier) {
    check(world, def);
    const ShapeDef& shape = world.shape_def(def.shape);
    wire::PostPosition place{shape.body, shape.position, shape.orientation * Vec3::UnitZ(),
                             shape.radius, shape.half_length};
    place.carrier = carrier.valid() ? carrier : shape.body;
    place.carried_axis = place.axis;
    if (carrier.valid())
        place.carried_axis = world.pose(carrier).orientation.conjugate() *
                             (world.pose(shape.body).orientation * place.axis);
    world.add_system(std::make_unique<wire::PostSystem>(def, place));
}

bool NodeEdits::lay_over(GuideDef& def, double speed, Guide& out, double (&material)[2]) noexcept {
    if (!hands_.begin()) return false;
    try {
        std::array<double, 2> both{};
        out = wire::add_guide_parts(world_, def, speed, both);
        (void)wire::add_stop(world_, def, out);
        material[0] = both[0];
        material[1] = both[1];
        return true;
    } catch (const std::bad_alloc&) {
        hands_.out_of_memory();
        return false;
    } catch (const std::exception&) {
        return false;
    }
}

InteractionId NodeEdits::lift_off(const Guide& guide, const InteractionDef& element) noexcept {
    if (!hands_.begin()) return {};
    try {
        return world_.wires().disengage(guide.before, guide.behind, element);
    } catch (const std::bad_alloc&) {
        hands_.out_of_memory();
        return {};
    } catch (const std::exception&) {
        return {};
    }
}

bool NodeEdits::move_along(const Guide& guide, double along, double fed) noexcept {
    if (!hands_.begin()) return false;
    try {
        return world_.wires().move_along(guide.before, guide.behind, along, fed);
    } catch (const std::bad_alloc&) {
        hands_.out_of_memory();
        return false;
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace hawser
