// SPDX-License-Identifier: Apache-2.0
/// Thrust allocation beside a brute-force reference: projected gradients on dense grids of sectors.
#include "vessel/allocation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace hawser::test {
namespace {

using vessel::AllocatedThruster;
using vessel::Allocation;
using vessel::QuadraticProgram;
using vessel::ThrusterNow;

constexpr double kAlPi = std::numbers::pi;

/// Return the minimum of ½xᵀHx + gᵀx over a box by coordinate descent, which converges for H > 0.
Eigen::VectorXd box_minimum(const Eigen::MatrixXd& h, const Eigen::VectorXd& g,
                            const Eigen::VectorXd& low, const Eigen::VectorXd& high) {
    Eigen::VectorXd x = low.cwiseMax(Eigen::VectorXd::Zero(g.size())).cwiseMin(high);
    for (int sweep = 0; sweep < 200000; ++sweep) {
        double moved = 0.0;
        for (Eigen::Index i = 0; i < g.size(); ++i) {
            const double slope = h.row(i).dot(x) + g[i];
            const double next = std::clamp(x[i] - slope / h(i, i), low[i], high[i]);
            moved = std::max(moved, std::abs(next - x[i]));
            x[i] = next;
        }
        if (moved < 1e-15) break;
    }
    return x;
}

TEST(Allocation, ProgramMatchesCoordinateDescentInBoxes) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    QuadraticProgram program;
    for (int trial = 0; trial < 200; ++trial) {
        const int n = 1 + trial % 8;
        Eigen::MatrixXd m = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return any(rng); });
        const Eigen::MatrixXd h = m * m.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
        const Eigen::VectorXd g = Eigen::VectorXd::NullaryExpr(n, [&] { return 3.0 * any(rng); });
        Eigen::VectorXd low(n), high(n);
        program.begin(n);
        program.hessian() = h;
        program.gradient() = g;
        for (int i = 0; i < n; ++i) {
            low[i] = -std::abs(any(rng));
            high[i] = std::abs(any(rng));
            program.add({i, -1, 1.0, 0.0, high[i]});
            program.add({i, -1, -1.0, 0.0, -low[i]});
        }
        ASSERT_TRUE(program.solve());
        const Eigen::VectorXd expected = box_minimum(h, g, low, high);
        // Coordinate descent ends at 1e-15 a sweep; its rate is that of the condition, 1e3.
        EXPECT_LT((program.solution() - expected).cwiseAbs().maxCoeff(), 1e-9) << trial;
    }
}

TEST(Allocation, ProgramFindsThatConstraintsContradictEachOther) {
    QuadraticProgram program;
    program.begin(1);
    program.hessian()(0, 0) = 1.0;
    program.add({0, -1, 1.0, 0.0, -1.0});   // x ≤ −1
    program.add({0, -1, -1.0, 0.0, -1.0});  // x ≥ 1
    EXPECT_FALSE(program.solve());
}

std::vector<AllocatedThruster> random_ship(std::mt19937& rng, bool zones) {
    std::uniform_real_distribution<double> any(0.0, 1.0);
    std::vector<AllocatedThruster> out;
    for (const double side : {-1.0, 1.0}) {
        AllocatedThruster t;
        t.is_azimuth = true;
        t.x = -40.0 + 5.0 * any(rng);
        t.y = side * (4.0 + 3.0 * any(rng));
        t.ahead = 2e5 + 3e5 * any(rng);
        t.astern = 0.7 * t.ahead;
        if (zones) {
            const double from = 2.0 * kAlPi * any(rng), width = 0.3 + any(rng);
            const double free = 2.0 * kAlPi - width;
            for (int k = 0; k < 2; ++k)
                t.sectors.push_back({from + width + 0.5 * k * free, 0.5 * free, false});
        }
        out.push_back(t);
    }
    for (int k = 0; k < 2; ++k) {
        AllocatedThruster t;
        t.x = 28.0 + 6.0 * any(rng);
        t.axis = 0.5 * kAlPi;
        t.ahead = t.astern = 1e5 + 1e5 * any(rng);
        out.push_back(t);
    }
    return out;
}

Vec3 effect(const std::vector<AllocatedThruster>& ship, const std::vector<double>& f) {
    Vec3 out = Vec3::Zero();
    for (std::size_t i = 0; i < ship.size(); ++i)
        out += Vec3(f[2 * i], f[2 * i + 1], ship[i].x * f[2 * i + 1] - ship[i].y * f[2 * i]);
    return out;
}

/// Return the cost function of the header, computed independently.
double cost_of(const std::vector<AllocatedThruster>& ship, const Vec3& tau,
               const std::vector<double>& f) {
    double sum = 0.0, arm = 1.0, out = 0.0;
    for (std::size_t i = 0; i < ship.size(); ++i) {
        sum += std::max(ship[i].ahead, ship[i].astern);
        arm = std::max({arm, std::abs(ship[i].x), std::abs(ship[i].y)});
        const double most = std::max(ship[i].ahead, ship[i].astern);
        out += (f[2 * i] * f[2 * i] + f[2 * i + 1] * f[2 * i + 1]) / (most * most);
    }
    const Vec3 off = effect(ship, f) - tau;
    out += 1e6 * (off[0] * off[0] + off[1] * off[1]) / (sum * sum);
    out += 4e6 * off[2] * off[2] / (sum * arm * sum * arm);
    return out;
}

bool allowed(const AllocatedThruster& t, double x, double y, double slack) {
    const double size = std::hypot(x, y);
    if (size > t.ahead * (1.0 + slack)) return false;
    if (t.sectors.empty() || size < 1e-4 * t.ahead) return true;
    return std::any_of(t.sectors.begin(), t.sectors.end(), [&](const vessel::ThrustSector& s) {
        const double off = std::remainder(std::atan2(y, x) - s.from - 0.5 * s.width, 2.0 * kAlPi);
        return std::abs(off) <= 0.5 * s.width + slack;
    });
}

/// Search locally from many starts: steps of each force in eight directions, halved when none
/// improves.
double searched_cost(const std::vector<AllocatedThruster>& ship, const Vec3& tau,
                     std::mt19937& rng) {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    double best = 1e300;
    for (int start = 0; start < 12; ++start) {
        std::vector<double> f(2 * ship.size(), 0.0);
        double step = 0.3;
        double now = cost_of(ship, tau, f);
        for (std::size_t i = 0; i < 2; ++i) {
            std::vector<double> g = f;
            g[2 * i] = any(rng) * ship[i].ahead;
            g[2 * i + 1] = any(rng) * ship[i].ahead;
            if (allowed(ship[i], g[2 * i], g[2 * i + 1], 0.0)) f = g;
        }
        now = cost_of(ship, tau, f);
        for (int k = 0; k < 60000 && step > 1e-6; ++k) {
            std::vector<double> g = f;
            for (std::size_t i = 0; i < ship.size(); ++i) {
                const double s = step * ship[i].ahead;
                if (ship[i].is_azimuth) g[2 * i] += s * any(rng);
                g[2 * i + 1] += s * any(rng);
                if (!ship[i].is_azimuth)
                    g[2 * i + 1] = std::clamp(g[2 * i + 1], -ship[i].astern, ship[i].ahead);
                if (ship[i].is_azimuth && !allowed(ship[i], g[2 * i], g[2 * i + 1], 0.0)) {
                    g[2 * i] = f[2 * i];
                    g[2 * i + 1] = f[2 * i + 1];
                }
            }
            const double cost = cost_of(ship, tau, g);
            if (cost < now) {
                now = cost;
                f = g;
            } else if (k % 40 == 39) {
                step *= 0.9;
            }
        }
        best = std::min(best, now);
    }
    return best;
}

// A random search with many starts finds no force that is cheaper than the program's.
TEST(Allocation, NoSearchBeatsTheProgramOnRandomShips) {
    std::mt19937 rng(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int trial = 0; trial < 12; ++trial) {
        const auto ship = random_ship(rng, trial % 2 == 1);
        Allocation allocation(ship);
        const Vec3 tau(3e5 * any(rng), 3e5 * any(rng), 1e7 * any(rng));
        std::vector<std::int32_t> sectors(ship.size(), -1);
        allocation.allocate(tau, nullptr, sectors.data());
        std::vector<double> f;
        for (std::size_t i = 0; i < ship.size(); ++i) {
            f.push_back(allocation.x(i));
            f.push_back(allocation.y(i));
            EXPECT_TRUE(!ship[i].is_azimuth ||
                        allowed(ship[i], allocation.x(i), allocation.y(i), 1e-6))
                << trial << " " << i;
        }
        EXPECT_LT((effect(ship, f) - allocation.total()).norm(), 1e-6 * tau.norm());
        const double ours = cost_of(ship, tau, f), theirs = searched_cost(ship, tau, rng);
        // The polygon of 32 sides is 0.5 % inside of the disc, which counts where it saturates.
        EXPECT_LT(ours, theirs * 1.02 + 1e-3) << trial;
    }
}

TEST(Allocation, MeetsWhatIsPossibleAndKeepsOutOfZones) {
    std::mt19937 rng(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int trial = 0; trial < 100; ++trial) {
        const auto ship = random_ship(rng, false);
        Allocation allocation(ship);
        const Vec3 tau(1e5 * any(rng), 1e5 * any(rng), 1e6 * any(rng));
        std::vector<std::int32_t> sectors(ship.size(), -1);
        allocation.allocate(tau, nullptr, sectors.data());
        // q of 1e6: off by about cost/q of the sum of capacities.
        EXPECT_LT(allocation.scaled_norm(Vec3(allocation.total() - tau)), 3e-6) << trial;
        EXPECT_EQ(allocation.independent_axes(), 3);
    }
}

TEST(Allocation, FailedThrustersGiveNothing) {
    std::mt19937 rng(5);
    const auto ship = random_ship(rng, true);
    Allocation allocation(ship);
    const std::vector<double> available{0.0, 1.0, 0.0, 1.0};
    std::vector<std::int32_t> sectors(ship.size(), -1);
    allocation.allocate(Vec3(1e5, 1e5, 0.0), available.data(), sectors.data());
    for (const std::size_t i : {0, 2})
        EXPECT_NEAR(std::hypot(allocation.x(i), allocation.y(i)), 0.0, 1e-6 * ship[i].ahead);
}

TEST(Allocation, AFractionOfTheCapacityIsALimit) {
    std::mt19937 rng(9);
    std::uniform_real_distribution<double> any(0.1, 0.9);
    for (int trial = 0; trial < 40; ++trial) {
        const auto ship = random_ship(rng, trial % 2 == 1);
        std::vector<double> available;
        for (std::size_t i = 0; i < ship.size(); ++i) available.push_back(any(rng));
        Allocation allocation(ship);
        std::vector<std::int32_t> sectors(ship.size(), -1);
        allocation.allocate(Vec3(3e6 * any(rng), 3e6 * any(rng), 5e7 * any(rng)), available.data(),
                            sectors.data());
        for (std::size_t i = 0; i < ship.size(); ++i)
            EXPECT_LE(std::hypot(allocation.x(i), allocation.y(i)),
                      available[i] * ship[i].ahead * (1.0 + 1e-6))
                << trial << ' ' << i;
    }
    // On the centre line all thrust goes ahead; the polygon of the disc has a vertex there.
    std::vector<AllocatedThruster> line(2);
    line[0] = {.is_azimuth = true, .x = -30.0, .ahead = 3e5, .astern = 2e5};
    line[1] = {.is_azimuth = true, .x = 20.0, .ahead = 2e5, .astern = 1e5};
    Allocation allocation(line);
    const double available[] = {0.5, 1.0};
    std::int32_t sectors[] = {-1, -1};
    allocation.allocate(Vec3(1e7, 0.0, 0.0), available, sectors);
    EXPECT_NEAR(allocation.total()[0], 0.5 * 3e5 + 2e5, 1e-3);
    EXPECT_NEAR(allocation.total()[1], 0.0, 1e-3);
}

TEST(Allocation, ThrustersMakeUpForAnAzimuthThatStillTurns) {
    std::vector<AllocatedThruster> ship(3);
    ship[0] = {.is_azimuth = true, .x = -30.0, .y = 0.0, .ahead = 3e5, .astern = 2e5};
    ship[1] = {.x = 30.0, .axis = 0.5 * kAlPi, .ahead = 2e5, .astern = 2e5};
    ship[2] = {.x = -20.0, .axis = 0.5 * kAlPi, .ahead = 2e5, .astern = 2e5};
    Allocation allocation(ship);
    // The azimuth points ahead, and 1e5 N to starboard without moment are wanted.
    const ThrusterNow now[] = {{0.0, 0.0, 3e5}, {0.5 * kAlPi, -2e5, 2e5}, {0.5 * kAlPi, -2e5, 2e5}};
    double thrusts[3];
    allocation.thrust_at_fixed_angles(Vec3(0.0, 1e5, 0.0), now, thrusts);
    EXPECT_NEAR(thrusts[0], 0.0, 100.0);
    EXPECT_NEAR(thrusts[1], 0.4e5, 200.0);  // levers 30 and 20 m
    EXPECT_NEAR(thrusts[2], 0.6e5, 200.0);
}

TEST(Allocation, AShaftAloneHasNoAuthorityInSwayAndYaw) {
    std::vector<AllocatedThruster> ship(1);
    ship[0] = {.x = -30.0, .ahead = 3e5, .astern = 2e5};
    EXPECT_EQ(Allocation(ship).independent_axes(), 1);
    EXPECT_EQ(Allocation(ship).largest_axis_forces()[2], 0.0);
}

}  // namespace
}  // namespace hawser::test
