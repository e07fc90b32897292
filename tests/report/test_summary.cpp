// SPDX-License-Identifier: Apache-2.0
#include "record/small_scene.h"
#include "report/samples.h"
#include "report/summary.h"

#include <nlohmann/json.hpp>

namespace hawser::test {

/// A requested cut that contacts keep closed is exact and no degradation. The
/// largest defect of the cuts in force is kept.
TEST(Degradations, CountWhatWasInForceWithItsDefect) {
    report::Degradations d;
    StepStats s;
    s.degradation.cuts = 3;
    s.momentum_defect = 1e-13;
    for (s.step = 1; s.step <= 5; ++s.step) d.after_step(s);
    EXPECT_EQ(d.all.steps, 0);
    EXPECT_EQ(d.spans, 0);
    s.compliant = 2;
    s.degraded_by = DegradedBy::prediction;
    for (const double defect : {0.1, 0.3, 0.2}) {
        s.momentum_defect = defect;
        s.cut_defect = 10.0 * defect;
        d.after_step(s);
        ++s.step;
    }
    EXPECT_EQ(d.coupling.steps, 3);
    EXPECT_EQ(d.coupling.interfaces, 1);
    EXPECT_EQ(d.coupling.momentum_defect, 0.3);
    EXPECT_EQ(d.coupling.cut_defect, 3.0);
    EXPECT_EQ(d.by_cause[static_cast<std::size_t>(DegradedBy::prediction)], 3);
    EXPECT_EQ(d.list.size(), 1U);
    report::Summary summary;
    summary.budget_ms = 5.0;
    summary.degradations = d;
    const auto json = nlohmann::json::parse(report::to_json(summary));
    EXPECT_EQ(json["degradations"]["coupling"]["momentum_defect_max"], 0.3);
    EXPECT_EQ(json["degradations"]["coupling"]["cut_defect_max"], 3.0);
    EXPECT_NE(
        report::to_text(summary, report::Detail::solver).find("momentum defect of compliant cuts"),
        std::string::npos);
}

TEST(Samples, QuantilesOfAFewAndOfMany) {
    report::Samples few;
    for (const double v : {5.0, 1.0, 3.0}) few.add(v);
    EXPECT_EQ(few.median(), 3.0);
    EXPECT_EQ(few.quantile(0), 1.0);
    EXPECT_EQ(few.quantile(0.75), 4.0);
    EXPECT_EQ(few.max(), 5.0);
    report::Samples many(64);
    for (int i = 0; i < 10000; ++i) many.add(i == 4999 ? 1e9 : i);
    EXPECT_EQ(many.count(), 10000);
    EXPECT_EQ(many.max(), 1e9);
    // 32 to 64 evenly spaced values are kept: the error of the median is less than one spacing.
    EXPECT_NEAR(many.median(), 5000, 10000 / 32.0);
    EXPECT_EQ(report::Samples().median(), 0.0);
}

TEST(Summary, JsonHasAllFields) {
    SmallScene scene;
    report::SummaryCollector collector(scene.info, scene.world);
    const int steps = 100;
    double top = 0.0;
    for (int i = 0; i < steps; ++i) {
        ASSERT_EQ(scene.world.step(), Status::ok);
        collector.after_step(scene.world, scene.world.events().take());
        for (const auto e : scene.info.cables[0].elements)
            top = std::max(top, record::element_tension(scene.world, e));
    }
    const report::Summary summary = collector.result(scene.world);
    const auto json = nlohmann::json::parse(report::to_json(summary));
    for (const char* key : {"scene",           "scene_hash",
                            "bodies",          "interactions",
                            "equations",       "islands",
                            "contacts",        "nnz",
                            "flops",           "steps",
                            "step_ms",         "solver_ms",
                            "solver_cpu_ms",   "stage_ms",
                            "residuals",       "violation_max",
                            "violation_where", "stretch_error_max",
                            "energy",          "event_counts",
                            "events",          "state_hash",
                            "threads",         "instruction_set",
                            "processor",       "load_average",
                            "version",         "peak_memory_bytes",
                            "tensions",        "motions"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["steps"], steps);
    EXPECT_EQ(json["timed_steps"], steps - report::kWarmUpSteps);
    EXPECT_EQ(json["bodies"], 2);
    EXPECT_EQ(json["equations"], 3 + 6 + 2);
    EXPECT_GT(json["step_ms"]["median"].get<double>(), 0.0);
    EXPECT_GE(json["step_ms"]["max"].get<double>(), json["step_ms"]["p99"].get<double>());
    EXPECT_EQ(json["stage_ms"].size(), std::size_t(kStageCount));
    EXPECT_DOUBLE_EQ(json["tensions"]["wire"]["max"].get<double>(), top);
    EXPECT_DOUBLE_EQ(json["tensions"]["wire"]["fraction_of_breaking_load"].get<double>(),
                     top / 1e4);
    const auto& motion = json["motions"]["box & <friends>"];
    EXPECT_GT(motion["displacement_max"].get<double>(), 0.0);
    EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16u);
    // The box oscillates: losses of elements and the step's damping are small.
    EXPECT_LT(std::abs(json["energy"]["drift_relative"].get<double>()), 0.1);
    EXPECT_NE(report::to_text(summary, report::Detail::solver).find("wire"), std::string::npos);
}

}  // namespace hawser::test
