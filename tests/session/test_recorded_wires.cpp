// SPDX-License-Identifier: Apache-2.0
/// Recordings contain the shape of wires with changing nodes: pictures show the shape of the run.
#include <hawser/hawser.h>
#include <hawser/recording.h>
#include <hawser/scene.h>
#include <hawser/session.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace hawser {
namespace {

/// Expect that the ends of the pieces of a wire, and their tensions, agree in the world and a
/// frame.
void expect_the_same(const World& w, const record::Recording& r, const record::Frame& f) {
    ASSERT_NE(f.wires, nullptr);
    ASSERT_EQ(f.wires->size(), w.wires().ids().size());
    for (std::size_t k = 0; k < f.wires->size(); ++k) {
        const record::RecordedWire& wire = (*f.wires)[k];
        EXPECT_EQ(wire.name, w.wires().name(w.wires().ids()[k]));
        const auto elements = w.wires().elements(w.wires().ids()[k]);
        ASSERT_EQ(wire.pieces.size(), elements.size());
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const auto ends = w.wires().ends(elements[i]);
            for (int end = 0; end < 2; ++end) {
                const Pose& pose = f.poses[static_cast<std::size_t>(wire.pieces[i].body[end])];
                const Vec3 at = pose.position + pose.orientation * wire.pieces[i].point[end];
                // The touching point on a wheel is the one of the last edit: it moves by
                // centimetres.
                EXPECT_LT((at - ends[static_cast<std::size_t>(end)]).norm(), 0.2) << i;
            }
            const double pull = std::max(0.0, -w.force(elements[i])[0]);
            EXPECT_NEAR(f.pulls[wire.first_piece + i], pull, 1e-6 * pull + 1e-3) << i;
        }
    }
    EXPECT_EQ(r.damage, "");
}

TEST(RecordedWires, AreThoseOfTheFrame) {
    const auto file = std::filesystem::temp_directory_path() / "hawser_recorded_wires.hwr";
    scene::Scene scene = scene::load_file("scenes/wire_bollard.json");
    Session session(std::move(scene));
    session.record(file);
    for (int i = 0; i < 900; ++i) ASSERT_EQ(session.step(), Status::ok);
    session.finish();
    const record::Recording r = record::Recording::open(file);
    ASSERT_EQ(r.frame_count(), 901u);
    expect_the_same(session.world(), r, r.frame(900));
    // Nodes have passed: other pieces than at the start.
    ASSERT_NE(r.frame(0).wires, nullptr);
    EXPECT_NE(r.frame(0).wires, r.frame(900).wires);
    const std::vector<bool> inside = record::cable_interior(r);
    for (std::size_t b = 0; b < r.bodies.size(); ++b)
        EXPECT_EQ(inside[b], r.bodies[b].kind == BodyKind::lump) << r.bodies[b].name;
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace hawser
