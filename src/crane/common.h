// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file common.h
/// What knuckle-boom and lattice cranes have in common, and refusals by name.

#include <hawser/crane.h>

#include "base/number.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace hawser::crane {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kUnbounded = 1e30;

/// Parts of a definition that both kinds have; it outlives this.
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
[[nodiscard]] Common common_of(const Def& d) {
    return {d.name,  d.mount, d.slew,   d.column, d.boom_foot, d.boom, d.boom_angle,
            d.hoist, d.hook,  d.rating, d.loads,  d.take,      d.ramp};
}

/// @param where  Path of the field, such as "hoist/efficiency". @param kind  Of what has the name.
[[noreturn]] inline void refuse(const std::string& name, const std::string& where,
                                const std::string& why, const char* kind = "crane") {
    throw DefError(std::string(kind) + " '" + name + "': " + where + ": " + why);
}

/// Refuses what is out of range, or does not fit, before anything is added. @throws DefError.
void check(const KnuckleCraneDef& def);
void check(const LatticeCraneDef& def);

inline constexpr std::size_t kMostEyes = 8;

/// What a hook is to take: that of a crane, or one by itself (hawser/hook.h).
struct Takes {
    const char* kind;  ///< "crane", "hook": what refusals call the owner.
    const std::string& name;
    const std::vector<CraneLoad>& loads;
    int take;
};
/// Loads that are wrong by themselves. @throws DefError.
void check_loads(const Takes& takes);
/// Loads that cannot hang in this world. @throws DefError.
void check_load_bodies(const World& world, const Takes& takes);

/// Name of a part of a crane, "crane/boom".
[[nodiscard]] inline std::string part(const std::string& crane, const char* what) {
    return crane + "/" + what;
}

/// Leg i of a hook.
[[nodiscard]] inline std::string leg_name(const std::string& hook, std::size_t i) {
    return hook + "/leg" + std::to_string(i + 1);
}

/// Sling to eye i of a load, from a point of the hook that is so far away [m].
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

/// Which part of the route is fall k, from 1 on: before the falls the line comes from the drum,
/// over the knuckle where there is one; between falls 1 and 2, 3 and 4 … it passes under a hook
/// sheave.
[[nodiscard]] constexpr int part_of_fall(int k, bool knuckle) noexcept {
    return (knuckle ? 2 : 1) + k + k / 2;
}

}  // namespace hawser::crane
