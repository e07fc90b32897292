// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bends.h
/// Define bending and torsion of wires and rods: bend, twist.
///
/// Bend: e₁ and e₂ are the unit tangents of the two segments at a node, t their mean direction. The
/// two rows are the components of e₂ − e₁ perpendicular to t, of size 2 sin(φ/2) for a bend angle
/// φ. With ε = l̄/EI the hinge stiffness is EI/l̄, that of a beam of constant bending stiffness.
///
/// A slack wire that heaps up folds its segments. A segment shorter than l̄/10 has no usable
/// direction: a couple on it would need unbounded forces 2 EI/(l̄ |d|). There e = d/(l̄/10)
/// replaces d/|d|. It is continuous and has the same energy otherwise.
///
/// Source: Servin, Lacoursière, Nordfelth, Bodin, "Hybrid, multiresolution wires with massless
/// frictional contacts" (2011).

#include "model/kinds/common.h"

namespace hawser::HAWSER_ISA::kinds {

inline constexpr ParamInfo kBendParams[] = {
    {"EI", "N m^2", kDefault, 1e-9, 1e15, "Bending stiffness of the line."},
    {"length", "m", kDefault, 1e-9, 1e6, "Mean length of the two elements at the node."}};

/// Bending resistance at the middle of three nodes.
struct Bend {
    static constexpr int kBodies = 3, kRows = 2;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Bend,
        .name = "bend",
        .bodies = 3,
        .rows = 2,
        .uses_points = true,
        .uses_frames = false,
        .row_units = "rr",
        .traits = kElastic | kOfWires | kBendsWire,
        .params = kBendParams,
        .doc = "Bending stiffness of a line at the middle one of three nodes in order."};
    static constexpr bool kInLanes = true;
    /// Fraction of the length l̄ below which a segment has no direction.
    static constexpr double kCollapsed = 0.1;
    template <class T>
    struct DataT {
        T point[3][3];
        T shortest;
    };
    using Data = DataT<double>;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        for (int r = 0; r < 2; ++r) {
            s[r].compliance =
                given(d.compliance.data()[r], d.params.data()[1] / d.params.data()[0]);
            s[r].turns = true;
            damping_or_flagged(d, h, r, s[r]);
        }
    }
    template <class T, class Ref>
    HAWSER_INLINE static void evaluate(const DataT<T>& d, const Ref* b, Rows<3, 2, T>& out) {
        V3T<T> arm[3], p[3];
        for (int i = 0; i < 3; ++i) {
            arm[i] = b[i].arm(d.point[i]);
            p[i] = b[i].x + arm[i];
        }
        const V3T<T> d1 = p[1] - p[0], d2 = p[2] - p[1];
        const T l1 = norm(d1), l2 = norm(d2), one = constant(l1, 1.0), none = constant(l1, 0.0);
        const T i1 = 1.0 / select_greater(l1, d.shortest, l1, d.shortest);
        const T i2 = 1.0 / select_greater(l2, d.shortest, l2, d.shortest);
        // The change of a unit vector is perpendicular to it; the vector of a collapsed segment
        // changes in any direction.
        const T square1 = select_greater(l1, d.shortest, one, none);
        const T square2 = select_greater(l2, d.shortest, one, none);
        const V3T<T> e1 = i1 * d1, e2 = i2 * d2, sum = e1 + e2;
        const T s = norm(sum);
        // else: a wire folded back on itself
        const V3T<T> t = select_greater(s, constant(s, 1e-9), T(1.0 / s) * sum, e1);
        V3T<T> n[2];
        perpendicular(t, n[0], n[1]);
        for (int r = 0; r < 2; ++r) {
            out.g[r] = dot(n[r], e2 - e1);
            const V3T<T> a = i1 * (n[r] - square1 * dot(n[r], e1) * e1);  // −∂g/∂p0
            const V3T<T> c = i2 * (n[r] - square2 * dot(n[r], e2) * e2);  // ∂g/∂p2
            out.set(0, r, a, cross(arm[0], a));
            out.set(1, r, -a - c, -cross(arm[1], a + c));
            out.set(2, r, c, cross(arm[2], c));
        }
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) {
        Data o{};
        o.shortest = kCollapsed * d.params.data()[1];
        for (int b = 0; b < 3; ++b) copy_point(d, b, o.point[b]);
        return o;
    }
#endif
};

inline constexpr ParamInfo kTwistParams[] = {
    {"GJ", "N m^2", kDefault, 1e-9, 1e15, "Torsional stiffness of the line."},
    {"length", "m", kDefault, 1e-9, 1e6, "Length over which the twist acts."}};

/// Torsional stiffness between two rigid elements.
struct Twist {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Twist,
        .name = "twist",
        .bodies = 2,
        .rows = 1,
        .uses_points = false,
        .uses_frames = true,
        .row_units = "r",
        .coordinate = KindCoordinate::about,
        .traits = kElastic | kOfWires,
        .params = kTwistParams,
        .doc = "Torsional stiffness GJ/length about the common z axis of the two frames."};
    using Data = JointData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        s[0].compliance = given(d.compliance.data()[0], d.params.data()[1] / d.params.data()[0]);
        damping_or_flagged(d, h, 0, s[0]);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        V3 t;
        out.g[0] = twist(axes(b[0], d.frame[0]), axes(b[1], d.frame[1]), t);
        out.set(0, 0, {0, 0, 0}, -t);
        out.set(1, 0, {0, 0, 0}, t);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return JointData::of(d); }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
