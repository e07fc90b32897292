// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rigid_lanes.h
/// Eight rigid bodies with consecutive indices, one per lane.

#include "assembly/view.h"
#include "base/lanes.h"
#include "base/transpose.h"

#include <cstring>

namespace hawser::HAWSER_ISA {

/// True if eight consecutive bodies from `body` on are rigid and vector loads stay within the
/// arrays.
inline bool eight_rigid(const assembly::View& view, std::int32_t body) {
    if (body + kLanes > view.body_count) return false;
    if (!kExactLoads && (body + kLanes + 2 > view.body_count || view.dof[body + kLanes] < 3))
        return false;
    std::uint64_t dof;
    std::memcpy(&dof, view.dof + body, sizeof dof);
    return dof == 0x0606060606060606;
}

using W3 = V3T<W8>;
using WM3 = M3T<W8>;

/// Load eight consecutive three-vectors, one vector per lane.
inline W3 load_threes(const double* p) {
    V8 v[3];
    load_threes(p, v);
    return {v[0], v[1], v[2]};
}

/// Shift the lanes of v down by one, and set the last lane to the vector at p.
inline W3 shift_in(const W3& v, const double* p) {
    return {shift_in(v.x, p[0]), shift_in(v.y, p[1]), shift_in(v.z, p[2])};
}
/// Store eight consecutive three-vectors in the layout of load_threes().
inline void store_threes(double* p, const W3& v) { store_every<3>(p, {v.x, v.y, v.z}); }

/// Load the first eight of `stride` doubles of each of eight bodies, transposed into lanes. Entries
/// beyond `stride` are unspecified.
inline void load_bodies(const double* first, int stride, V8 (&v)[kLanes]) {
    const int own = stride < kLanes ? stride : kLanes;
    for (int l = 0; l < kLanes; ++l) v[l] = load_at_least(first + l * stride, own);
    transpose(v);
}
/// True if the axes of all eight bodies are principal axes. @param moment  Bodies::principal.
inline bool all_principal(const V8& moment) {
    return !any(select_greater(moment, V8{}, V8{}, one(moment)));
}
/// True if any of the six values of eight bodies is not zero.
inline bool any_of_six(const double* first) {
    V8 size{};
    for (int k = 0; k < 6; ++k) {
        const V8 some = load(first + kLanes * k);
        size += select_greater(some, -some, some, -some);
    }
    return any(size);
}
/// Store the first `count` entries of each of eight bodies, `stride` doubles per body. Transposes
/// v.
inline void store_bodies(double* first, int stride, int count, V8 (&v)[kLanes]) {
    transpose(v);
    for (int l = 0; l < kLanes; ++l) store_lanes(first + l * stride, v[l], 0, count);
}
inline WM3 load_bodies9(const double* first) {
    V8 v[kLanes], last[kLanes];
    load_bodies(first, 9, v);
    load_bodies(first + 1, 9, last);
    return {{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], last[7]}};
}

}  // namespace hawser::HAWSER_ISA
