// SPDX-License-Identifier: Apache-2.0
// Wires in still water, with bending stiffness and buoyant sections. The forces on each node are
// computed here from the positions of nodes, by the formulas of sea.h and by differences of an
// energy.
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <hawser/catenary.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

double share(double surface, double z, double middle, double d) {
    const double low = std::min(z, middle) - 0.5 * d, high = std::max(z, middle) + 0.5 * d;
    return std::clamp((surface - low) / (high - low), 0.0, 1.0);
}

double bend_energy(const std::vector<Vec3>& x, std::size_t i, double k) {
    const Vec3 a = x[i] - x[i - 1], b = x[i + 1] - x[i];
    return k * (1.0 - a.dot(b) / (a.norm() * b.norm()));
}

/// Return the largest unbalanced force at a node, relative to the weight of the heaviest node. One
/// section of equal elements.
double left(const CatenaryDef& def, const Catenary& c) {
    const CatenarySection& s = def.sections[0];
    const std::size_t n = c.nodes.size() - 1;
    const double l = s.length / static_cast<double>(n);
    double most = 0.0;
    for (std::size_t i = 1; i < n; ++i) {
        Vec3 force = Vec3::Zero();
        for (const std::size_t other : {i - 1, i + 1}) {
            const Vec3 d = c.nodes[other] - c.nodes[i];
            force += std::max(0.0, d.norm() - l) / l * s.EA * d.normalized();
            const double z = c.nodes[i].z(), middle = 0.5 * (z + c.nodes[other].z());
            force.z() -= 0.5 * l * s.weight;
            force.z() += 0.5 * l * s.buoyancy * share(*def.water, z, middle, s.diameter);
        }
        for (int k = 0; k < 3 && s.EI > 0.0; ++k) {
            constexpr double kStep = 1e-5;
            double e[2];
            for (const int side : {0, 1}) {
                std::vector<Vec3> x = c.nodes;
                x[i][k] += side == 0 ? -kStep : kStep;
                e[side] = 0.0;
                for (std::size_t j = std::max<std::size_t>(i, 2) - 1; j <= std::min(i + 1, n - 1);
                     ++j)
                    e[side] += bend_energy(x, j, s.EI / l);
            }
            force[k] -= (e[1] - e[0]) / (2.0 * kStep);
        }
        if (def.seabed && c.nodes[i].z() <= def.seabed->height + 1e-9) {
            const double carried = std::max(0.0, -force.z());
            force.z() = std::max(0.0, force.z());
            const double slip = std::hypot(force.x(), force.y());
            const double held =
                std::min(1.0, def.seabed->friction * carried / std::max(slip, 1e-300));
            force.x() *= 1.0 - held;
            force.y() *= 1.0 - held;
        }
        most = std::max(most, force.norm());
    }
    return most / (l * std::max(s.weight, s.buoyancy));
}

CatenaryDef random_line(Random& random) {
    CatenaryDef def;
    const double size = random.uniform(20.0, 400.0);
    def.from = {0.0, 0.0, random.uniform(-0.3, 0.3) * size};
    def.to = {random.uniform(0.2, 1.0) * size, random.uniform(-0.2, 0.2) * size,
              -random.uniform(0.0, 1.0) * size};
    const double length = random.uniform(1.02, 1.6) * (def.to - def.from).norm();
    const double d = random.uniform(0.05, 0.3), area = 0.785398 * d * d;
    const double EA = std::pow(10.0, random.uniform(7.0, 9.0));
    def.sections = {{length, 0.0, EA, random.integer(12, 60)}};
    CatenarySection& s = def.sections[0];
    s.buoyancy = 1025.0 * 9.81 * area;
    s.weight = random.uniform(0.5, 4.0) * s.buoyancy;  // some float
    s.diameter = d;
    def.water = random.uniform(-0.1, 0.1) * size;
    return def;
}

TEST(Rest, EveryNodeInStillWaterIsInBalance) {
    Random random(first_seed(11));
    int balanced = 0;
    const int cases = by_tier(200, 5'000, 20'000);
    for (int i = 0; i < cases; ++i) {
        const CatenaryDef def = random_line(random);
        const Catenary c = catenary(def);
        if (c.status != CatenaryStatus::balanced) continue;  // a slack rope on the surface
        ++balanced;
        // 1e-6 of a node's weight, and rounding of positions (400 m) times EA/l.
        EXPECT_LT(left(def, c), 1e-4) << i;
    }
    EXPECT_GT(balanced, cases * 9 / 10);
}

TEST(Rest, EveryNodeOfAStiffWireIsInBalance) {
    Random random(first_seed(12));
    int balanced = 0;
    const int cases = by_tier(60, 2'000, 8'000);
    for (int i = 0; i < cases; ++i) {
        CatenaryDef def = random_line(random);
        CatenarySection& s = def.sections[0];
        // Stiffer lines push, and elements that only pull then have no balance.
        s.EI = std::pow(10.0, random.uniform(-5.0, -2.7)) * s.weight * std::pow(s.length, 3.0);
        s.EI = std::min(s.EI, 1e-3 * s.EA * s.length * s.length);
        const Catenary c = catenary(def);
        if (c.status != CatenaryStatus::balanced || left(def, c) > 1e-3) continue;
        ++balanced;
    }
    EXPECT_GT(balanced, cases * 8 / 10);
}

/// A fault: buoyant sections of a riser in the form of a lazy wave were rejected over a seabed.
TEST(Rest, SectionsThatFloatOverASeabed) {
    CatenaryDef def;
    def.to = {160.0, 0.0, -99.9};
    CatenarySection pipe{90.0, 494.0, 2.3e8, 30}, floats{40.0, 40.0, 2.3e8, 16};
    pipe.buoyancy = 64.0;
    pipe.diameter = 0.09;
    floats.buoyancy = 100.0;
    floats.diameter = 0.11;
    CatenarySection last = pipe;
    last.length = 110.0;
    last.elements = 40;
    def.sections = {pipe, floats, last};
    def.water = 0.0;
    def.seabed = FlatSeabed{-99.9, 0.3};
    const Catenary c = catenary(def);
    EXPECT_EQ(c.status, CatenaryStatus::balanced);
    double lowest_before = 0.0, top = -100.0;
    for (std::size_t i = 0; i < c.nodes.size(); ++i) {
        if (c.s[i] < 95.0) lowest_before = std::min(lowest_before, c.nodes[i].z());
        if (c.s[i] > 90.0 && c.s[i] < 160.0) top = std::max(top, c.nodes[i].z());
        EXPECT_GE(c.nodes[i].z(), -99.9 - 1e-9);
    }
    EXPECT_GT(top, lowest_before + 1.0) << "the floating section makes a crest";
}

/// A pipe between ends at one height, as far apart as it is long, has the sag of a pinned beam, 5 w
/// l^4/384 EI.
TEST(Rest, APinnedBeamSagsByFiveOver384) {
    CatenaryDef def;
    def.to = {10.0, 0.0, 0.0};
    CatenarySection beam{10.0, 100.0, 1e6, 40};
    beam.EI = 1e6;
    def.sections = {beam};
    const Catenary c = catenary(def);
    EXPECT_EQ(c.status, CatenaryStatus::balanced);
    const double sag = 5.0 * 100.0 * 1e4 / (384.0 * 1e6);
    // 40 elements: (1/40)^2; the pull of EA on a sag of 0.013 m: 1e-3.
    EXPECT_NEAR(-c.nodes[20].z(), sag, 5e-3 * sag);
}

}  // namespace
}  // namespace hawser::test
