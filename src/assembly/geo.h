// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file geo.h
/// Geometric stiffness and relative-rotation damping of one interaction.
///
/// *Line* (distance, stretch): a tension T along the unit vector u, length l, resists
/// transverse motion of the end points: K_g = (T/l)(E − u uᵀ) on their relative displacement.
/// Without it a taut wire is stable only while h √(T/ρ) ≤ element length. With s = h² T/(l m), m
/// the lighter end, p = (s − ¼)/(s + ¼) for s > ¼ and 0 below, v̂ = 2 v − v₋ the velocity of the
/// step before carried on,
///   M̃ += (a + d) h² K,  a += h² K (a v + d v̂),   a = ¼ + p (A − ¼),  d = p D
/// with A = ½, D = −0.1, or 1 and −0.2 for a wire that has gained energy lately (solve/wires.h):
/// up to s = ¼ the trapezoidal rule; beyond, where it keeps swings for ever that the step does not
/// resolve, d < 0 damps the second difference of the velocity, by about |d| (hω)³/2 of a swing ω.
///
/// *Arms*: a force f on a body at arm r turns with the body: K = (f·r)E − r fᵀ on its rotation,
/// symmetrised. In the plane of unit vectors r̂, f̂ at angle θ (c = cos θ) its eigenvalues, in
/// units of |f||r|, are c (normal to the plane), (c + 1)/2 along d = r̂ − f̂ and (c − 1)/2 ≤ 0
/// along s = r̂ + f̂. Projected to be positive semi-definite:
///   c ≥ 0:  c (E − s sᵀ/|s|²) + d dᵀ/4        (regular at θ = 0, where d = 0)
///   c < 0:  (c + 1)/2 · d dᵀ/|d|²
/// That of arms enters conservatively: M̃ += (h²/4) K, a += (h²/4) K v. Sources: Tournier, Nesme,
/// Gilles, Faure, "Stable constrained dynamics" (2015); Andrews, Teichmann, Kry, "Geometric
/// stiffness for real-time constrained multibody dynamics" (2017); the conservative form is
/// that of the trapezoidal rule.
///
/// *Damping* of joints between two rigid bodies: c = k_b h |f| min(|r₀|, |r₁|) min(1, 16 s²) on
/// the relative rotation, numerical; it leaves rigid rotation and angular momentum alone. M̃ += h c,
/// a −= h c (ω₀ − ω₁). The number s = h² |f| max(|r₀|/I₀, |r₁|/I₁), I across the arm, is (hω)² for
/// the swing of a body about the joint under f. Chains of links need the damping where that swing
/// is not resolved (measured: without it they diverge from s = 2 to 3 on) and nowhere else; a
/// motion that is resolved sees c of fifth order in h.
///
/// *Swings far too fast for the step.* f is that of the step before, and where h c exceeds the
/// inertia, half of the damping being explicit turns the relative velocity over instead of taking
/// it away: chains diverged from s of some hundred on. With u = (s − 4)/(s + 4) for s > 4, else 0,
/// c is (1 + 9 u) times as large, M̃ += (1 + u) h c, a −= (1 − u) h c (ω₀ − ω₁), from half explicit
/// to implicit with the same sum; and the arms' stiffness is (1 + u/2) times as large, against a
/// force that grows within a step. Measured on chains, tests/stepper/joint_damping_test.cpp.
///
/// *Consistent mass.* Two lumps that hold half of an element's mass m each and nothing between
/// them have another angular momentum than the element: a velocity that changes linearly along it
/// has the kinetic energy (m/6)(|v₀|² + v₀·v₁ + |v₁|²), which is that of the lumps less
/// (m/12)|v₀ − v₁|². So μ = m/6 (View::pair_mass) enters as M̃ −= μ [E −E; −E E], a −= the same on
/// v; M̃ stays positive, since the lumps hold m/2 each. Then a node put on the element changes
/// neither momentum nor energy. Lines with an end on a body that turns keep their mass in the lump.
///
/// Between two rigid bodies a line has a = ¼ and d = 0 always: what turns with it would lose its
/// angular momentum to d.
///
/// Record (doubles): 0 w = (a + d) h² T/l; 1-3 u; 4-6 r₀; 7-9 r₁; 10-15 (h²/4) P₀ and 16-21
/// (h²/4) P₁ as xx xy xz yy yz zz; 22 (1 + u) h c. 23: max(|r₀|/I₀, |r₁|/I₁) [1/(kg m)], constant,
/// set by the analysis; 0 where one of the bodies does not turn. Between bodies without arms a
/// record ends after u. Ball joints between two rigid bodies have an arms record instead
/// (model/arms.h), and the stiffness of their arms is computed with the bodies' own terms.

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

/// out (dof entries) = a body's block M + h D, arms' stiffness included, times u.
inline void block_times(const double* block, int dof, const double* u, double* out) {
    if (dof == 1) {
        out[0] = block[0] * u[0];
        return;
    }
    store3(out, mul6(block, load3(u)));
    if (dof == 6) store3(out + 3, mul6(block + 6, load3(u + 3)));
}

/// u of the text above. @param s4  4 s.
template <class T>
inline T unresolved(const T& s4) {
    const T beyond = positive_part(T(s4 - constant(s4, 16.0)));
    return beyond * (1.0 / (beyond + constant(s4, 32.0)));
}
inline constexpr double kMoreStiffness = 0.5, kMoreDamping = 9.0;

/// a and d of the text above. @param s  h² T/(l m). @param alert  1: the wire gained lately, else
/// 0.
template <class T>
struct AcrossShares {
    T late, ahead;
};
template <class T>
inline AcrossShares<T> across_shares(const T& s, const T& alert) {
    const T s4 = 4.0 * s, unit = one(s);
    const T beyond = positive_part(T(s4 - unit)) * (1.0 / (s4 + unit));
    return {constant(s, 0.25) + beyond * (constant(s, 0.25) + 0.5 * alert),
            zero(s) - 0.1 * beyond * (unit + alert)};
}

/// Share of its geometric stiffness that a completed joint has: none while s ≤ 1, all from 2 on.
/// At s of about one it would bend paths that the step resolves. @param s4  4 s.
template <class T>
inline T completed_stiffness(const T& s4) {
    const T beyond = 0.25 * positive_part(T(s4 - constant(s4, 4.0)));
    return select_greater(beyond, one(s4), one(s4), beyond);
}

/// scale × projected arm stiffness of the force f, of size nf, at arm r, of length nr. Zero where
/// either is.
template <class T>
inline void arm_stiffness(const V3T<T>& f, const T& nf, const V3T<T>& r, const T& nr,
                          const T& scale, T* out) {
    constexpr double kTiny = 1e-300;  // against 0/0
    const V3T<T> fh = T(1.0 / (nf + kTiny)) * f, rh = T(1.0 / (nr + kTiny)) * r;
    const V3T<T> s = rh + fh, d = rh - fh;
    const T c = dot(rh, fh), k = scale * nf * nr, none = zero(c);
    // K = e E − ss s sᵀ + dd d dᵀ
    const T e = k * positive_part(c), ss = e * (1.0 / (dot(s, s) + kTiny));
    const T obtuse = 0.5 * k * (c + 1.0) * (1.0 / (dot(d, d) + kTiny));
    const T dd = select_greater(none, c, obtuse, 0.25 * k);
    out[0] = e - ss * s.x * s.x + dd * d.x * d.x;
    out[1] = dd * d.x * d.y - ss * s.x * s.y;
    out[2] = dd * d.x * d.z - ss * s.x * s.z;
    out[3] = e - ss * s.y * s.y + dd * d.y * d.y;
    out[4] = dd * d.y * d.z - ss * s.y * s.z;
    out[5] = e - ss * s.z * s.z + dd * d.z * d.z;
}

/// What the force of a joint between two rigid bodies, of size nf, makes of it at arms of lengths
/// n0, n1: the scale of the arms' stiffness, (1 + u) h c and (1 − u) h c. `swing`: 23 of a record.
template <class T>
struct JointTerms {
    T stiff, damping, back;
};
/// Of a completed joint, whose swing has its sign changed, the stiffness fades in and there is no
/// damping.
template <class T>
inline JointTerms<T> joint_terms(const assembly::View& view, const T& nf, const T& n0, const T& n1,
                                 const T& marked_swing) {
    const T unit = one(nf), none = zero(nf);
    const T swing = select_greater(none, marked_swing, -marked_swing, marked_swing);
    const T push = (view.h * view.h) * nf, s4 = 4.0 * push * swing;
    const T fast = unresolved(s4);
    const T need = select_greater(unit, s4, T(s4 * s4), T(unit + kMoreDamping * fast));
    const T half =
        select_greater(none, marked_swing, none,
                       push * view.rotation_damping * select_greater(n1, n0, n0, n1) * need);
    const T fade = select_greater(none, marked_swing, completed_stiffness(s4), unit);
    return {
        (0.25 * view.h * view.h * view.geometric_stiffness) * fade * (unit + kMoreStiffness * fast),
        half * (unit + fast), half * (unit - fast)};
}

/// Line and damping parts of M̃ v on both slots; `lin`, `ang` are the slots' velocities. With
/// damping = −(1 − u)/(1 + u), of a for the velocities before the step. The arms' part acts on one
/// body alone and is kept in that body's block. @param out0, out1  Six doubles for each slot.
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
