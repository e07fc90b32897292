// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water_rod.h
/// Water loads on slender bodies: line coefficients, and rods of rigid bodies (sea.h). Examples are
/// legs, braces, spar buoys, booms and pipes.
///
/// *Rods*. A rod of length L is divided into n segments of length l = L/n. Loads act at the centre
/// p of a segment (from the body's centre of mass, world axes), where the water has the relative
/// velocity r = u − v − ω × p. With the unit vector t along the rod, the displaced area A per
/// length and the wet fraction w:
/// ```
///     f = w l (½ρ C_dn d |r_n| r_n + ½ρ C_dt π d |r_t| r_t + ρ A (a + C_a (a − a_p)) + ρ g A z)
///     a_p = v̇ + ω̇ × p + ω × (ω × p)
/// ```
/// z points up, a is the water's acceleration. C_a has separate values across and along the rod.
/// Source: J. R. Morison and others, "The force exerted by surface waves on piles", 1950. The body
/// receives the force f and the moment p × f. Terms that depend on its motion are matrices of six
/// rows Jᵀ B J, J = [E, −[p]×]. B is the added mass, the tangent of drag, or the stiffness of
/// buoyancy:
/// ```
///     A = ρ A l w (C_an (E − t tᵀ) + C_at t tᵀ),    K = ρ g A l/s z zᵀ  where the surface cuts it,
///     D = c_n (|r_n| (E − t tᵀ) + r_n r_nᵀ/|r_n|) + 2 c_t |r_t| t tᵀ
/// ```
/// Each is a sum of b bᵀ with b = (n, p × n), and therefore positive semi-definite. A segment has
/// the vertical extent s = l |t_z| + d √(1 − t_z²) of a cylinder; its wet fraction is the part of s
/// below the surface. A fully submerged rod has the secant stiffness to the position above the
/// water, and the stable part of the moment of its buoyancy about the centre of mass (both as in
/// hull.h).
///
/// Limits: slender rods, d ≪ λ/5 and d ≪ L, without diffraction and wave radiation. Ends have no
/// loads; represent them by WaterBody, or by C_dt and C_at. The flow is the undisturbed one at the
/// centre line: rods do not shield each other, and overlap at joints. The added mass has no Munk
/// moment. The wet part of a segment at the surface acts at its centre. No wind.
///
/// A hull (water_hull.h) on the same body displaces the volume that it encloses. Set `volume` 0 for
/// rods inside it. They then have drag only, because added mass and wave force are proportional to
/// the volume.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/math.h>

#include <cmath>
#include <numbers>

namespace hawser {

/// Water coefficients of lines and rods of one type.
struct LineWater {
    double diameter = 0.0;       ///< Drag diameter d [m]. Required.
    double volume = kDefault;    ///< Displaced volume per length [m²]; default: π d²/4.
    double cd_normal = 1.2;      ///< Drag coefficient C_dn across, relative to the diameter [1].
    double cd_tangential = 0.0;  ///< Drag coefficient C_dt along, relative to the circumference
                                 ///< [1].
    double ca_normal = 1.0;      ///< Added mass coefficient C_a across, relative to the volume [1].
    double ca_tangential = 0.0;  ///< Added mass coefficient C_a along, relative to the volume [1].

    /// Return the displaced volume per length [m²]; by default that of the diameter.
    [[nodiscard]] double area() const noexcept {
        return std::isnan(volume) ? 0.25 * std::numbers::pi * diameter * diameter : volume;
    }
};

/// Largest number of segments of a rod.
inline constexpr int kMaxRodSegments = 1000;

/// Straight rod of a rigid body in the water.
struct WaterRod {
    BodyId body{};             ///< Body; not a lumped mass. Required.
    Vec3 from{0.0, 0.0, 0.0};  ///< First end, from the centre of mass, in the body's frame [m].
    Vec3 to{0.0, 0.0, 0.0};    ///< Second end, likewise [m]. Required.
    LineWater water{};         ///< Coefficients. Required.
    int segments = 8;          ///< Number of segments n, 1 to kMaxRodSegments.
};

}  // namespace hawser
