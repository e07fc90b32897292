// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file common.h
/// Define the common parts of knuckle-boom and lattice cranes, and errors with names.

#include <hawser/crane.h>
#include <hawser/shapes.h>

#include "base/number.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hawser::crane {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kUnbounded = 1e30;

/// Parts of a definition that both kinds have. The definition must outlive this struct.
struct Common {
    const std::string& name;
    const CraneMount& mount;
    const CraneSlew& slew;
    const CraneColumn& column;
    const Vec3& boom_foot;
    const CraneLink& boom;
    double boom_angle;
    const CraneTackle& hoist;
    const CraneHook& hook;
    const CraneRating& rating;
    const std::vector<CraneLoad>& loads;
    int take;
    double ramp;
};

template <class Def>
[[nodiscard]] Common common_fields(const Def& d) {
    return {d.name,  d.mount, d.slew,   d.column, d.boom_foot, d.boom, d.boom_angle,
            d.hoist, d.hook,  d.rating, d.loads,  d.take,      d.ramp};
}

/// Throw an error of a definition.
/// @param where  Path of the field, such as "hoist/efficiency".
/// @param kind   Kind of the named object.
[[noreturn]] inline void throw_def_error(const std::string& name, const std::string& where,
                                         const std::string& why, const char* kind = "crane") {
    throw DefError(std::string(kind) + " '" + name + "': " + where + ": " + why);
}

/// Reject values that are out of range or inconsistent, before anything is added. @throws DefError.
void check(const KnuckleCraneDef& def);
void check(const LatticeCraneDef& def);

inline constexpr std::size_t kMaxEyes = 8;

/// Loads of a hook: of a crane's hook, or of a separate one (hawser/hook.h).
struct HookLoads {
    const char* kind;  ///< Name of the owner in errors: "crane" or "hook".
    const std::string& name;
    const std::vector<CraneLoad>& loads;
    int take;
};
/// Check the loads for errors that do not depend on the world. @throws DefError.
void check_loads(const HookLoads& takes);
/// Check that the loads can hang in this world. @throws DefError.
void check_load_bodies(const World& world, const HookLoads& takes);

/// Return the name of a part of a crane, such as "crane/boom".
[[nodiscard]] inline std::string part(const std::string& crane, const char* what) {
    return crane + "/" + what;
}

/// Return the name of leg i of a hook.
[[nodiscard]] inline std::string leg_name(const std::string& hook, std::size_t i) {
    return hook + "/leg" + std::to_string(i + 1);
}

/// Return the sling to eye i of a load. @param way  Distance from the point of the hook to the eye
/// [m].
[[nodiscard]] inline InteractionDef sling_of(const CraneLoad& load, std::size_t i, std::string name,
                                             BodyId hook, const Vec3& point, double way) {
    InteractionDef sling;
    sling.name = std::move(name);
    sling.kind = InteractionKind::Stretch;
    sling.body[0] = hook;
    sling.body[1] = load.body;
    sling.point[0] = point;
    sling.point[1] = load.eyes[i];
    sling.set("length", std::max(load.sling_length, way)).set("EA", load.sling_EA);
    return sling.set("breaking_load", load.breaking_load);
}

/// Return the contact shape of the leg from a hook on a wire's node to an eye: a segment with
/// radius, material and groups of the wire.
/// @return nullopt if no segment ends at the hook
[[nodiscard]] std::optional<ShapeDef> leg_shape_of(const World& world, BodyId hook, BodyId load,
                                                   const Vec3& eye, std::string name);

/// Return the index of fall k in the parts of the route; k starts at 1. The parts before the falls
/// run from the drum, over the knuckle if there is one. One part lies under a hook sheave between
/// falls 1 and 2, 3 and 4, and so on.
[[nodiscard]] constexpr int part_of_fall(int k, bool knuckle) noexcept {
    return (knuckle ? 2 : 1) + k + k / 2;
}

}  // namespace hawser::crane
