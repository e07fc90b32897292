// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// Limits of the monitors of a world (World::verdict()).
///
/// Monitors check the states of a run. Each compares a measure with two limits. Above the first
/// (`doubtful`) the result is suspect; above the second (`wrong`) the step fails.
///
/// The *exchanged energy* is the kinetic energy plus half of the absolute changes of kinetic,
/// gravity and elastic energy and of all works. The changes decay with kMemory. Definitions, and
/// the reason of each limit: docs/limits.md.

namespace hawser {

/// Limits of a measure, in its unit.
struct Limit {
    double doubtful, wrong;  ///< Values above which the result is suspect, and the step fails.
};

namespace limit {
/// Created energy over exchanged energy [1]: mechanical energy gained beyond the work of forces,
/// drives, friction and contacts.
inline constexpr Limit kCreated{0.009, 0.2};
/// Created energy over exchanged energy [1], if the elastic energy of lines follows from their
/// lengths instead of their forces, and the rise lasts for 0.3 s.
inline constexpr Limit kHeld{0.05, 0.2};
/// Rise of unexplained energy over exchanged energy [1]: created energy plus the energy that rows
/// and drag dissipated. A gain may hide in those losses.
inline constexpr Limit kHidden{1.0, 2.0};
/// Fall of unexplained energy over exchanged energy [1].
inline constexpr Limit kLost{0.1, 0.3};
/// Largest compliance of a joint whose violation counts as a gap [m/N].
inline constexpr double kMeantRigid = 1e-10;
/// Gap of a rigid joint [m], and also gap over the size of the smaller body [1]; both must be
/// exceeded.
inline constexpr Limit kOpen{0.005, 0.05};
/// Penetration depth over the thickness of the thinner shape [1].
inline constexpr Limit kDeep{0.5, 1.0};
/// Deviation of a taut element from its law, |l − l₀(1 + T/EA)|/l₀ [1].
inline constexpr Limit kCable{0.03, 0.15};
/// Largest strain of an element [1], and multiple of its strain at the breaking load [1]; the
/// larger limit applies. The strain is the larger one of those by length and by tension.
inline constexpr double kMostStrain = 0.5, kMostBreaking = 8.0;
/// Residual of momentum or of the contact law [1], if it lasts for kSustained.
inline constexpr Limit kCertificate{1e-3, 0.1};
/// Fraction of the recent steps with failed constraint iterations above which a run is suspect [1].
/// Recent: mean with the time constant kMemory.
inline constexpr double kIncomplete = 0.01;
inline constexpr Limit kTurn{0.5, 20.0};   ///< Rotation of a body or element in a step [rad].
inline constexpr double kMemory = 10.0;    ///< Decay time of exchanged energy and extrema [s].
inline constexpr double kMean = 0.5;       ///< Averaging time of energies that fail a step [s].
inline constexpr double kSustained = 0.5;  ///< Duration above which a residual counts [s].
inline constexpr double kLook = 0.1;       ///< Interval between samples of a large scene [s], at
                                           ///< least a step. Small scenes: every step.
inline constexpr double kSettled = 3.0;  ///< Decay time of the allowance for initial gaps [steps].
/// Energies that count as zero: kNothing times the kinetic and elastic energy [1], or the energy to
/// lift all bodies by kNothingHigher [m].
inline constexpr double kNothing = 1e-6, kNothingHigher = 1e-4;
}  // namespace limit

}  // namespace hawser
