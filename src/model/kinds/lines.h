// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lines.h
/// Define elements of wires along their line: distance, stretch, winch stretch.
///
/// Stretch: g = |x₁ − x₀| − l₀ with ε = l₀/EA, so that the force at rest is EA·strain. Source:
/// Servin, Lacoursière, Nordfelth, Bodin, "Hybrid, multiresolution wires with massless frictional
/// contacts" (2011).

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

/// Evaluate row 0: distance of the points minus the rest length. If the distance is zero, the
/// direction is x.
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

/// Massless rigid rod between two points.
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
        // The elongation of a spring is not a violation.
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
    {"breaking_load", "N", 1e30, 0.0, 1e30, "The element breaks above this tension."},
    {"mass", "kg", 0.0, 0.0, 1e12,
     "Of the element, of which lumps at its ends hold half each: it moves as a straight piece "
     "between them. 0: the lumps move by themselves."}};

inline void stretch_rows(const InteractionDef& d, double h, RowSpec* s) {
    s[0].compliance = given(d.compliance.data()[0], d.params.data()[0] / d.params.data()[1]);
    damping_or_flagged(d, h, 0, s[0]);
    s[0].one_sided = d.params.data()[2] > 0.5;
}

/// Wire element between two nodes or attachment points.
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
    {"breaking_load", "N", 1e30, 0.0, 1e30, "The element breaks above this tension."},
    {"radius", "m", kDefault, -1e3, 1e3, "Line paid out per unit of drum coordinate.", true},
    {"drum_zero", "m or rad", 0.0, -1e9, 1e9, "Drum coordinate that `length` is given at.", true}};

struct WinchData {
    double point[2][3];
    double length, radius, zero;
};

/// Wire element whose rest length follows a drum:
/// ```
///     l = max(l₀ + r (θ − θ₀), ε l₀)     l₀ length, r radius, θ₀ drum_zero, ε kLeastOfDrumElement
/// ```
/// At the bound ε l₀ the row has no derivative to the drum: neither acts on the other. A winch
/// changes l₀, r and θ₀ together when the layer of its drum changes, so that l is continuous.
struct WinchStretch {
    static constexpr int kBodies = 3, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::line;
    static constexpr KindInfo kInfo{.kind = InteractionKind::WinchStretch,
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
                                        "Wire element from a fairlead whose rest length follows "
                                        "the coordinate of a scalar drum "
                                        "(third body), down to 2 % of `length`."};
    using Data = WinchData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { stretch_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<3, 1>& out) {
        const double rest = d.length + d.radius * (b[2].x.x - d.zero);
        const double least = kLeastOfDrumElement * d.length;
        line_row(d, b, rest > least ? rest : least, out);
        out.set(2, 0, {rest > least ? -d.radius : 0.0, 0, 0}, {0, 0, 0});
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

}  // namespace hawser::HAWSER_ISA::kinds
