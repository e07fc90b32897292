// SPDX-License-Identifier: Apache-2.0
/// Pictures of tensions over time and along wires whose nodes are inserted and removed.
#include "draw/along.h"
#include "draw/curves.h"
#include "draw/plots.h"
#include "draw/svg.h"
#include "draw/winch_scene.h"
#include "record/series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::test {
namespace {

constexpr double kG = 9.81, kMass = 800.0, kPerLength = 4.2;

TEST(TensionAlong, IsThatOfTheNodesThereAreAndOfTheLengthThatIsOut) {
    const record::Recording r = WinchScene::record(9.0);
    ASSERT_EQ(r.cables.size(), 1U);
    const std::size_t last = r.frame_count() - 1;
    const auto along = draw::tensions_along(r, record::collect_series(r), 6, last);
    ASSERT_EQ(along.size(), 1U);
    const draw::Along& a = along[0];
    EXPECT_TRUE(a.changes);
    EXPECT_GT(a.elements.size(), std::size_t(r.cables[0].elements)) << "nodes came";
    // The wire hangs straight: the length paid out is the distance from the drum to the load.
    const record::Frame frame = r.frame(last);
    const double out = -frame.poses[std::size_t(r.cables[0].nodes.back())].position.z();
    EXPECT_GT(out, WinchScene::kWire + 7.0);
    EXPECT_NEAR(a.length, out, 1e-3) << "poses are in single precision, and it sways by rounding";
    EXPECT_LT(a.elements.back(), out);
    EXPECT_GT(a.elements.back(), out - 3.5) << "within half an element of the end";
    // Weight below the middle of each element. The load is lowered at a constant 1 m/s, its damping
    // carries 400 N, and the wire's mass is stretched by 0.2 %.
    for (std::size_t i = 0; i < a.elements.size(); ++i) {
        const double weight = kG * (kMass + kPerLength * (out - a.elements[i])) - 400.0;
        EXPECT_NEAR(a.tensions[i], weight, 0.01 * weight) << i;
    }
    // The band has points along the whole wire, and the largest is ≥ the smallest everywhere.
    ASSERT_GT(a.s.size(), 100U);
    EXPECT_GT(a.s.back(), 0.99 * a.length);
    for (std::size_t i = 0; i < a.s.size(); ++i) {
        EXPECT_LE(a.least[i], a.mean[i]);
        EXPECT_LE(a.mean[i], a.greatest[i]);
    }
}

TEST(TensionAlong, PicturesSayOfWhichLengthsAndWhen) {
    const record::Recording r = WinchScene::record(9.0);
    const auto drawing = draw::plot_wires(r, record::collect_series(r), r.frame_count() - 1);
    ASSERT_TRUE(drawing);
    const std::string svg = draw::to_svg(*drawing);
    for (const char* words : {"length along the wire from the first end [m]", "Black: at 9 s",
                              "Lengths as the wires lie"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;
    EXPECT_EQ(svg.find("unstretched"), std::string::npos);
}

TEST(TensionCurves, AreThoseOfTheElementsThereAre) {
    const record::Recording r = WinchScene::record(9.0);
    const record::Series series = record::collect_series(r);
    ASSERT_EQ(series.cables.size(), 1U);
    const record::Frame frame = r.frame(r.frame_count() - 1);
    ASSERT_NE(frame.wires, nullptr);
    const auto& s = series.cables[0];
    // At the drum the wire carries its whole weight, at the load the least.
    EXPECT_FLOAT_EQ(float(s.highest.back()),
                    *std::max_element(frame.pulls.begin(), frame.pulls.end()));
    EXPECT_FLOAT_EQ(float(s.lowest.back()),
                    *std::min_element(frame.pulls.begin(), frame.pulls.end()));
    EXPECT_FLOAT_EQ(float(s.last.back()), frame.pulls.back());
    const double hung = kPerLength * kG * (WinchScene::kWire + 7.0);
    EXPECT_GT(s.first.back() - s.last.back(), 0.8 * hung) << "all of the wire that is out";
}

TEST(TensionCurves, PiecesThatAreCutOffHaveTheirOwn) {
    const record::Recording r = WinchScene::record(WinchScene::kCut + 0.2);
    const record::Series series = record::collect_series(r);
    ASSERT_EQ(series.cables.size(), 2U);
    EXPECT_EQ(series.cables[0].name, "fall");
    EXPECT_EQ(series.cables[1].name, "fall/2");
    const std::vector<double>& piece = series.cables[1].highest;
    for (std::size_t i = 0; i < piece.size(); ++i)
        EXPECT_EQ(std::isfinite(piece[i]), series.time[i] > WinchScene::kCut + 1e-6) << i;
    const auto tensions = draw::plot_tensions(r, series);
    ASSERT_TRUE(tensions);
    EXPECT_NE(draw::to_svg(*tensions).find("fall/2"), std::string::npos);
    const auto along = draw::tensions_along(r, series, 6, r.frame_count() - 1);
    ASSERT_EQ(along.size(), 2U);
    // The part below the cut at the drawn time, and the part left at the drum.
    EXPECT_NEAR(along[0].elements.back(), WinchScene::kAt, 3.0);
    EXPECT_GT(along[1].length, WinchScene::kWire + 8.0 - WinchScene::kAt);
}

TEST(TensionCurves, BreakWhereTheRunGoesBack) {
    const record::Recording r = WinchScene::record(8.0, true);
    ASSERT_EQ(r.takes.size(), 1U);
    const record::Series series = record::collect_series(r);
    const auto parts = record::continuous_intervals(series, series.cables[0].first);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].second, r.takes[0].frames);
    for (const auto& [begin, end] : parts)
        for (std::size_t i = begin + 1; i < end; ++i) EXPECT_GT(series.time[i], series.time[i - 1]);
    // No line of a picture over time runs from right to left.
    const draw::Axes axes{.frame = {0, 0, 800, 100}, .x = {0, 8}, .y = {0, 1e4}};
    for (const auto& line : draw::curve_parts(axes, series, series.cables[0].first, 1.0))
        for (std::size_t i = 1; i < line.size(); ++i) EXPECT_GE(line[i].x, line[i - 1].x);
}

}  // namespace
}  // namespace hawser::test
