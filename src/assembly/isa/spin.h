// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file spin.h
/// Rotation of a rigid body within a step, body frame: free rotation and the effect of torques. The
/// inertia is a matrix, or Principal if the body axes are principal axes, as usual.

#include "base/simd.h"
#include "base/turn.h"

namespace hawser::HAWSER_ISA {

/// diag(moments) [kg m²], or its inverse.
template <class T>
struct Principal {
    T moment[3];
};
template <class T>
HAWSER_INLINE V3T<T> operator*(const Principal<T>& i, const V3T<T>& v) {
    return {i.moment[0] * v.x, i.moment[1] * v.y, i.moment[2] * v.z};
}
/// Return R I Rᵀ, the inertia I of a body in the world frame, for its rotation R.
template <class T>
HAWSER_INLINE M3T<T> in_world(const M3T<T>& r, const M3T<T>& inertia) {
    return congruence(r, inertia.a);
}
template <class T>
HAWSER_INLINE M3T<T> in_world(const M3T<T>& r, const Principal<T>& inertia) {
    M3T<T> o;
    for (int i = 0; i < 3; ++i) {
        const T x = r.a[3 * i] * inertia.moment[0], y = r.a[3 * i + 1] * inertia.moment[1],
                z = r.a[3 * i + 2] * inertia.moment[2];
        for (int j = 0; j <= i; ++j)
            o.a[3 * j + i] = o.a[3 * i + j] =
                x * r.a[3 * j] + y * r.a[3 * j + 1] + z * r.a[3 * j + 2];
    }
    return o;
}
/// Return (E + û) I, where û is the cross-product matrix of u.
template <class T>
HAWSER_INLINE M3T<T> turned(const M3T<T>& inertia, const V3T<T>& u) {
    const T* i = inertia.a;
    return {{i[0] + u.y * i[6] - u.z * i[3], i[1] + u.y * i[7] - u.z * i[4],
             i[2] + u.y * i[8] - u.z * i[5], i[3] + u.z * i[0] - u.x * i[6],
             i[4] + u.z * i[1] - u.x * i[7], i[5] + u.z * i[2] - u.x * i[8],
             i[6] + u.x * i[3] - u.y * i[0], i[7] + u.x * i[4] - u.y * i[1],
             i[8] + u.x * i[5] - u.y * i[2]}};
}
template <class T>
HAWSER_INLINE M3T<T> turned(const Principal<T>& inertia, const V3T<T>& u) {
    const T *i = inertia.moment, x = u.x, y = u.y, z = u.z;
    return {{i[0], -z * i[1], y * i[2], z * i[0], i[1], -x * i[2], -y * i[0], x * i[1], i[2]}};
}

/// Return a matrix of inertia times a factor.
template <class T>
HAWSER_INLINE M3T<T> scaled(const M3T<T>& inertia, const T& factor) {
    M3T<T> o;
    for (int i = 0; i < 9; ++i) o.a[i] = factor * inertia.a[i];
    return o;
}
template <class T>
HAWSER_INLINE M3T<T> scaled(const Principal<T>& inertia, const T& factor) {
    const T none = zero(factor), *i = inertia.moment;
    return {{factor * i[0], none, none, none, factor * i[1], none, none, none, factor * i[2]}};
}

/// Return the angular velocity after a step h without torque, in the body frame: μ₊(ω₊) = μ₋(ω)
/// with the momenta of base/turn.h.
/// Newton's method starts from the explicit step; its Jacobian is well conditioned if h|ω| < 1.
/// Each correction is about h|ω| times the square of the one before, so that slow bodies need one
/// iteration.
template <class T, class Inertia>
HAWSER_INLINE V3T<T> free_rotation(const Inertia& inertia, const Inertia& inverse, const V3T<T>& w,
                                   const T& h) {
    const V3T<T> iw = inertia * w;
    const T half = 0.5 * h, quarter = half * half;
    const V3T<T> target = iw + turn_momentum(inertia, w, T(-half));
    V3T<T> u = w - h * (inverse * cross(w, iw));
    for (int n = 0; n < 4; ++n) {
        const V3T<T> iu = inertia * u;
        const T e = dot(u, iu), y = quarter * dot(u, u), bend = quarter * turn_bend(y);
        const V3T<T> across = cross(u, iu), twice = cross(u, across);
        const V3T<T> f = iu + half * across + bend * twice - target;
        // J = I + (h/2)(û I − (Iu)^) + (h²/4) b (e E + 2 u (Iu)ᵀ − |u|² I − (2 Iu − d) uᵀ),
        // with the slope b' ≈ 1/45 + 4y/945 in d = (h²/2)(b'/b) u × (u × Iu).
        const T slope = (2.0 * quarter * quarter) * ((4.0 / 945.0) * y + constant(y, 1.0 / 45.0));
        const V3T<T> hu = half * u, hi = half * iu, qu = (2.0 * bend) * u;
        const V3T<T> back = (2.0 * bend) * iu - slope * twice;
        const T qe = bend * e;
        const M3T<T> m = turned(inertia, hu), still = scaled(inertia, T(bend * dot(u, u)));
        const M3T<T> j{{m.a[0] + (qe + qu.x * iu.x - back.x * u.x) - still.a[0],
                        m.a[1] + (hi.z + qu.x * iu.y - back.x * u.y) - still.a[1],
                        m.a[2] + (qu.x * iu.z - hi.y - back.x * u.z) - still.a[2],
                        m.a[3] + (qu.y * iu.x - hi.z - back.y * u.x) - still.a[3],
                        m.a[4] + (qe + qu.y * iu.y - back.y * u.y) - still.a[4],
                        m.a[5] + (hi.x + qu.y * iu.z - back.y * u.z) - still.a[5],
                        m.a[6] + (hi.y + qu.z * iu.x - back.z * u.x) - still.a[6],
                        m.a[7] + (qu.z * iu.y - hi.x - back.z * u.y) - still.a[7],
                        m.a[8] + (qe + qu.z * iu.z - back.z * u.z) - still.a[8]}};
        const V3T<T> du = solve3(j, f);
        u = u - du;
        // Stop if h|ω| (|δ|/|ω|)² is below 1e-17; here squared.
        const T square = dot(u, u), change = dot(du, du);
        if (!any(positive_part(4.0 * quarter * square * change * change -
                               1e-34 * (square * square))))
            break;
    }
    // If h|ω| is far above 1, the iteration may not converge and energy could grow without bound.
    // Such a spin stays unchanged.
    return select_greater(1.5 * dot(w, iw), dot(u, inertia * u), u, w);
}

/// Return the gyroscopic impulse −(h/2)(δ × Iω + ω × Iδ) between the spin ω and its change δ due to
/// torques in this step. It is the mean of the values at the start and the end of the step. With
/// the value at the start only, a spinning body under torque (a top) would be of first order. δ is
/// taken from the last step. The term is explicit and therefore damped if h|ω| is large.
template <class T, class Inertia>
HAWSER_INLINE V3T<T> forced_gyro(const Inertia& inertia, const V3T<T>& w, const V3T<T>& change,
                                 const T& h) {
    const T half = 0.5 * h, limit = half * (1.0 / (one(h) + half * half * dot(w, w)));
    const V3T<T> sum = cross(change, inertia * w) + cross(w, inertia * change);
    return V3T<T>{zero(h), zero(h), zero(h)} - limit * sum;
}

/// Spin terms in the own terms of a body, world frame.
template <class T>
struct Spin {
    M3T<T> inertia;
    V3T<T> free;      ///< ω₊ without torque.
    V3T<T> momentum;  ///< I ω₊ of `free`, with the gyroscopic impulse.
};
/// Compute the spin terms. @param r, w, change  Rotation, ω in the world frame, δ in the body
/// frame.
template <class T, class Inertia>
HAWSER_INLINE Spin<T> spin_terms(const Inertia& inertia, const Inertia& inverse, const M3T<T>& r,
                                 const V3T<T>& w, const V3T<T>& change, const T& h) {
    const V3T<T> spin = tmul(r, w), free = free_rotation(inertia, inverse, spin, h);
    return {in_world(r, inertia), r * free,
            r * (inertia * free + forced_gyro(inertia, spin, change, h))};
}

}  // namespace hawser::HAWSER_ISA
