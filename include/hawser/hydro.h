// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro.h
/// Coefficients of a floating body in waves: added mass, damping, excitation, drift, motions.
///
/// Programs that solve for the potential of the flow about a body at rest (WAMIT, NEMOH, Capytaine)
/// give them by frequency and direction; hydro_files.h reads them. All of them here are
/// dimensional, in SI units, about the point `reference`, along the body's axes, and in one
/// convention:
/// ```
///     η = Re a e^{i(k·x − ωt)}          F = Re X a e^{−iωt}, x = 0 at the reference
///     M v̇ + A(ω) v̇ + B(ω) v + C x = F
/// ```
/// so that in long waves a free heave force is in phase with η and a surge force towards x > 0 runs
/// a quarter of a period before it, X = −i|X|. WAMIT has e^{+iωt}: X is its conjugate. NEMOH and
/// Capytaine have e^{−iωt}. A direction is the one to which waves run.
///
/// In time (W. E. Cummins, "The impulse response function and ship motions", 1962)
/// ```
///     F = −A(∞) v̇ − ∫₀^T K(τ) v(t − τ) dτ,      K(t) = (2/π) ∫ B(ω) cos ωt dω
/// ```
/// A(∞) joins the body's block. B is taken as linear between frequencies, 0 at ω = 0, and as ω⁻³
/// above the last one, of which there are nodes up to four times that one: where B is positive
/// semi-definite at each node, it is so between them.
///
/// *Convolution*: with ν̄_k the mean of the velocities before and after t_k,
/// ```
///     F_k = −½ h K(0) ν̄_k − Σ_{m≥1} h K(mh) ν̄_{k−m}
/// ```
/// whose first term is implicit, as damping. The damping of this sum at ω is Σ_n B(ω + 2πn/h)
/// (Poisson): it can make no energy, at any step; what its end after T takes from that is made good
/// by a constant damping, reported.
///
/// *State space*: K(t) ≈ C e^{At} B of at most a given order, by singular values of the matrix of
/// K((i + j) δ) (S.-Y. Kung, "A new identification and model reduction algorithm", 1978). Where
/// its damping falls below zero, as much is added as constant damping: reported, with the fit
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

/// Coefficients of one body.
struct WaveCoefficients {
    /// The point they are about, from the body's centre of mass, in its frame [m].
    Vec3 reference{0.0, 0.0, 0.0};
    std::vector<double> frequency{};  ///< ω, ascending, above 0 [rad/s].
    /// A(ω), B(ω): one a frequency, or none [kg, kg m, kg m²; N s/m, N s, N m s].
    std::vector<Matrix6> added_mass{}, damping{};
    bool has_infinite = false, has_zero = false;
    Matrix6 infinite = Matrix6::Zero();  ///< A(∞).
    Matrix6 zero = Matrix6::Zero();      ///< A(0): for checks alone.
    std::vector<double> heading{};       ///< Directions to which waves run, ascending [rad].
    /// X of all of the waves' force, of what the body scatters alone, and of motions at the
    /// reference [N/m, N; 1, rad/m]; empty: not known. Entry (heading, frequency, k) at index().
    std::vector<std::complex<double>> excitation{}, scattering{}, motion{};
    /// Mean second-order force of regular waves, over a² [N/m², N/m], by frequency and heading.
    std::vector<double> drift{};
    bool has_stiffness = false;
    Matrix6 stiffness = Matrix6::Zero();  ///< C, with that of weight [N/m, N, N m].

    [[nodiscard]] std::size_t index(std::size_t head, std::size_t freq, int k) const noexcept {
        return (head * frequency.size() + freq) * 6 + static_cast<std::size_t>(k);
    }
};

/// What is wrong with coefficients, in words with the place; "": nothing. Sizes, order, what is not
/// finite; A(∞) and B not positive semi-definite, with the frequency; A(0) and A(∞) swapped, told
/// by what the damping makes of A(ω) (T. F. Ogilvie, 1964).
[[nodiscard]] std::string coefficients_fault(const WaveCoefficients& c);

/// Treatment of damping that is not positive semi-definite.
enum class NegativeDamping : std::uint8_t {
    refuse,    ///< coefficients_fault() names it.
    truncate,  ///< B from the first such frequency on falls as ω⁻³ from that of the one before.
    fit        ///< B of each such frequency becomes the nearest positive semi-definite matrix.
};
/// Repair damping beyond the noise that coefficients_fault() accepts; others stay as they are.
/// @throws DefError where `truncate` has no frequency before.
[[nodiscard]] WaveCoefficients repaired_damping(const WaveCoefficients& c, NegativeDamping how);

/// End of a memory: the largest |K_ij(t)|/√(K_ii(0) K_jj(0)) for t from 0.8 T to T, and the
/// shortest T for which it is at most `limit`; NaN: none up to 20 T.
struct MemoryEnd {
    double ratio = 0.0;
    double enough = 0.0;  ///< [s]
};
[[nodiscard]] MemoryEnd memory_end(const WaveCoefficients& c, double memory, double limit = 0.01);

/// A(∞) = A(ω) + (1/ω) ∫ K(t) sin ωt dt, the mean over frequencies (Ogilvie). A(ω) and B(ω) are
/// needed.
[[nodiscard]] Matrix6 infinite_added_mass(const WaveCoefficients& c);

/// K(t) of the damping as it is, without an end [kg/s², …].
[[nodiscard]] Matrix6 retardation(const WaveCoefficients& c, double t);

}  // namespace hawser
