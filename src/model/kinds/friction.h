// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file friction.h
/// Define dry friction in hinges, on sliders and of scalar bodies. With a bound that an input
/// drives it is a brake.
///
/// ```
///   q ──┤ spring ε ├── anchor ──┤ slides beyond F ├──
/// ```
/// A stiff spring connects a coordinate q to an anchor: g = q − anchor. While |force| ≤ F the
/// anchor is fixed, so that nothing creeps: at rest g = −ε f. At ±F the row has that force, and the
/// anchor follows at the distance ε F (solve/bounds.h).
///
/// A band brake holds less in one direction than in the other, because the drum tightens or
/// slackens its band: `back` is the ratio. F is a parameter plus a fraction of the force of other
/// interactions. Examples are the force of a bearing, or of the two ends of a line round a bollard.

#include "model/kinds/drives.h"

namespace hawser::HAWSER_ISA::kinds {

inline constexpr ParamInfo kTorqueParams[] = {
    {"torque", "N m", 0.0, 0.0, 1e30, "Largest torque, without the contribution of `loads`.",
     true}};
inline constexpr ParamInfo kForceParams[] = {
    {"force", "N", 0.0, 0.0, 1e30, "Largest force, without the contribution of `loads`.", true}};

inline constexpr ParamInfo kScalarFrictionParams[] = {
    {"force", "N", 0.0, 0.0, 1e30, "Largest force, without the contribution of `loads`.", true},
    {"back", "1", 1.0, 0.0, 1e6,
     "Bound against motion down the coordinate, over that against motion up it.", true}};

inline void friction_rows(const InteractionDef& d, double h, RowSpec* s) {
    constraint_rows(d, h, 0, 1, false, s, kStopCompliance);
    s[0].friction = true;
}

struct JointFrictionData {
    double anchor;  ///< Anchor; part of the state as Interactions::anchor.
    JointData joint;
#ifdef HAWSER_KIND_SETUP
    static JointFrictionData of(const InteractionDef& d) { return {0.0, JointData::of(d)}; }
#endif
};

/// Friction of a hinge.
struct HingeFriction {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::HingeFriction,
                                    .name = "hinge_friction",
                                    .bodies = 2,
                                    .rows = 1,
                                    .uses_points = false,
                                    .uses_frames = true,
                                    .row_units = "r",
                                    .takes_loads = true,
                                    .coordinate = KindCoordinate::about,
                                    .traits = kFrictionKind,
                                    .params = kTorqueParams,
                                    .doc =
                                        "Dry friction, or a brake, about z of the frames. Other "
                                        "interactions may add to its bound (`loads`)."};
    using Data = JointFrictionData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { friction_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        hinge_row(d.joint, b, out);
        out.g[0] = turned(out.g[0] - d.anchor);
    }
    /// Map an angle to the equivalent angle in [−π, π].
    static double turned(double angle) {
        constexpr double kTurn = 6.283185307179586;
        return angle - kTurn * __builtin_round(angle / kTurn);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return Data::of(d); }
#endif
};

/// Friction of a slider.
struct SlideFriction {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::SlideFriction,
                                    .name = "slide_friction",
                                    .bodies = 2,
                                    .rows = 1,
                                    .uses_points = true,
                                    .uses_frames = true,
                                    .row_units = "m",
                                    .takes_loads = true,
                                    .coordinate = KindCoordinate::along,
                                    .traits = kFrictionKind,
                                    .params = kForceParams,
                                    .doc =
                                        "Dry friction, or a brake, along z of frame 0. Other "
                                        "interactions may add to its bound (`loads`)."};
    using Data = JointFrictionData;
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { friction_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<2, 1>& out) {
        travel_row(d.joint, b, out);
        out.g[0] -= d.anchor;
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return Data::of(d); }
#endif
};

/// Friction of a scalar body.
struct ScalarFriction {
    static constexpr int kBodies = 1, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{.kind = InteractionKind::ScalarFriction,
                                    .name = "scalar_friction",
                                    .bodies = 1,
                                    .rows = 1,
                                    .uses_points = false,
                                    .uses_frames = false,
                                    .row_units = "m",
                                    .scalar_slot = 0,
                                    .takes_loads = true,
                                    .coordinate = KindCoordinate::scalar,
                                    .traits = kFrictionKind,
                                    .params = kScalarFrictionParams,
                                    .doc =
                                        "Dry friction, or a brake, of a scalar body (drum, spool). "
                                        "Other interactions may add to its bound (`loads`)."};
    struct Data {
        double anchor;
    };
    static void defaults(const InteractionDef& d, double h, RowSpec* s) { friction_rows(d, h, s); }
    static void evaluate(const Data& d, const BodyRef* b, Rows<1, 1>& out) {
        out.g[0] = b[0].x.x - d.anchor;
        out.set(0, 0, {1, 0, 0}, {0, 0, 0});
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef&) { return {0.0}; }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
