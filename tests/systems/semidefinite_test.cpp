// SPDX-License-Identifier: Apache-2.0
/// Valid load matrices of systems: a direction without mass is accepted, one of negative mass is
/// rejected.
#include "assembly/load_matrix.h"

#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

/// Return a direction whose components differ by up to eight powers of ten.
Vec3 any_direction(Random& random) {
    Vec3 t;
    for (int k = 0; k < 3; ++k)
        t[k] = (random.chance(0.5) ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-8, 0));
    return t.normalized();
}

/// Return c (t² E − (1 + beyond) t tᵀ), the added mass of a straight piece of wire.
std::vector<double> across(const Vec3& t, double c, double beyond) {
    const Mat3 m = c * (t.squaredNorm() * Mat3::Identity() - (1.0 + beyond) * t * t.transpose());
    return {c * (t.y() * t.y() + t.z() * t.z()) - c * beyond * t.x() * t.x(),
            m(1, 0),
            c * (t.x() * t.x() + t.z() * t.z()) - c * beyond * t.y() * t.y(),
            m(2, 0),
            m(2, 1),
            c * (t.x() * t.x() + t.y() * t.y()) - c * beyond * t.z() * t.z()};
}

/// A fault: in the order of its rows the last pivot of such a matrix was down to −1e-12. The step
/// ended with Status::bad_load if a wire in the sea had a free end.
TEST(Semidefinite, TakesAPieceOfWireOfAnyDirection) {
    Random random(first_seed(1));
    const int cases = by_tier(10'000, 200'000, 2'000'000);
    for (int i = 0; i < cases; ++i) {
        const Vec3 t = any_direction(random);
        const double c = std::pow(10.0, random.uniform(-6, 6));
        ASSERT_TRUE(assembly::semidefinite(across(t, c, 0.0).data(), 3))
            << i << ' ' << t.transpose();
        // 1e-9 of it below 0: far above the rounding of its entries.
        ASSERT_FALSE(assembly::semidefinite(across(t, c, 1e-9).data(), 3)) << i;
    }
}

TEST(Semidefinite, TakesWhatUnderflowsBesideNothing) {
    const double m[] = {0.0, -1e-170, 1.0, 0.0, 0.0, 1.0};
    EXPECT_TRUE(assembly::semidefinite(m, 3));
    const double n[] = {0.0, -1e-100, 1.0, 0.0, 0.0, 1.0};
    EXPECT_FALSE(assembly::semidefinite(n, 3));
}

/// Chain along x in still water has a transverse component that decays by rounding to any size. Its
/// squares have few digits: a fault rejected a load in the second step.
TEST(Semidefinite, TakesComponentsWhoseSquaresUnderflow) {
    Random random(first_seed(3));
    const int cases = by_tier(10'000, 200'000, 2'000'000);
    for (int i = 0; i < cases; ++i) {
        Vec3 t;
        for (int k = 0; k < 3; ++k)
            t[k] = (random.chance(0.5) ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-170, 0));
        t[random.integer(0, 2)] = 1.0;
        const double c = std::pow(10.0, random.uniform(-6, 6));
        ASSERT_TRUE(assembly::semidefinite(across(t, c, 0.0).data(), 3))
            << i << ' ' << t.transpose();
        // Any fraction of a node that is barely wet makes all entries this small.
        const double small = std::pow(10.0, random.uniform(-323, -290));
        ASSERT_TRUE(assembly::semidefinite(across(t, small, 0.0).data(), 3)) << i;
        ASSERT_FALSE(assembly::semidefinite(across(Vec3(1.0, 1.0, t.x()), c, 1e-9).data(), 3)) << i;
    }
}

/// tr M⁻¹ S of three rows, the damping of most loads, against the inverse by cofactors.
TEST(Semidefinite, TraceIsThatOfTheInverse) {
    Random random(first_seed(4));
    const int cases = by_tier(2'000, 50'000, 500'000);
    for (int i = 0; i < cases; ++i) {
        const Vec3 t = any_direction(random), u = any_direction(random);
        const double added = std::pow(10.0, random.uniform(-4, 3));
        const Mat3 m = Mat3::Identity() + added * (Mat3::Identity() - t * t.transpose());
        const Mat3 s = u * u.transpose() + 0.1 * Mat3::Identity();
        double low[6], damping[6];
        for (int r = 0, k = 0; r < 3; ++r)
            for (int c = 0; c <= r; ++c, ++k) {
                low[k] = m(r, c);
                damping[k] = s(r, c);
            }
        // (E + a (E − t tᵀ))⁻¹ = (E + a t tᵀ)/(1 + a), up to the length of t.
        const Mat3 inverse = (Mat3::Identity() + added * t * t.transpose()) / (1.0 + added);
        const double want = (inverse * s).trace();
        ASSERT_NEAR(assembly::trace_over(low, damping, 3), want, 1e-11 * want) << i;
    }
}

/// Sums of outer products of six rows, of any rank and with rows of very different units.
TEST(Semidefinite, TakesSumsOfOuterProducts) {
    Random random(first_seed(2));
    const int cases = by_tier(5'000, 60'000, 600'000);
    for (int i = 0; i < cases; ++i) {
        double unit[6], m[21] = {};
        for (double& u : unit) u = std::pow(10.0, random.uniform(-4, 4));
        const int rank = random.integer(1, 6);
        for (int r = 0; r < rank; ++r) {
            double v[6];
            for (int k = 0; k < 6; ++k) v[k] = unit[k] * random.uniform(-1, 1);
            for (int a = 0, e = 0; a < 6; ++a)
                for (int b = 0; b <= a; ++b, ++e) m[e] += v[a] * v[b];
        }
        ASSERT_TRUE(assembly::semidefinite(m, 6)) << i << ", rank " << rank;
        m[random.integer(0, 1) == 0 ? 0 : 20] *= -1.0;
        ASSERT_FALSE(assembly::semidefinite(m, 6)) << i;
    }
}

}  // namespace
}  // namespace hawser::test
