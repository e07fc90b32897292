// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drag.h
/// Compute water loads on a node: half elements of lines, and small bodies (hawser/sea.h).
///
/// **Lines.** r is the velocity of the water relative to the node, t the direction of the element.
/// Drag is added together with its tangent, which is positive semi-definite:
/// ```
///     f = c_n |r_n| r_n + c_t |r_t| r_t       D = c_n (|r_n| P + r_n r_nᵀ/|r_n|) + 2 c_t |r_t| t
///     tᵀ
/// ```
/// with P = E − t tᵀ. A half element extends from z to z_m and has the diameter d. Its wetted
/// fraction is the part of [min − d/2, max + d/2] below the surface. Its buoyancy then has the
/// stiffness ρ g V/(|z_m − z| + d).
///
/// **Bodies** have a potential of drag, Φ = ⅓ (rᵀ B r)^{3/2} with B = diag(c_i^{2/3}) in the body's
/// axes. Along an axis f = c_i |r_i| r_i; a body with equal c_i has f = c |r| r:
/// ```
///     f = q B r,   D = q B + B r (B r)ᵀ/q,   q = √(rᵀ B r)
/// ```
/// The stiffness of buoyancy is the secant to the position at which the body leaves the water. If
/// the body pierces the surface, this is the tangent. Below the surface it prevents a step from
/// throwing a light body out of the water.
///
/// Matrices are sums of a aᵀ, entry by entry. Rounding therefore cannot make them indefinite.

#include <hawser/sea.h>

namespace hawser::marine {

/// Symmetric 3×3 matrix, stored as xx, yx, yy, zx, zy, zz.
struct Sym3 {
    double m[6] = {};

    /// Add c a aᵀ to the symmetric matrix.
    void add(double c, const Vec3& a) noexcept {
        const double x = c * a.x(), y = c * a.y(), z = c * a.z();
        m[0] += x * a.x();
        m[1] += y * a.x();
        m[2] += y * a.y();
        m[3] += z * a.x();
        m[4] += z * a.y();
        m[5] += z * a.z();
    }
    /// Add c (t² E − t tᵀ) without cancellation, so that no diagonal entry is negative.
    void add_across(double c, const Vec3& t) noexcept {
        const double xx = t.x() * t.x(), yy = t.y() * t.y(), zz = t.z() * t.z();
        m[0] += c * (yy + zz);
        m[1] -= c * t.x() * t.y();
        m[2] += c * (xx + zz);
        m[3] -= c * t.x() * t.z();
        m[4] -= c * t.y() * t.z();
        m[5] += c * (xx + yy);
    }
    [[nodiscard]] Vec3 operator*(const Vec3& v) const noexcept {
        return {m[0] * v.x() + m[1] * v.y() + m[3] * v.z(),
                m[1] * v.x() + m[2] * v.y() + m[4] * v.z(),
                m[3] * v.x() + m[4] * v.y() + m[5] * v.z()};
    }
};

/// Load of a system on a body: f − A v̇ − D v − K (x − x_k).
struct PointLoad {
    Vec3 force{0.0, 0.0, 0.0};
    Sym3 mass{}, damping{}, stiffness{};
    bool any = false;  ///< Something is wet, or in the wind.
};

/// Position and velocity of a node.
struct PointMotion {
    Vec3 position, velocity;
};

/// Density [kg/m³] and gravity [m/s²] of the water.
struct WaterLaw {
    double density, gravity;
};

/// Half element next to a node.
struct HalfElement {
    double length = 0.0;         ///< Length of the half [m].
    Vec3 middle{0.0, 0.0, 0.0};  ///< Middle of the element [m].
    Vec3 along{0.0, 0.0,
               0.0};  ///< Unit vector t; zero if unknown: all directions count as transverse.
    const LineWater* of = nullptr;
};

/// Straight piece of a slender body, with its wetted fraction.
struct WetPiece {
    const LineWater* of;
    Vec3 t;         ///< Along it.
    double length;  ///< [m].
    double wet;     ///< 0 to 1.
};
/// Terms of Morison's formula for a piece.
struct PieceWater {
    Vec3 across, along;      ///< r_n, r_t [m/s].
    double fast, slide;      ///< Their sizes [m/s].
    double cn, ct;           ///< c_n, c_t [N s²/m²].
    double displaced, mass;  ///< Mass of the displaced water, and of its wetted fraction [kg].
    Vec3 drag;               ///< c_n |r_n| r_n + c_t |r_t| r_t [N].
    Vec3 wave;               ///< Force of the accelerated water [N].
};
[[nodiscard]] PieceWater water_past(const WetPiece& piece, const Vec3& velocity,
                                    const WaterPoint& water, double density) noexcept;

/// Return the fraction of the range [low, low + spread] that is below the surface, 0 to 1.
[[nodiscard]] double wet_fraction(double surface, double low, double spread) noexcept;

void add_half_element(const HalfElement& half, const PointMotion& lump, const WaterPoint& water,
                      const WaterLaw& law, PointLoad& out) noexcept;

/// Add the drag q B r of a body and its tangent. @param axes  Axes of the body, as columns. @param
/// areas  C_d A along these axes [m²].
void add_body_drag(const Mat3& axes, const Vec3& areas, double half_density, const Vec3& flow,
                   const Vec3& velocity, Vec3& force, Sym3& damping) noexcept;

/// Add the water loads on a small body. @param height  Height of the body, not 0 [m].
void add_body_water(const WaterBody& body, double height, const Mat3& axes,
                    const PointMotion& motion, const WaterPoint& water, const Vec3& wind,
                    double air, const WaterLaw& law, PointLoad& out) noexcept;

}  // namespace hawser::marine
