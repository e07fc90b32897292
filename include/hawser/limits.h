// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// Limits of the monitors of a world, World::verdict(). docs/limits.md states the reason of each.

namespace hawser {

/// Limits of a value. Beyond `doubtful` a result is suspect; beyond `wrong` a step fails.
struct Limit {
    double doubtful, wrong;
};

namespace limit {
/// Created mechanical energy relative to the exchanged energy.
inline constexpr Limit kCreated{0.009, 0.2};
/// The same with the energy of lines by their lengths, independent of their forces, if it lasts.
inline constexpr Limit kHeld{0.05, 0.2};
/// Created energy plus the losses of rows and drag, which may hide a gain, relative to the
/// exchanged energy.
inline constexpr Limit kHidden{1.0, 2.0};
/// Unexplained loss of energy relative to the exchanged energy.
inline constexpr Limit kLost{0.1, 0.3};
/// Largest compliance at which the violation of a joint counts as a gap [m/N].
inline constexpr double kMeantRigid = 1e-10;
/// Gap [m], and relative to the size of the smaller body.
inline constexpr Limit kOpen{0.005, 0.05};
/// Penetration depth relative to the thickness of the thinner shape.
inline constexpr Limit kDeep{0.5, 1.0};
inline constexpr Limit kCable{0.03, 0.15};  ///< |l − l₀(1 + T/EA)|/l₀.
/// Strain above the range of materials, and multiple of the strain at the breaking load. Values
/// come from the tension or the length.
inline constexpr double kMostStrain = 0.5, kMostBreaking = 8.0;
inline constexpr Limit kCertificate{1e-3, 0.1};  ///< Relative residual that lasts for kSustained.
/// Fraction of the steps of kMemory with failed iterations of rigid joints.
inline constexpr double kIncomplete = 0.01;
inline constexpr Limit kTurn{0.5, 20.0};   ///< Rotation of a body or element in a step [rad].
inline constexpr double kMemory = 10.0;    ///< Decay time of exchanged energy and extrema [s].
inline constexpr double kMean = 0.5;       ///< Averaging time of energies that fail a step [s].
inline constexpr double kSustained = 0.5;  ///< Duration of a lasting residual [s].
inline constexpr double kLook = 0.1;       ///< Sampling interval [s], at least a step.
inline constexpr double kSettled = 3.0;    ///< Steps in which initial gaps decay.
/// Energies that count as zero: relative to kinetic and elastic energy, and a height of all bodies
/// [m].
inline constexpr double kNothing = 1e-6, kNothingHigher = 1e-4;
}  // namespace limit

}  // namespace hawser
