// SPDX-License-Identifier: Apache-2.0
/// @file
/// Parts of the scenes of the comparison.
#pragma once

#include "scenes.h"

#include <vector>

namespace hawser::bench {

inline constexpr double kShipMass = 4e6;                           ///< [kg]
inline constexpr double kShipHeave = 80.0 * 18.0 * 1025.0 * 9.81;  ///< Water plane 80 x 18 m [N/m].

/// Make a solid box at rest, parallel to the world's axes.
[[nodiscard]] Body box(double mass, const Vec3& half, const Vec3& at);

/// Return the rotation by yaw and pitch of the body x axis to `d`.
[[nodiscard]] Quat along_x(const Vec3& d);

/// Make a solid cylinder from `p` to `q`, its body x axis along the cylinder.
[[nodiscard]] Body link(double mass, double radius, const Vec3& p, const Vec3& q);

/// Add a ball joint of two bodies of `s`, or a body and the world, at a point of the world.
void join(Scene& s, int a, int b, const Vec3& at);

/// Add a body. @return its index.
int add(Scene& s, const Body& b);

/// Add links between consecutive `nodes`, with ball joints to `from`, between links and to `to`.
/// @return index of the first joint; the last one is that plus the number of links.
int chain(Scene& s, int from, int to, const std::vector<Vec3>& nodes, double mass, double radius,
          double drag = 0.0);

/// Let a body float: weightless, with a heave spring, damping, and roll and pitch stiffness.
void float_hull(Scene& s, int body, double heave_k);

}  // namespace hawser::bench
