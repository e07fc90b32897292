// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water_hull.h
/// Hulls in the sea (sea.h): what presses, what is radiated and scattered, drag, drift.
///
/// Formulas of pressure: hull.h; of radiation and waves by coefficients: hydro.h.
///
/// **Added mass and damping by constants** meet the mean motion of the water over the wet volume of
/// the hull. The hull is cut into cells (hull_cells()) of volume V and wet share w, the share of
/// their height below the surface. u, a are the water's velocity and acceleration at their middles,
/// r the place of a middle from that of the wet volume:
/// ```
///     ū = Σ wV u/Σ wV        ω_k = Σ wV (r × u)_k/Σ wV (r² − r_k²)
///     F = A (ā − v̇) + B (ū − v)        M = A (α − ω̇_body) + B (ω − ω_body)
/// ```
/// with α from a as ω from u. In waves much longer than the hull this is the water at one point. In
/// short waves crests and troughs along the hull cancel, as they do for the pressure.
///
/// **Drag areas** hold at the design draught: along each axis of the body they are multiplied with
/// the wet projected area over that at the design draught, upright in still water. The projected
/// area along x is Σ over rows of cells along x of the largest wet height in the row times the
/// width; along y likewise; along z the ground area of columns with a wet cell (a cell counts
/// from a wet share of 0.1 in full). Wind areas are multiplied with the dry projected area over
/// that at the design draught.

#include <hawser/def.h>
#include <hawser/hull.h>
#include <hawser/hydro.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hawser {

class World;

/// How what a hull radiates acts on it (hydro.h).
enum class RadiationKind : std::uint8_t {
    convolution,  ///< A(∞), and the memory as a sum over past velocities.
    state_space,  ///< A(∞), and the memory by states.
    constant,     ///< A and B of one period, WaterHull::constant_period.
    none          ///< Coefficients are for waves alone.
};
/// Of which coefficients the force of waves is.
enum class ExcitationKind : std::uint8_t {
    none,        ///< None.
    full,        ///< All of it; only for a hull that its mesh does not press with waves.
    scattering,  ///< What it scatters, on top of the pressure on its mesh.
};

/// Drag of a strip of a hull: ½ρ C_dA |r·n| (r·n) n at a point of it, r the water's velocity there
/// past it. Rows of strips along a hull resist drifting and turning.
struct HullStrip {
    Vec3 at{0.0, 0.0, 0.0};    ///< From the centre of mass, in the body's frame [m].
    Vec3 axis{0.0, 1.0, 0.0};  ///< n, of length 1.
    double drag_area = 0.0;    ///< C_d A at the hull's design draught [m²].
};

/// Weight of displaced water and stiffness of a hull whose motions are small, instead of a mesh's.
struct LinearStatics {
    bool on = false;
    double height = 0.0;       ///< z of the centre of mass at rest, above still water [m].
    double weight = kDefault;  ///< Of the displaced water at rest [N]; kDefault: the body's.
};

/// Hull of a rigid body.
struct WaterHull {
    BodyId body{};    ///< Required; of the kind rigid.
    HullMesh mesh{};  ///< In the body's frame, from its centre of mass [m]. Required, closed.
    /// False: pressure ρg(η − z), hydrostatic below the surface; true: Airy's (Froude-Krylov).
    bool wave_pressure = true;
    /// A along and about the body's axes at the centre of mass [kg, kg m²], as it is afloat, past
    /// the mean motion of the water.
    std::array<double, 6> added_mass{};
    std::array<double, 6> damping{};  ///< Linear, likewise [N s/m, N m s].
    /// C_d A of the wet hull and of what is above the water at the design draught; forces act at
    /// the centre of mass [m²]. Wind is that of 10 m, or of the centre of mass where that is
    /// higher.
    Vec3 drag_area{0.0, 0.0, 0.0};
    Vec3 wind_area{0.0, 0.0, 0.0};
    /// From the surface to the lowest point of the mesh, upright [m]. Default: the draught at which
    /// the hull carries the mass of its body and of what joints hold to it, shared among their
    /// hulls by volume. If they do not float, or have no mass, the draught of the start; if that is
    /// not between 0 and the height of the mesh, the height.
    double design_draught = kDefault;
    std::vector<HullStrip> strips{};
    /// Of hydro.h; null: none. Shared and never changed.
    std::shared_ptr<const WaveCoefficients> coefficients{};
    RadiationKind radiation = RadiationKind::convolution;
    double memory = 60.0;          ///< T, of the memory [s].
    int order = 8;                 ///< Most states of a state space.
    double constant_period = 0.0;  ///< Of RadiationKind::constant [s].
    ExcitationKind excitation = ExcitationKind::none;
    /// Mean and slow drift: the sums over components of one sign of D
    /// |Σ a √|D| e^{iθ}|² (J. N. Newman, "Second-order, slowly-varying forces on vessels in
    /// irregular waves", 1974, in the form of a square), whose mean is Σ a² D.
    bool drift = false;
    /// Coriolis and centripetal forces of A, −ω × (A ν)₁ and −v × (A ν)₁ − ω × (A ν)₂ (G.
    /// Kirchhoff, 1869). Off where a table of drift has them in its means already.
    bool coriolis = false;
    /// Waves act where the hull is slowly: place and heading follow by four lags of this time each,
    /// 4 L³ − 3 L⁴, without delay at a steady speed [s].
    double slow_time = 16.0;
    LinearStatics linear{};  ///< On: `mesh` may be empty, `coefficients` give the stiffness.
};

/// What a hull remembers, for readers and verifiers.
struct HullMemory {
    RadiationKind kind = RadiationKind::none;
    double step = 0.0;                          ///< Between samples [s].
    std::vector<std::array<double, 6>> past{};  ///< ν̄ at the reference, body's axes, newest first.
    std::array<double, 6> last{};               ///< ν before the last step.
    bool begun = false;                         ///< `last` is known.
    /// Of a state space, d x/dt = A x + B ν̄, memory C x: x, and A, B, C row by row.
    std::vector<double> states{}, a{}, b{}, c{};
    Matrix6 first = Matrix6::Zero();  ///< K(0), as it is taken.
    Matrix6 added = Matrix6::Zero();  ///< Damping added for passivity.
    double fit_error = 0.0;           ///< Largest ‖K − C e^{At} B‖ over ‖K(0)‖, entries scaled.
    std::array<double, 3> lag[4]{};   ///< Slow x, y, heading after each lag.
};
/// Of hull number i of the sea. @throws DefError where there is none.
[[nodiscard]] HullMemory hull_memory(const World& world, std::size_t i);

}  // namespace hawser
