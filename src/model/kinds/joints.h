// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joints.h
/// Define constraints between two bodies: ball, hinge, prismatic, cylindrical, universal, lock.
/// Frame 0 is fixed in body 0, frame 1 in body 1; the joint's axis is z of frame 0.

#include "model/kinds/common.h"

namespace hawser::HAWSER_ISA::kinds {

/// Ball joint: two points coincide.
struct Ball {
    static constexpr int kBodies = 2, kRows = 3;
    static constexpr Geometry kGeometry = Geometry::joint;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Ball,
        .name = "ball",
        .bodies = 2,
        .rows = 3,
        .uses_points = true,
        .uses_frames = false,
        .row_units = "mmm",
        .traits = kHoldsBodies | kForceOnSecond | kOfWires | kCompact,
        .doc = "Ball joint: a point of one body stays on a point of the other."};
    /// Compact between two rigid bodies, see model/arms.h.
    static constexpr bool kMayBeCompact = true;
    template <class T>
    struct DataT {
        T point[2][3];
    };
    using Data = DataT<double>;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 3, true, s);
    }
    template <class T, class Ref>
    static void evaluate(const DataT<T>& d, const Ref* b, Rows<2, 3, T>& out) {
        point_rows(b, b[0].arm(d.point[0]), b[1].arm(d.point[1]), out);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) {
        Data o{};
        copy_point(d, 0, o.point[0]);
        copy_point(d, 1, o.point[1]);
        return o;
    }
#endif
};

/// Common base of the kinds with JointData.
struct JointKind {
    using Data = JointData;
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return JointData::of(d); }
#endif
};

/// Hinge: two points coincide and two axes stay parallel.
struct Hinge : JointKind {
    static constexpr int kBodies = 2, kRows = 5;
    static constexpr Geometry kGeometry = Geometry::joint;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{.kind = InteractionKind::Hinge,
                                    .name = "hinge",
                                    .bodies = 2,
                                    .rows = 5,
                                    .uses_points = true,
                                    .uses_frames = true,
                                    .row_units = "mmmrr",
                                    .coordinate = KindCoordinate::about,
                                    .traits = kHoldsBodies | kForceOnSecond,
                                    .doc =
                                        "Hinge: a point of both bodies coincides, and they rotate "
                                        "about the z axis of the frames."};
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 3, true, s);
        constraint_rows(d, h, 3, 2, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 5>& out) {
        point_rows(b, b[0].arm(d.point[0]), b[1].arm(d.point[1]), out);
        const Axes p = axes(b[0], d.frame[0]), q = axes(b[1], d.frame[1]);
        dot_row(p.x, q.z, 3, out);
        dot_row(p.y, q.z, 4, out);
    }
};

/// Slider: no relative rotation, translation along the axis only.
struct Prismatic : JointKind {
    static constexpr int kBodies = 2, kRows = 5;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Prismatic,
        .name = "prismatic",
        .bodies = 2,
        .rows = 5,
        .uses_points = true,
        .uses_frames = true,
        .row_units = "mmrrr",
        .coordinate = KindCoordinate::along,
        .traits = kHoldsBodies | kSlides,
        .doc = "Slider: body 1 moves along z of frame 0 and does not turn against body 0."};
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 2, true, s);
        constraint_rows(d, h, 2, 3, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 5>& out) {
        const V3 ra = b[0].arm(d.point[0]), rb = b[1].arm(d.point[1]);
        const V3 u = b[1].x + rb - b[0].x - ra;
        const Axes p = axes(b[0], d.frame[0]), q = axes(b[1], d.frame[1]);
        slide_row(p.x, ra, rb, u, 0, out);
        slide_row(p.y, ra, rb, u, 1, out);
        dot_row(p.x, q.z, 2, out);
        dot_row(p.y, q.z, 3, out);
        dot_row(p.x, q.y, 4, out);
    }
};

/// Cylindrical joint: translation along and rotation about one axis.
struct Cylindrical : JointKind {
    static constexpr int kBodies = 2, kRows = 4;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{.kind = InteractionKind::Cylindrical,
                                    .name = "cylindrical",
                                    .bodies = 2,
                                    .rows = 4,
                                    .uses_points = true,
                                    .uses_frames = true,
                                    .row_units = "mmrr",
                                    .coordinate = KindCoordinate::along,
                                    .traits = kHoldsBodies | kSlides,
                                    .doc = "Body 1 slides along and turns about z of frame 0."};
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 2, true, s);
        constraint_rows(d, h, 2, 2, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 4>& out) {
        const V3 ra = b[0].arm(d.point[0]), rb = b[1].arm(d.point[1]);
        const V3 u = b[1].x + rb - b[0].x - ra;
        const Axes p = axes(b[0], d.frame[0]), q = axes(b[1], d.frame[1]);
        slide_row(p.x, ra, rb, u, 0, out);
        slide_row(p.y, ra, rb, u, 1, out);
        dot_row(p.x, q.z, 2, out);
        dot_row(p.y, q.z, 3, out);
    }
};

/// Universal joint: two points coincide; z of frame 0 stays perpendicular to z of frame 1.
struct Universal : JointKind {
    static constexpr int kBodies = 2, kRows = 4;
    static constexpr Geometry kGeometry = Geometry::joint;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Universal,
        .name = "universal",
        .bodies = 2,
        .rows = 4,
        .uses_points = true,
        .uses_frames = true,
        .row_units = "mmmr",
        .traits = kHoldsBodies | kForceOnSecond | kTwoAxes,
        .doc = "Cardan joint: a shared point, and z of frame 0 stays square to z of frame 1."};
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 3, true, s);
        constraint_rows(d, h, 3, 1, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 4>& out) {
        point_rows(b, b[0].arm(d.point[0]), b[1].arm(d.point[1]), out);
        dot_row(axes(b[0], d.frame[0]).z, axes(b[1], d.frame[1]).z, 3, out);
    }
};

/// Lock: no relative motion.
struct Lock : JointKind {
    static constexpr int kBodies = 2, kRows = 6;
    static constexpr Geometry kGeometry = Geometry::joint;
    static constexpr bool kCompletes = true;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Lock,
        .name = "lock",
        .bodies = 2,
        .rows = 6,
        .uses_points = true,
        .uses_frames = true,
        .row_units = "mmmrrr",
        .traits = kHoldsBodies | kForceOnSecond | kAxisFree,
        .doc = "Welds two bodies together: the points and the frames coincide."};
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 3, true, s);
        constraint_rows(d, h, 3, 3, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 6>& out) {
        point_rows(b, b[0].arm(d.point[0]), b[1].arm(d.point[1]), out);
        const Axes p = axes(b[0], d.frame[0]), q = axes(b[1], d.frame[1]);
        dot_row(p.x, q.z, 3, out);
        dot_row(p.y, q.z, 4, out);
        dot_row(p.x, q.y, 5, out);
    }
};

}  // namespace hawser::HAWSER_ISA::kinds
