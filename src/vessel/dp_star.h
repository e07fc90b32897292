// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_star.h
/// Capacity stars of thrusters and the program that allocates loads to them
/// (hawser/dp_capability.h).

#include <hawser/dp_capability.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace hawser::vessel {

using Force2 = Eigen::Vector2d;

/// Convex sector: hull of the origin and of vertices in ascending direction.
struct Fan {
    std::vector<Force2> vertices{};
};

/// Capacity star of a thruster as a union of convex sectors.
struct Star {
    std::vector<Fan> fans{};  ///< Empty: no thrust.
    double power = 0.0;       ///< P_B [W].
    int board = -1;           ///< Index of its switchboard; −1: none.
    double x = 0.0, y = 0.0;  ///< Place [m].
};

/// Smallest factor U with f ∈ U · star. @return Infinite if no factor has f in the star.
[[nodiscard]] double gauge(const Star& star, const Force2& f) noexcept;
/// The same of one fan.
[[nodiscard]] double gauge(const Fan& fan, const Force2& f) noexcept;

/// Angle between vertices of the polygon in the circle of an azimuth: that of the published
/// solution of the test ship (docs/vessels.md) [rad].
inline constexpr double kArcStep = 0.17453292519943295;

/// Compute the star of a thruster after all losses; no fans if it failed.
/// @param arc_step  Vertices of arcs lie at its multiples, at the ends of sectors and dips, and at
/// each degree in the dip of a skeg [rad].
[[nodiscard]] Star capacity_star(const DpShip& ship, std::size_t thruster, const DpCondition& at,
                                 double from, const std::vector<bool>& failed,
                                 double arc_step = kArcStep);

/// Smallest U for a load: branch and bound over fans, a linear program in each node.
/// @param boards  Power that each switchboard has for thrusters [W].
[[nodiscard]] DpUtilisation smallest_utilisation(const std::vector<Star>& stars,
                                                 const std::vector<double>& boards,
                                                 const DpLoad& load);

}  // namespace hawser::vessel
