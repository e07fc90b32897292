// SPDX-License-Identifier: Apache-2.0
#include "draw/figures/matrix.h"

#include "draw/axes.h"
#include "draw/figures/index.h"
#include "draw/figures/panel.h"

#include <algorithm>
#include <array>

namespace hawser::draw {
namespace {

// If a cell of the picture holds several kinds, the last one in this order is drawn.
enum class Cell : std::uint8_t { empty, fill, coupling, rows, body };
using Palette = std::array<Color, 5>;

constexpr Palette kPlainPalette{{{255, 255, 255, 0},
                                 {250, 178, 130, 255},
                                 {28, 40, 66, 255},
                                 {28, 40, 66, 255},
                                 {28, 40, 66, 255}}};
constexpr Palette kShadedPalette{{{255, 255, 255, 0},
                                  {250, 178, 130, 255},
                                  {28, 40, 66, 255},
                                  {213, 94, 0, 255},
                                  {0, 114, 178, 255}}};

constexpr Color color(const Palette& palette, Cell cell) {
    return palette[at(static_cast<int>(cell))];
}

/// Square of cells, each for one or more scalars.
class Cellular {
  public:
    explicit Cellular(std::int64_t scalars)
        : scalars_(std::max<std::int64_t>(1, scalars)),
          cells_(std::min<std::int64_t>(scalars_, 584)),
          kind_(at(cells_ * cells_), Cell::empty) {}

    void block(std::int64_t row, std::int64_t rows, std::int64_t column, std::int64_t columns,
               Cell kind) {
        const std::int64_t r1 = (row + rows - 1) * cells_ / scalars_;
        const std::int64_t c1 = (column + columns - 1) * cells_ / scalars_;
        for (std::int64_t r = row * cells_ / scalars_; r <= r1; ++r)
            for (std::int64_t c = column * cells_ / scalars_; c <= c1; ++c)
                for (Cell* k : {&kind_[at(r * cells_ + c)], &kind_[at(c * cells_ + r)]})
                    *k = std::max(*k, kind);
    }

    void draw(Drawing& drawing, const Box& frame, const Palette& colors) const {
        const double size = frame.width / static_cast<double>(cells_);
        for (const Cell kind : {Cell::fill, Cell::coupling, Cell::rows, Cell::body}) {
            Cells out{.boxes = {}, .fill = color(colors, kind)};
            for (std::int64_t r = 0; r < cells_; ++r)
                for (std::int64_t c = 0, end = 0; c < cells_; c = std::max(end, c + 1)) {
                    for (end = c; end < cells_ && kind_[at(r * cells_ + end)] == kind;) ++end;
                    if (end > c)
                        out.boxes.push_back({frame.x + static_cast<double>(c) * size,
                                             frame.y + static_cast<double>(r) * size,
                                             static_cast<double>(end - c) * size, size});
                }
            drawing.add(std::move(out));
        }
    }

  private:
    std::int64_t scalars_, cells_;
    std::vector<Cell> kind_;
};

void frame_parts(Drawing& drawing, const Box& square, const BlockGraph& graph,
                 std::span<const std::int32_t> order, const std::vector<std::int64_t>& offset) {
    const double scale =
        square.width / static_cast<double>(std::max<std::int64_t>(1, offset.back()));
    for (std::size_t k = 0; k < order.size();) {
        const std::int32_t part = graph.part[at(order[k])];
        std::size_t end = k + 1;
        while (end < order.size() && graph.part[at(order[end])] == part) ++end;
        // A frame around a few scalars would hide them.
        const double from = scale * static_cast<double>(offset[k]);
        const double size = scale * static_cast<double>(offset[end]) - from;
        if (part >= 0 && size > 8.0)
            drawing.box({square.x + from, square.y + from, size, size},
                        part_color(part).with_alpha(26), part_color(part), 1.8);
        k = end;
    }
}

}  // namespace

Color part_color(std::int32_t part) { return curve_color(at(std::max(0, part))); }

Drawing draw_matrix(const BlockGraph& graph, std::span<const std::int32_t> order,
                    const FactorBlocks& factor, const MatrixPicture& picture) {
    Drawing drawing = make_panel(kFigureWidth, kFigureHeight, picture.title, picture.notes);
    const Box square = panel_square();
    std::vector<std::int64_t> offset{0};
    std::vector<std::int32_t> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        offset.push_back(offset.back() + graph.size[at(order[k])]);
        position[at(order[k])] = static_cast<std::int32_t>(k);
    }
    Cellular cells(offset.back());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::int32_t node = order[k];
        const std::int64_t size = graph.size[at(node)];
        cells.block(offset[k], size, offset[k], size,
                    graph.sign[at(node)] > 0 ? Cell::body : Cell::rows);
        if (picture.fill)
            for (std::int64_t e = factor.start[k]; e < factor.start[k + 1]; ++e)
                if (factor.fill[at(e)]) {
                    const std::size_t r = at(factor.row[at(e)]);
                    cells.block(offset[r], offset[r + 1] - offset[r], offset[k], size, Cell::fill);
                }
        for (const std::int32_t other : graph.neighbours(node)) {
            const std::size_t r = at(position[at(other)]);
            if (r > k)
                cells.block(offset[r], offset[r + 1] - offset[r], offset[k], size, Cell::coupling);
        }
    }
    if (!graph.part.empty()) frame_parts(drawing, square, graph, order, offset);
    cells.draw(drawing, square, picture.fill ? kPlainPalette : kShadedPalette);
    drawing.box(square, kNoColor, kSoft);
    const Point legend{square.x, square.bottom() + 28};
    if (picture.fill)
        draw_swatches(drawing, legend, square.width,
                      {{"matrix K", color(kPlainPalette, Cell::body)},
                       {"fill of its factor", color(kPlainPalette, Cell::fill)}});
    else
        draw_swatches(drawing, legend, square.width,
                      {{"bodies: mass", color(kShadedPalette, Cell::body)},
                       {"interactions: rows", color(kShadedPalette, Cell::rows)},
                       {"Jacobian and stiffness", color(kShadedPalette, Cell::coupling)}});
    return drawing;
}

}  // namespace hawser::draw
