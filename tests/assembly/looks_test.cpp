// SPDX-License-Identifier: Apache-2.0
/// Kernels of the monitors, eight values per batch, against Eigen and the scalar path.
#include "assembly/kernels.h"
#include "base/index.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

namespace hawser::test {
namespace {

using Eigen::Vector3d;
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

template <class T>
auto matrix_at(T* p) {
    using M = std::conditional_t<std::is_const_v<T>, const RowMajor3, RowMajor3>;
    return Eigen::Map<M>(p);
}
template <class T>
auto vector_at(T* p) {
    using V = std::conditional_t<std::is_const_v<T>, const Vector3d, Vector3d>;
    return Eigen::Map<V>(p);
}

/// Rigid bodies, three point masses among them, with the data that the kernel reads.
struct Rig {
    static constexpr int kBodies = 40, kFirstLump = 17, kLumps = 3, kSlack = 8;
    std::vector<std::uint8_t> dof = std::vector<std::uint8_t>(kBodies + kSlack, 6);
    std::vector<std::uint8_t> weight = std::vector<std::uint8_t>(kBodies + kSlack, 1);
    std::vector<std::int32_t> dof_begin, moving;
    std::vector<double> x, r, v, after, mass, inertia, principal;
    assembly::View view{};

    explicit Rig(std::uint64_t seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        std::fill_n(dof.begin() + kFirstLump, kLumps, std::uint8_t{3});
        for (auto* a : {&x, &r, &v, &after, &mass, &inertia, &principal})
            a->assign(9 * (kBodies + kSlack), 0.0);
        std::int32_t begin = 0;
        for (int i = 0; i < kBodies; ++i) {
            dof_begin.push_back(begin);
            begin += dof[at(i)];
            if (i != 30) moving.push_back(i);  // body 30 is like one that was removed
            weight[at(i)] = random() % 4 == 0 ? 0 : 1;
            mass[at(i)] = 1.5 + any(random);
            for (int k = 0; k < 3; ++k) x[at(3 * i + k)] = 10.0 * any(random);
            const Vector3d axis(any(random), any(random), any(random));
            const RowMajor3 turned =
                Eigen::AngleAxisd(3.0 * any(random), axis.normalized()).toRotationMatrix();
            matrix_at(&r[at(9 * i)]) = turned;
            const Vector3d moments(1.0, 1.3 + 0.1 * any(random), 1.5);
            RowMajor3 own = moments.asDiagonal();
            // The first eight have inertias about their own axes, the others about arbitrary axes.
            if (i < 8)
                vector_at(&principal[at(6 * i)]) = moments;
            else
                own = turned * own * turned.transpose();
            matrix_at(&inertia[at(9 * i)]) = own;
        }
        for (int k = 0; k < begin; ++k) {
            v[at(k)] = 3.0 * any(random);
            after[at(k)] = 3.0 * any(random);
        }
        view.body_count = kBodies;
        view.dof = dof.data();
        view.dof_begin = dof_begin.data();
        view.x = x.data();
        view.r = r.data();
        view.v = v.data();
        view.mass = mass.data();
        view.inertia = inertia.data();
        view.principal = principal.data();
        view.weight = weight.data();
        view.gravity[0] = 0.3;
        view.gravity[1] = -0.2;
        view.gravity[2] = -9.81;
    }
    [[nodiscard]] double kinetic(int i, const std::vector<double>& of) const {
        const double* u = &of[at(dof_begin[at(i)])];
        const Vector3d own = matrix_at(&r[at(9 * i)]).transpose() * vector_at(u + 3);
        return 0.5 * (mass[at(i)] * vector_at(u).squaredNorm() +
                      own.dot(matrix_at(&inertia[at(9 * i)]) * own));
    }
    [[nodiscard]] double spin_of(int i) const {
        return vector_at(&v[at(dof_begin[at(i)] + 3)]).squaredNorm();
    }
    /// Return the energy of gravity, `back` seconds ago [J].
    [[nodiscard]] double potential(int i, double back) const {
        if (weight[at(i)] == 0) return 0.0;
        const Vector3d place =
            vector_at(&x[at(3 * i)]) - back * vector_at(&v[at(dof_begin[at(i)])]);
        return -mass[at(i)] * vector_at(view.gravity).dot(place);
    }
};

TEST(RigidEnergies, AreThoseOfEachBody) {
    for (const std::uint32_t seed : seeds(1, 20, 100, 1000)) {
        SCOPED_TRACE(seed);
        const Rig rig(seed);
        constexpr double kHalf = 0.05;
        int taken = 0;
        for (int first = 0; first < static_cast<int>(rig.moving.size()); ++first) {
            const int count = static_cast<int>(rig.moving.size()) - first;
            assembly::BodyEnergies e, want;
            const std::int32_t done = assembly::kernels().rigid_energies(
                rig.view, rig.moving.data() + first, count, rig.after.data(), kHalf, &e);
            ASSERT_EQ(done % 8, 0);
            ASSERT_LE(done, count);
            for (int k = first; k < first + done; ++k) {
                const int i = rig.moving[at(k)];
                ASSERT_EQ(rig.dof[at(i)], 6);
                want.before += rig.kinetic(i, rig.v);
                want.after += rig.kinetic(i, rig.after);
                want.half_way += rig.potential(i, kHalf);
                want.pose += rig.potential(i, 0.0);
                want.turn = std::max(want.turn, rig.spin_of(i));
            }
            // Sums of up to 24 terms of up to 250 J, each rounded a few times.
            constexpr double kRounding = 1e-11;
            EXPECT_NEAR(e.before, want.before, kRounding);
            EXPECT_NEAR(e.after, want.after, kRounding);
            EXPECT_NEAR(e.half_way, want.half_way, kRounding);
            EXPECT_NEAR(e.pose, want.pose, kRounding);
            EXPECT_NEAR(e.turn, want.turn, kRounding);
            if (done > 0) {
                EXPECT_NEAR(rig.spin_of(e.turn_body), e.turn, kRounding);
            }
            taken += done;
        }
        EXPECT_GT(taken, 0);
    }
}

/// Batches leave out groups of fewer than eight rows, and bodies that are not rigid.
TEST(RigidEnergies, LeaveTheOthers) {
    const Rig rig(1);
    const auto done_from = [&](std::size_t first, std::int32_t count) {
        assembly::BodyEnergies e;
        return assembly::kernels().rigid_energies(rig.view, rig.moving.data() + first, count,
                                                  rig.after.data(), 0.0, &e);
    };
    EXPECT_EQ(done_from(0, 7), 0);
    EXPECT_EQ(done_from(0, 39), 16);  // one of the next eight is a point mass
    EXPECT_EQ(done_from(Rig::kFirstLump, 22), 0);
    EXPECT_EQ(done_from(20, 19), 8);
    EXPECT_EQ(done_from(23, 16), 0);  // body 30 is missing
}

/// Against one row at a time, over ranges with arbitrary first and last rows. A NaN violation is
/// reported.
TEST(WidestRow, IsTheFirstOfTheLargest) {
    std::mt19937_64 random(first_seed(7));
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const int trials = by_tier(200, 1000, 10'000);
    for (int trial = 0; trial < trials; ++trial) {
        const int begin = static_cast<int>(random() % 10), end = static_cast<int>(random() % 60);
        std::vector<double> g(at(64)), share(at(64));
        for (double& x : g) x = any(random);
        for (double& x : share) x = random() % 3 == 0 ? 0.0 : any(random) + 1.0;
        if (trial % 5 == 0) g[random() % g.size()] = NAN;
        const double least = trial % 4 == 0 ? 0.5 : 0.0;
        double most = least, want = least;
        int row = -1;
        for (int r = begin; r < end; ++r) {
            const double open = std::fabs(g[at(r)]) * share[at(r)];
            if (!(open <= want)) {
                want = open;
                row = r;
            }
        }
        EXPECT_EQ(assembly::kernels().widest_row(g.data(), share.data(), begin, end, &most), row);
        EXPECT_TRUE(most == want || (std::isnan(most) && std::isnan(want))) << most << ' ' << want;
    }
}

}  // namespace
}  // namespace hawser::test
