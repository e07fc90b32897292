// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file flow.h
/// Motion of a vessel through the water, and forces on it, both at O in the marine frame
/// (hawser/vessel_hull.h).

#include <Eigen/Core>

namespace hawser::vessel {

/// Forces X, Y, Z [N] and moments K, M, N [N m].
using Wrench = Eigen::Matrix<double, 6, 1>;

struct Flow {
    Wrench motion = Wrench::Zero();  ///< u v w p q r, through the water [m/s, rad/s].
    double roll = 0.0;               ///< φ [rad].
    double rudder = 0.0;             ///< Rudder angle δ of the coefficient set [rad].
    double rps = 0.0;                ///< Revolutions n of the coefficient set [1/s].
    double density = 1025.0;         ///< [kg/m³].

    [[nodiscard]] double u() const noexcept { return motion[0]; }
    [[nodiscard]] double v() const noexcept { return motion[1]; }
    [[nodiscard]] double p() const noexcept { return motion[3]; }
    [[nodiscard]] double r() const noexcept { return motion[5]; }
};

}  // namespace hawser::vessel
