// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file geo.h
/// Geometric stiffness and relative-rotation damping of one interaction.
///
/// *Line* (distance, stretch). A tension T along the unit vector u, length l, resists transverse
/// motion of the end points. K_g = (T/l)(E − u uᵀ) acts on their relative displacement. Without it
/// a taut wire is stable only if h √(T/ρ) ≤ element length. Let s = h² T/(l m), m the mass of the
/// lighter end. Let p = (s − ¼)/(s + ¼) for s > ¼, else 0. The extrapolated velocity is v̂ = 2 v −
/// v₋. Then
///   M̃ += (a + d) h² K,  a += h² K (a v + d v̂),   a = ¼ + p (A − ¼),  d = p D.
/// A = ½, D = −0.1. For a wire that gained energy recently (solve/wires.h) A = 1, D = −0.2. Up to s
/// = ¼ this is the trapezoidal rule, which never damps an unresolved vibration. Beyond, d < 0 damps
/// the second difference of the velocity, by about |d| (hω)³/2 of a vibration ω.
///
/// *Arms*. A force f on a body at arm r turns with the body: K = (f·r)E − r fᵀ on its rotation,
/// symmetrised. Let θ be the angle of the unit vectors r̂, f̂, and c = cos θ. The eigenvalues in
/// units of |f||r| are
///   c  normal to the plane of both,
///   (c + 1)/2  along d = r̂ − f̂,
///   (c − 1)/2 ≤ 0  along s = r̂ + f̂.
/// The projection to positive semi-definite matrices is
///   c ≥ 0:  c (E − s sᵀ/|s|²) + d dᵀ/4        (regular at θ = 0, where d = 0)
///   c < 0:  (c + 1)/2 · d dᵀ/|d|²
/// The stiffness of arms enters in conservative form: M̃ += (h²/4) K, a += (h²/4) K v. Sources:
/// Tournier, Nesme, Gilles, Faure, "Stable constrained dynamics" (2015); Andrews, Teichmann, Kry,
/// "Geometric stiffness for real-time constrained multibody dynamics" (2017). The conservative form
/// belongs to the trapezoidal rule.
///
/// *Damping* of joints between two rigid bodies. The coefficient c = k_b h |f| min(|r₀|, |r₁|)
/// min(1, 16 s²) acts on the relative rotation. It is numerical and does not affect rigid rotation
/// and angular momentum. It enters as M̃ += h c, a −= h c (ω₀ − ω₁). The number s = h² |f|
/// max(|r₀|/I₀, |r₁|/I₁), with I across the arm, is (hω)² of the oscillation about the joint under
/// f. Chains of links need the damping only if that oscillation is not resolved. Measured: without
/// it they diverge from s = 2 to 3 on. For resolved motion c is of fifth order in h.
///
/// *Oscillations far too fast for the step.* f is the force of the step before. If h c exceeds the
/// inertia, the explicit half of the damping reverses the relative velocity instead of reducing it.
/// Chains diverged from s of some hundred on. With u = (s − 4)/(s + 4) for s > 4, else 0, c is
/// multiplied by (1 + 9 u), M̃ += (1 + u) h c, a −= (1 − u) h c (ω₀ − ω₁). This changes from half
/// explicit to implicit with the same sum. The stiffness of arms is multiplied by (1 + u/2),
/// against a force that grows within a step. Measured on chains,
/// tests/stepper/joint_damping_test.cpp.
///
/// *Bound.* Beyond s = 2.5e9 the stiffness of arms and c stop growing with |f|. There the pivots of
/// M̃ keep seven digits of the inertia. Without the bound, forces of 1e10 N on bodies of 1 mm made
/// them negative by rounding.
///
/// *Consistent mass.* Let two point masses have half of the mass m of an element each. Their
/// angular momentum differs from that of the element. A velocity that changes linearly along the
/// element has the kinetic energy (m/6)(|v₀|² + v₀·v₁ + |v₁|²). This is the energy of the point
/// masses minus (m/12)|v₀ − v₁|². Therefore μ = m/6 (View::pair_mass) enters as M̃ −= μ [E −E; −E
/// E], a −= μ [E −E; −E E] v. M̃ stays positive, because the point masses have m/2 each. A node
/// inserted on the element then changes neither momentum nor energy. Lines with an end on a turning
/// body keep their mass in the point mass.
///
/// A line between two rigid bodies always has a = ¼ and d = 0: d would remove angular momentum of
/// its rotation.
///
/// Record (doubles): 0 w = (a + d) h² T/l; 1-3 u; 4-6 r₀; 7-9 r₁; 10-15 (h²/4) P₀ and 16-21 (h²/4)
/// P₁ as xx xy xz yy yz zz; 22 (1 + u) h c. 23: max(|r₀|/I₀, |r₁|/I₁) [1/(kg m)], constant, set by
/// the analysis; 0 if one of the bodies does not turn. Between bodies without arms a record ends
/// after u. Ball joints between two rigid bodies have an arms record instead (model/arms.h). The
/// stiffness of their arms is computed with the own terms of the bodies.

#include "assembly/view.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {

template <class S, class T>
inline V3T<T> mul6(const S* s, const V3T<T>& v) {
    return {s[0] * v.x + s[1] * v.y + s[2] * v.z, s[1] * v.x + s[3] * v.y + s[4] * v.z,
            s[2] * v.x + s[4] * v.y + s[5] * v.z};
}
inline M3 full6(const double* s) {
    return {{s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5]}};
}

/// Multiply the block M + h D of a body, including the stiffness of arms, by u. @param out  dof
/// entries.
inline void block_times(const double* block, int dof, const double* u, double* out) {
    if (dof == 1) {
        out[0] = block[0] * u[0];
        return;
    }
    store3(out, mul6(block, load3(u)));
    if (dof == 6) store3(out + 3, mul6(block + 6, load3(u + 3)));
}

/// Return the damping factor u of vibrations that the step does not resolve, defined in the text at
/// the head of this file. @param s4  4 s.
template <class T>
inline T unresolved(const T& s4) {
    const T beyond = positive_part(T(s4 - constant(s4, 16.0)));
    return beyond * (1.0 / (beyond + constant(s4, 32.0)));
}
inline constexpr double kMoreStiffness = 0.5, kMoreDamping = 9.0;
inline constexpr double kMaxVibration = 1e10;  ///< Bound of 4 s in the text above.

/// Coefficients a and d of the text above. @param s  h² T/(l m). @param flagged  1 if the wire
/// gained energy recently, else 0.
template <class T>
struct AcrossFractions {
    T late, ahead;
};
template <class T>
inline AcrossFractions<T> across_fractions(const T& s, const T& flagged) {
    const T s4 = 4.0 * s, unit = one(s);
    const T beyond = positive_part(T(s4 - unit)) * (1.0 / (s4 + unit));
    return {constant(s, 0.25) + beyond * (constant(s, 0.25) + 0.5 * flagged),
            zero(s) - 0.1 * beyond * (unit + flagged)};
}

/// Return the fraction of the geometric stiffness that applies to a completed joint: 0 for s ≤ 1, 1
/// for s ≥ 2. Near s = 1 the stiffness would distort motion that the step resolves. @param s4  4 s.
template <class T>
inline T completed_stiffness(const T& s4) {
    const T beyond = 0.25 * positive_part(T(s4 - constant(s4, 4.0)));
    return select_greater(beyond, one(s4), one(s4), beyond);
}

/// Compute `scale` times the projected stiffness of a force f of magnitude nf at an arm r of length
/// nr (see the head of this file). The result is zero if nf or nr is zero.
template <class T>
inline void arm_stiffness(const V3T<T>& f, const T& nf, const V3T<T>& r, const T& nr,
                          const T& scale, T* out) {
    constexpr double kNoDivisionByZero = 1e-300;  // prevents 0/0
    const V3T<T> fh = T(1.0 / (nf + kNoDivisionByZero)) * f,
                 rh = T(1.0 / (nr + kNoDivisionByZero)) * r;
    const V3T<T> s = rh + fh, d = rh - fh;
    const T c = dot(rh, fh), k = scale * nf * nr, none = zero(c);
    // K = e E − ss s sᵀ + dd d dᵀ
    const T e = k * positive_part(c), ss = e * (1.0 / (dot(s, s) + kNoDivisionByZero));
    const T obtuse = 0.5 * k * (c + 1.0) * (1.0 / (dot(d, d) + kNoDivisionByZero));
    const T dd = select_greater(none, c, obtuse, 0.25 * k);
    out[0] = e - ss * s.x * s.x + dd * d.x * d.x;
    out[1] = dd * d.x * d.y - ss * s.x * s.y;
    out[2] = dd * d.x * d.z - ss * s.x * s.z;
    out[3] = e - ss * s.y * s.y + dd * d.y * d.y;
    out[4] = dd * d.y * d.z - ss * s.y * s.z;
    out[5] = e - ss * s.z * s.z + dd * d.z * d.z;
}

/// Terms of a joint between two rigid bodies, from the magnitude nf of its force at arms of lengths
/// n0, n1. They are the scale of the stiffness of arms, (1 + u) h c, and (1 − u) h c. `vibration`:
/// entry 23 of a record.
template <class T>
struct JointTerms {
    T stiff, damping, back;
};
/// Compute the terms of geometric stiffness of a joint. The vibration rate of a completed joint has
/// a negative sign: its stiffness fades in, and it has no damping.
template <class T>
inline JointTerms<T> joint_terms(const assembly::View& view, const T& nf, const T& n0, const T& n1,
                                 const T& marked_vibration) {
    const T unit = one(nf), none = zero(nf);
    const T vibration = select_greater(none, marked_vibration, -marked_vibration, marked_vibration);
    const T push = (view.h * view.h) * nf, s4 = 4.0 * push * vibration;
    const T fast = unresolved(s4);
    const T need = select_greater(unit, s4, T(s4 * s4), T(unit + kMoreDamping * fast));
    const T half =
        select_greater(none, marked_vibration, none,
                       push * view.rotation_damping * select_greater(n1, n0, n0, n1) * need);
    const T fade = select_greater(none, marked_vibration, completed_stiffness(s4), unit);
    const T bound =
        select_greater(s4, constant(s4, kMaxVibration), T(kMaxVibration * (1.0 / s4)), unit);
    return {(0.25 * view.h * view.h * view.geometric_stiffness) * fade *
                (unit + kMoreStiffness * fast) * bound,
            half * (unit + fast) * bound, half * (unit - fast) * bound};
}

/// Multiply the geometric stiffness and damping of a line by the velocities `lin`, `ang` of its two
/// slots. With damping = −(1 − u)/(1 + u), the result is the contribution to the right-hand side
/// for the velocities before the step. The part of arms acts on one body only and is stored in the
/// block of that body.
/// @param out0, out1  Six doubles for each slot.
inline void geo_product(const double* rec, const V3* lin, const V3* ang, double damping,
                        double* out0, double* out1) {
    const V3 r0 = load3(rec + 4), r1 = load3(rec + 7), u = load3(rec + 1);
    const V3 d = (damping * rec[22]) * (ang[0] - ang[1]);
    const V3 rel = lin[0] + cross(ang[0], r0) - lin[1] - cross(ang[1], r1);
    const V3 t = rec[0] * (rel - dot(u, rel) * u);
    store3(out0, t);
    store3(out0 + 3, d + cross(r0, t));
    store3(out1, -t);
    store3(out1 + 3, -d - cross(r1, t));
}

}  // namespace hawser::HAWSER_ISA
