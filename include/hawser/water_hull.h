// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water_hull.h
/// Hulls of rigid bodies in the sea (sea.h). Their loads are pressure, radiation, scattering, drag
/// and drift. Formulas of pressure: hull.h. Formulas of radiation and scattering: hydro.h.
///
/// *Added mass and damping* that are constant (members `added_mass`, `damping`) act relative to the
/// mean motion of the water over the wet volume. The hull is divided into cells (hull_cells()) of
/// volume V and wet fraction w, the submerged fraction of their height. At the centre of a cell the
/// water has the velocity u and the acceleration a. The vector r leads from the centre of the wet
/// volume to this centre.
/// ```
///     ū = Σ wV u/Σ wV        ω_k = Σ wV (r × u)_k/Σ wV (r² − r_k²)
///     F = A (ā − v̇) + B (ū − v)        M = A (α − ω̇_body) + B (ω − ω_body)
/// ```
/// The means ā and α follow from a as ū and ω from u. In waves much longer than the hull these are
/// the values at one point. In short waves crests and troughs along the hull cancel, as in the
/// pressure.
///
/// *Drag areas* hold at the design draught. Along each axis of the body they are scaled by the wet
/// projected area over that at the design draught, upright in still water. The projected area along
/// x is a sum over rows of cells along x: largest wet height in the row times the width. The sum
/// along y is similar. Along z it is the ground area of columns with a wet cell. A cell counts in
/// full from a wet fraction of 0.1. Wind areas are scaled by the dry projected area over that at
/// the design draught.

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

/// Model of the radiation force (hydro.h).
enum class RadiationKind : std::uint8_t {
    convolution,  ///< A(∞), and the memory as a sum over past velocities.
    state_space,  ///< A(∞), and the memory as a state space.
    constant,     ///< A and B at one period, WaterHull::constant_period.
    none          ///< No radiation force; the coefficients only give the wave force.
};
/// Wave force that follows from coefficients.
enum class ExcitationKind : std::uint8_t {
    none,        ///< No force from coefficients.
    full,        ///< Total wave force; only for a hull without wave pressure on its mesh.
    scattering,  ///< Force of the scattered waves, in addition to the pressure on the mesh.
};

/// Drag of a strip of a hull, ½ρ C_dA |r·n| (r·n) n at a point. The water there has the relative
/// velocity r. Rows of strips along a hull resist drift and rotation.
struct HullStrip {
    Vec3 at{0.0, 0.0, 0.0};    ///< Point from the centre of mass, in the body's frame [m].
    Vec3 axis{0.0, 1.0, 0.0};  ///< Direction n, unit length.
    double drag_area = 0.0;    ///< C_d A at the design draught [m²].
};

/// Linear hydrostatics for small motions, instead of those of a mesh.
struct LinearStatics {
    bool on = false;           ///< True: linear hydrostatics replace those of the mesh.
    double height = 0.0;       ///< z of the centre of mass at rest, above still water [m].
    double weight = kDefault;  ///< Weight of the displaced water at rest [N]; default: that of the
                               ///< body.
};

/// Definition of the hull of a rigid body, an entry of SeaDef::hulls.
struct WaterHull {
    BodyId body{};    ///< Body of kind rigid. Required.
    HullMesh mesh{};  ///< Closed mesh in the body's frame, from its centre of mass [m]. Required.
    /// False: hydrostatic pressure ρg(η − z) below the surface. True: pressure of Airy waves
    /// (Froude-Krylov).
    bool wave_pressure = true;
    /// Added mass A along and about the body's axes at the centre of mass, when afloat [kg, kg m²].
    /// It acts relative to the mean motion of the water.
    std::array<double, 6> added_mass{};
    std::array<double, 6> damping{};  ///< Linear damping B, likewise [N s/m, N m s].
    /// C_d A of the wet hull and of the part above water at the design draught, at the centre of
    /// mass [m²]. The wind is that at 10 m, or at the centre of mass if that is higher.
    Vec3 drag_area{0.0, 0.0, 0.0};
    Vec3 wind_area{0.0, 0.0, 0.0};
    /// Distance from the surface to the lowest point of the mesh, upright [m]. Default: the draught
    /// at which the hull carries its body and the bodies joined to it. Their mass is divided among
    /// their hulls by volume. If the hull does not float or has no mass, the initial draught is
    /// used. If that is not between 0 and the height of the mesh, the height is used.
    double design_draught = kDefault;
    std::vector<HullStrip> strips{};  ///< Drag strips.
    /// Coefficients of hydro.h; null: none. Shared and constant.
    std::shared_ptr<const WaveCoefficients> coefficients{};
    RadiationKind radiation = RadiationKind::convolution;  ///< Model of the radiation force.
    double memory = 60.0;                                  ///< Duration T of the memory [s].
    int order = 8;                                         ///< Largest order of the state space.
    double constant_period = 0.0;                      ///< Period of RadiationKind::constant [s].
    ExcitationKind excitation = ExcitationKind::none;  ///< Coefficients of the wave force.
    /// True: mean and slow drift. It is the sum, over components with one sign of D, of |Σ a √|D|
    /// e^{iθ}|², whose mean is Σ a² D. Source: J. N. Newman, "Second-order, slowly-varying forces
    /// on vessels in irregular waves", 1974, as a square.
    bool drift = false;
    /// True: Coriolis and centripetal forces of A, −ω × (A ν)₁ and −v × (A ν)₁ − ω × (A ν)₂ (G.
    /// Kirchhoff, 1869). False if the drift coefficients include them in their means.
    bool coriolis = false;
    /// Time constant of the hull's slow position in the waves [s]. Position and heading follow by
    /// four lags, 4 L³ − 3 L⁴, without delay at constant speed.
    double slow_time = 16.0;
    LinearStatics linear{};  ///< If on, `mesh` may be empty, and `coefficients` contain the
                             ///< stiffness.
};

/// Memory of a hull, for inspection and verification.
struct HullMemory {
    RadiationKind kind = RadiationKind::none;
    double step = 0.0;  ///< Time between samples [s].
    /// Mean velocities ν̄ of past steps at the reference point, body's axes, newest first.
    std::vector<std::array<double, 6>> past{};
    std::array<double, 6> last{};  ///< Velocity ν before the last step.
    bool begun = false;            ///< True if `last` is set.
    /// State space dx/dt = A x + B ν̄ with the memory force C x: states x, and A, B, C row by row.
    std::vector<double> states{}, a{}, b{}, c{};
    Matrix6 first = Matrix6::Zero();  ///< Retardation function K(0) in use.
    Matrix6 added = Matrix6::Zero();  ///< Constant damping that was added so that the hull adds no
                                      ///< energy.
    double fit_error = 0.0;           ///< Largest ‖K − C e^{At} B‖ over ‖K(0)‖, scaled entries [1].
    std::array<double, 3> lag[4]{};   ///< Slow x, y and heading after each lag [m, m, rad].
};
/// Return the memory of a hull.
/// @param i  Index in SeaDef::hulls.
/// @throws DefError if the hull does not exist.
[[nodiscard]] HullMemory hull_memory(const World& world, std::size_t i);

}  // namespace hawser
