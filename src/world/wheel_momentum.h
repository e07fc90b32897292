// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wheel_momentum.h
/// Momentum of a wire that comes to lie on a guide, and of one that leaves it.
///
/// The parts at a guide, of masses m₁ and m₂, load their nodes with m₁/2 and m₂/2. The other half,
/// (m₁ + m₂)/2, lies at the wheel and moves along the wire only, with the slide:
/// ```
///     a ──── m₁ ────( )──── m₂ ──── b        w = wheel + slide rate · u
///     m₁/2        (m₁+m₂)/2       m₂/2       speeds: v_a, w, v_b
/// ```
/// *Off.* The nodes get that half, each as much as the other part left at the wheel:
/// ```
///     (M_k + (m₁+m₂)/2) v_k' = (M_k + m_k/2) v_k + ((m₁+m₂ − m_k)/2) w_k
/// ```
/// *On.* The half moves across the wire with v, as on a straight element. The wheel stops it, and
/// the body of the guide gets the impulse (m₁+m₂)/2 · (v − wheel)⊥.

#include <hawser/id.h>
#include <hawser/math.h>

#include <array>
#include <cstdint>

namespace hawser::context {
struct StepContext;
}

namespace hawser::world {

/// Mass at a wheel that goes to each end of the wire there [kg]. Speeds are those of the last step,
/// and those predicted for the next one [m/s].
struct WireAtWheel {
    std::array<double, 2> mass{};
    std::array<Vec3, 2> speed{Vec3::Zero(), Vec3::Zero()}, ahead{Vec3::Zero(), Vec3::Zero()};
};

/// Read the mass and motion of the wire at the wheel between two parts. @param mass  Mass of both
/// parts [kg].
[[nodiscard]] WireAtWheel read_wire_at_wheel(const context::StepContext& ctx,
                                             std::array<std::int32_t, 2> part,
                                             double mass) noexcept;
/// Set the velocity of a node that has received part of the wire's mass at a wheel, and record the
/// change of energy as edited. @param end  End of the element at which the node is.
void divide_momentum(context::StepContext& ctx, std::int32_t lump, const WireAtWheel& wheel,
                     std::size_t end) noexcept;

/// Apply to the body of a guide the impulse of the half element that its wheel now carries.
/// @param part  Parts of the element. @param speed  Speeds of the ends before the edit [m/s].
/// @param mass  Mass of the half [kg].
void apply_lateral_impulse(context::StepContext& ctx, std::array<std::int32_t, 2> part,
                           const std::array<Vec3, 2>& speed, double mass) noexcept;

}  // namespace hawser::world
