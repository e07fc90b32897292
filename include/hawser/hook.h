// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hook.h
/// A hook at the end of a wire, or on any body, that takes loads by slings and lets them go while
/// the world runs.
///
/// ```cpp
/// world.add(hawser::HookDef{.name = "hook", .body = block, .point = {0, 0, -0.6},
///     .loads = {{.body = box, .eyes = {{1, 1, 1}, {1, -1, 1}, {-1, -1, 1}, {-1, 1, 1}},
///                .sling_length = 3.0, .sling_EA = 2e7}}});
/// world.set_system_signal("hook.take", 1);  // takes the box once all its eyes are in reach
/// world.set_system_signal("hook.take", 0);  // lets it go
/// ```
/// *Slings.* A load hangs by legs of equal length from the hook's point to its eyes, made and let
/// go as one: one leg of a few centimetres for an eye alone, two or four of a sling. Legs are lines
/// that only pull, without mass: the interactions NAME/leg1 and on. A level load of the weight W
/// hangs on n legs, each at α from the vertical, by W/(n cos α) a leg.
/// ```
///        o  point        o
///        |             / | \        α between a leg and the vertical
///        e            e     e
///      ┌─┴─┐        ┌─┴─────┴─┐
/// ```
/// *Take.* `take` is the number of a load, 1 the first of `loads`. It is taken once no eye is
/// farther from the point than a leg is long, and `reach`; a leg that would be too short is then as
/// long as the way, so that taking pulls at nothing. Until then the hook waits: event `missed`
/// once, with the distance of the farthest eye.
///
/// *Let go.* `take` 0, or the number of another load. A hook with a safety latch (`latch`) opens
/// only while what hangs on it is no more than that: told under a greater load it stays closed and
/// opens once the load is set down. Above `strength` it opens by itself, and takes again only after
/// `take` has been 0.
///
/// A hook is a System (system.h). Signals, as "name.signal": input `take`; outputs `held`, the
/// number of the load that hangs, 0: none; `load`, the pull of all legs on the hook [N]; `leg`, the
/// largest tension [N]; `state` (HookState as a number). They and the force at which it opens are
/// of the last step. Events: `join` of the load, with the distance of its farthest eye [m];
/// `detach` of it, with the pull [N]; `overload` of it where the hook opened by its strength;
/// `missed` of the hook's body.
///
/// Limits: legs do not touch anything. A lump, as the end of a wire is one, bears at its place.
/// What hangs swings about the point without friction. Cranes have hooks of their own (crane.h).

#include <hawser/crane.h>
#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

class World;

/// What a hook does.
enum class HookState : std::uint8_t {
    empty,    ///< Nothing hangs, and nothing is to.
    waiting,  ///< What it is to take is not in reach.
    holding,  ///< A load hangs.
    latched,  ///< It is to let go, and what hangs is too heavy for its latch.
    opened,   ///< It opened above its strength; `take` has to be 0 before it takes again.
};

struct HookDef {
    std::string name{};         ///< Unique among systems. Required.
    BodyId body{};              ///< The hook, or the lump at a wire's end. Required; no scalar.
    Vec3 point{0.0, 0.0, 0.0};  ///< Where slings bear, in its frame [m]; 0 of a lump.
    std::vector<CraneLoad> loads{};  ///< What it may take, as cranes have it.
    int take = 0;                    ///< Load that hangs from the start; 0: none.
    double strength = 1e30;          ///< Above it the hook opens [N].
    double latch = 1e30;             ///< Above it the hook does not open when told to [N].
};

/// What World::add() of it calls. @throws DefError on what is missing or out of range, on a name
/// that is taken, or where what is to hang from the start is out of reach.
void define(World& world, const HookDef& def);

}  // namespace hawser
