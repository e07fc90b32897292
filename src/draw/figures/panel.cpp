// SPDX-License-Identifier: Apache-2.0
#include "draw/figures/panel.h"

#include "draw/axes.h"

#include <algorithm>

namespace hawser::draw {
namespace {

constexpr double kPageMargin = 28, kPageHead = 80, kPageBetween = 18;

struct PanelMover {
    Drawing& page;
    Point at;
    double scale;
    Box whole;

    [[nodiscard]] Point move(Point p) const { return {at.x + scale * p.x, at.y + scale * p.y}; }
    [[nodiscard]] Box move(const Box& b) const {
        const Point p = move(Point{b.x, b.y});
        return {p.x, p.y, scale * b.width, scale * b.height};
    }
    void operator()(Path path) const {
        for (Point& p : path.points) p = move(p);
        for (double& d : path.dash) d *= scale;
        path.width *= scale;
        page.add(std::move(path));
    }
    void operator()(Cells cells) const {
        for (Box& b : cells.boxes) b = move(b);
        page.add(std::move(cells));
    }
    void operator()(Text text) const {
        text.at = move(text.at);
        text.size *= scale;
        page.add(std::move(text));
    }
    void operator()(Clip clip) const {
        clip.box = clip.box ? move(*clip.box) : whole;
        page.add(clip);
    }
};

}  // namespace

Drawing make_panel(double width, double height, const std::string& title,
                   const std::vector<std::string>& notes) {
    Drawing d{.width = width, .height = height, .title = title};
    d.text({kPageMargin, 34}, title, 20.0, Anchor::start, kInk, true);
    double y = 57;
    for (std::size_t i = 0; i < notes.size(); ++i, y += 19) {
        const double fit = (width - 2 * kPageMargin) / std::max(1.0, text_width(notes[i], 1.0));
        d.text({kPageMargin, y}, notes[i], std::min(14.5, fit), Anchor::start,
               i == 0 ? kInk : kSoft);
        d.description += (i == 0 ? "" : "; ") + notes[i];
    }
    return d;
}

Box panel_square() { return {kPageMargin, 108, kFigureSquare, kFigureSquare}; }

void draw_swatches(Drawing& drawing, Point at, double width, const std::vector<Swatch>& swatches) {
    constexpr double kTextSize = 13.0;
    Point p = at;
    for (const Swatch& s : swatches) {
        const double mark = s.line ? 22 : 12;
        const double wide = mark + 7 + text_width(s.name, kTextSize);
        if (p.x > at.x && p.x + wide > at.x + width) p = {at.x, p.y + 19};
        if (s.line)
            drawing.line({p.x, p.y - 4.5}, {p.x + mark, p.y - 4.5}, s.color, 3.0, s.dash);
        else
            drawing.box({p.x, p.y - 10.5, 12, 12}, s.color, kSoft.with_alpha(120), 0.6);
        drawing.text({p.x + mark + 7, p.y}, s.name, kTextSize);
        p.x += wide + 20;
    }
}

void place(Drawing& page, const Drawing& panel, Point at, double width) {
    const double scale = width / panel.width;
    const PanelMover placer{page, at, scale, {at.x, at.y, width, scale * panel.height}};
    page.add(Clip{placer.whole});
    for (const Shape& shape : panel.shapes) std::visit(placer, shape);
    page.add(Clip{});
}

Drawing make_page(const std::string& title, const std::string& parameters,
                  const std::vector<std::vector<const Drawing*>>& rows) {
    double width = 0.0;
    for (const auto& row : rows) {
        double sum = 2 * kPageMargin - kPageBetween;
        for (const Drawing* d : row) sum += d->width + kPageBetween;
        width = std::max(width, sum);
    }
    Drawing page{.width = width, .height = 0.0};
    draw_heading(page, title, parameters);
    double y = kPageHead;
    for (const auto& row : rows) {
        double sum = 0.0, high = 0.0;
        for (const Drawing* d : row) sum += d->width;
        const double room =
            width - 2 * kPageMargin - kPageBetween * (static_cast<double>(row.size()) - 1.0);
        double x = kPageMargin;
        for (const Drawing* d : row) {
            const double wide = d->width * room / sum;
            place(page, *d, {x, y}, wide);
            x += wide + kPageBetween;
            high = std::max(high, d->height * room / sum);
        }
        y += high + kPageBetween;
    }
    page.height = y + 8;
    return page;
}

}  // namespace hawser::draw
