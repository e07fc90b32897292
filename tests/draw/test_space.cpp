// SPDX-License-Identifier: Apache-2.0
/// Views in space: order along the view, hidden parts of solids, water, colours.
#include "draw/plots.h"
#include "draw/solids_view.h"
#include "draw/svg.h"
#include "draw/view_labels.h"
#include "draw/water.h"
#include "record/series.h"
#include "record/small_scene.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <hawser/session.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hawser::test {
namespace {

using draw::Camera;
using draw::Solid;

Solid box_at(const Vec3& where, const Vec3& half, const Camera& camera, double turn = 0.0) {
    record::Triangles t = record::box_surface(half);
    const Mat3 r = Eigen::AngleAxisd(turn, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : t.points) p = where + r * p;
    return draw::make_solid(std::move(t), {}, camera);
}

TEST(SpaceView, TheCameraIsAFrame) {
    for (const double azimuth : {-170.0, -60.0, 0.0, 33.0, 120.0})
        for (const double elevation : {5.0, 22.0, 85.0}) {
            const Camera c = Camera::at(azimuth, elevation);
            EXPECT_NEAR(c.right.cross(c.up).dot(c.to_viewer), 1.0, 1e-12);
            EXPECT_NEAR(c.right.z(), 0.0, 1e-12) << "the horizon is level";
            EXPECT_GT(c.up.z(), 0.0);
        }
    // From the south: y points away from the viewer and x to the right.
    const Camera south = Camera::at(-90.0, 0.0);
    EXPECT_NEAR(south.right.x(), 1.0, 1e-12);
    EXPECT_NEAR(south.to_viewer.y(), -1.0, 1e-12);
}

/// A box parallel to the axes.
struct AxisBox {
    Vec3 middle, half;
};

/// Compare two disjoint boxes along the view. @return 1 if `b` hides part of `a`, −1 if `a` hides
/// part of `b`, 0 if they do not overlap in the picture.
int nearer(const AxisBox& a, const AxisBox& b, const Camera& camera) {
    double low = -1e9, high = 1e9;  // bounds of the distances from a to b towards the viewer
    for (int k = 0; k < 3; ++k) {
        const double from = (b.middle[k] - a.middle[k] - a.half[k] - b.half[k]),
                     to = (b.middle[k] - a.middle[k] + a.half[k] + b.half[k]),
                     rate = camera.to_viewer[k];
        low = std::max(low, std::min(from / rate, to / rate));
        high = std::min(high, std::max(from / rate, to / rate));
    }
    return low >= high ? 0 : low > 0.0 ? 1 : -1;
}

/// True if each of some boxes hides part of the next one, and the last one of the first.
bool hide_in_a_circle(const std::vector<AxisBox>& boxes, const Camera& camera) {
    std::vector<const AxisBox*> left;
    for (const AxisBox& box : boxes) left.push_back(&box);
    while (!left.empty()) {
        const auto hides_none = [&](const AxisBox* box) {
            return std::none_of(left.begin(), left.end(), [&](const AxisBox* other) {
                return other != box && nearer(*box, *other, camera) < 0;
            });
        };
        const auto last = std::find_if(left.begin(), left.end(), hides_none);
        if (last == left.end()) return true;
        left.erase(last);
    }
    return false;
}

/// By rays: at points of the picture where two boxes overlap, the nearer one is painted later.
TEST(SpaceView, PaintsSolidsSoThatNearOnesCoverFarOnes) {
    const Camera camera = Camera::at(-60.0, 22.0);
    std::mt19937 random(first_seed(5));
    std::uniform_real_distribution<double> at(-10.0, 10.0), size(0.3, 3.0);
    int compared = 0, circles = 0;
    const int rounds = by_tier(40, 200, 2000);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Solid> solids;
        std::vector<AxisBox> boxes;
        for (int i = 0; i < 12; ++i) {
            const AxisBox box{{at(random), at(random), at(random)},
                              {size(random), size(random), size(random)}};
            Solid one = box_at(box.middle, box.half, camera, 0.0);
            // Overlapping boxes have no order.
            const bool free = std::none_of(solids.begin(), solids.end(), [&](const Solid& other) {
                for (int k = 0; k < 3; ++k) {
                    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
                    for (int s = 0; s < 2; ++s)
                        for (const Vec3& p : (s == 0 ? one : other).surface.points) {
                            low[s] = std::min(low[s], p[k]);
                            high[s] = std::max(high[s], p[k]);
                        }
                    if (low[0] > high[1] || low[1] > high[0]) return false;
                }
                return true;
            });
            if (!free) continue;
            solids.push_back(std::move(one));
            boxes.push_back(box);
        }
        if (hide_in_a_circle(boxes, camera)) {  // no order is right
            ++circles;
            continue;
        }
        const std::vector<std::size_t> order = draw::painting_order(solids, camera);
        ASSERT_EQ(order.size(), solids.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                // Solids painted earlier must not hide a corner of a later one, except if that
                // corner is behind its own solid.
                const Solid &early = solids[order[i]], &late = solids[order[j]];
                for (const Vec3& p : late.surface.points) {
                    EXPECT_FALSE(draw::is_hidden(p, {early}, camera));
                    ++compared;
                }
            }
    }
    EXPECT_GT(compared, 125 * rounds);
    EXPECT_LE(circles, rounds / 20);
}

TEST(SpaceView, HidesWhatStandsBehindASolid) {
    const Camera camera = Camera::at(0.0, 0.0);  // the viewer looks along −x
    const std::vector<Solid> solids{box_at({0, 0, 0}, {1, 2, 3}, camera)};
    EXPECT_TRUE(draw::is_hidden({-5, 1.9, 2.9}, solids, camera));
    EXPECT_FALSE(draw::is_hidden({5, 0, 0}, solids, camera)) << "before it";
    EXPECT_FALSE(draw::is_hidden({-5, 2.1, 0}, solids, camera)) << "beside it";
    EXPECT_TRUE(draw::is_hidden({0, 0, 0}, solids, camera)) << "in it";
    EXPECT_FALSE(draw::is_hidden({1, 0, 0}, solids, camera)) << "on the side that is seen";
    EXPECT_TRUE(draw::is_hidden({-1, 0, 0}, solids, camera)) << "on the side that is not";
    // A box seen along an axis shows the four edges of its face; from an oblique angle it shows
    // nine of twelve.
    EXPECT_EQ(draw::visible_creases(solids[0], camera).size(), 4U);
    const Camera askew = Camera::at(-60.0, 22.0);
    EXPECT_EQ(draw::visible_creases(box_at({0, 0, 0}, {1, 2, 3}, askew), askew).size(), 9U);
}

TEST(SpaceView, CutsPolygonsAtTheWater) {
    const std::vector<Vec3> square{{0, 0, -1}, {4, 0, -1}, {4, 0, 3}, {0, 0, 3}};
    const auto area = [](const std::vector<Vec3>& p) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < p.size(); ++i) sum += 0.5 * p[i].cross(p[(i + 1) % p.size()]);
        return sum.norm();
    };
    EXPECT_NEAR(area(draw::clipped(square, 0.0, true)), 12.0, 1e-12);
    EXPECT_NEAR(area(draw::clipped(square, 0.0, false)), 4.0, 1e-12);
    EXPECT_TRUE(draw::clipped(square, 5.0, true).empty());
    EXPECT_EQ(draw::clipped(square, 5.0, false).size(), 4U);
}

/// Record a buoy in water whose level a tide raises; a command sets 4 m after half a second.
record::Recording record_tide(const std::filesystem::path& file) {
    SessionDef def;
    def.scene_text = R"({"version": 1, "name": "tide", "settings": {"step": 0.05},
      "bodies": [{"name": "buoy", "kind": "lump", "position": [0, 0, 9], "mass": 1000},
                 {"name": "mark", "kind": "fixed", "position": [2, 0, 5]}],
      "sea": {"depth": 30, "level": [{"time": 0, "level": 2}, {"time": 2, "level": 3}],
              "bodies": [{"body": "buoy", "volume": 2, "drag_area": [1, 1, 1]}]},
      "timeline": [{"at": 0.5, "set": {"sea.level": 4}}]})";
    def.record = file;
    Session session(def);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(session.step(), Status::ok) << i;
    (void)session.finish();
    return record::Recording::open(file);
}

/// Return the height of the still-water line in the picture of a side view; nullopt if it is not
/// drawn.
std::optional<double> water_line(const record::Recording& r, std::size_t frame) {
    const auto drawing =
        draw::plot_views(r, record::collect_series(r), frame, {.shown = draw::Shown::side});
    for (const draw::Shape& shape : drawing.value().shapes)
        if (const auto* path = std::get_if<draw::Path>(&shape);
            path != nullptr && path->width == 1.4 && path->points.size() == 2 &&
            path->stroke.r == 70 && path->stroke.g == 130 && path->stroke.b == 180)
            return path->points[0].y;
    return std::nullopt;
}

TEST(SpaceView, WaterStandsWhereItStoodThen) {
    const record::Recording r = record_tide(fresh_folder() / "r.hwr");
    ASSERT_EQ(r.frame_count(), 41U);
    // Expected: the tide at each time, and 4 m after the step at 0.5 s.
    for (std::size_t f = 0; f < r.frame_count(); ++f) {
        const record::Frame frame = r.frame(f);
        const double level = 2.0 + 0.5 * frame.time + (frame.time > 0.501 ? 4.0 : 0.0);
        EXPECT_NEAR(draw::water_of(r, frame).level.value(), level, 1e-12) << frame.time;
        EXPECT_EQ(draw::water_of(r, frame).seabed, -30.0) << "does not rise with the tide";
    }
    // The picture begins at 5 m: water at z = 0 or 2 m would be below it.
    EXPECT_FALSE(water_line(r, 0));
    const auto low = water_line(r, 12), high = water_line(r, 39);
    ASSERT_TRUE(low && high);
    EXPECT_LT(*high, *low) << "pictures count down";
    const auto space = draw::plot_space(r, record::collect_series(r), 39, {});
    EXPECT_TRUE(space);
}

TEST(SpaceView, FindsWaterAndSeabedOfAScene) {
    SmallScene scene;
    const auto file = fresh_folder() / "r.hwr";
    scene.record(file, 3);
    record::Recording r = record::Recording::open(file);
    EXPECT_FALSE(draw::water_of(r, r.frame(0)).level);
    r.scene_text = R"({"sea": {"depth": 80}})";
    EXPECT_EQ(draw::water_of(r, r.frame(0)).level, 0.0);
    EXPECT_EQ(draw::water_of(r, r.frame(0)).seabed, -80.0);
    r.scene_text = R"({"interactions": [{"kind": "hinge"}, {"kind": "hydrostatic"}]})";
    EXPECT_EQ(draw::water_of(r, r.frame(0)).level, 0.0);
    EXPECT_FALSE(draw::water_of(r, r.frame(0)).seabed);
    r.outlines.push_back({.body = 0,
                          .kind = record::OutlineKind::plane,
                          .points = {Vec3(0, 0, -30), Vec3::UnitZ()}});
    EXPECT_EQ(draw::water_of(r, r.frame(0)).seabed, -30.0);
    for (const char* text : {"", "[]", "{", "{\"sea\": 3}", "{\"interactions\": [1, {}]}",
                             "{\"sea\": {\"depth\": \"x\"}}"}) {
        r.scene_text = text;
        EXPECT_NO_THROW((void)draw::water_of(r, r.frame(0))) << text;
    }
}

TEST(SpaceView, DrawsAFrameAndCrossesWhatHasParted) {
    SmallScene scene;
    const auto file = fresh_folder() / "r.hwr";
    scene.record(file, 90);  // wire/s1 breaks at its end
    record::Recording r = record::Recording::open(file);
    r.scene_text = R"({"sea": {"depth": 80}})";
    const record::Series series = record::collect_series(r);
    const auto red = [&](std::size_t frame) {
        const std::string svg = draw::to_svg(draw::plot_space(r, series, frame, {}).value());
        std::size_t count = 0;
        for (std::size_t at = svg.find("stroke=\"#be1e1e\""); at != std::string::npos;
             at = svg.find("stroke=\"#be1e1e\"", at + 1))
            ++count;
        return count;
    };
    EXPECT_EQ(red(89), 0U);
    EXPECT_GE(red(90), 2U);
    EXPECT_FALSE(draw::plot_space(r, series, 91, {}));
    // A given size and given axes are used for every frame.
    draw::ViewOptions fixed;
    fixed.width = 640;
    fixed.height = 400;
    fixed.box = std::pair(Vec3(-3, -3, -3), Vec3(3, 3, 1));
    for (const auto shown : {draw::Shown::space, draw::Shown::side, draw::Shown::top}) {
        fixed.shown = shown;
        const auto grid = [&](std::size_t frame) {
            const auto drawing = draw::plot_views(r, series, frame, fixed);
            EXPECT_EQ(drawing->width, 640.0);
            EXPECT_EQ(drawing->height, 400.0);
            std::string out;
            for (const draw::Shape& shape : drawing->shapes)
                if (const auto* text = std::get_if<draw::Text>(&shape);
                    text != nullptr && text->size < 13.0 && !text->bold && text->at.x < 560)
                    out += text->text + " ";
            return out;
        };
        EXPECT_EQ(grid(5).substr(0, 40), grid(60).substr(0, 40));
    }
}

TEST(SpaceView, ColoursCoverAHundredthOfTheTension) {
    SmallScene scene;
    const auto file = fresh_folder() / "r.hwr";
    scene.record(file, 3);
    const record::Recording r = record::Recording::open(file);
    record::Frame frame = r.frame(3);
    frame.tensions = {280000.0F, 280010.0F};
    const draw::Range range = draw::tension_range(frame);
    EXPECT_NEAR(range.span(), 2800.1, 0.1);
    EXPECT_LE(range.low, 280000.0);
    EXPECT_GE(range.high, 280010.0);
    frame.tensions = {200000.0F, 280000.0F};
    EXPECT_NEAR(draw::tension_range(frame).span(), 80000.0, 1e-6) << "as it is";
}

}  // namespace
}  // namespace hawser::test
