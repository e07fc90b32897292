// SPDX-License-Identifier: Apache-2.0
/// Rotation of a step (base/turn.h) against closed forms.
#include "base/turn.h"
#include "model/bodies.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

double scale(double y) { return 1.0 - y * generic::turn_bend(y); }

TEST(Turn, IsTheCotangentUpToTwoRadians) {
    EXPECT_NEAR(generic::turn_bend(0.0), 1.0 / 3.0, 1e-16);
    for (int k = 1; k <= 1000; ++k) {
        const double a = k / 1000.0, y = a * a;
        // The reference loses digits of b in the difference, not of s.
        EXPECT_NEAR(scale(y), a / std::tan(a), 4e-16) << a;
    }
    for (const double a : {1e-8, 1e-4, 1e-2})
        EXPECT_NEAR(generic::turn_bend(a * a), 1.0 / 3.0 + a * a / 45.0, a * a * a * a + 1e-16);
}

TEST(Turn, StaysBelowHalfATurn) {
    const double d = 1e-6;
    EXPECT_NEAR(scale(1.0 - d), scale(1.0 + d), 1e-6);
    EXPECT_NEAR((scale(1.0 + d) - scale(1.0)) / d, (scale(1.0) - scale(1.0 - d)) / d, 1e-5);
    double last = 0.0;
    for (double a = 0.01; a < 1e6; a *= 1.1) {
        const double s = scale(a * a), angle = 2.0 * std::atan2(a, s);
        ASSERT_GT(s, 0.0) << a;
        EXPECT_GT(angle, last) << a;
        last = angle;
    }
    EXPECT_LT(last, EIGEN_PI);
}

TEST(Turn, MapsMomentumBeforeToAfter) {
    for (const std::uint32_t seed : seeds(1, 50, 500, 5000)) {
        Random random(seed);
        const double t = random.uniform(1e-3, 0.1);
        const Vec3 w = std::pow(10.0, random.uniform(-3.0, 2.5)) * random.vector(1.0).normalized();
        const Vec3 moments(random.uniform(0.1, 3.0), random.uniform(0.1, 3.0),
                           random.uniform(0.1, 3.0));
        const Quat own = random.rotation();
        const Mat3 inertia = own * moments.asDiagonal() * own.conjugate();
        generic::M3 m;
        for (int i = 0; i < 9; ++i) m.a[i] = inertia(i / 3, i % 3);
        const generic::V3 v{w.x(), w.y(), w.z()};
        const auto momentum = [&](double half) {
            const generic::V3 more = generic::turn_momentum(m, v, half);
            return Vec3(inertia * w + Vec3(more.x, more.y, more.z));
        };
        // ω is the same in the world frame and in the frame that turns about it.
        const Quat turn = model::turn_by(w.data(), t);
        const Vec3 before = momentum(-0.5 * t), after = momentum(0.5 * t);
        EXPECT_NEAR((turn.conjugate() * after - before).norm(), 0.0, 1e-14 * before.norm()) << seed;
        const double angle = t * w.norm();
        if (angle > 2.0) continue;
        const Quat exact(Eigen::AngleAxisd(angle, w.normalized()));
        EXPECT_NEAR((turn.coeffs() - exact.coeffs()).norm(), 0.0, 1e-15) << seed;
    }
}

}  // namespace
}  // namespace hawser::test
