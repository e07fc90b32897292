// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hook.h
/// Hook at the end of a wire, or on any body. It attaches loads by slings and releases them during
/// the run.
///
/// ```cpp
/// world.add(hawser::HookDef{.name = "hook", .body = block, .point = {0, 0, -0.6},
///     .loads = {{.body = box, .eyes = {{1, 1, 1}, {1, -1, 1}, {-1, -1, 1}, {-1, 1, 1}},
///                .sling_length = 3.0, .sling_EA = 2e7}}});
/// world.set_system_signal("hook.take", 1);  // attach the box once all its eyes are within reach
/// world.set_system_signal("hook.take", 0);  // release it
/// ```
/// *Slings*. A load hangs on legs of equal length from the hook's point to its eyes. All legs are
/// attached and released together: one short leg for a single eye, two or four for a sling. Legs
/// are massless lines that carry tension only, the interactions NAME/leg1 and so on. A level load
/// of weight W on n legs at the angle α from the vertical causes W/(n cos α) in each leg.
/// ```
///        o  point        o
///        |             / | \        α between a leg and the vertical
///        e            e     e
///      ┌─┴─┐        ┌─┴─────┴─┐
/// ```
/// *Attach*. The input `take` is the number of a load, 1 the first of `loads`. The load is attached
/// once all eyes are within sling_length + reach of the point. A shorter leg gets the actual
/// distance as its length, so that attaching causes no tension. While the load is out of reach the
/// hook waits. It reports the event `missed` once, with the distance of the farthest eye [m].
///
/// *Release*. `take` 0, or the number of another load, releases the load. A hook with a safety
/// latch (`latch`) opens only if the load is at most `latch`. Otherwise it stays closed, and opens
/// once the load is set down. Above `strength` it opens by itself, and attaches a load again only
/// after `take` has been 0.
///
/// A hook is a System (system.h) with the input "NAME.take". Outputs: `held` is the number of the
/// attached load, 0: none. Output `load` is the force of all legs on the hook [N], `leg` the
/// largest tension [N], `state` the number of a HookState. Outputs and the opening force are those
/// of the last step.
///
/// Events: `join` of the load, with the distance of its farthest eye [m]; `detach` of the load,
/// with the force [N]. Event `overload` of the load, if the hook opens by its strength; `missed` of
/// the hook's body.
///
/// *Contact*. If the hook is a node of a wire whose elements have contact shapes, each leg is a
/// segment (shapes.h) with radius, material and groups of that wire, named like the leg. Legs of
/// other hooks have no contacts.
///
/// Limits: On a lumped mass, such as a wire's end, the force acts at its
/// position. Loads swing about the point without friction. Cranes have their own hooks (crane.h).

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
    double latch = 1e30;             ///< Force above which the hook does not open on request [N].
};

/// Add a hook; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range
/// @throws DefError if the name is already used, or the load to attach at the start is out of reach
void define(World& world, const HookDef& def);

}  // namespace hawser
