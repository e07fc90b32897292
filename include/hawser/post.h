// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file post.h
/// What wires come to lie on and lift off while they run: a pin, a bollard, a rail, the edge of a
/// deck. A guide (guide.h) has its wire from the start and keeps it; a post takes wires that touch
/// its shape, and lets go of them.
///
/// ```cpp
/// const hawser::ShapeId pin = world.add_shape({.kind = hawser::ShapeKind::cylinder, .body = ship,
///     .position = {-40, 2, 3}, .radius = 0.075, .half_length = 0.6, .margin = 1.0});
/// world.add(hawser::PostDef{.name = "pin", .shape = pin, .friction = 0.15});
/// ```
/// *Found* by its contacts: capsules of wires and the post's shape are swept along their velocities
/// (World's collider), so that a fast wire is stopped at the surface in the step that would take it
/// through; one that others yank within a step is stopped where it was within the shape's `margin`.
/// In the next step the element that touches is divided about a contact node without mass
/// (World::lay_over()): as it lies then, with the tension that it has, at the radius of the post
/// and half of the wire, which turns it by next to nothing yet.
/// ```
///      a ──────────────── b          a ─────.     .───── b
///            ( )             ──►           ( `─○─' )              ○ the contact node
/// ```
/// From there on it is a guide: Euler's ratio at the angle of each step, no creep below it, nodes
/// that run through. A lump that comes to lie on the post itself goes first, where it may
/// (World::remove_node()).
///
/// *Lets go* where the wire would have to pull at it: its tension by the angle, 0.002 rad less, and
/// the weight of the half elements that a guide has, are below 0. So a wire that lies just straight
/// does not come and go. And where the straight way between the nodes on
/// both sides passes the end of the shape by more than its radius. The parts are one element again
/// (World::lift_off()), at the rest length that keeps their tension, or past an end at that which
/// they had. An element longer than 1.5 `element_length` gets a node.
///
/// *Slides* along the post, where `slides` says so. Seen on the unrolled surface the wire comes at
/// the angle β₁ to the axis and leaves at β₂. While |ln tan(β₂/2) − ln tan(β₁/2)| ≤ μ `angle`,
/// which is Coulomb's law across the wire, its place stays to the bit; beyond, it goes to where
/// both are equal (World::move_along()); without friction to equal angles, the shortest way. At an
/// end of the shape it comes off. Otherwise a wire keeps its place along the post.
///
/// A post is a System (system.h). Signals, as "name.signal": `held`, wires that lie on it; `taken`
/// and `let_go`, how many have so far; `angle` [rad], `before` and `behind` [N] and `slide` [m] of
/// the first one. Where wires slide also `along`, its place from the middle of the shape along z,
/// and `slid`, how far all have slid since the start [m].
///
/// Limits: each wire lies on a post once, and of what lies on it no other part is taken. Friction
/// along a wire and across it are bounded apart. Where the wire passes the next post, a
/// lump comes half-way, so that an element with a capsule touches that; posts nearer than 0.2 m
/// along the wire are not told apart. A wire needs capsules (WireDef::radius) to be found, lumps on
/// both sides, and elements with a mass of their own (WireDef::consistent_mass). The turn of a
/// shape's end (a capsule's cap) counts as its side. What the contact's friction had stored is
/// dropped when a wire is taken. docs/wires.md, "Posts".

#include <hawser/id.h>
#include <hawser/interactions.h>

#include <string>

namespace hawser {

class World;

struct PostDef {
    std::string name{};       ///< Unique among systems. Parts: name/K/slide, …, K from 1 on.
    ShapeId shape{};          ///< A cylinder or capsule of one body that is no lump. Required.
    double friction = 0.0;    ///< μ of wires that lie on it.
    double efficiency = 1.0;  ///< η where it is a roller: lesser tension over greater; (0, 1].
    double inertia = 0.0;     ///< Of a roller that turns with the wire [kg m²].
    int wires = 2;            ///< That lie on it at once, 1 to 16; others stay contacts.
    double element_length = kDefault;  ///< As GuideDef has it.
    bool slides = false;               ///< Wires that lie on it slide along its axis.
};

/// What World::add() of it calls. @throws DefError on what is missing or out of range, or a name
/// that is taken.
void define(World& world, const PostDef& def);

}  // namespace hawser
