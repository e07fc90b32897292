// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drag.h
/// What water does to a lump: half elements of lines, and small bodies (hawser/sea.h).
///
/// **Lines.** r is the velocity of the water past the lump, t the direction of the element. Drag
/// goes in with its tangent, which is positive semi-definite:
/// ```
///     f = c_n |r_n| r_n + c_t |r_t| r_t       D = c_n (|r_n| P + r_n r_nᵀ/|r_n|) + 2 c_t |r_t| t
///     tᵀ
/// ```
/// with P = E − t tᵀ. A half element from z to z_m of a line of diameter d is wet by the share of
/// [min − d/2, max + d/2] that is below the surface, of which buoyancy has the stiffness
/// ρ g V/(|z_m − z| + d).
///
/// **Bodies** have a potential of drag, Φ = ⅓ (rᵀ B r)^{3/2} with B = diag(c_i^{2/3}) in the body's
/// axes, so that along an axis f = c_i |r_i| r_i and a body with equal c_i has c |r| r:
/// ```
///     f = q B r,   D = q B + B r (B r)ᵀ/q,   q = √(rᵀ B r)
/// ```
/// The stiffness of buoyancy is the secant to where the body is out of the water: where it pierces
/// the surface its tangent, below it what keeps a light body from being thrown out by a step in
/// which its buoyancy would have ended.
///
/// Matrices are sums of a aᵀ, entry by entry to rounding, so that no rounding makes them
/// indefinite.

#include <hawser/sea.h>

namespace hawser::marine {

/// A symmetric matrix of three rows: xx, yx, yy, zx, zy, zz.
struct Sym3 {
    double m[6] = {};

    /// += c a aᵀ.
    void add(double c, const Vec3& a) noexcept {
        const double x = c * a.x(), y = c * a.y(), z = c * a.z();
        m[0] += x * a.x();
        m[1] += y * a.x();
        m[2] += y * a.y();
        m[3] += z * a.x();
        m[4] += z * a.y();
        m[5] += z * a.z();
    }
    /// += c (t² E − t tᵀ), of no less than no entry by cancellation.
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

/// As a system puts it on a body: f − A v̇ − D v − K (x − x_k).
struct PointLoad {
    Vec3 force{0.0, 0.0, 0.0};
    Sym3 mass{}, damping{}, stiffness{};
    bool any = false;  ///< Something is wet, or in the wind.
};

/// What a lump does: place and velocity.
struct PointMotion {
    Vec3 position, velocity;
};

/// Density and gravity.
struct WaterLaw {
    double density, gravity;
};

/// A half element at a lump.
struct HalfElement {
    double length = 0.0;         ///< Of the half [m].
    Vec3 middle{0.0, 0.0, 0.0};  ///< Of the element [m].
    Vec3 along{0.0, 0.0, 0.0};   ///< t; zero: nobody knows, all directions are across.
    const LineWater* of = nullptr;
};

/// A straight piece of what is slender, and the share of it that is wet.
struct WetPiece {
    const LineWater* of;
    Vec3 t;         ///< Along it.
    double length;  ///< [m].
    double wet;     ///< 0 to 1.
};
/// Morison's formula on such a piece.
struct PieceWater {
    Vec3 across, along;      ///< r_n, r_t [m/s].
    double fast, slide;      ///< Their sizes [m/s].
    double cn, ct;           ///< c_n, c_t [N s²/m²].
    double displaced, mass;  ///< Mass of the water that it displaces, and of the wet share [kg].
    Vec3 drag;               ///< c_n |r_n| r_n + c_t |r_t| r_t [N].
    Vec3 wave;               ///< Of the accelerated water [N].
};
[[nodiscard]] PieceWater water_past(const WetPiece& piece, const Vec3& velocity,
                                    const WaterPoint& water, double density) noexcept;

/// Of what reaches from `low` over `spread` up the share that is below the surface, 0 to 1.
[[nodiscard]] double wet_fraction(double surface, double low, double spread) noexcept;

void add_half_element(const HalfElement& half, const PointMotion& lump, const WaterPoint& water,
                      const WaterLaw& law, PointLoad& out) noexcept;

/// q B r and its tangent. @param axes  The body's, as columns. @param areas  C_d A.
void add_body_drag(const Mat3& axes, const Vec3& areas, double half_density, const Vec3& flow,
                   const Vec3& velocity, Vec3& force, Sym3& damping) noexcept;

/// A small body. @param height  Of it, not 0.
void add_body_water(const WaterBody& body, double height, const Mat3& axes,
                    const PointMotion& motion, const WaterPoint& water, const Vec3& wind,
                    double air, const WaterLaw& law, PointLoad& out) noexcept;

}  // namespace hawser::marine
