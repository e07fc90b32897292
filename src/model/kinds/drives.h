// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drives.h
/// Define holds, motors and ranges: rows with a target.

#include "model/kinds/common.h"

namespace hawser::HAWSER_ISA::kinds {

struct TargetData {
    double target;
};

inline constexpr ParamInfo kHoldParams[] = {{"target", "m or rad", kDefault, -1e9, 1e9,
                                             "Coordinate held; default: the initial one.", true}};

/// Hold of a scalar body at a coordinate: a brake that does not slip.
struct Hold {
    static constexpr int kBodies = 1, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::Hold,
                                    .name = "hold",
                                    .bodies = 1,
                                    .rows = 1,
                                    .uses_points = false,
                                    .uses_frames = false,
                                    .row_units = "m",
                                    .scalar_slot = 0,
                                    .from_pose = "target",
                                    .coordinate = KindCoordinate::scalar,
                                    .params = kHoldParams,
                                    .doc = "Holds a scalar body (drum, spool) at a coordinate."};
    using Data = TargetData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 1, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<1, 1>& out) {
        out.g[0] = b[0].x.x - d.target;
        out.set(0, 0, {1, 0, 0}, {0, 0, 0});
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return {d.params[0]}; }
    static void complete(InteractionDef& d, const Vec3* position) {
        d.params[0] = given(d.params[0], position[0].x());
    }
#endif
};

/// Evaluate row 0: the angle of frame 1 against frame 0 about z.
inline void hinge_row(const JointData& joint, const BodyRef* b, Rows<2, 1>& out) {
    V3 t;
    out.g[0] = twist(axes(b[0], joint.frame[0]), axes(b[1], joint.frame[1]), t);
    out.set(0, 0, {0, 0, 0}, -t);
    out.set(1, 0, {0, 0, 0}, t);
}

/// Evaluate row 0: the travel of body 1 along z of frame 0.
inline void travel_row(const JointData& joint, const BodyRef* b, Rows<2, 1>& out) {
    const V3 ra = b[0].arm(joint.point[0]), rb = b[1].arm(joint.point[1]);
    slide_row(axes(b[0], joint.frame[0]).z, ra, rb, b[1].x + rb - b[0].x - ra, 0, out);
}

inline constexpr ParamInfo kMotorParams[] = {
    {"speed", "m/s or rad/s", 0.0, -1e6, 1e6, "Speed wanted.", true},
    {"force_min", "N or N m", -1e30, -1e30, 1e30, "Smallest force or torque.", true},
    {"force_max", "N or N m", 1e30, -1e30, 1e30, "Largest force or torque.", true},
    {"power", "W", 1e30, 0.0, 1e30,
     "Largest power with which it drives: force times speed at the end of the step. Braking is "
     "bounded by the force alone."}};

inline void motor_rows(const InteractionDef& d, RowSpec* s) {
    s[0].compliance = given(d.compliance.data()[0], kStopCompliance);
    s[0].velocity = true;
}

struct MotorData {
    double speed;
    JointData joint;
#ifdef HAWSER_KIND_SETUP
    static MotorData of(const InteractionDef& d) { return {d.params[0], JointData::of(d)}; }
#endif
};

/// Motor of a hinge's angle at a speed.
struct HingeMotor {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::HingeMotor,
        .name = "hinge_motor",
        .bodies = 2,
        .rows = 1,
        .uses_points = false,
        .uses_frames = true,
        .row_units = "v",
        .coordinate = KindCoordinate::about,
        .traits = kMotorKind,
        .params = kMotorParams,
        .doc = "Turns body 1 against body 0 about z of frame 0 at a speed."};
    using Data = MotorData;
    static void defaults(const InteractionDef& d, double, RowSpec* s) { motor_rows(d, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        const V3 z = axes(b[0], d.joint.frame[0]).z;
        out.g[0] = d.speed;
        out.set(0, 0, {0, 0, 0}, -z);
        out.set(1, 0, {0, 0, 0}, z);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return MotorData::of(d); }
#endif
};

/// Motor of a slider at a speed.
struct SlideMotor {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::SlideMotor,
                                    .name = "slide_motor",
                                    .bodies = 2,
                                    .rows = 1,
                                    .uses_points = true,
                                    .uses_frames = true,
                                    .row_units = "v",
                                    .coordinate = KindCoordinate::along,
                                    .traits = kMotorKind,
                                    .params = kMotorParams,
                                    .doc = "Moves body 1 along z of frame 0 at a speed."};
    using Data = MotorData;
    static void defaults(const InteractionDef& d, double, RowSpec* s) { motor_rows(d, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        travel_row(d.joint, b, out);
        out.g[0] = d.speed;
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return MotorData::of(d); }
#endif
};

/// Motor of a scalar body at a speed.
struct ScalarMotor {
    static constexpr int kBodies = 1, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::ScalarMotor,
                                    .name = "scalar_motor",
                                    .bodies = 1,
                                    .rows = 1,
                                    .uses_points = false,
                                    .uses_frames = false,
                                    .row_units = "v",
                                    .scalar_slot = 0,
                                    .coordinate = KindCoordinate::scalar,
                                    .traits = kMotorKind,
                                    .params = kMotorParams,
                                    .doc = "Turns a scalar body (drum) at a speed."};
    using Data = TargetData;
    static void defaults(const InteractionDef& d, double, RowSpec* s) { motor_rows(d, s); }
    static void evaluate(const Data& d, const BodyRef*, Rows<1, 1>& out) {
        out.g[0] = d.target;
        out.set(0, 0, {1, 0, 0}, {0, 0, 0});
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return {d.params[0]}; }
#endif
};

inline constexpr ParamInfo kSlideRangeParams[] = {
    {"min", "m", kDefault, -1e9, 1e9, "Lower end of the range."},
    {"max", "m", kDefault, -1e9, 1e9, "Upper end of the range."}};

struct RangeData {
    double min, max;
    JointData joint;
#ifdef HAWSER_KIND_SETUP
    static RangeData of(const InteractionDef& d) {
        return {d.params[0], d.params[1], JointData::of(d)};
    }
#endif
    /// Return the distance of a coordinate q from the range [m or rad]: negative below, positive
    /// above, 0 inside.
    [[nodiscard]] double outside(double q) const {
        return q < min ? q - min : (q > max ? q - max : 0.0);
    }
};

/// Distances of a coordinate from the lower and to the upper end of its range, negative beyond an
/// end; kNoEnd without an end [m or rad].
struct RangeEnds {
    double low, high;
};
inline constexpr double kNoEnd = 1e30;  // model::kUnbounded

inline void range_rows(const InteractionDef& d, double h, RowSpec* s) {
    constraint_rows(d, h, 0, 1, false, s, kStopCompliance);
    s[0].range = true;
}

inline constexpr ParamInfo kHingeRangeParams[] = {
    {"min", "rad", kDefault, -1e9, 1e9,
     "Lower end of the range. Values of -π or less mean no limit: the angle is between -π and π "
     "and does not count turns."},
    {"max", "rad", kDefault, -1e9, 1e9,
     "Upper end of the range. Values of π or more mean no limit. A joint that passes π within a "
     "step is assumed to come from below."}};

/// Range of a hinge's angle; inactive inside.
struct HingeRange {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::HingeRange,
        .name = "hinge_range",
        .bodies = 2,
        .rows = 1,
        .uses_points = false,
        .uses_frames = true,
        .row_units = "r",
        .coordinate = KindCoordinate::about,
        .traits = kRangeKind,
        .params = kHingeRangeParams,
        .doc = "Range of the angle of frame 1 against frame 0 about z."};
    using Data = RangeData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { range_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        (void)evaluate_ends(d, b, out);
    }
    static RangeEnds evaluate_ends(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        constexpr double kHalfTurn = 3.14159265358979323846;
        hinge_row(d.joint, b, out);
        const double q = out.g[0];
        out.g[0] = d.outside(q);
        return {d.min > -kHalfTurn ? q - d.min : kNoEnd, d.max < kHalfTurn ? d.max - q : kNoEnd};
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return RangeData::of(d); }
#endif
};

/// Range of a slider's travel; inactive inside.
struct SlideRange {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::SlideRange,
                                    .name = "slide_range",
                                    .bodies = 2,
                                    .rows = 1,
                                    .uses_points = true,
                                    .uses_frames = true,
                                    .row_units = "m",
                                    .coordinate = KindCoordinate::along,
                                    .traits = kRangeKind,
                                    .params = kSlideRangeParams,
                                    .doc = "Range of the travel of body 1 along z of frame 0."};
    using Data = RangeData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { range_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        (void)evaluate_ends(d, b, out);
    }
    static RangeEnds evaluate_ends(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        travel_row(d.joint, b, out);
        const double q = out.g[0];
        out.g[0] = d.outside(q);
        return {d.min > -kNoEnd ? q - d.min : kNoEnd, d.max < kNoEnd ? d.max - q : kNoEnd};
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return RangeData::of(d); }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
