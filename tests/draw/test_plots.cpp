// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"
#include "draw/commands_note.h"
#include "draw/plots.h"
#include "draw/png.h"
#include "draw/spy.h"
#include "draw/svg.h"
#include "draw/view_labels.h"
#include "draw/xml_check.h"
#include "record/small_scene.h"
#include "record/units.h"

#include <png.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {

using draw::Drawing;

bool has_text(const XmlDocument& document, const std::string& wanted) {
    return std::any_of(document.texts.begin(), document.texts.end(),
                       [&](const std::string& t) { return t.find(wanted) != std::string::npos; });
}

/// Check that a picture states its content, its scene and its parameters.
XmlDocument check_picture(const Drawing& drawing) {
    const std::string svg = draw::to_svg(drawing);
    XmlDocument document;
    EXPECT_NO_THROW(document = XmlReader(svg).read()) << svg.substr(0, 500);
    EXPECT_TRUE(has_text(document, "small"));
    EXPECT_TRUE(has_text(document, instruction_set()));
    EXPECT_TRUE(has_text(document, "hash"));
    return document;
}

class Plots : public testing::Test {
  protected:
    void SetUp() override {
        const auto file = fresh_folder() / "r.hwr";
        scene.record(file, 90);
        recording.emplace(record::Recording::open(file));
        series = record::collect_series(*recording);
    }
    SmallScene scene;
    std::optional<record::Recording> recording;
    record::Series series;
};

TEST_F(Plots, TensionsHaveAxesUnitsAndLegend) {
    const auto drawing = draw::plot_tensions(*recording, series);
    ASSERT_TRUE(drawing);
    const XmlDocument d = check_picture(*drawing);
    for (const char* text : {"time [s]", "tension [N]", "wire", "of breaking", "wire/s1 parts"})
        EXPECT_TRUE(has_text(d, text)) << text;
}

TEST_F(Plots, MotionsHaveAxesUnitsAndLegend) {
    const auto drawing = draw::plot_motions(*recording, series);
    ASSERT_TRUE(drawing);
    const XmlDocument d = check_picture(*drawing);
    for (const char* text : {"time [s]", "roll [deg]", "yaw [deg]", "box & <friends>"})
        EXPECT_TRUE(has_text(d, text)) << text;
}

TEST_F(Plots, CommandsAreMarkedAndListed) {
    EXPECT_EQ(recording->input_names, std::vector<std::string>{"box.push"});
    for (const auto& drawing :
         {draw::plot_tensions(*recording, series), draw::plot_motions(*recording, series)}) {
        ASSERT_TRUE(drawing);
        EXPECT_TRUE(has_text(check_picture(*drawing), "A  0.05 s: inputs set, box.push 20"));
    }
    // Repeated values are no commands. The first of many moments are listed, the rest are counted.
    recording->inputs.clear();
    for (int i = 0; i < 30; ++i) recording->inputs.push_back({i, 0, i < 10 ? 5.0 : 1.0 + i});
    const auto commands = draw::list_commands_by_time(*recording);
    ASSERT_EQ(commands.size(), 6u);
    EXPECT_EQ(commands[0].text, "box.push 5");
    EXPECT_DOUBLE_EQ(commands[1].time, 10.0 / 60.0);
    EXPECT_EQ(commands[5].text, "box.push 15; 15 later changes are not marked");
}

// Names do not overlap: in a heap of many boxes each name is drawn once or not at all.
TEST_F(Plots, NamesDoNotOverlap) {
    record::Frame frame = recording->frame(0);
    for (int i = 0; i < 40; ++i) {
        record::RecordedBody body = recording->bodies[2];
        body.name = "crate " + std::to_string(i);
        body.half_size = Vec3(0.05, 0.05, 0.05);
        recording->bodies.push_back(body);
    }
    for (int i = 0; i < 40; ++i)
        frame.poses.push_back(
            {Vec3(0.1 * (i % 8), 0, -2 + 0.1 * std::floor(i / 8.0)), Quat::Identity()});
    const draw::Axes axes{.frame = {100, 100, 600, 500}, .x = {-1, 2}, .y = {-3.2, 0.2}};
    draw::Drawing drawing;
    draw::draw_names(drawing, axes, {0, 2, 1.0, ""}, *recording, frame);
    std::vector<draw::Box> boxes;
    for (const draw::Shape& shape : drawing.shapes)
        if (const auto* text = std::get_if<draw::Text>(&shape)) {
            ASSERT_EQ(text->anchor, draw::Anchor::start);
            const double w = draw::text_width(text->text, text->size, text->bold);
            boxes.push_back({text->at.x, text->at.y - 0.7 * text->size, w, 0.7 * text->size});
        }
    EXPECT_GT(boxes.size(), 15u);
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        EXPECT_GE(boxes[a].x, axes.frame.x);
        EXPECT_LE(boxes[a].right(), axes.frame.right());
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_FALSE(boxes[a].x < boxes[b].right() && boxes[b].x < boxes[a].right() &&
                         boxes[a].y < boxes[b].bottom() && boxes[b].y < boxes[a].bottom())
                << a << " and " << b;
    }
}

TEST_F(Plots, ViewsHaveBothPanelsAndAColourBar) {
    const auto drawing = draw::plot_views(*recording, series, recording->frame_count() - 1);
    ASSERT_TRUE(drawing);
    const XmlDocument d = check_picture(*drawing);
    for (const char* text :
         {"Side view", "Top view", "x [m]", "y [m]", "z [m]", "tension [", "box & <friends>"})
        EXPECT_TRUE(has_text(d, text)) << text;
}

TEST_F(Plots, DetailsAreDrawnOnlyForSmallBodies) {
    // The box is large compared with its small scene.
    EXPECT_FALSE(draw::plot_details(*recording, 1));
    recording->bodies[2].half_size = Vec3(0.1, 0.1, 0.1);
    const auto drawing = draw::plot_details(*recording, recording->frame_count() - 1);
    ASSERT_TRUE(drawing);
    const XmlDocument d = check_picture(*drawing);
    EXPECT_TRUE(has_text(d, "box & <friends>, side view"));
    // Lines that leave the panel are clipped at its frame, in the pixels as well.
    const draw::Image image = draw::rasterise(*drawing, 1.0);
    for (int y = 0; y < 60; ++y)
        for (int x = 1000; x < image.width; ++x)
            ASSERT_EQ(image.rgb[std::size_t(3 * (y * image.width + x))], 255) << x << ", " << y;
}

TEST_F(Plots, SpyShowsMatrixAndFactor) {
    const SystemView view = scene.world.solver().matrix();
    const draw::FactorBlocks factor = draw::factor_blocks(view);
    const Drawing drawing =
        draw::plot_spy(view, factor, "small: spy", std::string("hash 1 ") + instruction_set());
    const XmlDocument d = check_picture(drawing);
    EXPECT_TRUE(has_text(d, "row [scalar]"));
    EXPECT_TRUE(has_text(d, "fill"));
    EXPECT_TRUE(has_text(d, "Factor in elimination order"));
}

// A chain eliminated from one end has no fill; a star eliminated from its centre fills in.
TEST(Spy, EliminationFindsTheFill) {
    SystemView star;
    star.nodes.assign(4, SystemNode{.body = {0}, .size = 3});
    star.edge_start = {0, 3, 4, 5, 6};
    star.edges = {1, 2, 3, 0, 0, 0};
    star.order = {0, 1, 2, 3};
    const auto filled = draw::factor_blocks(star);
    EXPECT_EQ(filled.row, (std::vector<std::int32_t>{1, 2, 3, 2, 3, 3}));
    EXPECT_EQ(filled.fill, (std::vector<bool>{false, false, false, true, true, true}));
    star.order = {1, 2, 3, 0};
    EXPECT_EQ(draw::factor_blocks(star).row, (std::vector<std::int32_t>{3, 3, 3}));
    EXPECT_THROW((void)draw::factor_blocks(star, 2), std::runtime_error);
}

TEST_F(Plots, PngOpensAndIsNotBlank) {
    const auto drawing = draw::plot_tensions(*recording, series);
    ASSERT_TRUE(drawing);
    const auto files = draw::write_pictures(*drawing, fresh_folder() / "deep" / "tensions");
    ASSERT_EQ(files.size(), 2u);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&image, files[1].c_str()), 0) << image.message;
    EXPECT_EQ(image.width, png_uint_32(2 * drawing->width));
    EXPECT_EQ(image.height, png_uint_32(2 * drawing->height));
    image.format = PNG_FORMAT_GRAY;
    std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
    ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
    const auto dark = std::count_if(pixels.begin(), pixels.end(), [](auto p) { return p < 100; });
    const auto light = std::count_if(pixels.begin(), pixels.end(), [](auto p) { return p > 250; });
    EXPECT_GT(dark, 1000);
    EXPECT_GT(light, long(pixels.size()) / 2);
}

TEST(Png, AFolderThatCannotBeMadeIsNamed) {
    try {
        (void)draw::write_pictures(Drawing{}, "/proc/none/picture");
        FAIL();
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("/proc/none/picture"), std::string::npos);
    }
}

TEST(Svg, EscapesWhatXmlForbids) {
    EXPECT_EQ(draw::escape_xml("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
    EXPECT_EQ(draw::escape_xml("\x01é"), " &#233;");
    EXPECT_EQ(draw::escape_xml("\xFF\xC3"), "&#65533;&#65533;");
    Drawing drawing{.title = "<&>"};
    drawing.text({0, 0}, "\xE2\x82", 12);
    EXPECT_NO_THROW(XmlReader(draw::to_svg(drawing)).read());
}

TEST(Raster, FillsAndStrokesCoverTheRightPixels) {
    Drawing drawing{.width = 10, .height = 10};
    drawing.box({2, 2, 4, 4}, {0, 0, 0, 255});
    drawing.line({0, 8.5}, {10, 8.5}, {0, 0, 0, 255}, 1.0);
    const draw::Image image = draw::rasterise(drawing, 1.0);
    const auto at = [&](int x, int y) {
        return int(image.rgb[3 * (std::size_t(y) * 10 + std::size_t(x))]);
    };
    EXPECT_EQ(at(3, 3), 0);
    EXPECT_EQ(at(5, 5), 0);
    EXPECT_EQ(at(6, 3), 255);
    EXPECT_EQ(at(1, 3), 255);
    EXPECT_EQ(at(5, 8), 0);
    EXPECT_EQ(at(5, 7), 255);
    // Half a pixel of a box is half dark.
    Drawing half{.width = 4, .height = 4};
    half.box({0, 0, 1.5, 4}, {0, 0, 0, 255});
    const draw::Image soft = draw::rasterise(half, 1.0);
    EXPECT_NEAR(soft.rgb[3], 128, 1);
}

// Damaged recordings contain any number. Drawing them must end and stay inside the image.
TEST(Raster, AbsurdCoordinatesAreHarmless) {
    Drawing drawing{.width = 20, .height = 20};
    for (const double far : {1e6, 1e30, 1e300, -1e300, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        drawing.line({10, 10}, {far, 10}, {0, 0, 0, 255}, 2.0, {3.0, 2.0});
        drawing.line({far, far}, {-far, 10}, {0, 0, 0, 255}, 2.0);
        drawing.add(draw::Path{
            .points = {{0, 0}, {far, 0}, {far, far}}, .fill = {0, 0, 0, 40}, .closed = true});
    }
    const draw::Image image = draw::rasterise(drawing, 1.0);
    EXPECT_EQ(image.rgb.size(), 1200u);
    EXPECT_NO_THROW(XmlReader(draw::to_svg(drawing)).read());
}

TEST(Raster, TextIsDrawnWhereItIsPut) {
    Drawing drawing{.width = 60, .height = 20};
    drawing.text({30, 15}, "Hg", 16, draw::Anchor::middle);
    const draw::Image image = draw::rasterise(drawing, 1.0);
    int dark = 0, outside = 0;
    const double half = 0.5 * draw::text_width("Hg", 16) + 1.0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 60; ++x)
            if (image.rgb[3 * (std::size_t(y) * 60 + std::size_t(x))] < 128)
                (std::abs(x + 0.5 - 30) < half ? dark : outside) += 1;
    EXPECT_GT(dark, 40);
    EXPECT_EQ(outside, 0);
}

TEST(Ticks, AreRoundAndInside) {
    for (const draw::Range r : {draw::Range{0, 1}, {-3, 17}, {1e6, 1.0001e6}, {0, 1e-7}}) {
        const auto values = draw::ticks(r, 6);
        EXPECT_GE(values.size(), 3u);
        EXPECT_LE(values.size(), 14u);
        for (const double v : values) {
            EXPECT_GE(v, r.low - 1e-9 * r.span());
            EXPECT_LE(v, r.high + 1e-9 * r.span());
        }
    }
    EXPECT_EQ(draw::ticks({0, 1}, 5),
              (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
    EXPECT_EQ(draw::tick_label(0.25, 0.05), "0.25");
    EXPECT_EQ(draw::tick_label(-2, 1), "−2");
    EXPECT_EQ(record::with_unit(-0.0, "N"), "0 N");
    EXPECT_EQ(record::with_unit(1.25e6, "N"), "1.25 MN");
    EXPECT_EQ(record::with_unit(5e-6, "m"), "5 µm");
    // The kilogram has a prefix already.
    EXPECT_EQ(record::with_unit(797e3, "kg"), "797 t");
    EXPECT_EQ(record::with_unit(12.34e6, "kg"), "12.34 kt");
    EXPECT_EQ(record::with_unit(-20.0, "kg"), "-20 kg");
    EXPECT_EQ(record::with_unit(0.25, "kg"), "250 g");
}

TEST(Curves, ThinningKeepsPeaks) {
    std::vector<double> x, y;
    for (int i = 0; i < 100000; ++i) {
        x.push_back(i);
        y.push_back(i == 50001 ? 1.0 : 0.0);
    }
    const draw::Axes axes{.frame = {0, 0, 100, 50}, .x = {0, 1e5}, .y = {0, 1}};
    const auto points = draw::thinned(axes, x, y);
    EXPECT_LT(points.size(), 1000u);
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](auto p) { return p.y == 0.0; }));
}

}  // namespace hawser::test
