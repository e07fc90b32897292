// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// What the states of a world are judged by, World::verdict(). The reason of each is in
/// docs/limits.md.

namespace hawser {

/// Beyond `doubtful` a result is that, beyond `wrong` a step is refused.
struct Limit {
    double doubtful, wrong;
};

namespace limit {
/// Mechanical energy that came from nothing, over what was exchanged.
inline constexpr Limit kCreated{0.009, 0.2};
/// The same with lines by their lengths, whatever they exert, where it lasts.
inline constexpr Limit kHeld{0.05, 0.2};
/// Created energy with all that rows and drag took added to it, which may hide some: over what was
/// exchanged.
inline constexpr Limit kHidden{1.0, 2.0};
/// Energy that went without reason, over what was exchanged.
inline constexpr Limit kLost{0.1, 0.3};
/// What a joint softer than nothing, but no softer than this, may give is a gap [m/N].
inline constexpr double kMeantRigid = 1e-10;
inline constexpr Limit kOpen{0.005, 0.05};  ///< [m], and over the size of the smaller body.
/// How deep bodies lie in each other, over the thickness of the thinner shape.
inline constexpr Limit kDeep{0.5, 1.0};
inline constexpr Limit kCable{0.03, 0.15};  ///< |l − l₀(1 + T/EA)|/l₀.
/// What no material bears, by its tension or its length: strain, and over that of the breaking
/// load.
inline constexpr double kMostStrain = 0.5, kMostBreaking = 8.0;
inline constexpr Limit kCertificate{1e-3, 0.1};  ///< Relative, for kSustained.
/// Share of the steps of kMemory whose iterations of rigid joints failed.
inline constexpr double kIncomplete = 0.01;
inline constexpr Limit kTurn{0.5, 20.0};   ///< Of a body or an element in a step [rad].
inline constexpr double kMemory = 10.0;    ///< Of what was exchanged [s].
inline constexpr double kMean = 0.5;       ///< Of energies that refuse a step [s].
inline constexpr double kSustained = 0.5;  ///< [s].
inline constexpr double kLook = 0.1;       ///< From look to look [s], at least a step.
inline constexpr double kSettled = 3.0;    ///< What stands open at the start closes [steps].
/// Energy that is nothing: of kinetic and elastic energy, and of all bodies this much higher [m].
inline constexpr double kNothing = 1e-6, kNothingHigher = 1e-4;
}  // namespace limit

}  // namespace hawser
