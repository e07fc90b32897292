// SPDX-License-Identifier: Apache-2.0
/// @file
/// Building blocks of the scenes of the comparison.
#pragma once

#include "scenes.h"

#include <vector>

namespace hawser::bench {

inline constexpr double kShipMass = 4e6;                           ///< [kg]
inline constexpr double kShipHeave = 80.0 * 18.0 * 1025.0 * 9.81;  ///< Water plane 80 x 18 m [N/m].

/// Solid box at rest, its axes those of the world.
[[nodiscard]] Body box(double mass, const Vec3& half, const Vec3& at);

/// Yaw and pitch that turn the body x axis into `d`.
[[nodiscard]] Quat along_x(const Vec3& d);

/// Solid cylinder from `p` to `q`, its body x axis along the cylinder.
[[nodiscard]] Body link(double mass, double radius, const Vec3& p, const Vec3& q);

/// Ball joint of two bodies of `s`, or a body and the world, at a point of the world.
void join(Scene& s, int a, int b, const Vec3& at);

/// Adds a body. @return its index.
int add(Scene& s, const Body& b);

/// Links between consecutive `nodes`, with ball joints to `from`, between links and to `to`.
/// @return the index of the first joint; the last one is that plus the number of links.
int chain(Scene& s, int from, int to, const std::vector<Vec3>& nodes, double mass, double radius,
          double drag = 0.0);

/// Lets a body float: weightless, with a heave spring, damping, and roll and pitch stiffness.
void float_hull(Scene& s, int body, double heave_k);

}  // namespace hawser::bench
