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
    bool has_only_bends = true;  ///< True if no other interaction except bends acts on it.
};
[[nodiscard]] NodeLinks adjacent_elements(const context::StepContext& ctx,
                                          std::int32_t body) noexcept;
/// Return the bend interaction whose middle body is `middle` and whose outer body on a given side
/// is `other`; −1: none.
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

/// Return the mass of the material of an element [kg]; 0 if the element has no mass of its own.
[[nodiscard]] double mass_of_element(const context::StepContext& ctx,
                                     std::int32_t element) noexcept;
/// True if the compliance of an element follows from its length, so that it is neither given nor
/// determined by a drum.
[[nodiscard]] bool is_of_material(const context::StepContext& ctx, std::int32_t element) noexcept;

/// True if an element is at a drum. Then drum_side() is its end at the fairlead, to which no node
/// belongs.
[[nodiscard]] bool is_at_drum(const context::StepContext& ctx, std::int32_t element) noexcept;
[[nodiscard]] std::size_t drum_side(const context::StepContext& ctx, std::int32_t element) noexcept;
/// Return the velocity due to material that enters at the fairlead [m/s].
/// @param beyond  Fraction of the element behind the point at which the velocity is evaluated.
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
/// Convert a position on an element, as a fraction of its whole length, to the fraction of its
/// straight part. They differ if a part of the element lies on a wheel.
[[nodiscard]] double straight_fraction(const context::StepContext& ctx, std::int32_t id,
                                       double share) noexcept;
/// Return the attachment point of an element in the frame of its body [m].
[[nodiscard]] Vec3 attachment_point(const context::StepContext& ctx, std::int32_t id,
                                    std::size_t slot) noexcept;

/// Return the force of an element at its present length by its elastic law alone [N], 0 if slack,
/// and EA from the rest length.
[[nodiscard]] double tension_of(const context::StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double stiffness_of(const context::StepContext& ctx, std::int32_t id) noexcept;

/// Return the stretching speed of an element without the material paid out by a drum [m/s].
[[nodiscard]] double stretching_speed(const context::StepContext& ctx, std::int32_t id) noexcept;
/// Return the effective damping time of an element in the step [s], including numerical damping.
[[nodiscard]] double damping_time_of(const context::StepContext& ctx, std::int32_t id) noexcept;
/// Return the force of an element by its elastic law and its damper [N], 0 if slack; and the rest
/// length that gives a force at the present length and speed [m].
[[nodiscard]] double force_of(const context::StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double rest_length_for_force(const context::StepContext& ctx, std::int32_t id,
                                           double force, double stiffness) noexcept;

/// Return the weight of a node of the given mass on an element [N]. It includes the forces on the
/// nodes at the ends of the element (buoyancy), in proportion to mass.
[[nodiscard]] Vec3 weight_of(const context::StepContext& ctx, std::int32_t id,
                             double mass) noexcept;
/// Return the distance from the chord of an element to the equilibrium position of a node at the
/// fraction `share` of its length [m].
[[nodiscard]] Vec3 sag_below_chord(const Vec3& chord, double share, const Vec3& weight,
                                   double tension) noexcept;

/// Set rest length, mass and tension of an element. At a drum the rest length is the one at the
/// present coordinate of the drum; the winch applies the mass and drag of the element.
void set_element(context::StepContext& ctx, std::int32_t id, double rest, double mass,
                 double tension) noexcept;

/// Add the mass `more` and the drag of a changed element to a node.
void add_mass(context::StepContext& ctx, std::int32_t body, double more,
              const Vec3& damping) noexcept;
[[nodiscard]] Vec3 damping_of(const context::StepContext& ctx, std::int32_t body) noexcept;

/// True if an interaction resists bending of a wire.
[[nodiscard]] bool is_bend(const context::StepContext& ctx, std::int32_t id) noexcept;

/// Set the length of a bend interaction to half the sum of the lengths of the elements `one` and
/// `other` beside its node.
void set_bend(context::StepContext& ctx, std::int32_t id, std::int32_t one,
              std::int32_t other) noexcept;

/// Update the data of the elements near a node that depend on the masses of their end nodes.
void update_for_masses(context::StepContext& ctx, const NodeSurroundings& place) noexcept;

}  // namespace hawser::edit
