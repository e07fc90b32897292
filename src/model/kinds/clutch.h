// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file clutch.h
/// Couple two scalar bodies.
///
/// With q_k their coordinates the row is q̇₁ − q̇₀ = u within a range of forces. At u = 0 it is a
/// closed clutch, which slips if the required force exceeds the range. Its power counts as driven.

#include "model/kinds/drives.h"

namespace hawser::HAWSER_ISA::kinds {

/// Drive of a scalar body against another one: a clutch that slips beyond a force, or a chain in
/// the pockets of its wheel.
struct ScalarClutch {
    static constexpr int kBodies = 2, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::ScalarClutch,
        .name = "scalar_clutch",
        .bodies = 2,
        .rows = 1,
        .uses_points = false,
        .uses_frames = false,
        .row_units = "v",
        .scalar_slot = 0,
        .scalars = 2,
        .coordinate = KindCoordinate::scalar,
        .traits = kMotorKind,
        .params = kMotorParams,
        .doc =
            "Sets the relative speed of two scalar bodies, 0 to couple them: a clutch that "
            "slips beyond its largest force. Its coordinate is that of the second body less "
            "that of the first."};
    using Data = TargetData;
    static void defaults(const InteractionDef& d, double, RowSpec* s) { motor_rows(d, s); }
    static void evaluate(const Data& d, const BodyRef*, Rows<2, 1>& out) {
        out.g[0] = d.target;
        out.set(0, 0, {-1, 0, 0}, {0, 0, 0});
        out.set(1, 0, {1, 0, 0}, {0, 0, 0});
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) { return {d.params[0]}; }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
