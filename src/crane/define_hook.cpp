// SPDX-License-Identifier: Apache-2.0
#include <hawser/hook.h>
#include <hawser/world.h>

#include "crane/common.h"
#include "crane/hook_system.h"

#include <memory>
#include <string>
#include <vector>

namespace hawser {
namespace {

[[noreturn]] void throw_def_error(const HookDef& def, const std::string& why) {
    throw DefError("hook '" + def.name + "': " + why);
}

void check_bodies(World& world, const HookDef& def) {
    if (!world.alive(def.body)) throw_def_error(def, "the body of the hook is missing; give one");
    const BodyKind own = world.body_def(def.body).kind;
    if (own == BodyKind::scalar)
        throw_def_error(def, "a scalar body has no position from which a load could hang");
    if (!def.point.allFinite() || !(def.point.norm() <= 1e7))
        throw_def_error(def, "point is not finite, or beyond 1e7 m");
    if (own == BodyKind::lump && !def.point.isZero(0.0))
        throw_def_error(def, "a lump is a point: leave out `point`");
    for (std::size_t i = 0; i < def.loads.size(); ++i)
        if (def.loads[i].body == def.body)
            throw_def_error(def,
                            "loads/" + std::to_string(i) + "/body: a hook cannot attach itself");
    crane::check_load_bodies(world, {"hook", def.name, def.loads, def.take});
}

void check(World& world, const HookDef& def) {
    if (def.name.empty()) throw DefError("a hook needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique");
    if (def.loads.empty())
        throw_def_error(def, "it has no loads; name the loads that it can attach in `loads`");
    crane::check_loads({"hook", def.name, def.loads, def.take});
    check_bodies(world, def);
    for (const double force : {def.strength, def.latch})
        if (!(force > 0.0 && force <= 1e30))
            throw_def_error(def,
                            "strength and latch are forces above 0 [N]; leave them out for none");
    if (def.latch < HookDef{}.latch && def.latch > def.strength)
        throw_def_error(def, "latch = " + number(def.latch) +
                                 " N is above strength = " + number(def.strength) +
                                 " N, at which the hook opens by itself; give a latch below it");
    for (std::size_t i = 0; i < crane::kMaxEyes; ++i)
        if (world.find_interaction(crane::leg_name(def.name, i)).valid())
            throw_def_error(def, "the interaction '" + crane::leg_name(def.name, i) +
                                     "' is there; one of its legs would be called so");
    for (std::size_t i = 0; i < crane::kMaxEyes; ++i)
        if (world.find_shape(crane::leg_name(def.name, i)).valid())
            throw_def_error(def, "the shape '" + crane::leg_name(def.name, i) +
                                     "' exists; the hook needs this name for a leg; rename it");
}

}  // namespace

void define(World& world, const HookDef& def) {
    check(world, def);
    std::vector<InteractionId> legs;
    std::vector<ShapeId> shapes;
    try {
        if (def.take > 0) {
            const CraneLoad& load = def.loads[static_cast<std::size_t>(def.take - 1)];
            const Vec3 point = world.world_point(def.body, def.point);
            for (std::size_t i = 0; i < load.eyes.size(); ++i) {
                const double way = (world.world_point(load.body, load.eyes[i]) - point).norm();
                if (way > load.sling_length + load.reach)
                    throw_def_error(def, "take: an eye of the load is " + number(way) +
                                             " m from the hook's point, and its sling reaches " +
                                             number(load.sling_length + load.reach) +
                                             " m; attach it later, or move the hook nearer");
                legs.push_back(world.add_interaction(crane::sling_of(
                    load, i, crane::leg_name(def.name, i), def.body, def.point, way)));
                if (const auto shape = crane::leg_shape_of(world, def.body, load.body, load.eyes[i],
                                                           crane::leg_name(def.name, i)))
                    shapes.push_back(world.add_shape(*shape));
            }
        }
        world.add_system(std::make_unique<crane::HookSystem>(def));
    } catch (...) {
        for (const ShapeId shape : shapes) (void)world.remove_shape(shape);
        for (const InteractionId leg : legs) (void)world.remove_interaction(leg);
        throw;
    }
}

}  // namespace hawser
