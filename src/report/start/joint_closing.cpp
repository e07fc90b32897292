// SPDX-License-Identifier: Apache-2.0
#include "report/start/joint_rows.h"

#include <algorithm>
#include <cmath>

// Move the bodies to the least sum of squared violations: Levenberg-Marquardt.
namespace hawser::report::start {

double JointRows::open() const {
    double sum = 0.0;
    for (std::size_t r = 0; r < rows_; ++r) {
        const double g = violations_[r] / first_scale_[r];
        sum += g * g;
    }
    return sum;
}

void JointRows::move(World& world) {
    std::vector<double> b(violations_);
    for (double& g : b) g = -g;
    const std::vector<double> x = solve(b);
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        const double* dx =
            &x[static_cast<std::size_t>(factor_.scalar_begin(static_cast<std::int32_t>(n)))];
        Pose pose = world.pose(bodies_[n]);
        const int size = pattern_.size[n];
        for (int i = 0; i < std::min(size, 3); ++i) pose.position[i] += dx[i];
        if (size == 6) {
            const Vec3 turn(dx[3], dx[4], dx[5]);
            if (const double angle = turn.norm(); angle > 0.0)
                pose.orientation =
                    (Quat(Eigen::AngleAxisd(angle, turn / angle)) * pose.orientation).normalized();
        }
        if (pose.position.allFinite() && pose.orientation.coeffs().allFinite())
            world.set_pose(bodies_[n], pose);
    }
}

void JointRows::close(World& world) {
    constexpr int kMaxClosingIterations = 60;
    small_ = 1e-3;
    for (int round = 0; round < kMaxClosingIterations; ++round) {
        if (!update(world)) break;
        const double before = open();
        std::vector<Pose> poses;
        for (const BodyId body : bodies_) poses.push_back(world.pose(body));
        move(world);
        if (!update(world)) break;
        const double now = open();
        if (now < before) {
            small_ = std::max(kSmallEigenvalue, 0.1 * small_);
            if (before - now < 1e-10 * before || now < 1e-24) break;
            continue;
        }
        for (std::size_t n = 0; n < bodies_.size(); ++n) world.set_pose(bodies_[n], poses[n]);
        small_ *= 10.0;
        if (small_ > 1e6) break;
    }
    small_ = kSmallEigenvalue;
    (void)update(world);
}

}  // namespace hawser::report::start
