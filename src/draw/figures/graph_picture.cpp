// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"
#include "draw/figures/index.h"
#include "draw/figures/interaction_graph.h"
#include "draw/figures/matrix.h"
#include "draw/figures/panel.h"
#include "draw/projection.h"
#include "record/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::draw {
namespace {

constexpr Color kTwoBodyColor{70, 82, 100, 255}, kHyperedgeColor{178, 205, 232, 255},
    kContactColor{230, 159, 0, 255};
constexpr Color kCutColor{214, 20, 40, 255}, kNoPartColor{150, 156, 164, 255};
constexpr double kInsetSize = 176;

/// Rectangle of the world, projected along an axis.
struct Scope {
    View view;
    Point middle;
    double half = 1.0;  ///< Half the side [m].
    Box frame;

    [[nodiscard]] Point to_page(const Vec3& p) const {
        const double s = 0.5 * frame.width / half;
        return {frame.x + 0.5 * frame.width + s * (p[view.right] - middle.x),
                frame.y + 0.5 * frame.height - s * (view.up_sign * p[view.up] - middle.y)};
    }
    [[nodiscard]] bool is_visible(const Vec3& p) const {
        const Point q = to_page(p);
        return q.x >= frame.x && q.x <= frame.right() && q.y >= frame.y && q.y <= frame.bottom();
    }
};

/// Return the view in which the box appears largest; the top view if two are equal.
View widest_view(const Vec3& extent) {
    const std::array<View, 3> views{{{0, 1, 1.0, "top view"},
                                     {0, 2, 1.0, "side view along y"},
                                     {1, 2, 1.0, "side view along x"}}};
    const auto area = [&](const View& v) {
        return (extent[v.right] + 1e-3) * (extent[v.up] + 1e-3);
    };
    return *std::max_element(views.begin(), views.end(), [&](const View& a, const View& b) {
        return area(a) < 0.999 * area(b);
    });
}

Scope visible_scope(const Bounds& bounds, const Box& frame, double margin) {
    const Vec3 extent = bounds.high - bounds.low, middle = 0.5 * (bounds.low + bounds.high);
    Scope s{.view = widest_view(extent), .middle = {}, .frame = frame};
    s.middle = {middle[s.view.right], middle[s.view.up]};
    s.half = 0.5 * margin * std::max({extent[s.view.right], extent[s.view.up], 1e-3});
    return s;
}

double radius(const GraphNode& n, double scale) {
    const double r = n.kind == BodyKind::lump ? 1.4 : 2.4 + 0.75 * std::log2(1.0 + n.degree);
    return scale * r;
}

void draw_disc(Drawing& d, Point at, double r, Color fill, Color stroke, double width) {
    Path p{.points = {}, .stroke = stroke, .width = width, .fill = fill, .closed = true};
    const int corners = r < 2.5 ? 8 : 20;
    for (int k = 0; k < corners; ++k) {
        const double a = 2.0 * M_PI * (k + 0.5) / corners;
        p.points.push_back({at.x + r * std::cos(a), at.y + r * std::sin(a)});
    }
    d.add(std::move(p));
}

Color edge_color(const InteractionGraph& g, const GraphEdge& e, bool parts) {
    if (!parts)
        return e.kind == "contact"  ? kContactColor
               : e.nodes.size() > 2 ? kHyperedgeColor
                                    : kTwoBodyColor;
    if (e.cut) return kCutColor;
    for (const std::int32_t n : e.nodes)
        if (g.nodes[at(n)].part >= 0) return part_color(g.nodes[at(n)].part).with_alpha(150);
    return kNoPartColor;
}

void draw_edges(Drawing& d, const InteractionGraph& g, const Scope& s, bool parts, double scale) {
    // Draw wide and pale edges first, cuts last.
    for (const int pass : {0, 1, 2})
        for (const GraphEdge& e : g.edges) {
            const bool wide = e.nodes.size() > 2;
            if (pass != (parts && e.cut ? 2 : wide ? 0 : 1)) continue;
            std::vector<Point> at_nodes;
            bool any_visible = false;
            for (const std::int32_t n : e.nodes) {
                at_nodes.push_back(s.to_page(g.nodes[at(n)].position));
                any_visible |= s.is_visible(g.nodes[at(n)].position);
            }
            if (!any_visible) continue;
            const Color color = edge_color(g, e, parts);
            const double width = scale * (pass == 2 ? 2.6 : wide ? 4.2 : 1.1);
            for (const Vec3& p : e.fixed) {
                const Point q = s.to_page(p);
                d.line(at_nodes.front(), q, kNoPartColor.with_alpha(170), 0.8 * scale);
                const double r = 2.2 * scale;
                d.box({q.x - r, q.y - r, 2 * r, 2 * r}, kWhite, kNoPartColor, 1.0);
            }
            if (at_nodes.size() > 1)
                d.add(Path{.points = at_nodes,
                           .stroke = wide && pass == 0 ? color.with_alpha(110) : color,
                           .width = width});
        }
}

void draw_nodes(Drawing& d, const InteractionGraph& g, const Scope& s, bool parts, double scale) {
    for (const bool large : {false, true})
        for (const GraphNode& n : g.nodes) {
            const bool small = n.kind == BodyKind::lump && !n.separator;
            if (small == large || !s.is_visible(n.position)) continue;
            Color fill = kInk;
            if (parts)
                fill = n.separator ? kWhite : n.part >= 0 ? part_color(n.part) : kNoPartColor;
            const double r = radius(n, scale);
            if (parts && n.separator)
                draw_disc(d, s.to_page(n.position), std::max(r, 3.2 * scale), fill, kInk, 1.8);
            else
                draw_disc(d, s.to_page(n.position), r, fill, small ? kNoColor : kWhite,
                          small ? 0.0 : 0.8);
        }
    if (!parts) return;
    for (const GraphEdge& e : g.edges) {
        if (!e.cut) continue;
        Vec3 middle = Vec3::Zero();
        for (const std::int32_t n : e.nodes) middle += g.nodes[at(n)].position;
        middle /= static_cast<double>(e.nodes.size());
        if (!s.is_visible(middle)) continue;
        const Point p = s.to_page(middle);
        const double r = 6.5 * scale;
        d.line({p.x - r, p.y - r}, {p.x + r, p.y + r}, kCutColor, 2.4 * scale);
        d.line({p.x - r, p.y + r}, {p.x + r, p.y - r}, kCutColor, 2.4 * scale);
    }
}

/// Find dense groups of bodies other than wire nodes, most crowded first.
std::vector<Bounds> dense_groups(const InteractionGraph& g, double reach, std::size_t most) {
    std::vector<bool> assigned(g.nodes.size(), false);
    std::vector<Bounds> out;
    const auto counts = [&](const GraphNode& n) { return n.kind != BodyKind::lump; };
    while (out.size() < most) {
        std::size_t best = 0, best_count = 0;
        for (std::size_t i = 0; i < g.nodes.size(); ++i) {
            if (assigned[i] || !counts(g.nodes[i])) continue;
            std::size_t near = 0;
            for (std::size_t j = 0; j < g.nodes.size(); ++j)
                near += !assigned[j] && counts(g.nodes[j]) &&
                        (g.nodes[i].position - g.nodes[j].position).norm() < reach;
            if (near > best_count) best_count = near, best = i;
        }
        if (best_count < 4) break;
        Bounds b;
        for (std::size_t j = 0; j < g.nodes.size(); ++j)
            if (!assigned[j] && counts(g.nodes[j]) &&
                (g.nodes[best].position - g.nodes[j].position).norm() < reach) {
                assigned[j] = true;
                b.add(g.nodes[j].position);
            }
        out.push_back(b);
    }
    return out;
}

void draw_insets(Drawing& d, const InteractionGraph& g, const Scope& main, const Box& strip,
                 bool parts) {
    const std::vector<Bounds> places = dense_groups(g, 0.14 * main.half, 3);
    double x = strip.x;
    const char* name = "A";
    static constexpr std::array<const char*, 3> kNames{"A", "B", "C"};
    for (std::size_t k = 0; k < places.size(); ++k, x += kInsetSize + 28) {
        name = kNames[k];
        const Box box{x, strip.y, kInsetSize, kInsetSize};
        const Scope s = visible_scope(places[k], box, 1.3);
        d.box(box, kWhite);
        d.add(Clip{box});
        draw_edges(d, g, s, parts, 1.0);
        draw_nodes(d, g, s, parts, 1.25);
        d.add(Clip{});
        d.box(box, kNoColor, kSoft);
        const Point p = main.to_page(0.5 * (places[k].low + places[k].high));
        d.add(Text{.at = {p.x + 9, p.y - 9}, .text = name, .size = 15, .bold = true, .halo = true});
        d.add(Text{
            .at = {box.x + 6, box.y + 17}, .text = name, .size = 15, .bold = true, .halo = true});
        d.add(Text{.at = {box.right() - 5, box.bottom() - 6},
                   .text = s.view.title,
                   .size = 11,
                   .anchor = Anchor::end,
                   .color = kSoft,
                   .halo = true});
    }
}

void draw_scale(Drawing& d, const Scope& s) {
    const double target_size = 0.25 * 2.0 * s.half;
    double length = std::pow(10.0, std::floor(std::log10(target_size)));
    for (const double f : {5.0, 2.0})
        if (f * length <= target_size) {
            length *= f;
            break;
        }
    const double wide = 0.5 * s.frame.width / s.half * length;
    const Point p{s.frame.right() - wide - 12, s.frame.bottom() - 12};
    d.line(p, {p.x + wide, p.y}, kInk, 1.6);
    d.add(Text{.at = {p.x + 0.5 * wide, p.y - 6},
               .text = record::with_unit(length, "m"),
               .size = 12,
               .anchor = Anchor::middle,
               .halo = true});
    d.add(Text{.at = {s.frame.x + 8, s.frame.bottom() - 10},
               .text = s.view.title,
               .size = 12,
               .color = kSoft,
               .halo = true});
}

}  // namespace

Drawing draw_graph(const InteractionGraph& graph, const GraphPicture& picture) {
    Drawing d =
        make_panel(kFigureWidth, kFigureHeight + kInsetSize + 20, picture.title, picture.notes);
    const Box square = panel_square();
    Bounds bounds;
    for (const GraphNode& n : graph.nodes) bounds.add(n.position);
    for (const GraphEdge& e : graph.edges)
        for (const Vec3& p : e.fixed) bounds.add(p);
    if (bounds.empty()) bounds.add(Vec3::Zero());
    const Scope main = visible_scope(bounds, square, 1.08);
    d.box(square, kWhite, kSoft);
    d.add(Clip{square});
    draw_edges(d, graph, main, picture.parts, 1.0);
    draw_nodes(d, graph, main, picture.parts, 1.0);
    d.add(Clip{});
    draw_scale(d, main);
    draw_insets(d, graph, main, {square.x, square.bottom() + 14, square.width, kInsetSize},
                picture.parts);
    std::vector<Swatch> swatches;
    if (picture.parts) {
        std::int32_t parts = 0;
        for (const GraphNode& n : graph.nodes) parts = std::max(parts, n.part + 1);
        for (std::int32_t p = 0; p < parts; ++p)
            swatches.push_back({"part " + std::to_string(p + 1), part_color(p)});
        swatches.push_back({"cut interaction", kCutColor, true});
        swatches.push_back({"separator", kWhite});
    } else {
        swatches = {{"body", kInk},
                    {"between two bodies", kTwoBodyColor, true},
                    {"between three", kHyperedgeColor, true},
                    {"contact", kContactColor, true},
                    {"to what is fixed", kNoPartColor, true}};
    }
    draw_swatches(d, {square.x, square.bottom() + kInsetSize + 42}, square.width, swatches);
    return d;
}

}  // namespace hawser::draw
