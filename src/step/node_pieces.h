// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_pieces.h
/// Elements and lumps about a node (nodes.h): what they are, and how they are changed.

#include "base/memory.h"
#include "context/context.h"
#include "step/node_place.h"

#include <cstdint>
#include <span>

namespace hawser::stepper {

/// What a body has to do with wires.
struct NodeLinks {
    std::int32_t before = -1, after = -1;  ///< Element that ends, that begins there; −1: none.
    bool plain = true;                     ///< No other interaction but bends acts on it.
};
[[nodiscard]] NodeLinks links_of(const StepContext& ctx, std::int32_t body) noexcept;
/// The bend in the middle of which a body is, with another one at a given side; −1: none.
[[nodiscard]] std::int32_t bend_at(const StepContext& ctx, std::int32_t middle, std::int32_t other,
                                   std::size_t side) noexcept;
/// The bend with the lowest place above `after` that some of these bodies have, −1: none.
[[nodiscard]] std::int32_t next_bend(const StepContext& ctx, std::span<const std::int32_t> bodies,
                                     std::int32_t after) noexcept;

[[nodiscard]] std::int32_t end_of(const StepContext& ctx, std::int32_t id,
                                  std::size_t slot) noexcept;
[[nodiscard]] bool is_lump(const StepContext& ctx, std::int32_t body) noexcept;

/// Mass of the material of an element [kg]; 0: it has none of its own.
[[nodiscard]] double mass_of_element(const StepContext& ctx, std::int32_t element) noexcept;
/// Whether its compliance is that of its length, and not one that was given or a drum's.
[[nodiscard]] bool is_of_material(const StepContext& ctx, std::int32_t element) noexcept;

/// Whether a drum pays it out; then which end is at the drum's fairlead, the one that no lump
/// holds.
[[nodiscard]] bool is_wound(const StepContext& ctx, std::int32_t element) noexcept;
[[nodiscard]] std::size_t drum_side(const StepContext& ctx, std::int32_t element) noexcept;
/// Velocity by material that comes in at the fairlead, of a place that keeps a share of it beyond
/// [m/s].
[[nodiscard]] Vec3 inflow_of(const StepContext& ctx, std::int32_t element, double beyond,
                             const base::Array<double>& packed) noexcept;

/// Where an element is held [m], and how fast that moves [m/s].
[[nodiscard]] Vec3 point_of(const StepContext& ctx, std::int32_t id, std::size_t slot) noexcept;
[[nodiscard]] Vec3 speed_of(const StepContext& ctx, std::int32_t id, std::size_t slot,
                            const base::Array<double>& packed) noexcept;

/// From end to end, with what lies on a wheel [m]; over that of the straight part alone.
[[nodiscard]] double length_of(const StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double beyond_straight(const StepContext& ctx, std::int32_t id) noexcept;
/// Share of its straight part at which a share of an element ends.
[[nodiscard]] double straight_share(const StepContext& ctx, std::int32_t id, double share) noexcept;
/// Where an element is held, in the frame of the body that holds it [m].
[[nodiscard]] Vec3 held_at(const StepContext& ctx, std::int32_t id, std::size_t slot) noexcept;

/// Force of the law at the present length [N], 0 while it is slack; and EA by its length at rest.
[[nodiscard]] double tension_of(const StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double stiffness_of(const StepContext& ctx, std::int32_t id) noexcept;

/// How fast an element is stretched, without what a drum pays out [m/s].
[[nodiscard]] double rate_of(const StepContext& ctx, std::int32_t id) noexcept;
/// What the step damps an element with [s].
[[nodiscard]] double damping_time_of(const StepContext& ctx, std::int32_t id) noexcept;
/// Force of law and damper [N], 0 while it is slack; and the rest length with which it has a given
/// one at the present length and rate [m].
[[nodiscard]] double force_of(const StepContext& ctx, std::int32_t id) noexcept;
[[nodiscard]] double rest_for(const StepContext& ctx, std::int32_t id, double force,
                              double stiffness) noexcept;

/// Weight that a lump of some mass has on an element [N], with the forces that act on lumps at its
/// ends by their mass (buoyancy).
[[nodiscard]] Vec3 weight_of(const StepContext& ctx, std::int32_t id, double mass) noexcept;
/// How far below the chord of an element forces balance a lump at the share σ of it [m].
[[nodiscard]] Vec3 sag_of(const Vec3& chord, double share, const Vec3& weight,
                          double tension) noexcept;

/// An element has another rest length and mass, and pulls with a tension. Of one at a drum the rest
/// length is that at the drum's present coordinate; its mass and drag are its winch's.
void set_element(StepContext& ctx, std::int32_t id, double rest, double mass,
                 double tension) noexcept;

/// What a lump holds of an element that changes; its drag follows its mass.
void add_mass(StepContext& ctx, std::int32_t body, double more, const Vec3& damping) noexcept;
[[nodiscard]] Vec3 damping_of(const StepContext& ctx, std::int32_t body) noexcept;

/// Whether an interaction resists bending of a wire.
[[nodiscard]] bool is_bend(const StepContext& ctx, std::int32_t id) noexcept;

/// Length at the node of a bend: half of the pieces before and behind it.
void set_bend(StepContext& ctx, std::int32_t id, std::int32_t one, std::int32_t other) noexcept;

/// What elements about a place know of the masses at their ends.
void follow_masses(StepContext& ctx, const NodePlace& place) noexcept;

}  // namespace hawser::stepper
