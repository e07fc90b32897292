// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rigid_lanes.h
/// Eight rigid bodies that stand in a row, a body a lane.

#include "assembly/view.h"
#include "base/transpose.h"

namespace hawser::HAWSER_ISA {

/// Eight rigid bodies in a row, none of them so near the end that vector loads leave the arrays.
inline bool eight_rigid(const assembly::View& view, std::int32_t body) {
    if (body + kLanes + 2 > view.body_count || view.dof[body + kLanes] < 3) return false;
    for (int l = 0; l < kLanes; ++l)
        if (view.dof[body + l] != 6) return false;
    return true;
}

using W3 = V3T<W8>;
using WM3 = M3T<W8>;

/// `stride` doubles a body: the first eight of each of eight bodies, turned into lanes; what there
/// is beyond `stride` may be anything.
inline void load_bodies(const double* first, int stride, V8 (&v)[kLanes]) {
    const int own = stride < kLanes ? stride : kLanes;
    for (int l = 0; l < kLanes; ++l) v[l] = load_at_least(first + l * stride, own);
    transpose(v);
}
/// The other way round: the first `count` of each; turns v.
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
