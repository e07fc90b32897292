// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull_forces.h
/// Compute resistance, cross-flow drag and polynomials of a hull (hawser/vessel_hull.h).

#include <hawser/vessel_hull.h>

#include "vessel/flow.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::vessel {

/// Variables of polynomials: first the lower-case letters, then their magnitudes.
enum Variable : std::uint8_t {
    kU,
    kV,
    kR,
    kP,
    kRoll,
    kRudder,
    kRevolutions,
    kDrift,
    kAbsV,
    kAbsR,
    kAbsRudder,
    kAbsRevolutions,
    kAbsDrift
};
inline constexpr int kVariableCount = 13;
inline constexpr std::size_t kMaxPowers = 8;

/// Return the index of the variable that a letter of a polynomial term denotes; −1 if there is
/// none.
[[nodiscard]] int variable_of(char letter) noexcept;

/// Polynomial prepared for evaluation.
class Polynomial {
  public:
    Polynomial() = default;
    /// Prepare a definition that has been checked. @param mass  Mass of the body [kg].
    Polynomial(const HullPolynomial& def, double mass);
    [[nodiscard]] Wrench force(const Flow& flow) const noexcept;

  private:
    struct Term {
        double value = 0.0;
        std::int32_t axis = 0, powers = 0;
        std::array<std::uint8_t, kMaxPowers> of{};
        bool driven = false;  ///< With rudder or revolutions.
        bool propulsive =
            false;  ///< True if the term balances the propeller; equal ahead and astern.
    };
    using Values = std::array<double, kVariableCount>;
    [[nodiscard]] double value(const Term& term, const Values& at) const noexcept;
    [[nodiscard]] Wrench sum(const Values& at, double ahead, double astern_u) const noexcept;
    [[nodiscard]] Wrench by_speed(const Flow& flow) const noexcept;
    [[nodiscard]] Wrench by_mass(const Flow& flow) const noexcept;

    HullPolynomial def_;
    double mass_ = 0.0;
    std::vector<Term> terms_;
};

/// Return X of a resistance curve or its formula [N].
[[nodiscard]] double surge_force(const HullResistance& def, double u) noexcept;
/// Return Y and N of cross-flow drag.
[[nodiscard]] Wrench cross_flow_force(const CrossFlow& def, const Flow& flow) noexcept;
/// Compute X, Y and N of a current load.
[[nodiscard]] Wrench current_force(const CurrentLoad& def, const Flow& flow) noexcept;

}  // namespace hawser::vessel
