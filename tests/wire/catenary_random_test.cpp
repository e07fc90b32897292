// SPDX-License-Identifier: Apache-2.0
// Wires of random ends, lengths, weights, stiffnesses and seabeds. The forces on each node are
// computed here from the positions of the nodes alone.
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <hawser/catenary.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hawser {
namespace {

int wires() { return test::by_tier(1'000, test::kSanitized ? 2'000 : 40'000, 400'000); }

class Draw {
  public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}
    double between(double a, double b) { return a + (b - a) * (engine_() >> 11) * 0x1p-53; }
    double power(double a, double b) { return std::pow(10.0, between(a, b)); }
    bool one_in(int n) { return static_cast<int>(between(0.0, n)) == 0; }

  private:
    std::mt19937_64 engine_;
};

Vec3 somewhere(Draw& draw, double size) {
    const double x = draw.between(-size, size), y = draw.between(-size, size);
    return {x, y, draw.between(-size, size)};
}

CatenaryDef random_wire(Draw& draw) {
    CatenaryDef def;
    const double size = draw.power(-1.0, 3.5);
    def.from = somewhere(draw, size);
    def.to = somewhere(draw, size);
    if (draw.one_in(7)) def.to = {def.from.x(), def.from.y(), def.to.z()};
    if (draw.one_in(7)) def.to.z() = def.from.z();
    const double separation = (def.to - def.from).norm();
    const double slack = draw.one_in(5)   ? draw.between(0.9, 1.0)
                         : draw.one_in(4) ? 1.0 + draw.power(-9.0, -2.0)
                                          : draw.between(1.0, 3.0);
    const double length = std::max(slack * separation, 1e-3 * size);
    const int parts = draw.one_in(3) ? 3 : 1;
    for (int i = 0; i < parts; ++i) {
        const double share = length / parts, weight = draw.power(-1.0, 4.0);
        const double stiffness = draw.power(3.0, 10.5);
        const int n =
            static_cast<int>(draw.one_in(20) ? draw.between(1, 400) : draw.between(1, 30));
        def.sections.push_back({share, weight, stiffness, n});
    }
    if (draw.one_in(10)) def.sections[0].weight = 0.0;
    const double lower = std::min(def.from.z(), def.to.z());
    if (draw.one_in(2)) {
        const double height = draw.one_in(2) ? lower : lower - draw.between(0.0, size);
        def.seabed = FlatSeabed{height, draw.one_in(3) ? 0.0 : draw.between(0.0, 1.5)};
        if (draw.one_in(4)) def.from.z() = def.to.z() = height;
        // An anchor: below the possible positions of nodes.
        if (draw.one_in(3)) {
            const double l = def.sections[0].length / def.sections[0].elements;
            def.from.z() = height - draw.between(0.0, 0.5) * l;
        }
    } else if (draw.one_in(8)) {
        for (CatenarySection& part : def.sections) part.weight *= -1.0;
    }
    const bool sunk = def.seabed && def.from.z() < def.seabed->height;
    def.free = !sunk && draw.one_in(12);
    return def;
}

struct Load {
    std::vector<double> weight, compliance, length;
};

/// Compute the loads of a wire whose nodes are those of its sections.
Load loads(const CatenaryDef& def) {
    Load out;
    out.weight.push_back(0.0);
    for (const CatenarySection& part : def.sections) {
        for (int i = 0; i < part.elements; ++i) {
            out.length.push_back(part.length / part.elements);
            out.compliance.push_back(out.length.back() / part.EA);
            out.weight.back() += 0.5 * out.length.back() * part.weight;
            out.weight.push_back(0.5 * out.length.back() * part.weight);
        }
    }
    return out;
}

void expect_in_balance(const CatenaryDef& def, const Catenary& c, int number) {
    const Load load = loads(def);
    const std::size_t n = load.length.size();
    ASSERT_EQ(c.nodes.size(), n + 1) << number;
    ASSERT_EQ(c.nodes.front(), def.from) << number;
    ASSERT_TRUE(def.free || c.nodes.back() == def.to) << number;
    double far = 0.0, stiffest = 0.0, weight = 0.0;
    for (const Vec3& p : c.nodes) far = std::max(far, p.cwiseAbs().maxCoeff());
    far = std::max(far, c.s.back());
    for (const double k : load.compliance) stiffest = std::max(stiffest, 1.0 / k);
    for (const double w : load.weight) weight = std::max(weight, std::abs(w));
    // Rounding of positions times the stiffness of an element.
    const double digits = 16.0 * std::numeric_limits<double>::epsilon() * far * stiffest;
    const double allowed = 1e-6 * weight + digits;
    std::vector<Vec3> pull;
    for (std::size_t e = 0; e < n; ++e) {
        const Vec3 d = c.nodes[e + 1] - c.nodes[e];
        const double stretch = d.norm() - load.length[e];
        pull.push_back(stretch > 0.0 ? Vec3(stretch / load.compliance[e] * d.normalized())
                                     : Vec3(Vec3::Zero()));
        EXPECT_NEAR(c.tension[e], pull[e].norm(), digits + 1e-10 * c.tension[e])
            << number << " element " << e;
    }
    for (std::size_t i = 1; i < n + (def.free ? 1 : 0); ++i) {
        Vec3 force = -pull[i - 1] - Vec3(0, 0, load.weight[i]);
        if (i < n) force += pull[i];
        if (def.seabed) {
            const double over = c.nodes[i].z() - def.seabed->height;
            ASSERT_GE(over, -1e-9 * far) << number << " node " << i;
            if (over <= 1e-12 * far) {  // the bottom pushes, and friction holds
                const double push = std::max(0.0, -force.z());
                const double level = std::hypot(force.x(), force.y());
                const double held = std::min(level, def.seabed->friction * push);
                if (level > 0.0) force *= (level - held) / level;
                force.z() = push > 0.0 ? 0.0 : force.z();
            }
        }
        ASSERT_LE(force.norm(), allowed) << number << " node " << i << " of " << n;
    }
}

TEST(CatenaryRandom, every_node_is_in_balance) {
    Draw draw(test::first_seed(20260105));
    const int most = wires();
    int touching = 0, slack = 0;
    for (int i = 0; i < most; ++i) {
        const CatenaryDef def = random_wire(draw);
        const Catenary c = catenary(def);
        ASSERT_NE(c.status, CatenaryStatus::unbalanced)
            << i << ": " << c.residual << " N of " << c.allowed << " N";
        ASSERT_NE(c.status, CatenaryStatus::below_seabed) << i;
        expect_in_balance(def, c, i);
        if (testing::Test::HasFatalFailure()) return;
        touching += c.touches() ? 1 : 0;
        slack += c.status == CatenaryStatus::slack ? 1 : 0;
    }
    EXPECT_GT(touching, most / 4);
    EXPECT_GT(slack, most / 10);
}

/// Absurd numbers: results are finite, with a status of their accuracy.
TEST(CatenaryRandom, nothing_is_nan_whatever_it_is_asked_for) {
    Draw draw(test::first_seed(7));
    const int most = wires();
    for (int i = 0; i < most; ++i) {
        CatenaryDef def;
        def.from = somewhere(draw, draw.power(-6.0, 8.0));
        def.to = draw.one_in(5) ? def.from : somewhere(draw, draw.power(-6.0, 8.0));
        def.down = somewhere(draw, 1.0);
        for (int k = draw.one_in(2) ? 1 : 4; k > 0; --k) {
            const double length = draw.power(-6.0, 8.0), weight = draw.power(-9.0, 9.0);
            const double sign = draw.one_in(4) ? -1.0 : draw.one_in(5) ? 0.0 : 1.0;
            const double stiffness = draw.power(-3.0, 15.0);
            def.sections.push_back(
                {length, sign * weight, stiffness, static_cast<int>(draw.between(1.0, 20.0))});
        }
        if (draw.one_in(2)) {
            const double height = draw.between(-1.0, 1.0) * draw.power(-6.0, 8.0);
            def.seabed = FlatSeabed{height, draw.power(-3.0, 2.0)};
        }
        def.free = draw.one_in(6);
        const Catenary c = catenary(def);
        for (const Vec3& p : c.nodes) ASSERT_TRUE(p.allFinite()) << i;
        for (const double t : c.tension) ASSERT_TRUE(std::isfinite(t) && t >= 0.0) << i;
        ASSERT_TRUE(std::isfinite(c.residual) && std::isfinite(c.allowed)) << i;
        ASSERT_TRUE(c.pull_from.allFinite() && c.pull_to.allFinite()) << i;
    }
}

}  // namespace
}  // namespace hawser
