// SPDX-License-Identifier: Apache-2.0
/// Links between wires and legs of hooks that are made while a world runs, in pictures and exports.
#include "draw/plots.h"
#include "draw/projection.h"
#include "draw/wire_lines.h"
#include "export/export.h"
#include "record/joined_deck.h"
#include "record/series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hawser::test {
namespace {

constexpr std::size_t kWires = 2, kElements = 8;

TEST(JoinedLines, AreThoseThatThereWereInEachFrame) {
    JoinedDeck deck;
    const record::Recording r = deck.record(fresh_folder() / "r.hwr");
    EXPECT_EQ(r.damage, "");
    ASSERT_EQ(r.frame_count(), deck.lines.size());
    ASSERT_EQ(r.joints.size(), 1U) << "the stay";
    const draw::WireReader reader(r);
    std::vector<draw::WireLine> shown;
    std::size_t legs = 0, strops = 0;
    for (std::size_t f = 0; f < r.frame_count(); ++f) {
        const record::Frame frame = r.frame(f);
        reader.read(frame, shown);
        ASSERT_EQ(shown.size(), kWires + deck.lines[f].size()) << f;
        for (std::size_t k = kWires; k < shown.size(); ++k) {
            ASSERT_EQ(shown[k].segments.size(), 1U);
            const auto& [ends, pull] = deck.lines[f].at(std::string(shown[k].name));
            // Positions of bodies are in single precision.
            EXPECT_LT((shown[k].segments[0].from - ends[0]).norm(), 1e-5) << f;
            EXPECT_LT((shown[k].segments[0].to - ends[1]).norm(), 1e-5) << f;
            EXPECT_NEAR(shown[k].segments[0].tension, pull, 1e-6 * pull) << f;
        }
        legs += deck.lines[f].count("hook/leg1");
        strops += deck.lines[f].count("strop");
        EXPECT_EQ(draw::is_removed(frame, 0), f > JoinedDeck::kStayGone) << f;
    }
    // Legs appear with the step after the one of the request, and disappear in the same way.
    EXPECT_NEAR(static_cast<double>(legs), JoinedDeck::kLetGo - JoinedDeck::kTaken, 2.0);
    EXPECT_EQ(strops, std::size_t{JoinedDeck::kSteps - JoinedDeck::kJoined});
    EXPECT_FALSE(
        record::cable_interior(r)[static_cast<std::size_t>(deck.w.find_body("box").index)]);
}

/// Count strokes of wires and of joints, by their widths.
struct Strokes {
    std::size_t wires = 0, joints = 0;
};
Strokes strokes(const record::Recording& r, std::size_t frame, draw::Shown shown, double joint) {
    const auto drawing = draw::plot_views(r, record::collect_series(r), frame, {.shown = shown});
    Strokes out;
    for (const draw::Shape& shape : drawing.value().shapes)
        if (const auto* path = std::get_if<draw::Path>(&shape)) {
            out.wires += path->width == 2.2 ? 1U : 0U;
            out.joints += path->width == joint && path->points.size() == 2 ? 1U : 0U;
        }
    return out;
}

TEST(JoinedLines, AreDrawnFromWhereTheyComeToWhereTheyGo) {
    JoinedDeck deck;
    const record::Recording r = deck.record(fresh_folder() / "r.hwr");
    for (const auto& [shown, joint] :
         {std::pair(draw::Shown::side, 1.8), std::pair(draw::Shown::space, 1.6)}) {
        const auto at = [&](std::size_t frame) { return strokes(r, frame, shown, joint); };
        const Strokes start = at(5), leg = at(15), strop = at(25), loose = at(35), end = at(50);
        EXPECT_GE(start.wires, kElements);
        EXPECT_EQ(leg.wires, start.wires + 1);
        EXPECT_EQ(strop.wires, start.wires + 2);
        EXPECT_EQ(loose.wires, strop.wires);
        EXPECT_EQ(end.wires, start.wires + 1) << "the strop";
        EXPECT_EQ(leg.joints, start.joints);
        EXPECT_EQ(loose.joints + 1, strop.joints) << "the stay has gone";
    }
}

TEST(JoinedLines, AreExported) {
    JoinedDeck deck;
    const auto folder = fresh_folder();
    const record::Recording r = deck.record(folder / "r.hwr");
    exporting::write_vtk(r, exporting::choose_frames(r, 5, 0.0, 1e9), folder / "r.pvd");
    const auto names = [&](const char* file) {
        const std::vector<std::byte> bytes = read_bytes(folder / "r" / file);
        const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const auto lines = text.find("NumberOfLines=\"") + 15;
        return std::stoul(text.substr(lines));
    };
    EXPECT_EQ(names("frame_000001.vtp"), kElements);
    EXPECT_EQ(names("frame_000005.vtp"), kElements + 2);
}

}  // namespace
}  // namespace hawser::test
