// SPDX-License-Identifier: Apache-2.0
/// Splits (docs/theory/splits.md): their stability, their defects, and properties of all steps:
/// repeatable, restorable, equal for any number of threads.
#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>

#include "support/small_recipes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

/// Make two point masses along x on a spring of stiffness k, in two groups.
Recipe two_bodies(double m1, double m2, double k, double n) {
    Recipe r;
    r.world.step = 1.0 / 60;
    r.world.gravity = {0, 0, 0};
    r.world.staggered_start = false;
    r.world.geometric_stiffness = 0.0;
    r.world.coupling = Coupling::kinematic;
    const BodyId a = r.lump({0, 0, 0}, m1), b = r.lump({10.001, 0, 0}, m2);
    r.bodies[1].group = "other";
    InteractionDef d = between(InteractionKind::Distance, {a, b});
    d.compliance[0] = 1.0 / k;
    d.damping_time[0] = n * r.world.step;
    r.add(d.set("length", 10.0));
    return r;
}

/// True if the relative motion grows.
bool grows(const Recipe& r) {
    World w = r.make();
    auto largest = [&](int steps) {
        double most = 0.0;
        for (int i = 0; i < steps; ++i) {
            if (w.step() != Status::ok) return 1e300;
            most = std::max(most, std::fabs(w.violation(InteractionId{0})[0]));
            if (!(most < 1.0)) return 1e300;  // far beyond the amplitude of 1 mm
        }
        return most;
    };
    const double early = largest(200);
    (void)largest(1600);
    const double late = largest(200);
    return late >= 1e300 || late > 1.5 * early;
}

/// Compute A(1 + Υ(2 − R)) of docs/theory/splits.md: at most 2 if stable. n: damping time of the
/// spring in steps.
double criterion(double m1, double m2, double k, double n) {
    const double h = 1.0 / 60, w = 1.0 / m1 + 1.0 / m2, z = h * h * k * w * (n + 0.25);
    const double late = z < 1e-3 ? 0.5 + z / 12.0 : -1.0 / std::expm1(-z) - 1.0 / z;
    const double ups = 1.0 / (1.0 + 4.0 * n * late), recall = 1.0 - 4.0 * n * (1.0 - late);
    const double sigma = 4.0 * ups / (k * h * h);
    return (1.0 / (1.0 + m1 * sigma) + 1.0 / (1.0 + m2 * sigma)) * (1.0 + ups * (2.0 - recall));
}

TEST(Cuts, TwoBodiesAreStableUpToTheBoundaryOfTheTheory) {
    for (const auto [m1, m2, n] : {std::array{1.0, 1.0, 0.0}, std::array{1.0, 1.0, 2.0},
                                   std::array{1.0, 10.0, 0.5}, std::array{3.0, 40.0, 0.0}}) {
        double theory_low = 1.0, theory_high = 1e12, low = 1.0, high = 1e12;
        for (int i = 0; i < 60; ++i) {
            const double k = std::sqrt(theory_low * theory_high);
            (criterion(m1, m2, k, n) <= 2.0 ? theory_low : theory_high) = k;
        }
        while (high / low > 1.002) {
            const double k = std::sqrt(low * high);
            (grows(two_bodies(m1, m2, k, n)) ? high : low) = k;
        }
        // 1 %: resolution of 2,000 steps for growth that vanishes at the boundary.
        EXPECT_NEAR(std::sqrt(low * high) / theory_low, 1.0, 0.01)
            << "m " << m1 << " " << m2 << " n " << n;
    }
}

TEST(Cuts, CompliantIsStableHoweverStiffTheCut) {
    for (const double k : {1e5, 1e7, 1e9}) {
        Recipe r = two_bodies(1.0, 5.0, k, 0.0);
        EXPECT_TRUE(grows(r)) << k;
        r.world.coupling = Coupling::compliant;
        EXPECT_FALSE(grows(r)) << k;
    }
}

constexpr int kThird = 8, kLumps = 3 * kThird;

/// Make a chain of point masses along x with bending above the ground; each third is a group.
Recipe chain(Coupling coupling, Predictor predictor, double EA = 1e4) {
    Recipe r;
    r.world.coupling = coupling;
    r.world.predictor = predictor;
    std::vector<BodyId> node{r.ground()};
    for (int i = 1; i <= kLumps; ++i) {
        node.push_back(r.lump({0.9 * i, 0, 0.05 * i}, 2.0 + i % 3));
        r.bodies.back().group = i <= kThird ? "a" : (i <= 2 * kThird ? "b" : "c");
    }
    for (std::size_t i = 0; i + 1 < node.size(); ++i)
        r.add(between(InteractionKind::Stretch, {node[i], node[i + 1]})
                  .set("EA", EA)
                  .set("length", 0.9));
    for (std::size_t i = 0; i + 2 < node.size(); ++i)
        r.add(between(InteractionKind::Bend, {node[i], node[i + 1], node[i + 2]})
                  .set("EI", 5.0)
                  .set("length", 0.9));
    return r;
}

/// Add the ground.
World on_ground(const Recipe& r, int threads = 1) {
    WorldDef def = r.world;
    def.threads = threads;
    World w = r.make(def);
    w.add_shape({.kind = ShapeKind::plane, .body = BodyId{0}, .position = {0, 0, -0.5}});
    for (int i = 1; i <= kLumps; ++i)
        w.add_shape({.kind = ShapeKind::sphere, .body = BodyId{i}, .radius = 0.1});
    return w;
}

struct Way {
    Coupling coupling;
    Predictor predictor;
    double EA;  ///< Soft enough for a stable split.
};
class EachCut : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(Ways, EachCut,
                         testing::Values(Way{Coupling::kinematic, Predictor::hold, 1e4},
                                         Way{Coupling::kinematic, Predictor::forces, 2e3},
                                         Way{Coupling::kinematic, Predictor::clique, 1e6},
                                         Way{Coupling::compliant, Predictor::hold, 1e6},
                                         Way{Coupling::compliant, Predictor::clique, 1e6}));

TEST_P(EachCut, ContinuesBitForBitAfterRestore) {
    const Recipe r = chain(GetParam().coupling, GetParam().predictor, GetParam().EA);
    World a = on_ground(r);
    for (int round = 0; round < 6; ++round) {
        for (int i = 0; i < 15; ++i) ASSERT_EQ(a.step(), Status::ok);
        // Two stretches and four bends, fewer if balls of two groups touch.
        ASSERT_GE(a.stats().cuts, round == 0 ? 6 : 3);
        World fresh = on_ground(r);
        fresh.state().restore(a.state().save());
        ASSERT_EQ(fresh.state().hash(), a.state().hash());
        for (int i = 0; i < 5; ++i) {
            ASSERT_EQ(a.step(), Status::ok);
            ASSERT_EQ(fresh.step(), Status::ok);
            ASSERT_EQ(fresh.state().hash(), a.state().hash()) << "round " << round << " step " << i;
        }
    }
    EXPECT_GT(a.stats().contacts, 0) << "nothing fell on the ground";
    EXPECT_GE(a.solver().matrix().body_island[kLumps], 2);
}

TEST_P(EachCut, IsTheSameForAnyNumberOfThreads) {
    const Recipe r = chain(GetParam().coupling, GetParam().predictor, GetParam().EA);
    World one = on_ground(r), three = on_ground(r, 3);
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(one.step(), Status::ok);
        ASSERT_EQ(three.step(), Status::ok);
    }
    EXPECT_EQ(one.state().hash(), three.state().hash());
}

/// The reported momentum defect equals the gain of the bodies.
TEST_P(EachCut, MomentumDefectIsWhatBodiesGain) {
    Recipe r = chain(GetParam().coupling, GetParam().predictor, GetParam().EA);
    r.world.gravity = {0, 0, 0};
    r.interactions.erase(r.interactions.begin());               // free of the ground: one stretch,
    r.interactions.erase(r.interactions.begin() + kLumps - 1);  // and the first bend
    r.bodies[1].velocity = {0.3, 0.5, -0.4};
    World w = r.make();
    auto momentum = [&] {
        Vec3 p = Vec3::Zero();
        for (int b = 1; b <= kLumps; ++b)
            p += r.bodies[static_cast<std::size_t>(b)].mass * w.velocity(BodyId{b}).linear;
        return p;
    };
    double mass = 0.0, most = 0.0;
    for (const BodyDef& b : r.bodies) mass += b.mass;
    ASSERT_EQ(w.step(), Status::ok);
    for (int i = 0; i < 40; ++i) {
        const Vec3 before = momentum();
        ASSERT_EQ(w.step(), Status::ok);
        const double gained = (momentum() - before).norm();
        const double reported = w.stats().momentum_defect * r.world.step * 9.81 * mass;
        EXPECT_LE(gained, reported * (1.0 + 1e-9) + 1e-12);  // cuts may cancel each other
        most = std::max(most, reported);
    }
    EXPECT_GT(most, 1e-9) << "no defect to speak of";
}

TEST(Cuts, ExactIsTheSameWithGroupsAndWithout) {
    Recipe r = chain(Coupling::exact, Predictor::hold);
    World grouped = on_ground(r);
    for (BodyDef& b : r.bodies) b.group.clear();
    World plain = on_ground(r);
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(grouped.step(), Status::ok);
        ASSERT_EQ(plain.step(), Status::ok);
        EXPECT_LE(grouped.stats().momentum_defect, 1e-12);
    }
    EXPECT_EQ(grouped.state().hash(), plain.state().hash());
    EXPECT_EQ(grouped.stats().cuts, 0);
    EXPECT_TRUE(grouped.splits().cuts().empty());
}

TEST(Cuts, CliqueIsStableWhereHoldIsNot) {
    for (const Predictor p : {Predictor::hold, Predictor::clique}) {
        World w = chain(Coupling::kinematic, p, 1e7).make();
        double stretch = 0.0;
        for (int i = 0; i < 300; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            stretch = std::max(stretch, std::fabs(w.violation(InteractionId{kThird})[0]));
        }
        // Exact coupling keeps lengths to millimetres.
        EXPECT_EQ(stretch > 0.1, p == Predictor::hold) << stretch;
    }
    World w = chain(Coupling::exact, Predictor::hold, 1e7).make();
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_LE(std::fabs(w.violation(InteractionId{kThird})[0]), 0.01);
    }
}

TEST(Cuts, OneInteractionMayBeCoupledInItsOwnWay) {
    World w = chain(Coupling::kinematic, Predictor::hold).make();
    ASSERT_EQ(w.splits().cuts().size(), 6U);
    // A bend over the first border and its stretch: the other interactions across it are then not
    // cut either.
    w.splits().set_coupling(InteractionId{kThird}, Coupling::exact);
    ASSERT_EQ(w.splits().cuts().size(), 5U);
    int open = 0;
    for (const CutView& c : w.splits().cuts()) open += c.open ? 1 : 0;
    EXPECT_EQ(open, 3);
    w.splits().set_coupling(InteractionId{2 * kThird}, Coupling::compliant);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.stats().cuts, 3);
    EXPECT_EQ(w.splits().coupling(InteractionId{2 * kThird}), Coupling::compliant);
}

TEST(Cuts, ALineThatIsCutSlackensAndBreaksAsOne) {
    Recipe r = chain(Coupling::kinematic, Predictor::hold);
    r.interactions[2 * kThird]
        .set("breaking_load", 150.0)
        .set("tension_only", 1.0);  // weight below: 120 N
    World w = r.make();
    std::int64_t breaks = 0;
    for (int i = 0; i < 300 && breaks == 0; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        breaks = w.stats().event_count[static_cast<std::size_t>(EventKind::line_break)];
    }
    EXPECT_EQ(breaks, 1);
    EXPECT_FALSE(w.intact(InteractionId{2 * kThird}));
    for (const Event& e : w.events().take()) {
        EXPECT_LT(e.interaction.index, w.interaction_count());
        if (e.kind == EventKind::line_break) {
            EXPECT_EQ(e.interaction.index, 2 * kThird);
        }
    }
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.force(InteractionId{2 * kThird})[0], 0.0);
}

TEST(Cuts, ATwinTakesTheSameStep) {
    for (const Coupling c : {Coupling::exact, Coupling::kinematic}) {
        World w = on_ground(chain(c, Predictor::hold));
        for (int i = 0; i < 40; ++i) ASSERT_EQ(w.step(), Status::ok);
        World twin = w.twin(c);
        for (int i = 0; i < 20; ++i) {
            twin.state().copy_from(w);
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(twin.step(), Status::ok);
            for (int b = 1; b <= kLumps; ++b)
                // To the rounding of the forms, which were chosen at other poses.
                EXPECT_LE((w.velocity(BodyId{b}).linear - twin.velocity(BodyId{b}).linear).norm(),
                          1e-9);
        }
    }
}

TEST(Cuts, RefusesWhatItCannotDo) {
    EXPECT_THROW(World({.coupling = Coupling::kinematic, .sleep_after = 1.0}), DefError);
    EXPECT_THROW(World({.coupling = static_cast<Coupling>(7)}), DefError);
    EXPECT_THROW(World({.predictor = static_cast<Predictor>(7)}), DefError);
    Recipe r;
    const BodyId g = r.ground();
    const BodyId s = r.scalar(0.0, 1.0);
    (void)g;
    r.add(between(InteractionKind::ScalarMotor, {s}));
    World w = r.make();
    EXPECT_THROW(w.splits().set_coupling(InteractionId{0}, Coupling::kinematic), DefError);
    EXPECT_THROW(w.splits().set_coupling(InteractionId{3}, Coupling::kinematic), DefError);
    EXPECT_THROW(w.splits().set_group(BodyId{9}, "x"), DefError);
    World a = chain(Coupling::kinematic, Predictor::hold).make();
    World b = chain(Coupling::compliant, Predictor::hold).make();
    EXPECT_THROW(b.state().restore(a.state().save()), DefError);
    EXPECT_THROW(b.state().copy_from(w), DefError);
}

}  // namespace
}  // namespace hawser::test
