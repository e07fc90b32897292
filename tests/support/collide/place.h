// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file place.h
/// Placements of shapes in short notation.

#include <hawser/math.h>

#include "collide/geometry.h"

namespace hawser::test {

inline collide::Placement place(const Vec3& x, const Quat& q = Quat::Identity()) {
    collide::Placement p{};
    const Mat3 r = q.toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
        p.x[i] = x[i];
        for (int j = 0; j < 3; ++j) p.r[3 * i + j] = r(i, j);
    }
    return p;
}

inline Quat turn(double angle, const Vec3& about) {
    return Quat(Eigen::AngleAxisd(angle, about.normalized()));
}

}  // namespace hawser::test
