// SPDX-License-Identifier: Apache-2.0
/// Wires in reports: breaks, nodes inserted and removed, tension along them.
#include "record/wire_position.h"
#include "report/summary.h"
#include "report/wires_json.h"

#include <hawser/hawser.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace hawser::test {
namespace {

/// A hanging wire of 50 m, with elements of 10 m that have its mass.
struct HangingWire {
    World w;
    WireId wire;
    record::SceneInfo info;
    HangingWire() {
        WireDef def{.name = "rope", .from = w.add_body({.kind = BodyKind::fixed})};
        def.elements = 5;
        def.length = 50.0;
        def.EA = 1e8;
        def.mass_per_length = 4.0;
        def.consistent_mass = true;
        wire = w.wires().add(def);
        info.name = "hanging";
    }
};

TEST(ReportedWires, ListThePiecesOfWiresThatAreCut) {
    HangingWire h;
    report::SummaryCollector collector(h.info, h.w);
    WireId piece;
    InteractionId first;
    for (int i = 0; i < 30; ++i) {
        // Within an element: a node, an end and an element are added, all without names.
        if (i == 12) {
            piece = h.w.wires().cut(h.wire, 33.0);
            first = h.w.wires().elements(piece).front();
            EXPECT_EQ(record::body_label(h.w, h.w.wires().nodes(piece).front()),
                      "rope/2 node " + std::to_string(h.w.wires().nodes(piece).front().index));
            const std::string label = record::interaction_label(h.w, first);
            EXPECT_EQ(label, "rope/2 stretch " + std::to_string(first.index));
        }
        ASSERT_EQ(h.w.step(), Status::ok);
        collector.after_step(h.w, h.w.events().take());
    }
    const report::Summary s = collector.result(h.w);
    ASSERT_EQ(s.wires.size(), 2U);
    EXPECT_FALSE(s.wires[0].is_cut_piece);
    EXPECT_TRUE(s.wires[1].is_cut_piece);
    EXPECT_EQ(s.wires[1].name, "rope/2");
    // The cut is in the thirteenth step and sampled after it.
    EXPECT_NEAR(s.wires[1].since, 13.0 / 60.0, 1e-12);
    // The node beside the cut is removed with constant tensions: lengths change by the difference
    // of strains.
    EXPECT_NEAR(s.wires[1].length.now, 17.0, 1e-4);
    // It falls freely: it carries at most the weight that hung below it, with the recoil of that.
    EXPECT_GE(s.wires[1].tension.least, 0.0);
    EXPECT_LT(s.wires[1].tension.greatest, 2.0 * 17.0 * 4.0 * 9.81);
    const std::string text = report::to_text(s, report::Detail::user);
    EXPECT_NE(text.find("\n  rope/2  "), std::string::npos) << "in the table of cables: " << text;
    EXPECT_NE(text.find("\"rope/2\", a piece since 216.7 ms"), std::string::npos) << text;
    EXPECT_NEAR(nlohmann::json::parse(report::to_json(s))["wires"]["rope/2"]["since"].get<double>(),
                13.0 / 60.0, 1e-12);
}

TEST(ReportedWires, TellWhereTheyPart) {
    HangingWire h;
    report::SummaryCollector collector(h.info, h.w);
    for (int i = 0; i < 30; ++i) {
        if (i == 12) h.w.wires().part(h.wire, 31.0);
        ASSERT_EQ(h.w.step(), Status::ok);
        collector.after_step(h.w, h.w.events().take());
    }
    const report::Summary s = collector.result(h.w);
    ASSERT_EQ(s.broken_wires.size(), 1U);
    EXPECT_EQ(s.broken_wires[0].wire, "rope");
    EXPECT_EQ(s.broken_wires[0].element, "rope/s3");
    EXPECT_DOUBLE_EQ(s.broken_wires[0].s, 35.0);
    EXPECT_DOUBLE_EQ(s.broken_wires[0].length, 50.0);
    EXPECT_NEAR(s.broken_wires[0].time, 12.0 / 60.0, 1e-12);
    // One and a half nodes of 40 kg hang below it.
    EXPECT_NEAR(s.broken_wires[0].tension, 60.0 * 9.81, 0.02 * 60.0 * 9.81);
    ASSERT_EQ(s.wires.size(), 1U);
    EXPECT_EQ(s.wires[0].broken_wires.size(), 1U);
    const std::string text = report::to_text(s, report::Detail::user);
    EXPECT_NE(text.find("the wire \"rope\" at s = 35 m of 50 m, element \"rope/s3\", at 0.2 s"),
              std::string::npos)
        << text;
    const auto json = nlohmann::json::parse(report::to_json(s));
    EXPECT_EQ(json["parted"][0]["wire"], "rope");
    EXPECT_EQ(json["parted"][0]["s"], 35.0);
    EXPECT_EQ(json["wires"]["rope"]["parted"][0]["element"], "rope/s3");
    EXPECT_EQ(record::broken_label(h.w, h.w.wires().elements(h.wire)[3]), "rope/s3 (rope at 35 m)");
}

TEST(ReportedWires, FollowNodesThatComeAndGo) {
    HangingWire h;
    report::SummaryCollector collector(h.info, h.w);
    BodyId node;
    for (int i = 0; i < 90; ++i) {
        if (i == 30) node = h.w.wires().insert_node(h.w.wires().elements(h.wire)[1], 0.5);
        if (i == 60) {
            ASSERT_TRUE(h.w.wires().remove_node(node, 3.2));
        }
        ASSERT_EQ(h.w.step(), Status::ok);
        collector.after_step(h.w, h.w.events().take());
    }
    const report::Summary s = collector.result(h.w);
    const report::WireFigures& f = s.wires.at(0);
    EXPECT_EQ(f.nodes.start, 6.0);
    EXPECT_EQ(f.nodes.now, 6.0);
    EXPECT_EQ(f.nodes.least, 6.0);
    EXPECT_EQ(f.nodes.most, 7.0);
    // Rest lengths change slightly if a node is inserted or removed, so that tensions stay.
    EXPECT_NEAR(f.length.now, 50.0, 1e-3);
    ASSERT_EQ(f.along.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        const double weight = 9.81 * 40.0 * (4.5 - static_cast<double>(k));
        EXPECT_LE(f.along[k].least, f.along[k].mean);
        EXPECT_LE(f.along[k].mean, f.along[k].greatest);
        EXPECT_NEAR(f.along[k].mean, weight, 0.06 * weight) << k;
    }
    EXPECT_NE(report::to_text(s, report::Detail::user).find("\"rope\": nodes 6 (6 to 7)"),
              std::string::npos);
    const auto json = nlohmann::json::parse(report::to_json(s));
    EXPECT_EQ(json["wires"]["rope"]["nodes"]["most"], 7.0);
    EXPECT_EQ(json["wires"]["rope"]["tension_along"]["mean"].size(), 5U);
}

/// An element carries the weight of the wire below it: on average half of the wire, for any number
/// of elements.
TEST(ReportedWires, MeansAreOfTheElementsThereAre) {
    HangingWire h;
    const auto elements = h.w.wires().elements(h.wire);
    record::CableInfo& rope = h.info.cables.emplace_back();
    rope.name = "rope";
    rope.elements.assign(elements.begin(), elements.end());
    report::SummaryCollector collector(h.info, h.w);
    for (int i = 0; i < 120; ++i) {
        if (i == 2) {
            ASSERT_TRUE(h.w.wires().remove_node(h.w.wires().nodes(h.wire)[1], 3.2));
            ASSERT_TRUE(h.w.wires().remove_node(h.w.wires().nodes(h.wire)[2], 3.2));
        }
        ASSERT_EQ(h.w.step(), Status::ok);
        collector.after_step(h.w, h.w.events().take());
    }
    ASSERT_EQ(h.w.wires().elements(h.wire).size(), 3U);
    const report::Summary s = collector.result(h.w);
    const report::CableFigures& f = s.cables.at(0);
    EXPECT_LE(f.min, f.mean);
    EXPECT_LE(f.mean, f.max);
    // On average 25 m hang below a point of the material, 23 m below its three elements.
    EXPECT_NEAR(f.mean, 24.0 * 4.0 * 9.81, 0.1 * 24.0 * 4.0 * 9.81);
}

TEST(ReportedWires, AreNoneWhereThereIsNone) {
    World w;
    (void)w.add_body({.kind = BodyKind::fixed});
    const report::WireWatch watch(w);
    EXPECT_TRUE(watch.result(w).empty());
    EXPECT_EQ(report::wire_lines({}, {}), "");
}

/// docs/cli.md has a row for each key of a summary of wires.
TEST(WireSummary, EachOfItsKeysIsDocumented) {
    std::ifstream in("docs/cli.md");
    std::string line;
    while (std::getline(in, line) && !line.starts_with("| `wires` | for each")) continue;
    ASSERT_TRUE(line.starts_with("| `wires` |"));
    report::WireFigures rope;
    rope.name = "rope";
    const auto out = report::wires_json({rope});
    ASSERT_GE(out["rope"].size(), 7U);
    for (const auto& [key, value] : out["rope"].items()) {
        EXPECT_NE(line.find("`" + key + "`"), std::string::npos) << key;
        if (!value.is_object()) continue;
        for (const auto& [inner, unused] : value.items())
            EXPECT_NE(line.find("`" + inner + "`"), std::string::npos) << key << "/" << inner;
    }
}

}  // namespace
}  // namespace hawser::test
