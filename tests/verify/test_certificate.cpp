// SPDX-License-Identifier: Apache-2.0
// Separate code agrees with the solver and detects errors, and the energy of contacts is balanced.
#include <hawser/scene.h>

#include "report/summary.h"
#include "verify/certificate.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace hawser {
namespace {

scene::Scene contact_scene(const char* name) {
    return scene::load_file(std::string("scenes/") + name + ".json");
}

TEST(Certificate, FindsWrongVelocities) {
    scene::Scene scene = contact_scene("belt");
    verify::Verifier verifier(scene.world);
    const BodyId box = scene.world.find_body("box");
    for (int i = 0; i < 3; ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok);
        ASSERT_EQ(verifier.after_step(scene.world), "");
    }
    verifier.before_step(scene.world);
    ASSERT_EQ(scene.world.step(), Status::ok);
    Twist twist = scene.world.velocity(box);
    twist.linear.x() += 1e-4;
    scene.world.set_velocity(box, twist);
    EXPECT_NE(verifier.after_step(scene.world), "");
}

/// Return the verifier's report on a sixth step of the belt, before or after which data have been
/// changed without notice.
template <class Before, class After>
std::string said_of_belt(const Before& before, const After& after) {
    scene::Scene scene = contact_scene("belt");
    verify::Verifier verifier(scene.world);
    for (int i = 0; i < 6; ++i) {
        verifier.before_step(scene.world);
        if (i == 5) before(scene.world);
        EXPECT_EQ(scene.world.step(), Status::ok);
        if (i == 5) after(scene.world);
        const std::string wrong = verifier.after_step(scene.world);
        if (i == 5) return wrong;
        EXPECT_EQ(wrong, "");
    }
    return {};
}

TEST(Certificate, FindsLawsThatAreNotThoseOfTheMaterials) {
    const auto nothing = [](World&) {};
    EXPECT_EQ(said_of_belt(nothing, nothing), "");
    // The pair of the scene; values are changed after the solution of the step.
    const scene::Scene scene = contact_scene("belt");
    ASSERT_EQ(scene.world.material_pairs().size(), 1U);
    const MaterialPairDef pair = scene.world.material_pairs().front();
    const auto with = [&](double MaterialDef::* value, double factor) {
        return said_of_belt(nothing, [&](World& world) {
            MaterialPairDef other = pair;
            other.values.*value *= factor;
            world.add_material_pair(other);
        });
    };
    EXPECT_EQ(with(&MaterialDef::friction, 1.0), "");
    EXPECT_NE(with(&MaterialDef::friction, 1.0001).find("friction"), std::string::npos);
    EXPECT_NE(with(&MaterialDef::stiffness, 1.0001).find("softness"), std::string::npos);
    EXPECT_NE(with(&MaterialDef::tangential, 1.0001).find("tangential"), std::string::npos);
    // A departing body keeps a part of its speed: the target depends on the velocity before the
    // step.
    const std::string lifted = said_of_belt(
        [](World& world) {
            Twist twist = world.velocity(world.find_body("box"));
            twist.linear.z() += 1e-3;
            world.set_velocity(world.find_body("box"), twist);
        },
        nothing);
    EXPECT_NE(lifted.find("target velocity"), std::string::npos) << lifted;
}

TEST(Certificate, HoldsForStepsThatABudgetCuts) {
    // About seven factorisations per step, too few for the settling arch: the natural map is large,
    // but equals the reported one, and the momentum of the stones is balanced.
    scene::Options options;
    options.budget_work = 85e3;
    scene::Scene scene = scene::load_file("scenes/arch.json", options);
    verify::Verifier verifier(scene.world);
    int cuts = 0, open = 0;
    for (int i = 0; i < 90; ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok);
        ASSERT_EQ(verifier.after_step(scene.world), "") << "step " << i;
        cuts += scene.world.stats().cut ? 1 : 0;
        open += scene.world.stats().natural_map > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(cuts, 5);
    EXPECT_GT(open, 5);
    EXPECT_GT(verifier.result().covered_bodies, 10);
    EXPECT_LE(verifier.result().momentum, 1e-9);
}

TEST(Certificate, FrictionTakesWhatSlidingLoses) {
    // 100 kg boxes, μ = 0.4, a belt at 2 m/s. Velocities belong to half a step before positions:
    //     sliding starts at −h/2 with v = 2 + μ g h/2 to lose. Friction dissipates ½ m v² of each
    //     of four boxes, and the belt does the work m v times its speed.
    scene::Scene scene = contact_scene("belt");
    const double belt = 2.0, v = belt + 0.5 * 0.4 * 9.81 * scene.world.settings().step;
    while (scene.world.time() < 1.5) ASSERT_EQ(scene.world.step(), Status::ok);
    const Energy e = scene.world.energy();
    EXPECT_NEAR(e.kinetic, 4.0 * 50.0 * belt * belt, 1e-3 * 800.0);
    // The stack is not rigid: as the belt catches its foot it rocks on its soft contacts. The
    // velocities at −h/2 are below μ g h/2 = 0.033 m/s (the top box has 0.020 m/s after the first
    // step): in sum 1.7 N s, 3.3 J at the belt's speed. Normal impulses dissipate another 1 J.
    EXPECT_NEAR(e.friction + e.contact, 4.0 * 50.0 * v * v, 4.0);
    EXPECT_NEAR(e.driven, 4.0 * 100.0 * v * belt, 4.0);
    EXPECT_LT(std::abs(e.contact), 1.5);
}

TEST(Certificate, SummaryBalancesEnergyAndCountsContacts) {
    scene::Scene scene = contact_scene("incline_slide");
    record::SceneInfo info;
    report::SummaryCollector collector(info, scene.world);
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(scene.world.step(), Status::ok);
        collector.after_step(scene.world, scene.world.events().take());
    }
    const report::Summary summary = collector.result(scene.world);
    // Losses of contacts are the exact changes of the scheme: only rounding of sums of 1e5 J
    // remains.
    EXPECT_LT(std::abs(summary.energy_drift()), 1e-6 * summary.energy_scale);
    EXPECT_GT(summary.energy_end.friction, 0.1 * summary.energy_scale);
    const auto json = nlohmann::json::parse(report::to_json(summary));
    EXPECT_LE(json["friction"]["natural_map"]["p95"].get<double>(), 1e-6);
    EXPECT_EQ(json["friction"]["uncertified_steps"], 0);
    EXPECT_EQ(json["friction"]["flips_left"], 0);
    EXPECT_GE(json["friction"]["factorisations"]["median"].get<double>(), 0.5);
    EXPECT_EQ(json["contacts"]["median"], 32.0);  // four per box
    EXPECT_EQ(json["equations_with_contacts"]["median"], 8 * 6 + 3 * 32.0);
    EXPECT_FALSE(json.contains("budget"));
    EXPECT_NE(report::to_text(summary, report::Detail::solver).find("natural map"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser
