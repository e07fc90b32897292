// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gear.h
/// Couple two meshing wheels: the numbers of teeth relate their rotations against a carrier.
///
/// With θ_k the angle of wheel k against the carrier, by the frames' x axes, and N = n₁, n₂ teeth:
/// ```
///     g = wrap(n₁ θ₁ + n₂ θ₂) / n₁                     [rad of wheel 1]
///     ġ = a·(ω₁ − ω₀) + (n₂/n₁) a·(ω₂ − ω₀)
/// ```
/// Angles are known modulo whole turns. Since n₁ and n₂ are integers, a whole turn of a wheel
/// changes the sum by a multiple of 2π, which wrap() removes. No turns are counted, so the row
/// depends on poses alone and is the same after a restore. Outer teeth, n₂ > 0, turn the wheels
/// in opposite senses; inner teeth, n₂ < 0, in the same sense.
///
/// Limits: a slip of more than half a tooth within a step, π/n₁, engages the next tooth. The
/// world's monitor of joints reports it before (EventKind::joint_open). The bearings of the wheels
/// must keep the axes parallel. There is no play and no friction of teeth. There is no force that
/// pushes the wheels apart; such bearing forces do not appear in any torque.

#include "model/kinds/common.h"

#ifdef HAWSER_KIND_SETUP
#include <hawser/def.h>

#include <cmath>
#include <string>
#endif

namespace hawser::HAWSER_ISA::kinds {

inline constexpr ParamInfo kGearParams[] = {
    {"teeth_1", "1", kDefault, 1.0, 1e4, "Teeth of the first wheel, a whole number."},
    {"teeth_2", "1", kDefault, -1e4, 1e4,
     "Teeth of the second wheel, a whole number; below 0: inside of a ring."}};

struct Gear {
    static constexpr int kBodies = 3, kRows = 1;
    static constexpr Geometry kGeometry = Geometry::none;
    static constexpr KindInfo kInfo{
        .kind = InteractionKind::Gear,
        .name = "gear",
        .bodies = 3,
        .rows = 1,
        .uses_points = false,
        .uses_frames = true,
        .row_units = "r",
        .params = kGearParams,
        .doc =
            "Couples the turns of two wheels against a carrier, about the z axes of the three "
            "frames, which are parallel: teeth_1 θ₁ + teeth_2 θ₂ = 0. Bodies: carrier, first "
            "wheel, second wheel; their hinges are interactions of their own."};
    struct Data {
        double frame[3][9];
        double teeth[2];
    };
    static void defaults(const InteractionDef& d, double h, RowSpec* s) {
        constraint_rows(d, h, 0, 1, false, s);
    }
    static void evaluate(const Data& d, const BodyRef* b, Rows<3, 1>& out) {
        const Axes carrier = axes(b[0], d.frame[0]);
        V3 axis[2];
        double sum = 0.0;
        for (int k = 0; k < 2; ++k)
            sum += d.teeth[k] * twist(carrier, axes(b[1 + k], d.frame[1 + k]), axis[k]);
        constexpr double kTurn = 6.283185307179586;
        out.g[0] = (sum - kTurn * __builtin_nearbyint(sum / kTurn)) / d.teeth[0];
        const V3 second = (d.teeth[1] / d.teeth[0]) * axis[1];
        out.set(0, 0, {0, 0, 0}, -(axis[0] + second));
        out.set(1, 0, {0, 0, 0}, axis[0]);
        out.set(2, 0, {0, 0, 0}, second);
    }
#ifdef HAWSER_KIND_SETUP
    static Data make(const InteractionDef& d) {
        Data o{};
        for (int b = 0; b < 3; ++b) copy_frame(d, b, o.frame[b]);
        for (std::size_t k = 0; k < 2; ++k) o.teeth[k] = d.params[k];
        return o;
    }
    /// Check the numbers of teeth. @throws DefError if one is no whole number or 0.
    static void complete(InteractionDef& d, const Vec3*) {
        for (const double teeth : {d.params[0], d.params[1]})
            if (teeth == 0.0 || teeth != std::round(teeth))
                throw DefError("gear" + (d.name.empty() ? "" : " '" + d.name + "'") +
                               ": teeth_1 and teeth_2 are whole numbers other than 0, such as 20 "
                               "and 60");
    }
#endif
};

}  // namespace hawser::HAWSER_ISA::kinds
