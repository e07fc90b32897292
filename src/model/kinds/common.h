// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file common.h
/// Define the form of an interaction kind. A kind is one struct in one file:
///
/// ```
/// struct Ball {
///     static constexpr KindInfo kInfo{…};         // name, bodies, rows, parameters, text
///     static constexpr int kBodies, kRows;        // the same numbers for the compiler
///     static constexpr Geometry kGeometry;        // type of geometric stiffness
///     struct Data {…};                            // data of evaluate(), doubles only
///     static Data make(const InteractionDef&);    // set-up (HAWSER_KIND_SETUP only)
///     static void complete(InteractionDef&, const Vec3* position);  // optional; set-up only:
///                                                 // defaults from the initial poses
///     static void defaults(const InteractionDef&, double h, RowSpec*);   // ε, τ of each row
///     static void evaluate(const Data&, const BodyRef*, Rows<kBodies, kRows>&);
///     static constexpr bool kCompletes;           // optional: a rigid joint whose rows a step
///                                                 // solves at its end (step/completion.h)
/// };
/// ```
/// The function evaluate() computes the violation g and the Jacobian G of each row for the given
/// poses. They satisfy ġ_r = Σ_b G_r,b · (v_b, ω_b). All vectors are in the world frame. A scalar
/// body uses column 0.

#include <hawser/interactions.h>

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

/// Pose of one body for evaluate(). Point masses and scalar bodies have the identity rotation.
struct BodyRef {
    V3 x;             ///< Centre of mass [m]; for a scalar body x.x is the coordinate.
    const double* r;  ///< Rotation matrix, row-major 3×3.
    bool rotates;     ///< False for point masses: attachment points are ignored.

    /// Convert an attachment point to a vector in the world frame [m].
    /// @param local  Point in the frame of the body.
    [[nodiscard]] V3 arm(const double* local) const {
        return rotates ? load9(r) * load3(local) : V3{0, 0, 0};
    }
};

/// Rows of one interaction; T is double, or a vector over several interactions (base/simd.h).
template <int B, int R, class T = double>
struct Rows {
    T g[R];        ///< Violation [m or rad]; for a velocity row the target speed u.
    T J[B][R][6];  ///< Jacobian: linear part, then angular part.

    void set(int b, int r, const V3T<T>& lin, const V3T<T>& ang) {
        T* p = J[b][r];
        p[0] = lin.x;
        p[1] = lin.y;
        p[2] = lin.z;
        p[3] = ang.x;
        p[4] = ang.y;
        p[5] = ang.z;
    }
};

/// Constant properties of a row.
struct RowSpec {
    double compliance = 1e-12;      ///< ε or γ.
    double damping_time = 0.0;      ///< τ [s].
    bool velocity = false;          ///< G v = u instead of g = 0.
    bool damped_by_scheme = false;  ///< τ is the scheme's own and belongs to no damper.
    bool gap = false;               ///< Translational constraint: counts in violation_max.
    bool turns = false;             ///< g is a difference of directions, at most 2.
    bool one_sided = false;         ///< Only pulls (λ ≤ 0).
    bool range = false;             ///< Inactive while inside its range.
    bool friction = false;          ///< Its force is bounded, and its anchor slides at the bound.
};

/// Type of geometric stiffness: none; from the arms of a joint; from a line between two points.
enum class Geometry : unsigned char { none, joint, line };

/// Compliance of stops and holds: ranges, friction, motors [m/N].
inline constexpr double kStopCompliance = 1e-12;

inline double given(double value, double fallback) { return value == value ? value : fallback; }

/// Set the damping time τ of a row to the value of the definition, or to two steps if the
/// definition has none.
inline void damping_or_flagged(const InteractionDef& def, double h, int row, RowSpec& out) {
    const double defined = def.damping_time.data()[row];
    out.damping_time = given(defined, 2.0 * h);
    out.damped_by_scheme = defined != defined;
}

/// Set ε and τ of an ordinary constraint. Without a definition it is rigid (or has `compliance`)
/// and τ is two steps.
inline void constraint_rows(const InteractionDef& def, double h, int first, int count, bool gap,
                            RowSpec* out, double compliance = 0.0) {
    for (int r = first; r < first + count; ++r) {
        out[r].compliance = given(def.compliance.data()[r], compliance);
        damping_or_flagged(def, h, r, out[r]);
        out[r].gap = gap;
    }
}

/// Evaluate three rows: point of body 1 minus point of body 0.
template <int R, class T, class Ref>
inline void point_rows(const Ref* b, const V3T<T>& ra, const V3T<T>& rb, Rows<2, R, T>& out) {
    const V3T<T> d = b[1].x + rb - b[0].x - ra;
    const T o = zero(d.x), i = one(d.x);
    const V3T<T> e[3] = {{i, o, o}, {o, i, o}, {o, o, i}};
    const T dd[3] = {d.x, d.y, d.z};
    for (int r = 0; r < 3; ++r) {
        out.g[r] = dd[r];
        out.set(0, r, -e[r], -cross(ra, e[r]));
        out.set(1, r, e[r], cross(rb, e[r]));
    }
}

/// Compute a unit vector perpendicular to the unit vector t, and t × this vector. The basis is
/// deterministic: it starts from the axis farthest from t.
template <class T>
inline void perpendicular(const V3T<T>& t, V3T<T>& n1, V3T<T>& n2) {
    const T o = zero(t.x), i = one(t.x);
    const T xx = t.x * t.x, yy = t.y * t.y, zz = t.z * t.z;
    const T not_x = select_greater(xx, yy, i, select_greater(xx, zz, i, o));
    const T not_y = select_greater(yy, zz, i, o);
    const V3T<T> e{i - not_x, not_x * (i - not_y), not_x * not_y};
    n1 = e - dot(e, t) * t;
    n1 = T(1.0 / norm(n1)) * n1;
    n2 = cross(t, n1);
}

/// Evaluate row `r`: p·q = 0 for the axis p fixed in body 0 and q fixed in body 1.
template <int R>
inline void dot_row(V3 p, V3 q, int r, Rows<2, R>& out) {
    const V3 c = cross(p, q);
    out.g[r] = dot(p, q);
    out.set(0, r, {0, 0, 0}, c);
    out.set(1, r, {0, 0, 0}, -c);
}

/// Evaluate row `r`: the vector from point 0 to point 1 has no component along n, fixed in body 0.
template <int R>
inline void slide_row(V3 n, V3 ra, V3 rb, V3 d, int r, Rows<2, R>& out) {
    out.g[r] = dot(n, d);
    out.set(0, r, -n, -cross(ra + d, n));
    out.set(1, r, n, cross(rb, n));
}

/// Columns of a joint frame (rotation matrix local to the body) in the world.
struct Axes {
    V3 x, y, z;
};
inline Axes axes(const BodyRef& b, const double* frame) {
    const M3 r = load9(b.r);
    return {r * V3{frame[0], frame[3], frame[6]}, r * V3{frame[1], frame[4], frame[7]},
            r * V3{frame[2], frame[5], frame[8]}};
}

inline double arc(double s, double c) { return __builtin_atan2(s, c); }

/// Return the twist of frame 1 against frame 0 about their common z [rad], and the axis of its
/// rate.
inline double twist(const Axes& a, const Axes& b, V3& axis) {
    const double c = dot(a.z, b.z);
    axis = (1.0 / (1.0 + c)) * (a.z + b.z);
    return arc(dot(b.x, a.y) - dot(b.y, a.x), dot(b.x, a.x) + dot(b.y, a.y));
}

#ifdef HAWSER_KIND_SETUP
inline void copy_point(const InteractionDef& d, int b, double* out) {
    for (int i = 0; i < 3; ++i) out[i] = d.point[static_cast<std::size_t>(b)][i];
}
inline void copy_frame(const InteractionDef& d, int b, double* out) {
    const Mat3 m = d.frame[static_cast<std::size_t>(b)].normalized().toRotationMatrix();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out[3 * i + j] = m(i, j);
}
#endif

/// Data of the kinds that need both points and both frames.
struct JointData {
    double point[2][3];
    double frame[2][9];
#ifdef HAWSER_KIND_SETUP
    static JointData of(const InteractionDef& d) {
        JointData o{};
        for (int b = 0; b < 2; ++b) {
            copy_point(d, b, o.point[b]);
            copy_frame(d, b, o.frame[b]);
        }
        return o;
    }
#endif
};

}  // namespace hawser::HAWSER_ISA
