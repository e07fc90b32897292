// SPDX-License-Identifier: Apache-2.0
#include "model/arms.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hawser::model {
namespace {

/// G (v₀, ω₀, v₁, ω₁) is the velocity of the joint's point on body 1 minus that of body 0.
TEST(Arms, UnpackToTheRowsOfABallJoint) {
    const double record[kArms] = {0.3, -1.1, 2.0, 0.7, 0.5, -0.9, 5.0, 6.0};
    double buffer[kArmBufferSize];
    std::fill_n(buffer, kArmBufferSize, std::nan(""));
    const double* packed = packed_rows(record, true, buffer);
    // Vectors that start within the last row end behind it.
    for (int k = kArmRows * kArmWidth; k < kArmBufferSize; ++k) EXPECT_EQ(packed[k], 0.0);
    const Eigen::Map<const Eigen::Matrix<double, 3, 12, Eigen::RowMajor>> g(packed);
    Eigen::Matrix<double, 12, 1> u;
    u << 1, 2, 3, -0.5, 0.25, 2, 4, -1, 0.5, 1.5, -2, 0.75;
    const Eigen::Vector3d r0(0.3, -1.1, 2.0), r1(0.7, 0.5, -0.9);
    const Eigen::Vector3d w0 = u.segment<3>(3), w1 = u.segment<3>(9);
    const Eigen::Vector3d speed = u.segment<3>(6) + w1.cross(r1) - u.segment<3>(0) - w0.cross(r0);
    EXPECT_LE((g * u - speed).norm(), 1e-15 * u.norm());
}

TEST(Arms, ArePackedRowsWhereTheyAreNotInShort) {
    const double rows[3] = {1, 2, 3};
    double buffer[kArmBufferSize];
    EXPECT_EQ(packed_rows(rows, false, buffer), rows);
}

}  // namespace
}  // namespace hawser::model
