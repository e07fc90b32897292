// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull_sums.h
/// Integrals over the wet part of a hull (hawser/hull.h).
///
/// All integrals except forces are sums over columns of water below the surface, with the base
/// −n_z dA of each triangle: of volume s, of its moment s x, s y and s (z + s/2), of the waterplane
/// 1, x, y, x², …. These are of second degree at most, for which the middles of a triangle's sides
/// are exact. A triangle that faces upwards has columns of the other sign, so that overlapping
/// columns count once.

#include <hawser/hull.h>

#include <cstddef>
#include <cstdint>

namespace hawser::marine {

/// Position, depth and pressure of a corner of a hull.
struct HullCorner {
    Vec3 x{0.0, 0.0, 0.0};  ///< [m].
    double depth = 0.0;     ///< s, above 0 wet [m].
    double pressure = 0.0;  ///< Where wet [Pa].
};

struct HullSums {
    Vec3 force{0.0, 0.0, 0.0};   ///< [N].
    Vec3 torque{0.0, 0.0, 0.0};  ///< Moment about the origin of corners [N m].
    double volume = 0.0;         ///< [m³].
    Vec3 moment{0.0, 0.0, 0.0};  ///< ∫ x dV [m⁴].
    double plane = 0.0;          ///< Waterplane [m²].
    double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;  ///< Its moments [m³, m⁴].

    void add(const HullSums& other) noexcept;
    /// Add the wet part of a triangle.
    void add_triangle(const HullCorner& a, const HullCorner& b, const HullCorner& c) noexcept;

  private:
    void add_wet(const HullCorner& a, const HullCorner& b, const HullCorner& c) noexcept;
};

/// Compute ∫ r rᵀ dA over the waterplane for heave, roll and pitch, with r = (1, y, −x). Entries:
/// (0,0), (1,0), (1,1), (2,0), (2,1), (2,2). The result is positive semi-definite despite rounding.
void plane_stiffness(const HullSums& sums, double (&out)[6]) noexcept;

}  // namespace hawser::marine
