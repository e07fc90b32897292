// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hook.h
/// Hook on a body or at the end of a wire. It attaches loads by slings and releases them during the
/// run.
///
/// ```cpp
/// world.add(hawser::HookDef{.name = "hook", .body = block, .point = {0, 0, -0.6},
///     .loads = {{.body = box, .eyes = {{1, 1, 1}, {1, -1, 1}, {-1, -1, 1}, {-1, 1, 1}},
///                .sling_length = 3.0, .sling_EA = 2e7}}});
/// world.set_system_signal("hook.take", 1);  // attach the box once all its eyes are within reach
/// world.set_system_signal("hook.take", 0);  // release it
/// ```
/// *Slings*. A load hangs on legs of equal length from the hook's point to its eyes: one leg for a
/// single eye, two or four for a sling. All legs are attached and released together. Legs are
/// massless lines that carry tension only, the interactions NAME/leg1 and so on. A level load of
/// weight W on n legs at the angle α from the vertical causes the tension W/(n cos α) in each leg.
/// ```
///        o  point        o
///        |             / | \        α between a leg and the vertical
///        e            e     e
///      ┌─┴─┐        ┌─┴─────┴─┐
/// ```
/// *Attachment*. The input `take` is the number of a load, 1 the first of `loads`. The load is
/// attached when all its eyes are within sling_length + reach of the point. If an eye is farther
/// away than sling_length, its leg has that distance as rest length, so that attachment causes no
/// tension. While the load is out of reach the hook waits. It reports the event `missed` once, with
/// the distance of the farthest eye [m].
///
/// *Release*. `take` 0, or the number of another load, releases the load. A hook with a safety
/// latch opens only if its force is at most `latch`. Otherwise it stays closed until the load is
/// set down. Above `strength` it opens by itself, and attaches a load again only after `take` has
/// been 0.
///
/// A hook is a System (system.h) with the input "NAME.take". Outputs, as "NAME.signal":
/// - `held`: number of the attached load; 0: none;
/// - `load`: force of all legs on the hook [N];
/// - `leg`: largest tension of a leg [N];
/// - `state`: number of a HookState.
///
/// Outputs and the opening force are those of the last step.
///
/// Events of the load: `join` with the distance of its farthest eye [m], `detach` and `overload`
/// (opened above its strength) with the force [N]. Event of the hook's body: `missed`.
///
/// *Contact*. If the hook is a node of a wire whose elements have contact shapes, each leg is a
/// segment (shapes.h) with radius, material and groups of that wire, and the name of the leg. Legs
/// of other hooks have no contacts.
///
/// Limits: if the body is a lumped mass, such as a wire's end, the force acts at its position.
/// Loads swing about the point without friction. Cranes have their own hooks (crane.h).

#include <hawser/crane.h>
#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

class World;

/// Operating state of a hook.
enum class HookState : std::uint8_t {
    empty,    ///< No load is attached or requested.
    waiting,  ///< The requested load is out of reach.
    holding,  ///< A load is attached.
    latched,  ///< Release is requested, but the load exceeds the latch.
    opened,   ///< Opened above its strength; requires `take` 0 before the next load.
};

/// Definition of a hook. World::add() copies it.
struct HookDef {
    std::string name{};  ///< Unique name among systems. Required.
    BodyId body{};  ///< Body of the hook, or the node at a wire's end; not a scalar body. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Attachment point of slings, in the body's frame [m]; 0 for a
                                ///< node.
    std::vector<CraneLoad> loads{};  ///< Loads that can be attached.
    int take = 0;                    ///< Number of the load attached at the start; 0: none.
    double strength = 1e30;          ///< Force above which the hook opens by itself [N].
    double latch = 1e30;             ///< Force above which the safety latch prevents release [N].
};

/// Add a hook; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range
/// @throws DefError if the name is already used, or the load to attach at the start is out of reach
void define(World& world, const HookDef& def);

}  // namespace hawser
