// SPDX-License-Identifier: Apache-2.0
#include <hawser/chaser.h>
#include <hawser/world.h>

#include "base/number.h"
#include "wire/chaser_system.h"

#include <cmath>
#include <memory>
#include <string>

namespace hawser {
namespace {

[[noreturn]] void throw_def_error(const ChaserDef& def, const std::string& why) {
    throw DefError("chaser '" + def.name + "': " + why);
}

void check(World& world, const ChaserDef& def) {
    if (def.name.empty()) throw DefError("a chaser needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique");
    for (const char* part : {"/slide", "/behind", "/friction"})
        if (world.find_body(def.name + part).valid() ||
            world.find_interaction(def.name + part).valid())
            throw_def_error(
                def, "'" + def.name + part + "' exists, but is reserved for one of its parts");
    if (!world.alive(def.body)) throw_def_error(def, "the body of its ring is missing; give one");
    if (world.body_def(def.body).kind != BodyKind::rigid)
        throw_def_error(def, "its ring must be a rigid body; a fixed ring is a guide");
    if (!def.point.allFinite() || !(def.point.norm() <= 1e7))
        throw_def_error(def, "point is not finite, or beyond 1e7 m");
    if (!(def.reach > 0.0 && def.reach <= 1e3))
        throw_def_error(def,
                        "reach = " + number(def.reach) + " m; give a length above 0 up to 1000");
    if (!(def.friction >= 0.0 && def.friction <= 10.0))
        throw_def_error(def, "friction = " + number(def.friction) + "; give a number from 0 to 10");
    if (!(def.arrives >= 0.0 && def.arrives <= 1e6))
        throw_def_error(def, "arrives = " + number(def.arrives) + " m; give a length from 0 on");
    if (!std::isnan(def.element) && !(def.element > 0.0 && def.element <= 1e6))
        throw_def_error(def,
                        "element = " + number(def.element) + " m; give a length above 0, or none");
}

}  // namespace

void define(World& world, const ChaserDef& def) {
    check(world, def);
    world.add_system(std::make_unique<wire::ChaserSystem>(def));
}

}  // namespace hawser
