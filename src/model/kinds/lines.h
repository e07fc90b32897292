// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lines.h
/// Elements of wires: distance, stretch, winch stretch, bend, twist.
///
/// Stretch: g = |x₁ − x₀| − l₀ with ε = l₀/EA, so that the force at rest is EA·strain.
/// Bend: unit tangents e₁, e₂ of the two segments at a node, t their mean direction; the two
/// rows are the components of e₂ − e₁ square to t, of size 2 sin(φ/2) for a bend angle φ, with
/// ε = l̄/EI: the hinge stiffness EI/l̄ of a beam of constant bending stiffness.
/// A slack wire that heaps up folds its segments, and what is shorter than l̄/10 has no direction: a
/// couple on it would need forces 2 EI/(l̄ |d|), beyond all bounds. There e = d/(l̄/10) instead of
/// d/|d|, continuous, of the same energy otherwise.
/// Source: Servin, Lacoursière, Nordfelth, Bodin, "Hybrid, multiresolution wires with massless
/// frictional contacts" (2011).

#include "model/kinds/common.h"

namespace hawser::HAWSER_ISA::kinds {

template <class T>
struct PointDataT {
    T point[2][3];
    T length;
};
using PointData = PointDataT<double>;

#ifdef HAWSER_KIND_SETUP
inline PointData point_data(const InteractionDef& d, double length) {
    PointData o{};
    copy_point(d, 0, o.point[0]);
    copy_point(d, 1, o.point[1]);
    o.length = length;
    return o;
}
#endif

/// Row 0: distance of the points minus the rest length. A zero distance pushes along x.
template <int B, class D, class T, class Ref>
inline void line_row(const D& d, const Ref* b, const T& length, Rows<B, 1, T>& out) {
    const V3T<T> ra = b[0].arm(d.point[0]), rb = b[1].arm(d.point[1]);
    const V3T<T> u = b[1].x + rb - b[0].x - ra;
    const T l = norm(u), o = zero(l);
    const V3T<T> n = select_greater(l, constant(l, 1e-12), T(1.0 / l) * u, {one(l), o, o});
    out.g[0] = l - length;
    out.set(0, 0, -n, -cross(ra, n));
    out.set(1, 0, n, cross(rb, n));
}

inline constexpr ParamInfo kDistanceParams[] = {
    {"length", "m", kDefault, 1e-9, 1e6, "Distance kept; default: the initial distance.", true}};

/// A massless rigid rod between two points.
struct Distance {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::line;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Distance,
        .name = "distance",
        .bodies = 2,
        .rows = 1,
        .uses_points = true,
        .uses_frames = false,
        .row_units = "m",
        .length_from_pose = true,
        .traits = kAlongLine | kOfWires,
        .params = kDistanceParams,
        .doc =
            "Keeps two points at a distance: a massless rod, or a spring of compliance "
            "1/k when given one."};
    using Data = PointData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 1, true, s);
        // A spring's elongation is not a violation.
        s[0].gap = s[0].compliance <= 1e-9;
    }
    static constexpr bool kInLanes = true;
    template <class T>
    using DataT = PointDataT<T>;
    template <class T, class Ref>
    static void evaluate(const PointDataT<T>& d, const Ref* b, Rows<2, 1, T>& out) {
        line_row(d, b, d.length, out);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return point_data(d, d.params[0]); }
#endif
};

inline constexpr ParamInfo kStretchParams[] = {
    {"length", "m", kDefault, 1e-9, 1e6, "Unstretched length; default: the initial distance.",
     true},
    {"EA", "N", kDefault, 1e-3, 1e15, "Axial stiffness of the line."},
    {"tension_only", "1", 1.0, 0.0, 1.0, "1: goes slack instead of pushing."},
    {"breaking_load", "N", 1e30, 0.0, 1e30, "The element parts above this tension."},
    {"mass", "kg", 0.0, 0.0, 1e12,
     "Of the element, of which lumps at its ends hold half each: it moves as a straight piece "
     "between them. 0: the lumps move by themselves."}};

inline void stretch_rows(const InteractionDef& d, double h, RowSpec* s) {
    s[0].compliance = given(d.compliance.data()[0], d.params.data()[0] / d.params.data()[1]);
    damping_or_calm(d, h, 0, s[0]);
    s[0].one_sided = d.params.data()[2] > 0.5;
}

/// A wire element between two lumps or attachment points.
struct Stretch {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::line;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Stretch,
        .name = "stretch",
        .bodies = 2,
        .rows = 1,
        .uses_points = true,
        .uses_frames = false,
        .row_units = "m",
        .length_from_pose = true,
        .mass_param = 4,
        .traits = kAlongLine | kWireElement | kElastic | kOfWires,
        .params = kStretchParams,
        .doc = "Axial stiffness of a wire element, compliance length/EA."};
    using Data = PointData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { stretch_rows(d, h, s); }
    static constexpr bool kRestLength = true;  ///< Interactions::rest_length is data.length.
    static constexpr bool kInLanes = true;
    template <class T>
    using DataT = PointDataT<T>;
    template <class T, class Ref>
    static void evaluate(const PointDataT<T>& d, const Ref* b, Rows<2, 1, T>& out) {
        line_row(d, b, d.length, out);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return point_data(d, d.params[0]); }
#endif
};

inline constexpr ParamInfo kWinchStretchParams[] = {
    {"length", "m", kDefault, 1e-9, 1e6,
     "Unstretched length at drum coordinate 0; default: the initial distance.", true},
    {"EA", "N", kDefault, 1e-3, 1e15, "Axial stiffness of the line."},
    {"tension_only", "1", 1.0, 0.0, 1.0, "1: goes slack instead of pushing."},
    {"breaking_load", "N", 1e30, 0.0, 1e30, "The element parts above this tension."},
    {"radius", "m", kDefault, -1e3, 1e3, "Line paid out per unit of drum coordinate.", true},
    {"drum_zero", "m or rad", 0.0, -1e9, 1e9, "Drum coordinate that `length` is given at.", true}};

struct WinchData {
    double point[2][3];
    double length, radius, zero;
};

/// A stretch whose rest length a drum pays out: l = length + radius·(θ − drum_zero). Where a layer
/// of the drum ends, all three change so that l does not.
struct WinchStretch {
    static constexpr int kBodies = 3, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::line;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::WinchStretch,
        .name = "winch_stretch",
        .bodies = 3,
        .rows = 1,
        .uses_points = true,
        .uses_frames = false,
        .row_units = "m",
        .scalar_slot = 2,
        .length_from_pose = true,
        .traits = kAlongLine | kWireElement | kWoundUp | kElastic,
        .params = kWinchStretchParams,
        .doc =
            "Wire element from a fairlead whose rest length grows with the coordinate of a "
            "scalar drum (third body)."};
    using Data = WinchData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { stretch_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<3, 1>& out) {
        line_row(d, b, d.length + d.radius * (b[2].x.x - d.zero), out);
        out.set(2, 0, {-d.radius, 0, 0}, {0, 0, 0});
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) {
        Data o{};
        copy_point(d, 0, o.point[0]);
        copy_point(d, 1, o.point[1]);
        o.length = d.params[0];
        o.radius = d.params[4];
        o.zero = d.params[5];
        return o;
    }
#endif
};

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
        .traits = kElastic | kOfWires,
        .params = kBendParams,
        .doc = "Bending stiffness of a line at the middle one of three nodes in order."};
    static constexpr bool kInLanes = true;
    /// Of the length l̄: shorter segments do not point anywhere.
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
            damping_or_calm(d, h, r, s[r]);
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
        // A unit vector changes square to itself alone, one of a collapsed segment in any
        // direction.
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
        damping_or_calm(d, h, 0, s[0]);
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
