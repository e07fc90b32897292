// SPDX-License-Identifier: Apache-2.0
#include "draw/figures/timelines.h"

#include "draw/axes.h"
#include "draw/figures/panel.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::draw {

Drawing draw_timelines(const std::vector<NamedTimeline>& timelines, const std::string& title,
                       const std::vector<std::string>& notes) {
    constexpr double kPictureWidth = 3 * kFigureWidth + 36, kLeftMargin = 150, kRightMargin = 40,
                     kTopMargin = 124;
    constexpr double kCaptionHeight = 30, kThreadHeight = 34, kTimelineSeparation = 16;
    double height = kTopMargin, until = 0.0;
    std::vector<Timeline> all;
    for (const NamedTimeline& t : timelines) {
        height += kCaptionHeight + kTimelineSeparation +
                  (t.note.empty() ? kThreadHeight * t.timeline.threads : 0.0);
        if (!t.note.empty()) continue;
        until = std::max(until, t.timeline.seconds);
        all.push_back(t.timeline);
    }
    Drawing d = make_panel(kPictureWidth, height + 56, title, notes);
    draw_work_legend(d, {kLeftMargin, 92, kPictureWidth - kLeftMargin - kRightMargin, 14}, all);
    const record::Unit unit = record::readable_unit(until, "s");
    const Axes axes{.frame = {kLeftMargin, kTopMargin, kPictureWidth - kLeftMargin - kRightMargin,
                              height - kTopMargin},
                    .x = {0.0, until > 0.0 ? until * unit.factor : 1.0}};
    const std::vector<double> marks = ticks(axes.x, 12);
    const double distance = marks.size() > 1 ? marks[1] - marks[0] : 1.0;
    for (const double m : marks) {
        const double x = axes.at(m, 0.0).x;
        d.line({x, axes.frame.y}, {x, axes.frame.bottom()}, kGrid);
        d.text({x, axes.frame.bottom() + 18}, tick_label(m, distance), 13, Anchor::middle, kSoft);
    }
    d.text({axes.frame.x + 0.5 * axes.frame.width, axes.frame.bottom() + 40},
           fmt::format("time in the step [{}]", unit.name), 14, Anchor::middle, kSoft);
    double y = kTopMargin;
    for (const NamedTimeline& t : timelines) {
        d.text({kLeftMargin, y + 21}, t.name, 16, Anchor::start, kInk, true);
        // A viewer of the SVG may only have a wider font, such as DejaVu.
        const double x = kLeftMargin + 1.3 * text_width(t.name, 16, true) + 14;
        d.text({x, y + 21}, t.note.empty() ? describe(t.timeline) : t.note, 14, Anchor::start,
               kSoft);
        y += kCaptionHeight;
        if (t.note.empty()) {
            const double high = kThreadHeight * t.timeline.threads;
            draw_timeline(d, {kLeftMargin, y, axes.frame.width, high + 8}, t.timeline, until);
            y += high;
        }
        y += kTimelineSeparation;
    }
    return d;
}

}  // namespace hawser::draw
