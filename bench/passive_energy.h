// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file passive_energy.h
/// Energy test of scenes without motors and without sea.
///
/// M = K + G + E − W is the mechanical energy less the work of applied forces, all at the half step
/// (hawser::Energy). It must not rise. A rise counts if it lasts for 0.3 s:
/// ```
///     rise = max over t of  min M[t − 0.3 s, t] − min M[0, t − 0.3 s]
///     exchanged = max(largest kinetic energy, M(start) − least M, 1 J)
/// ```
/// K contains added mass. At least five samples form a window.

#include <hawser/hawser.h>

#include <vector>

namespace hawser::bench {

class PassiveEnergy {
  public:
    void sample(const World& world);

    struct Rise {
        double fraction = 0.0;  ///< Rise over exchanged energy.
        double joules = 0.0;
        double at = 0.0;  ///< End of the window [s].
    };
    /// @param step  Step of the run [s].
    [[nodiscard]] Rise largest(double step) const;

    /// Limit of the fraction in a run that ends ok.
    static constexpr double kLimit = 0.05;

  private:
    std::vector<double> energy_;  ///< M of each step [J].
    double kinetic_ = 0.0;        ///< Largest kinetic energy [J].
};

}  // namespace hawser::bench
