// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file routes.h
/// Define spans of a line over massless turning points: eyes, sheaves, bollards, pins.
///
/// Between two ends a line passes turning points 1 … n. The length that has run through turning
/// point j since the start is the coordinate q_j of a scalar body, its *slide*. It counts from span
/// j − 1 into span j. With l_j the rest length of span j at the start:
/// ```
///     end 0 ──span 0── (1) ──span 1── (2) ── … ── (n) ──span n── end n + 1
///     g_j = P_j − (l_j + q_j − q_{j+1}),   ε_j = l_j / EA
/// ```
/// Slides have almost no mass, so that T_j − T_{j−1} is the friction at turning point j. Line that
/// leaves a span enters the next one, and the total length is constant.
///
/// Wheels: a turning point may be a circle of radius R about an axis fixed in its body. The span
/// then leaves along a tangent. P_j is the straight part L plus the arc between the tangent point
/// and a mark:
/// ```
///         mark              P = L + R φ,  φ the angle from the mark to the tangent point,
///       .--|--.             positive if the line lies on the circle between them
///     .'   | φ '.
///     |    c----| R         dP/dt = u·(velocity of the far end − that of the body's point at the
///     '.       .|           tangent point): line that rolls off one side rolls onto the other.
///       '-----' | L
///               p           R = 0 is an eye: L alone.
/// ```
/// The mark is the tangent point at the definition of the span. It lies on the x axis of the end's
/// frame; the z axis is the wheel's axis. The route turns about +z at a wheel with R > 0, and about
/// −z at a wheel with R < 0. If a line winds on round its wheel, or a wheel turns under its line, φ
/// exceeds half a turn. Poses determine φ modulo whole turns. The turns are counted from step to
/// step and are part of the state, like the anchor of friction
/// (Interactions::update_whole_turns()). Initial turns are part of l_j.
///
/// Limits: φ changes by less than half a turn in a step. The component of a span along an axis
/// counts in its length but not in the tangent. Axes must be almost perpendicular to the span. If
/// two wheels are not parallel, the span leaves each one in its own plane (base/wheel_tangent.h).
/// The far end must stay outside the circle. If, viewed along the axis, the tangent would be at
/// more than asin 0.999 to the line of centres, the span leaves at that angle. Two wheels then both
/// use the plane of the first one. Source: Servin, Lacoursière, Nordfelth, Bodin, "Hybrid,
/// multiresolution wires with massless frictional contacts" (2011).

#include "base/wheel_tangent.h"
#include "model/kinds/friction.h"

namespace hawser::HAWSER_ISA::kinds {

/// One end of a span on its body.
struct SpanEnd {
    double point[3];  ///< Eye, or centre of the wheel [m].
    double frame[9];  ///< Frame; z: the wheel's axis, x: its mark.
    double radius;    ///< Radius, signed by the sense of passing [m]; 0: an eye.
    double wound;     ///< Angle of the wheel that the line covers beyond its mark [rad].
};

/// Whole turns of φ at both ends, packed into one number: the state has one slot for a span.
struct WholeTurns {
    static constexpr double kBase = 65536.0;  // far more than any line has
    double turns[2];
    static WholeTurns of(double packed) {
        const double second = __builtin_floor(packed / kBase + 0.5);
        return {{packed - kBase * second, second}};
    }
    [[nodiscard]] double packed() const { return turns[0] + kBase * turns[1]; }
};

inline constexpr double kWholeTurn = 6.283185307179586;  ///< [rad].

/// Shape of a span.
struct SpanShape {
    V3 at[2];         ///< Points where it leaves its ends, world frame [m].
    V3 along;         ///< Unit vector from end 0 to end 1.
    double length;    ///< Length of the straight part [m].
    double angle[2];  ///< Angle φ of each end, within half a turn [rad].
};

/// Largest sine of the angle between a tangent and the line of centres.
inline constexpr double kSteepest = 0.999;

/// Return the direction u of the common tangent of two wheels. It touches a wheel of signed radius
/// s at the point s u × n from its centre. @param d  Vector between the centres. @param n  Axis of
/// the wheels. @param separation  Second signed radius minus the first one.
inline V3 tangent_direction(const V3& d, const V3& n, double separation) {
    const V3 flat = d - dot(d, n) * n;
    const double size = norm(flat), most = kSteepest * size;
    const double s = separation > most ? most : separation < -most ? -most : separation;
    const double c = __builtin_sqrt(size * size - s * s);
    // Unit length in the plane, with d·(u × n) = −s.
    const double scale = 1.0 / (size * size);
    return (scale * c) * flat - (scale * s) * cross(n, flat);
}

/// True if two wheels have a common tangent, that is, if |separation| is at most kSteepest times
/// the distance of their centres across the axis.
inline bool tangent_is_defined(const V3& d, const V3& n, double separation) {
    const V3 flat = d - dot(d, n) * n;
    return separation * separation <= kSteepest * kSteepest * dot(flat, flat);
}

inline SpanShape span_shape(const SpanEnd (&e)[2], const BodyRef* b) {
    SpanShape out{};
    V3 centre[2], axis[2], mark[2];
    for (int k = 0; k < 2; ++k) {
        centre[k] = b[k].x + b[k].arm(e[k].point);
        const double* f = e[k].frame;
        const V3 z{f[2], f[5], f[8]}, x{f[0], f[3], f[6]};
        const M3 r = load9(b[k].r);
        axis[k] = b[k].rotates ? r * z : z;
        mark[k] = b[k].rotates ? r * x : x;
    }
    const V3 d = centre[1] - centre[0];
    out.at[0] = centre[0];
    out.at[1] = centre[1];
    const bool wheels = e[0].radius != 0.0 || e[1].radius != 0.0;
    if (wheels && dot(d, d) > 1e-12) {
        const V3 n = e[0].radius != 0.0 ? axis[0] : axis[1];
        const double turn = e[0].radius != 0.0 && dot(axis[0], axis[1]) < 0.0 ? -1.0 : 1.0;
        const double s1 = e[1].radius * (e[0].radius != 0.0 ? turn : 1.0);
        const V3 u = tangent_direction(d, n, s1 - e[0].radius);
        // For each wheel: signed radius, axis, and vector from its centre to the tangent point per
        // radius.
        const V3 across = cross(u, n);
        double s[2] = {e[0].radius, s1};
        V3 about[2] = {n, n}, out_of[2] = {across, across};
        if (s[0] != 0.0 && s[1] != 0.0 && !are_parallel(axis[0], axis[1]) &&
            tangent_is_defined(d, n, s1 - s[0])) {
            about[1] = axis[1];
            s[1] = e[1].radius;
            const V3 nearly = d + (s1 - s[0]) * across;
            tangent_between_wheels(d, about, s, nearly, out_of);
        }
        for (int k = 0; k < 2; ++k) {
            if (e[k].radius == 0.0) continue;
            out.at[k] = centre[k] + s[k] * out_of[k];
            const double sense = s[k] > 0.0 ? 1.0 : -1.0;
            const V3 radial = sense * out_of[k];
            // Along the route the line turns by `sense` about its axis. At the first end the arc on
            // the wheel ends at the tangent point; at the second it begins there.
            const double turned = arc(dot(cross(mark[k], radial), about[k]), dot(mark[k], radial));
            out.angle[k] = (k == 0 ? sense : -sense) * turned;
        }
    }
    const V3 straight = out.at[1] - out.at[0];
    out.length = norm(straight);
    out.along = out.length > 1e-12 ? (1.0 / out.length) * straight : V3{1, 0, 0};
    return out;
}

template <class D>
inline double span_path(const D& d, const SpanShape& s) {
    double path = s.length;
    const WholeTurns more = WholeTurns::of(d.anchor);
    for (int k = 0; k < 2; ++k) {
        const double r = d.end[k].radius;
        path += (r < 0.0 ? -r : r) * (s.angle[k] + d.end[k].wound + kWholeTurn * more.turns[k]);
    }
    return path;
}

/// Evaluate the rows of a span on its two bodies. @return the violation without the contribution of
/// the slides.
template <int B, class D>
inline double span_row(const D& d, const BodyRef* b, Rows<B, 1>& out) {
    const SpanShape s = span_shape(d.end, b);
    out.set(0, 0, -s.along, -cross(s.at[0] - b[0].x, s.along));
    out.set(1, 0, s.along, cross(s.at[1] - b[1].x, s.along));
    return span_path(d, s) - d.length;
}

/// Compute the arms from the bodies' centres to the points where the line leaves them.
template <class D>
inline void span_arms(const D& d, const BodyRef* b, V3 (&arm)[2]) {
    const SpanShape s = span_shape(d.end, b);
    for (int k = 0; k < 2; ++k) arm[k] = s.at[k] - b[k].x;
}

inline constexpr ParamInfo kSpanParams[] = {
    {"length", "m", kDefault, 1e-9, 1e6, "Unstretched length with the slides at 0."},
    {"EA", "N", kDefault, 1e-3, 1e15, "Axial stiffness of the line."},
    {"tension_only", "1", 1.0, 0.0, 1.0, "1: goes slack instead of pushing."},
    {"breaking_load", "N", 1e30, 0.0, 1e30, "The span breaks above this tension."},
    {"slide_0", "1", 1.0, -1e3, 1e3, "Length that comes per unit of the first slide."},
    {"slide_1", "1", -1.0, -1e3, 1e3, "Length that comes per unit of the second slide."},
    {"wheel_0", "m", 0.0, -1e3, 1e3,
     "Radius of the wheel at the first body, 0: an eye; below 0: passed turning about -z."},
    {"wheel_1", "m", 0.0, -1e3, 1e3,
     "Radius of the wheel at the second body, with the same signs."}};

struct SpanData {
    SpanEnd end[2];
    double length, slide[2];
    double anchor;  ///< Packed WholeTurns.
#ifdef HAWSER_KIND_SETUP
    static SpanData of(const InteractionDef& d) {
        SpanData o{};
        for (int k = 0; k < 2; ++k) {
            copy_point(d, k, o.end[k].point);
            copy_frame(d, k, o.end[k].frame);
            o.end[k].radius = d.params[6 + static_cast<std::size_t>(k)];
            o.slide[k] = d.params[4 + static_cast<std::size_t>(k)];
        }
        o.length = d.params[0];
        return o;
    }
#endif
};

inline void span_rows(const InteractionDef& d, double h, RowSpec* s) {
    s[0].compliance = given(d.compliance.data()[0], d.params.data()[0] / d.params.data()[1]);
    damping_or_flagged(d, h, 0, s[0]);
    s[0].one_sided = d.params.data()[2] > 0.5;
}

/// Span between two turning points that the line runs through.
struct Span {
    static constexpr int kBodies = 4, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Span,
        .name = "span",
        .bodies = 4,
        .rows = 1,
        .uses_points = true,
        .uses_frames = true,
        .row_units = "m",
        .scalar_slot = 2,
        .scalars = 2,
        .length_from_pose = true,
        .traits = kElastic | kOfWires | kRouted,
        .params = kSpanParams,
        .doc =
            "Part of a line between two turning points. Bodies: the bodies of the two turning "
            "points, and the scalar bodies whose coordinates are the lengths that have run through "
            "them."};
    using Data = SpanData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { span_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<4, 1>& out) {
        const double open = span_row(d, b, out);
        out.g[0] = open - d.slide[0] * b[2].x.x - d.slide[1] * b[3].x.x;
        for (int k = 0; k < 2; ++k) out.set(2 + k, 0, {-d.slide[k], 0, 0}, {0, 0, 0});
    }
    static void line_arms(const Data& d, const BodyRef* b, V3 (&arm)[2]) { span_arms(d, b, arm); }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return Data::of(d); }
#endif
};

inline constexpr ParamInfo kEndSpanParams[] = {
    {"length", "m", kDefault, 1e-9, 1e6, "Unstretched length at `drum_zero`.", true},
    {"EA", "N", kDefault, 1e-3, 1e15, "Axial stiffness of the line."},
    {"tension_only", "1", 1.0, 0.0, 1.0, "1: goes slack instead of pushing."},
    {"breaking_load", "N", 1e30, 0.0, 1e30, "Tension above which it breaks."},
    {"radius", "m", kDefault, -1e3, 1e3,
     "Length that enters per unit of the slide. Above 0: the turning point is on the first body; "
     "below 0: on the second body.",
     true},
    {"drum_zero", "m or rad", 0.0, -1e9, 1e9, "Coordinate of the slide that `length` is given at.",
     true},
    {"wheel", "m", 0.0, -1e3, 1e3,
     "Radius of the wheel at the turning point. 0: an eye. Below 0: the line passes it in the "
     "direction of rotation about -z."},
    {"wound", "rad", 0.0, 0.0, 1e3,
     "Angle of the wheel that the line covers beyond its reference mark."}};

/// Span between a turning point and an end that holds the line: a node of a wire or another body.
/// It acts on nodes of a wire like an element at a drum.
struct EndSpan {
    static constexpr int kBodies = 3, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::line;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::EndSpan,
        .name = "end_span",
        .bodies = 3,
        .rows = 1,
        .uses_points = true,
        .uses_frames = true,
        .row_units = "m",
        .scalar_slot = 2,
        .length_from_pose = true,
        .traits = kAlongLine | kWireElement | kWoundUp | kElastic | kOfWires | kRouted | kAtGuide,
        .params = kEndSpanParams,
        .doc =
            "First or last part of a line over turning points, from its end to the next turning "
            "point. Bodies: the body of the end and that of the turning point, in the order of the "
            "route, and the scalar body whose coordinate is the length that has run through."};
    struct Data {
        SpanEnd end[2];
        double length, radius, zero;
        double anchor;  ///< Packed WholeTurns.
    };
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { span_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<3, 1>& out) {
        out.g[0] = span_row(d, b, out) - d.radius * (b[2].x.x - d.zero);
        out.set(2, 0, {-d.radius, 0, 0}, {0, 0, 0});
    }
    static void line_arms(const Data& d, const BodyRef* b, V3 (&arm)[2]) { span_arms(d, b, arm); }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) {
        Data o{};
        for (int k = 0; k < 2; ++k) {
            copy_point(d, k, o.end[k].point);
            copy_frame(d, k, o.end[k].frame);
        }
        o.length = d.params[0];
        o.radius = d.params[4];
        o.zero = d.params[5];
        SpanEnd& place = o.end[o.radius > 0.0 ? 0 : 1];
        place.radius = d.params[6];
        place.wound = d.params[7];
        return o;
    }
#endif
};

inline constexpr ParamInfo kBodySpanParams[] = {
    {"path", "m", kDefault, 1e-9, 1e6, "Length between the two turning points."},
    {"length", "m", kDefault, 1e-9, 1e6, "Unstretched length with the slides at 0."},
    {"EA", "N", kDefault, 1e-3, 1e15, "Axial stiffness of the line."},
    {"tension_only", "1", 1.0, 0.0, 1.0, "1: goes slack instead of pushing."},
    {"slide_0", "1", 1.0, -1e3, 1e3, "Length that comes per unit of the first slide."},
    {"slide_1", "1", -1.0, -1e3, 1e3, "Length that comes per unit of the second slide."}};

/// Span between two turning points on one body: constant distance, no net force on the body.
struct BodySpan {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::BodySpan,
        .name = "body_span",
        .bodies = 2,
        .rows = 1,
        .uses_points = false,
        .uses_frames = false,
        .row_units = "m",
        .scalar_slot = 0,
        .scalars = 2,
        .traits = kElastic | kOfWires | kRouted,
        .params = kBodySpanParams,
        .doc =
            "Part of a line between two turning points of one body. Bodies: the scalar bodies "
            "whose coordinates are the lengths that have run through them."};
    struct Data {
        double open, slide[2];
    };
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        s[0].compliance = given(d.compliance.data()[0], d.params.data()[1] / d.params.data()[2]);
        damping_or_flagged(d, h, 0, s[0]);
        s[0].one_sided = d.params.data()[3] > 0.5;
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        out.g[0] = d.open - d.slide[0] * b[0].x.x - d.slide[1] * b[1].x.x;
        for (int k = 0; k < 2; ++k) out.set(k, 0, {-d.slide[k], 0, 0}, {0, 0, 0});
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) {
        return {d.params[0] - d.params[1], {d.params[4], d.params[5]}};
    }
#endif
};

inline constexpr ParamInfo kLineFrictionParams[] = {
    {"force", "N", 0.0, 0.0, 1e30, "Largest force, without the contribution of `loads`.", true},
    {"friction", "1", 0.0, 0.0, 10.0, "Friction coefficient of the line at the turning point."},
    {"efficiency", "1", 1.0, 1e-6, 1.0,
     "Efficiency of the turning point as a sheave: lesser tension over greater one, in addition to "
     "friction."},
    {"angle", "rad", 0.0, 0.0, 1e3,
     "Angle by which the line turned at the turning point at the definition, including whole "
     "turns."}};

/// Friction of a line at a turning point. Its loads are the parts before and behind, with the
/// factor tanh((μδ − ln η)/2). Here δ is the angle by which the line turns there at the start of
/// the step (solve/capstans.h). Between two turning points of one body δ is the angle of the
/// definition.
struct LineFriction {
    static constexpr int kBodies = 1, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::LineFriction,
        .name = "line_friction",
        .bodies = 1,
        .rows = 1,
        .uses_points = false,
        .uses_frames = false,
        .row_units = "m",
        .scalar_slot = 0,
        .takes_loads = true,
        .coordinate = KindCoordinate::scalar,
        .traits = kFrictionKind | kFollowsAngle,
        .params = kLineFrictionParams,
        .doc =
            "Friction of a line at a turning point. It acts on the scalar body whose coordinate is "
            "the length that has run through. Its `loads` are the parts before and behind; their "
            "factors follow the angle by which the line turns."};
    using Data = ScalarFriction::Data;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { friction_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<1, 1>& out) {
        ScalarFriction::evaluate(d, b, out);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef&) { return {0.0}; }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
