// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_star.h
/// Compute capacity stars of thrusters, and allocate loads to them (hawser/dp_capability.h).

#include <hawser/dp_capability.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace hawser::vessel {

using Force2 = Eigen::Vector2d;

/// Convex sector: convex hull of the origin and of vertices in ascending direction.
struct Fan {
    std::vector<Force2> vertices{};
};

/// Capacity star of a thruster as a union of convex sectors.
struct Star {
    std::vector<Fan> fans{};  ///< Empty: no thrust.
    double power = 0.0;       ///< P_B [W].
    int board = -1;           ///< Index of its switchboard; −1: none.
    double x = 0.0, y = 0.0;  ///< Position [m].
};

/// Return the smallest factor U with f ∈ U · star; infinite if there is none.
[[nodiscard]] double utilisation_factor(const Star& star, const Force2& f) noexcept;
/// Return the smallest factor U with f ∈ U · fan; infinite if there is none.
[[nodiscard]] double utilisation_factor(const Fan& fan, const Force2& f) noexcept;

/// Angle between vertices of the polygon in the circle of an azimuth: that of the published
/// solution of the test ship (docs/vessels.md) [rad].
inline constexpr double kArcStep = 0.17453292519943295;

/// Compute the thrust diagram (star) of a thruster after all losses; it is empty if the thruster
/// failed.
/// @param arc_step  Vertices of arcs lie at its multiples, at the ends of sectors and dips, and at
/// each degree in the dip of a skeg [rad].
[[nodiscard]] Star capacity_star(const DpShip& ship, std::size_t thruster, const DpCondition& at,
                                 double from, const std::vector<bool>& failed,
                                 double arc_step = kArcStep);

/// Return the smallest U for a load, by branch and bound over fans with a linear program in each
/// node.
/// @param boards  Power of each switchboard for thrusters [W].
[[nodiscard]] DpUtilisation smallest_utilisation(const std::vector<Star>& stars,
                                                 const std::vector<double>& boards,
                                                 const DpLoad& load);

}  // namespace hawser::vessel
