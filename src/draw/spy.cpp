// SPDX-License-Identifier: Apache-2.0
#include "draw/spy.h"

#include "draw/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hawser::draw {

namespace {

enum Kind : std::uint8_t { kEmpty, kFill, kCoupling, kInteraction, kBody, kKinds };

constexpr std::array<Color, kKinds> kColors{{{255, 255, 255, 0},
                                             {232, 150, 160, 255},
                                             {90, 100, 112, 255},
                                             {213, 94, 0, 255},
                                             {0, 114, 178, 255}}};

// Small matrices are drawn scalar by scalar, large ones on a grid of this many cells.
constexpr std::int64_t kGridCells = 640;

// Kind of entry in each cell of a square grid; the most important kind is stored.
class Grid {
  public:
    explicit Grid(std::int64_t scalars)
        : scalars_(std::max<std::int64_t>(1, scalars)), cells_(std::min(scalars_, kGridCells)) {
        kind_.assign(static_cast<std::size_t>(cells_ * cells_), kEmpty);
    }

    void block(std::int64_t row, std::int64_t rows, std::int64_t column, std::int64_t columns,
               Kind kind) {
        for (std::int64_t r = row * cells_ / scalars_; r <= (row + rows - 1) * cells_ / scalars_;
             ++r)
            for (std::int64_t c = column * cells_ / scalars_;
                 c <= (column + columns - 1) * cells_ / scalars_; ++c) {
                Kind& at = kind_[static_cast<std::size_t>(r * cells_ + c)];
                at = std::max(at, kind);
            }
    }

    void draw(Drawing& drawing, const Box& frame) const {
        const double size = frame.width / static_cast<double>(cells_);
        for (int kind = kFill; kind < kKinds; ++kind) {
            Cells cells{.boxes = {}, .fill = kColors[static_cast<std::size_t>(kind)]};
            for (std::int64_t r = 0; r < cells_; ++r) {
                for (std::int64_t c = 0; c < cells_;) {
                    std::int64_t end = c;
                    while (end < cells_ &&
                           kind_[static_cast<std::size_t>(r * cells_ + end)] == kind)
                        ++end;
                    if (end > c)
                        cells.boxes.push_back({frame.x + static_cast<double>(c) * size,
                                               frame.y + static_cast<double>(r) * size,
                                               static_cast<double>(end - c) * size, size});
                    c = std::max(end, c + 1);
                }
            }
            drawing.add(std::move(cells));
        }
    }

  private:
    std::int64_t scalars_, cells_;
    std::vector<Kind> kind_;
};

std::vector<std::int64_t> offsets(const SystemView& view, const std::vector<std::int32_t>& order) {
    std::vector<std::int64_t> out{0};
    for (const std::int32_t node : order)
        out.push_back(out.back() + view.nodes[static_cast<std::size_t>(node)].size);
    return out;
}

Kind diagonal_kind(const SystemNode& node) { return node.body.valid() ? kBody : kInteraction; }

Axes spy_axes(const Box& frame, std::int64_t scalars, std::string title) {
    const auto n = static_cast<double>(std::max<std::int64_t>(1, scalars));
    return {.frame = frame,
            .x = {0.0, n},
            .y = {n, 0.0},
            .x_label = "column [scalar]",
            .y_label = "row [scalar]",
            .title = std::move(title),
            .x_numbers = true,
            .x_ticks = 6,
            .y_ticks = 6};
}

}  // namespace

FactorBlocks factor_blocks(std::span<const std::int32_t> start,
                           std::span<const std::int32_t> adjacent,
                           std::span<const std::int32_t> order, std::int64_t limit) {
    const std::size_t n = order.size();
    std::vector<std::int32_t> position(n, -1);
    for (std::size_t k = 0; k < n; ++k)
        position[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
    std::vector<std::vector<std::int32_t>> children(n);
    std::vector<std::int32_t> seen(n, -1);
    FactorBlocks out;
    out.start.push_back(0);
    for (std::size_t k = 0; k < n; ++k) {
        const auto me = static_cast<std::int32_t>(k);
        std::vector<std::pair<std::int32_t, bool>> rows;
        const auto add = [&](std::int32_t row, bool fill) {
            if (row > me && seen[static_cast<std::size_t>(row)] != me) {
                seen[static_cast<std::size_t>(row)] = me;
                rows.emplace_back(row, fill);
            }
        };
        const auto node = static_cast<std::size_t>(order[k]);
        for (std::int32_t e = start[node]; e < start[node + 1]; ++e)
            add(position[static_cast<std::size_t>(adjacent[static_cast<std::size_t>(e)])], false);
        for (const std::int32_t child : children[k])
            for (std::int64_t e = out.start[static_cast<std::size_t>(child)];
                 e < out.start[static_cast<std::size_t>(child) + 1]; ++e)
                add(out.row[static_cast<std::size_t>(e)], true);
        std::sort(rows.begin(), rows.end());
        for (const auto& [row, fill] : rows) {
            out.row.push_back(row);
            out.fill.push_back(fill);
        }
        out.start.push_back(static_cast<std::int64_t>(out.row.size()));
        if (out.start.back() > limit)
            throw std::runtime_error(
                fmt::format("the factor has more than {} blocks: too many for a picture", limit));
        if (!rows.empty()) children[static_cast<std::size_t>(rows.front().first)].push_back(me);
    }
    return out;
}

FactorBlocks factor_blocks(const SystemView& view, std::int64_t limit) {
    return factor_blocks(view.edge_start, view.edges, view.order, limit);
}

Drawing plot_spy(const SystemView& view, const FactorBlocks& factor, const std::string& title,
                 const std::string& parameters) {
    Drawing drawing{.width = 1400, .height = 830};
    draw_heading(drawing, title, parameters);
    const Box left{90, 112, 580, 580}, right{770, 112, 580, 580};

    std::vector<std::int32_t> natural(view.nodes.size());
    for (std::size_t i = 0; i < natural.size(); ++i) natural[i] = static_cast<std::int32_t>(i);
    const std::vector<std::int64_t> at = offsets(view, natural);
    Grid matrix(at.back());
    for (std::size_t i = 0; i < view.nodes.size(); ++i) {
        const SystemNode& node = view.nodes[i];
        matrix.block(at[i], node.size, at[i], node.size, diagonal_kind(node));
        for (std::int32_t e = view.edge_start[i]; e < view.edge_start[i + 1]; ++e) {
            const auto j = static_cast<std::size_t>(view.edges[static_cast<std::size_t>(e)]);
            matrix.block(at[j], view.nodes[j].size, at[i], node.size, kCoupling);
        }
    }
    const std::vector<std::int64_t> to = offsets(view, view.order);
    Grid lower(to.back());
    for (std::size_t k = 0; k < view.order.size(); ++k) {
        const SystemNode& node = view.nodes[static_cast<std::size_t>(view.order[k])];
        lower.block(to[k], node.size, to[k], node.size, diagonal_kind(node));
        for (std::int64_t e = factor.start[k]; e < factor.start[k + 1]; ++e) {
            const auto r = static_cast<std::size_t>(factor.row[static_cast<std::size_t>(e)]);
            lower.block(to[r], to[r + 1] - to[r], to[k], node.size,
                        factor.fill[static_cast<std::size_t>(e)] ? kFill : kCoupling);
        }
    }
    spy_axes(left, at.back(), "Matrix in the order of the scene").draw(drawing);
    matrix.draw(drawing, left);
    spy_axes(right, to.back(), "Factor in elimination order").draw(drawing);
    lower.draw(drawing, right);

    static constexpr std::array<const char*, kKinds> kNames{
        "", "fill: not in the matrix", "coupling", "kept interaction (negative pivots)",
        "body (positive pivots)"};
    double x = 90;
    for (int kind = kBody; kind >= kFill; --kind) {
        const auto k = static_cast<std::size_t>(kind);
        drawing.box({x, 769, 14, 14}, kColors[k]);
        drawing.text({x + 21, 781}, kNames[k], 13.0);
        x += text_width(kNames[k], 13.0) + 58;
    }
    return drawing;
}

}  // namespace hawser::draw
