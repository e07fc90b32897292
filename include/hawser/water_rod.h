// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water_rod.h
/// What water does to slender things: per length of a line, and rods of rigid bodies (sea.h): legs
/// and braces of a platform, spar buoys, booms, pipes.
///
/// **Rods.** A rod of length L is cut into n segments of length l = L/n. Each is loaded at its
/// centre p (from the body's centre of mass, world axes), by the velocity r = u − v − ω × p of the
/// water there past it (J. R. Morison and others, "The force exerted by surface waves on piles",
/// 1950), with t along the rod, A the displaced area, w the share of it that is wet:
/// ```
///     f = w l (½ρ C_dn d |r_n| r_n + ½ρ C_dt π d |r_t| r_t + ρ A (a + C_a (a − a_p)) + ρ g A z)
///     a_p = v̇ + ω̇ × p + ω × (ω × p)
/// ```
/// z up, a the water's acceleration; C_a across and along the rod apart. The body takes f and
/// p × f. What depends on its motion goes in as blocks of six rows Jᵀ B J, J = [E, −[p]×], with B
/// the added mass, the tangent of drag, and the stiffness of buoyancy:
/// ```
///     A = ρ A l w (C_an (E − t tᵀ) + C_at t tᵀ),    K = ρ g A l/s z zᵀ  where the surface cuts it,
///     D = c_n (|r_n| (E − t tᵀ) + r_n r_nᵀ/|r_n|) + 2 c_t |r_t| t tᵀ
/// ```
/// each a sum of b bᵀ with b = (n, p × n). A segment reaches over s = l |t_z| + d √(1 − t_z²) up
/// and down, as a cylinder does, and is wet by the share of that below the surface. A rod that is
/// under water all over has the stiffness of the secant to where it would be out of it, and the
/// stable part of the couple of its buoyancy about the centre of mass (hull.h has both).
///
/// Limits: slender, with d ≪ λ/5 and d ≪ L: no diffraction, no radiation of waves, no ends (for the
/// drag and added mass of which WaterBody stands, or C_dt and C_at). Water is that at the centre
/// line, as if the rod were not there; rods do not shield each other, and where they meet they
/// overlap. The added mass of Morison's formula has no Munk moment. What is wet of a segment that
/// is cut counts at its centre. No wind.
///
/// A hull (water_hull.h) on the same body displaces what it encloses already: give rods in it
/// `volume` 0. Then they have drag alone, since added mass and the force of the wave are of the
/// volume.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/math.h>

#include <cmath>
#include <numbers>

namespace hawser {

/// What water does to lines and rods of one sort.
struct LineWater {
    double diameter = 0.0;       ///< Of drag [m]. Required.
    double volume = kDefault;    ///< Displaced, per length [m²]; kDefault: π d²/4.
    double cd_normal = 1.2;      ///< C_dn, on the diameter [1].
    double cd_tangential = 0.0;  ///< C_dt, on the circumference [1].
    double ca_normal = 1.0;      ///< C_a across, of the volume [1].
    double ca_tangential = 0.0;  ///< C_a along, of the volume [1].

    /// Displaced per length [m²], that of the diameter where none is given.
    [[nodiscard]] double area() const noexcept {
        return std::isnan(volume) ? 0.25 * std::numbers::pi * diameter * diameter : volume;
    }
};

/// Most segments of a rod.
inline constexpr int kMaxRodSegments = 1000;

/// A straight rod of a rigid body in the water.
struct WaterRod {
    BodyId body{};             ///< Required; not a lump.
    Vec3 from{0.0, 0.0, 0.0};  ///< One end, from the centre of mass, in the body's frame [m].
    Vec3 to{0.0, 0.0, 0.0};    ///< The other end [m]. Required.
    LineWater water{};         ///< Required.
    int segments = 8;          ///< n, 1 to kMaxRodSegments.
};

}  // namespace hawser
