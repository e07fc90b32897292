// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_stretch.h
/// Stretch of elements after a node next to a drum, bollard or guide was inserted or removed.
///
/// The law of an element includes a damper with τ = 2h in typical steps. At a coarse step its
/// length and rate may indicate a force that no step has exerted. If an edit kept that force by a
/// shorter rest length, it would store energy. An edit therefore keeps the force of the last step,
/// and stores no more than the elements did before (docs/theory/wire_nodes.md).

#include <cstdint>

namespace hawser::context {
struct StepContext;
}  // namespace hawser::context

namespace hawser::edit {

/// Return the value nearer to zero; 0 if the signs differ.
[[nodiscard]] double nearer_to_zero(double a, double b) noexcept;

/// Return the rest length at which an element of a length stores an energy V when taut [m]: the
/// solution l₀ ≤ l of V = EA (l − l₀)²/(2 l₀).
[[nodiscard]] double rest_length_for_energy(double length, double stiffness,
                                            double energy) noexcept;

/// Return the force that an element exerted in the last step [N]; 0 if it was slack.
[[nodiscard]] double exerted_force(const context::StepContext& ctx, std::int32_t id) noexcept;

/// Return the elastic energy of an element by its length half a step before the poses [J]. Unlike
/// energy_of_interaction(), it has no limit by the force of the last step.
[[nodiscard]] double energy_by_length(const context::StepContext& ctx, std::int32_t id) noexcept;

/// Increase the rest length of a taut element until it stores at most `most` [J] half a step before
/// the poses. Its multiplier becomes that of its force, at most the present one.
void limit_stretch(context::StepContext& ctx, std::int32_t id, double most) noexcept;

}  // namespace hawser::edit
