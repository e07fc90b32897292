// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file geo_force.h
/// Geometric terms of one interaction in the equations of its bodies (assembly/geo.h).

#include "assembly/geo.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {

/// Read the velocity of a slot from a packed array. Bodies without degrees of freedom use v_fixed.
inline void slot_velocity(const assembly::View& view, const double* v, std::int32_t body, V3& lin,
                          V3& ang) {
    const int dof = view.dof[body];
    const double* fixed_velocities = v == view.v ? view.v_before : view.v_fixed;
    const double* p = dof == 0 ? fixed_velocities + 6 * body : v + view.dof_begin[body];
    lin = dof == 1 ? V3{0, 0, 0} : load3(p);
    ang = dof == 6 || dof == 0 ? load3(p + 3) : V3{0, 0, 0};
}

/// Add the contribution of a line to the right-hand side a of its two bodies. @param fraction
/// Fraction of K that acts on v; the rest acts on v_ahead.
inline void line_past(const assembly::View& view, std::int32_t id, double fraction) {
    const assembly::GeoSlot& place = view.geo[id];
    const double* rec = view.geo_record + place.record;
    double* out[2] = {view.geo_force + place.slot(0) + place.dof,
                      view.geo_force + place.slot(1) + place.dof};
    const double pair = pair_mass_of(view, id);
    if (rec[0] == 0.0 && pair == 0.0) {
        for (double* o : out)
            for (int i = 0; i < place.dof; ++i) o[i] = 0.0;
        return;
    }
    const std::int32_t* body = view.body + kMaxInteractionBodies * id;
    V3 lin[2], ang[2], moved{0, 0, 0};
    for (int b = 0; b < 2; ++b) {
        V3 ahead, turn;
        slot_velocity(view, view.v, body[b], lin[b], ang[b]);
        slot_velocity(view, view.v_ahead, body[b], ahead, turn);
        moved = b == 0 ? lin[0] : moved - lin[1];
        lin[b] = fraction * lin[b] + (1.0 - fraction) * ahead;
        ang[b] = fraction * ang[b] + (1.0 - fraction) * turn;
    }
    if (place.dof == 3) {  // no arms: one slot for both
        const V3 u = load3(rec + 1), rel = lin[0] - lin[1];
        V3 t = rec[0] * (rel - dot(u, rel) * u);
        if (pair != 0.0) t = t - pair * moved;
        store3(out[0], t);
        return;
    }
    geo_product(rec, lin, ang, 0.0, out[0], out[1]);
}

/// Compute the contribution of an interaction to M̃ v of its two bodies (geo.h). With `damping`
/// (geo_product()), compute its contribution to a. @param from  0 or dof: half of the slot, see
/// GeoSlot.
inline void geo_force(const assembly::View& view, std::int32_t id, const double* v,
                      double damping = 1.0, int from = 0) {
    const assembly::GeoSlot& place = view.geo[id];
    const double* rec = view.geo_record + place.record;
    double* out[2] = {view.geo_force + place.slot(0) + from, view.geo_force + place.slot(1) + from};
    const std::int32_t* body = view.body + kMaxInteractionBodies * id;
    if (place.dof == 3) {  // no arms: one slot for both
        const V3 u = load3(rec + 1);
        V3 lin[2], ang;
        for (int b = 0; b < 2; ++b) slot_velocity(view, v, body[b], lin[b], ang);
        const V3 rel = lin[0] - lin[1];
        V3 t = rec[0] * (rel - dot(u, rel) * u);
        if (const double pair = pair_mass_of(view, id); pair != 0.0) t = t - pair * rel;
        store3(out[0], t);
        return;
    }
    if (rec[0] == 0.0 && rec[22] == 0.0) {
        for (double* o : out)
            for (int i = 0; i < 6; ++i) o[i] = 0.0;
        return;
    }
    if (rec[0] == 0.0) {  // damping of a joint between two rigid bodies
        const V3 d = (damping * rec[22]) * (load3(v + view.dof_begin[body[0]] + 3) -
                                            load3(v + view.dof_begin[body[1]] + 3));
        store3(out[0], {0, 0, 0});
        store3(out[0] + 3, d);
        store3(out[1], {0, 0, 0});
        store3(out[1] + 3, -d);
        return;
    }
    V3 lin[2], ang[2];
    for (int b = 0; b < 2; ++b) slot_velocity(view, v, body[b], lin[b], ang[b]);
    geo_product(rec, lin, ang, damping, out[0], out[1]);
}

}  // namespace hawser::HAWSER_ISA
