// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_pieces.h
/// Elements and nodes near a node (nodes.h): their properties and changes.

#include "base/memory.h"
#include "context/context.h"
#include "edit/node_place.h"

#include <cstdint>
#include <span>

namespace hawser::edit {

/// Connections of a body to wires.
struct NodeLinks {
    std::int32_t before = -1, after = -1;  ///< Elements that end and begin at the body; −1: none.
    bool plain = true;  ///< True if no other interaction except bends acts on it.
};
[[nodiscard]] NodeLinks adjacent_elements(const context::StepContext& ctx,
                                          std::int32_t body) noexcept;
/// Return the bend with a body in its middle and another one on a given side; −1: none.
[[nodiscard]] std::int32_t bend_at(const context::StepContext& ctx, std::int32_t middle,
                                   std::int32_t other, std::size_t side) noexcept;
/// Return the bend between the given bodies with the lowest index above `after`; −1 if there is
/// none.
[[nodiscard]] std::int32_t next_bend(const context::StepContext& ctx,
                                     std::span<const std::int32_t> bodies,
                                     std::int32_t after) noexcept;

[[nodiscard]] std::int32_t end_of(const context::StepContext& ctx, std::int32_t id,
                                  std::size_t slot) noexcept;
[[nodiscard]] bool is_free_node(const context::StepContext& ctx, std::int32_t body) noexcept;

/// Return the mass of the material of an element [kg]; 0: it has none of its own.
[[nodiscard]] double mass_of_element(const context::StepContext& ctx,
                                     std::int32_t element) noexcept;
/// True if its compliance follows from its length, and is neither given nor determined by a drum.
[[nodiscard]] bool is_of_material(const context::StepContext& ctx, std::int32_t element) noexcept;

/// True if a drum pays the element out; drum_side() is then its end at the fairlead, which no node
/// holds.
[[nodiscard]] bool is_wound(const context::StepContext& ctx, std::int32_t element) noexcept;
[[nodiscard]] std::size_t drum_side(const context::StepContext& ctx, std::int32_t element) noexcept;
/// Return the velocity due to material that enters at the fairlead, at a point with the fraction
/// `beyond` of it behind [m/s].
[[nodiscard]] Vec3 inflow_velocity(const context::StepContext& ctx, std::int32_t element,
                                   double beyond, const base::Array<double>& packed) noexcept;

/// Return the position of an end of an element [m], and its velocity [m/s].
[[nodiscard]] Vec3 point_of(const context::StepContext& ctx, std::int32_t id,
                            std::size_t slot) noexcept;
[[nodiscard]] Vec3 speed_of(const context::StepContext& ctx, std::int32_t id, std::size_t slot,
                            const base::Array<double>& packed) noexcept;

/// Return the length between the ends, including the part on a wheel [m], and its excess over the
/// straight part.
[[nodiscard]] double length_of(const context::StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double length_beyond_chord(const context::StepContext& ctx, std::int32_t id) noexcept;
/// Return the fraction of the straight part at which a fraction of an element ends.
[[nodiscard]] double straight_fraction(const context::StepContext& ctx, std::int32_t id,
                                       double share) noexcept;
/// Return the attachment point of an element in the frame of its body [m].
[[nodiscard]] Vec3 attachment_point(const context::StepContext& ctx, std::int32_t id,
                                    std::size_t slot) noexcept;

/// Return the force of the law at the present length [N], 0 if slack; and EA from the rest length.
[[nodiscard]] double tension_of(const context::StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double stiffness_of(const context::StepContext& ctx, std::int32_t id) noexcept;

/// Return the stretching speed of an element without the material paid out by a drum [m/s].
[[nodiscard]] double stretching_speed(const context::StepContext& ctx, std::int32_t id) noexcept;
/// Return the damping time of an element in the step [s].
[[nodiscard]] double damping_time_of(const context::StepContext& ctx, std::int32_t id) noexcept;
/// Return the force of law and damper [N], 0 if slack; and the rest length that gives a force at
/// the present length and speed [m].
[[nodiscard]] double force_of(const context::StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double rest_length_for_force(const context::StepContext& ctx, std::int32_t id,
                                           double force, double stiffness) noexcept;

/// Return the weight of a node of the given mass on an element [N]. Includes forces on nodes at its
/// ends in proportion to mass (buoyancy).
[[nodiscard]] Vec3 weight_of(const context::StepContext& ctx, std::int32_t id,
                             double mass) noexcept;
/// Return the distance below the chord of an element at which a node at its fraction σ is in
/// equilibrium [m].
[[nodiscard]] Vec3 sag_below_chord(const Vec3& chord, double share, const Vec3& weight,
                                   double tension) noexcept;

/// Set rest length, mass and tension of an element. At a drum the rest length is the one at the
/// present coordinate of the drum; its winch has its mass and drag.
void set_element(context::StepContext& ctx, std::int32_t id, double rest, double mass,
                 double tension) noexcept;

/// Add mass and drag of a changed element to a node.
void add_mass(context::StepContext& ctx, std::int32_t body, double more,
              const Vec3& damping) noexcept;
[[nodiscard]] Vec3 damping_of(const context::StepContext& ctx, std::int32_t body) noexcept;

/// True if an interaction resists bending of a wire.
[[nodiscard]] bool is_bend(const context::StepContext& ctx, std::int32_t id) noexcept;

/// Set the length at the node of a bend: half of the pieces before and behind it.
void set_bend(context::StepContext& ctx, std::int32_t id, std::int32_t one,
              std::int32_t other) noexcept;

/// Update the data of elements near a node that depend on the masses at their ends.
void follow_masses(context::StepContext& ctx, const NodeSurroundings& place) noexcept;

}  // namespace hawser::edit
