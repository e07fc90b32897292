// SPDX-License-Identifier: Apache-2.0
/// Shapes in recordings and pictures.
#include "draw/plots.h"
#include "draw/shapes.h"
#include "record/outlines.h"
#include "record/small_scene.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace hawser::test {
namespace {

struct Touching : SmallScene {
    Touching() {
        const BodyId top = world.find_body("top"), box = world.find_body("box & <friends>");
        ShapeDef s;
        s.kind = ShapeKind::plane;
        s.body = top;
        s.position = {0, 0, -2.2};
        world.add_shape(s);
        s = {};
        s.kind = ShapeKind::cylinder;
        s.body = box;
        s.radius = 0.5;
        s.half_length = 2.0;
        s.position = {0, 3, 0};
        world.add_shape(s);
        s.kind = ShapeKind::sphere;
        world.add_shape(s);
        s = {};
        s.kind = ShapeKind::heightfield;
        s.body = top;
        s.rows = s.columns = 200;
        s.cell = {0.1, 0.1};
        s.heights.assign(40'000, -2.5);
        world.add_shape(s);
        s = {};
        s.body = world.find_body("wire/1");
        s.radius = 0.1;
        world.add_shape(s);
    }
};

record::Recording recorded(Touching& scene) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("hawser_outlines_" + std::to_string(getpid()) + ".hwr");
    scene.record(file, 5);
    record::Recording r = record::Recording::open(file);
    std::filesystem::remove(file);
    return r;
}

TEST(Outlines, AreRecordedInTheFrameOfTheirBody) {
    Touching scene;
    const record::Recording r = recorded(scene);
    EXPECT_EQ(r.damage, "");
    // The cable's node has no outline.
    ASSERT_EQ(r.outlines.size(), 4U);
    EXPECT_EQ(r.outlines[0].kind, record::OutlineKind::plane);
    EXPECT_EQ(r.outlines[0].points[0], Vec3(0, 0, -2.2));
    EXPECT_EQ(r.outlines[0].points[1], Vec3::UnitZ());
    EXPECT_EQ(r.outlines[1].points.size(), 48U);
    for (const Vec3& p : r.outlines[1].points)
        EXPECT_NEAR((p - Vec3(0, 3, p.z())).norm(), 0.5, 1e-12);
    EXPECT_EQ(r.outlines[2].radius, 0.5);
    // Thinned, but the last line is kept.
    EXPECT_EQ(r.outlines[3].kind, record::OutlineKind::lines);
    EXPECT_LE(r.outlines[3].row, 65);
    EXPECT_NEAR(r.outlines[3].points.back().x(), 9.95, 1e-12);
}

TEST(Outlines, ArePartOfThePicture) {
    Touching scene;
    const record::Recording r = recorded(scene);
    const auto with = draw::plot_views(r, {}, r.frame_count() - 1);
    ASSERT_TRUE(with);
    // The plane's edge: a line across the side view at z = -2.2.
    int edges = 0, clips = 0;
    for (const draw::Shape& s : with->shapes) {
        clips += std::holds_alternative<draw::Clip>(s) ? 1 : 0;
        const auto* path = std::get_if<draw::Path>(&s);
        if (path != nullptr && path->points.size() == 2 && path->width == 1.4 &&
            path->points[0].y == path->points[1].y &&
            std::abs(path->points[1].x - path->points[0].x) > 500)
            ++edges;
    }
    EXPECT_EQ(edges, 1);
    EXPECT_EQ(clips, 4);
    draw::Bounds bounds;
    draw::add_outlines_to_bounds(r, r.frame(0), bounds);
    EXPECT_NEAR(bounds.high.y(), 3.5, 1e-9);
    EXPECT_GT(bounds.low.x(), -5.0);  // the ground, 20 m wide, is excluded
}

TEST(Outlines, NonsenseIsRefused) {
    record::RecordedOutline good{.body = 1, .points = {Vec3::Zero()}};
    const auto accepted = [](const record::RecordedOutline& o) {
        record::ByteWriter out;
        record::write_outlines(out, {o});
        record::ByteReader in(out.bytes());
        try {
            return record::get_outlines(in, 2).size() == 1;
        } catch (const record::BadBytes&) {
            return false;
        }
    };
    EXPECT_TRUE(accepted(good));
    auto bad = good;
    bad.body = 2;
    EXPECT_FALSE(accepted(bad));
    bad = good;
    bad.kind = record::OutlineKind::plane;
    EXPECT_FALSE(accepted(bad));
    bad.kind = record::OutlineKind::lines;
    EXPECT_FALSE(accepted(bad));
    bad.kind = static_cast<record::OutlineKind>(3);
    EXPECT_FALSE(accepted(bad));
    bad = good;
    bad.points.clear();
    EXPECT_FALSE(accepted(bad));
}

}  // namespace
}  // namespace hawser::test
