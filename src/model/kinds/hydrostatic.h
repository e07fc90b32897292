// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydrostatic.h
/// Define linear hydrostatics of a floating body: three springs against still water.

#include "model/kinds/common.h"

namespace hawser::HAWSER_ISA::kinds {

inline constexpr ParamInfo kHydrostaticParams[] = {
    {"heave_stiffness", "N/m", kDefault, 1e-6, 1e15, "ρ g × waterplane area."},
    {"roll_stiffness", "N m/rad", kDefault, 1e-6, 1e18,
     "Restoring stiffness about the body's x axis."},
    {"pitch_stiffness", "N m/rad", kDefault, 1e-6, 1e18,
     "Restoring stiffness about the body's y axis."},
    {"heave_damping", "N s/m", 0.0, 0.0, 1e15, "Linear damping in heave."},
    {"roll_damping", "N m s/rad", 0.0, 0.0, 1e18, "Linear damping in roll."},
    {"pitch_damping", "N m s/rad", 0.0, 0.0, 1e18, "Linear damping in pitch."},
    {"rest_height", "m", kDefault, -1e6, 1e6, "Height of the body at rest; default: initial."}};

/// Linear restoring of a floating body: heave, roll, pitch.
struct Hydrostatic {
    static constexpr int kBodies = 1, kRows = 3;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Hydrostatic,
        .name = "hydrostatic",
        .bodies = 1,
        .rows = 3,
        .uses_points = false,
        .uses_frames = false,
        .row_units = "mrr",
        .from_pose = "rest_height",
        .traits = kElastic | kRigidOnly,
        .params = kHydrostaticParams,
        .doc =
            "Linear hydrostatic restoring and damping of one floating body in heave, roll "
            "and pitch; pair with gravity off, or with the weight in rest_height."};
    struct Data {
        double rest;
    };
    static void defaults(const InteractionDef& d, double, RowSpec* s) {
        const double* p = d.params.data();
        for (int r = 0; r < 3; ++r) {
            s[r].compliance = given(d.compliance.data()[r], 1.0 / p[r]);
            s[r].damping_time = given(d.damping_time.data()[r], p[3 + r] / p[r]);
        }
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<1, 3>& out) {
        const double* r = b[0].r;
        const V3 x{r[0], r[3], r[6]}, y{r[1], r[4], r[7]}, up{0, 0, 1};
        out.g[0] = b[0].x.z - d.rest;
        out.set(0, 0, up, {0, 0, 0});
        out.g[1] = y.z;
        out.set(0, 1, {0, 0, 0}, cross(y, up));
        out.g[2] = -x.z;
        out.set(0, 2, {0, 0, 0}, -cross(x, up));
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return {d.params[6]}; }
    static void complete(InteractionDef& d, const Vec3* position) {
        d.params[6] = given(d.params[6], position[0].z());
    }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
