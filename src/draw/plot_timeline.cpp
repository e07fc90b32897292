// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"
#include "draw/timeline.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hawser::draw {

namespace {

constexpr double kThreadHeight = 26.0, kThreadGap = 8.0;  // height of a thread, gap between threads
constexpr Color kIdleColor{240, 241, 243, 255};

double height_of(const Timeline& t) {
    return t.threads * (kThreadHeight + kThreadGap) + kThreadGap;
}

}  // namespace

/// Return the colour of a kind of work, distinct also with a colour-vision deficiency (Okabe and
/// Ito); grey for other work.
Color color_of(Work work) noexcept {
    constexpr std::array<Color, kWorkCount> kColors{{{240, 228, 66, 255},
                                                     {0, 158, 115, 255},
                                                     {86, 180, 233, 255},
                                                     {213, 94, 0, 255},
                                                     {204, 121, 167, 255},
                                                     {0, 90, 160, 255},
                                                     {120, 124, 130, 255}}};
    return kColors[static_cast<std::size_t>(work)];
}

void draw_timeline(Drawing& drawing, const Box& frame, const Timeline& timeline, double until) {
    const double scale = until > 0.0 ? frame.width / until : 0.0;
    const double pitch = (frame.height - kThreadGap) / timeline.threads;
    const double height = pitch - kThreadGap;
    auto top = [&](int thread) { return frame.y + kThreadGap + thread * pitch; };
    for (int t = 0; t < timeline.threads; ++t) {
        drawing.box({frame.x, top(t), timeline.seconds * scale, height}, kIdleColor);
        drawing.text({frame.x - 8.0, top(t) + 0.5 * height + 4.0},
                     fmt::format("{}thread {}", timeline.simulated ? "simulated " : "", t), 11.0,
                     Anchor::end, kSoft);
    }
    // Tasks are drawn slightly shorter, to keep them distinct if there is enough space.
    std::array<Cells, kWorkCount> cells;
    for (const Segment& s : timeline.segments) {
        const double width = (s.end - s.begin) * scale;
        const double shown = std::max(width - (s.task && width > 2.0 ? 0.6 : 0.0), 0.05);
        // Code of the calling thread alone is drawn lower than tasks.
        const double inset = s.task ? 0.0 : 0.18 * height;
        cells[static_cast<std::size_t>(s.work)].boxes.push_back(
            {frame.x + s.begin * scale, top(s.thread) + inset, shown, height - 2.0 * inset});
    }
    for (int w = 0; w < kWorkCount; ++w) {
        Cells& c = cells[static_cast<std::size_t>(w)];
        c.fill = color_of(static_cast<Work>(w));
        if (!c.boxes.empty()) drawing.add(std::move(c));
    }
}

void draw_work_legend(Drawing& drawing, const Box& frame, const std::vector<Timeline>& timelines) {
    std::array<double, kWorkCount> seconds{};
    for (const Timeline& t : timelines)
        for (const Segment& s : t.segments)
            seconds[static_cast<std::size_t>(s.work)] += s.end - s.begin;
    double x = frame.x;
    auto entry = [&](Color color, const std::string& name) {
        drawing.box({x, frame.y, 14.0, 14.0}, color);
        drawing.text({x + 19.0, frame.y + 11.5}, name, 12.0);
        x += 19.0 + text_width(name, 12.0) + 18.0;
    };
    for (int w = 0; w < kWorkCount; ++w)
        if (seconds[static_cast<std::size_t>(w)] > 0.0)
            entry(color_of(static_cast<Work>(w)), to_string(static_cast<Work>(w)));
    entry(kIdleColor, "idle");
}

Drawing plot_timelines(const std::vector<Timeline>& timelines, const std::string& title,
                       const std::string& parameters) {
    constexpr double kLeftMargin = 130.0, kRightMargin = 30.0, kHeadHeight = 96.0,
                     kCaptionHeight = 22.0, kFootHeight = 52.0;
    double height = kHeadHeight + kFootHeight, until = 0.0;
    for (const Timeline& t : timelines) {
        height += kCaptionHeight + height_of(t);
        until = std::max(until, t.seconds);
    }
    Drawing d;
    d.height = height;
    d.title = title;
    d.description = parameters;
    d.box({0.0, 0.0, d.width, d.height}, kWhite);
    d.text({kLeftMargin, 30.0}, title, 18.0, Anchor::start, kInk, true);
    d.text({kLeftMargin, 50.0}, parameters, 12.0, Anchor::start, kSoft);
    draw_work_legend(d, {kLeftMargin, 64.0, d.width - kLeftMargin - kRightMargin, 14.0}, timelines);
    const record::Unit unit = record::readable_unit(until, "s");
    Axes axes;
    axes.frame = {kLeftMargin, kHeadHeight, d.width - kLeftMargin - kRightMargin,
                  height - kHeadHeight - kFootHeight};
    axes.x = {0.0, until > 0.0 ? until * unit.factor : 1.0};
    const std::vector<double> marks = ticks(axes.x, 10);
    const double distance = marks.size() > 1 ? marks[1] - marks[0] : 1.0;
    for (const double m : marks) {
        const double x = axes.at(m, 0.0).x;
        d.line({x, axes.frame.y}, {x, axes.frame.bottom()}, kGrid);
        d.text({x, axes.frame.bottom() + 18.0}, tick_label(m, distance), 11.0, Anchor::middle,
               kSoft);
    }
    d.text({axes.frame.x + 0.5 * axes.frame.width, axes.frame.bottom() + 38.0},
           fmt::format("time in the step [{}]", unit.name), 12.0, Anchor::middle, kSoft);
    double y = kHeadHeight;
    for (const Timeline& t : timelines) {
        d.text({kLeftMargin, y + 15.0}, describe(t), 12.0);
        y += kCaptionHeight;
        draw_timeline(d, {kLeftMargin, y, axes.frame.width, height_of(t)}, t, until);
        y += height_of(t);
    }
    return d;
}

}  // namespace hawser::draw
