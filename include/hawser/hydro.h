// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro.h
/// Hydrodynamic coefficients of a floating body in waves, by frequency and direction: added mass,
/// damping, excitation, drift, motions.
///
/// Potential flow programs (WAMIT, NEMOH, Capytaine) compute them by frequency and direction;
/// hydro_files.h reads their files. Coefficients here are dimensional, in SI units, about the point
/// `reference`, along the body's axes. They have one convention:
/// ```
///     η = Re a e^{i(k·x − ωt)}          F = Re X a e^{−iωt}, x = 0 at the reference
///     M v̇ + A(ω) v̇ + B(ω) v + C x = F
/// ```
/// Here η is the wave elevation, a its amplitude, X the complex force per amplitude, and A, B, C
/// are added mass, damping and stiffness. In long waves the heave force is in phase with η. A surge
/// force towards x > 0 leads η by a quarter of a period, X = −i|X|. WAMIT uses e^{+iωt}, so that
/// its X is the conjugate. NEMOH and Capytaine use e^{−iωt}. Directions are those to which waves
/// run.
///
/// *Time domain* (W. E. Cummins, "The impulse response function and ship motions", 1962). The
/// radiation force depends on past velocities through the retardation function K, with the memory
/// T:
/// ```
///     F = −A(∞) v̇ − ∫₀^T K(τ) v(t − τ) dτ,      K(t) = (2/π) ∫ B(ω) cos ωt dω
/// ```
/// A(∞) is part of the body's mass. B is linear between the given frequencies, 0 at ω = 0, and
/// proportional to ω⁻³ above the last one, with nodes up to four times the last frequency. If B is
/// positive semi-definite at each node, it is so between them.
///
/// *Convolution*. With ν̄_k the mean of the velocities before and after t_k,
/// ```
///     F_k = −½ h K(0) ν̄_k − Σ_{m≥1} h K(mh) ν̄_{k−m}
/// ```
/// The first term is implicit, like damping. The damping of this sum at ω is Σ_n B(ω + 2πn/h)
/// (Poisson), so that it adds no energy at any step. The truncation at T may reduce the damping. A
/// constant damping compensates for it, and is reported.
///
/// *State space*. A linear system of a given largest order approximates K(t) ≈ C e^{At} B. Its
/// matrices follow from the singular values of the matrix of K((i + j) δ). Source: S.-Y. Kung, "A
/// new identification and model reduction algorithm", 1978. If the damping of the approximation is
/// negative at a frequency, constant damping of that amount is added, and reported with the fit
/// error.

#include <hawser/math.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Hydrodynamic coefficients of one body.
struct WaveCoefficients {
    /// Reference point of the coefficients, from the body's centre of mass, in its frame [m].
    Vec3 reference{0.0, 0.0, 0.0};
    std::vector<double> frequency{};  ///< Frequencies ω, ascending, > 0 [rad/s].
    /// A(ω) and B(ω), one matrix for each frequency, or empty [kg, kg m, kg m²; N s/m, N s, N m s].
    std::vector<Matrix6> added_mass{}, damping{};
    bool has_infinite = false, has_zero = false;  ///< True if `infinite` or `zero` is known.
    Matrix6 infinite = Matrix6::Zero();           ///< Added mass at infinite frequency A(∞).
    Matrix6 zero = Matrix6::Zero();               ///< Added mass at frequency 0, for checks only.
    std::vector<double> heading{};  ///< Directions to which waves run, ascending [rad].
    /// Complex amplitudes per wave amplitude, by index(heading, frequency, component); empty:
    /// unknown. Total wave force, its scattered part [N/m, N], and motion at the reference point
    /// [1, rad/m].
    std::vector<std::complex<double>> excitation{}, scattering{}, motion{};
    /// Mean second-order force of regular waves over a² [N/m², N/m], by frequency and heading.
    std::vector<double> drift{};
    bool has_stiffness = false;           ///< True if `stiffness` is known.
    Matrix6 stiffness = Matrix6::Zero();  ///< Stiffness C, that of weight included [N/m, N, N m].

    /// Return the index of an amplitude by direction, frequency and component k, 0 to 5.
    [[nodiscard]] std::size_t index(std::size_t head, std::size_t freq, int k) const noexcept {
        return (head * frequency.size() + freq) * 6 + static_cast<std::size_t>(k);
    }
};

/// Check coefficients. Return their first fault in words, with its position or frequency; "": none.
/// Checks sizes, order, finite values, and that A(∞) and B are positive semi-definite. Detects
/// exchanged A(0) and A(∞) by comparison with A(ω) from the damping (T. F. Ogilvie, 1964).
[[nodiscard]] std::string coefficients_fault(const WaveCoefficients& c);

/// Treatment of damping that is not positive semi-definite.
enum class NegativeDamping : std::uint8_t {
    refuse,    ///< Report it by coefficients_fault().
    truncate,  ///< From the first such frequency on, B decreases as ω⁻³ from that of the frequency
               ///< before.
    fit        ///< Replace each such B by the nearest positive semi-definite matrix.
};
/// Return coefficients whose damping is repaired at frequencies where it is negative beyond the
/// noise that coefficients_fault() accepts. Other damping is unchanged.
/// @throws DefError if `truncate` has no frequency before the fault.
[[nodiscard]] WaveCoefficients repaired_damping(const WaveCoefficients& c, NegativeDamping how);

/// Result of memory_end(). The truncation measure of a memory T is the largest |K_ij(t)|/√(K_ii(0)
/// K_jj(0)) for t from 0.8 T to T.
struct MemoryEnd {
    double ratio = 0.0;  ///< Truncation measure of the given T [1].
    double enough =
        0.0;  ///< Shortest T whose measure is at most `limit` [s]; NaN: none up to 20 T.
};
/// Compute the truncation measure of a memory.
/// @param memory  Memory T [s].
/// @param limit  Permitted truncation measure [1].
[[nodiscard]] MemoryEnd memory_end(const WaveCoefficients& c, double memory, double limit = 0.01);

/// Compute A(∞) = A(ω) + (1/ω) ∫ K(t) sin ωt dt (Ogilvie), as the mean over all frequencies.
/// Requires A(ω) and B(ω).
[[nodiscard]] Matrix6 infinite_added_mass(const WaveCoefficients& c);

/// Return the retardation function K(t) of the given damping, without repair and truncation [kg/s²,
/// kg m/s², kg m²/s²].
/// @param t  Time [s].
[[nodiscard]] Matrix6 retardation(const WaveCoefficients& c, double t);

}  // namespace hawser
