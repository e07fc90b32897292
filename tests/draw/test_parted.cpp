// SPDX-License-Identifier: Apache-2.0
/// Broken cables in pictures.
#include "draw/parted.h"
#include "draw/plots.h"
#include "draw/svg.h"
#include "record/series.h"
#include "record/small_scene.h"

#include <gtest/gtest.h>

#include <string>

namespace hawser::test {
namespace {

/// Count the lines of the colour that marks broken ends by crosses.
std::size_t crosses(const draw::Drawing& drawing) {
    const std::string svg = draw::to_svg(drawing), color = "#be1e1e";
    std::size_t count = 0;
    for (std::size_t at = svg.find("stroke=\"" + color); at != std::string::npos;
         at = svg.find("stroke=\"" + color, at + 1))
        ++count;
    return count;
}

TEST(BrokenCables, AreFoundByTheNamesOfTheirElements) {
    SmallScene scene;
    const auto file = fresh_folder() / "r.hwr";
    scene.record(file, 90);
    record::Recording recording = record::Recording::open(file);
    ASSERT_EQ(recording.events.size(), 1U);
    ASSERT_EQ(draw::broken_elements(recording, 2.0).size(), 1U);
    EXPECT_EQ(draw::broken_elements(recording, 2.0)[0].element, 1);
    EXPECT_TRUE(draw::broken_elements(recording, 1.4).empty()) << "not yet";
    // Names that no element of a cable has, in files from any source.
    for (const char* where :
         {"wire/s2", "wire/s-1", "wire/s", "wire/s1x", "wire/s99999999999999", "wir", "", "s1"}) {
        recording.events[0].where = where;
        EXPECT_TRUE(draw::broken_elements(recording, 2.0).empty()) << where;
    }
    recording.events[0].where = "wire/s0 (wire at 0.52 m)";
    ASSERT_EQ(draw::broken_elements(recording, 2.0).size(), 1U);
    EXPECT_EQ(draw::broken_elements(recording, 2.0)[0].element, 0);
}

/// Record 1.5 s of a cable that breaks at its end.
record::Recording record_parting() {
    SmallScene scene;
    const auto file = fresh_folder() / "r.hwr";
    scene.record(file, 90);
    return record::Recording::open(file);
}

TEST(BrokenCables, AreDrawnInPiecesWithTheirEndsMarked) {
    record::Recording recording = record_parting();
    const record::Series series = record::collect_series(recording);
    const auto parted = draw::plot_views(recording, series, recording.frame_count() - 1);
    ASSERT_TRUE(parted);
    // Two views, two ends, two strokes each.
    EXPECT_EQ(crosses(*parted), 8U);
    EXPECT_NE(draw::to_svg(*parted).find("Crosses: wire/s1 parted, 1.5 s"), std::string::npos);
    const auto whole = draw::plot_views(recording, series, 30);
    ASSERT_TRUE(whole);
    EXPECT_EQ(crosses(*whole), 0U);
}

TEST(BrokenCables, TensionIsDrawnAlongThem) {
    record::Recording recording = record_parting();
    const record::Series series = record::collect_series(recording);
    const auto drawing = draw::plot_wires(recording, series, recording.frame_count() - 1);
    ASSERT_TRUE(drawing);
    const std::string svg = draw::to_svg(*drawing);
    for (const char* text : {"tension [N]", "unstretched length from the first end [m]",
                             "wire/s1 parted, 1.5 s", "small: tension along the cables"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    recording.cables.clear();
    recording.plot_cables.clear();
    EXPECT_FALSE(draw::plot_wires(recording, record::collect_series(recording), 0));
}

}  // namespace
}  // namespace hawser::test
