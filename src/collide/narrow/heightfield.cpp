// SPDX-License-Identifier: Apache-2.0
// Heights on a grid. Each cell is two triangles, divided from node (i, j) to node (i + 1, j + 1).
// The ground is solid: a shape below the surface, at any depth, is pushed up along the normal of
// the triangle above it. There is no ground beyond the border.
//
// Below a sharp valley the prisms along the normals of its triangles do not cover a wedge. Across a
// sharp ridge the deepest point of a shape for each triangle may lie over another one. In both
// cases no triangle accepts a point. The shape is then pushed along the normal of the nearest
// triangle that is above its middle or intersects it.
#include "collide/bounds.h"
#include "collide/narrow/pairs.h"
#include "collide/narrow/separate.h"
#include "collide/narrow/shape_data.h"
#include "collide/narrow/triangle_contact.h"

#include <hawser/shapes.h>

#include <algorithm>

namespace hawser::collide::narrow {
namespace {

constexpr long kMaxNodes = 16'777'216;
/// Depth of the box of the ground below the lowest node [m].
constexpr double kDepthBelowGround = 100.0;

struct Ground {
    const ShapeData& data;
    V3 centre;  ///< Centre of the shape: origin of the local coordinates.

    V3 node(int i, int j) const {
        return V3{(j - 0.5 * (data.columns - 1)) * data.cell[0],
                  (i - 0.5 * (data.rows - 1)) * data.cell[1],
                  data.heights[static_cast<std::size_t>(i) * data.columns + j]} -
               centre;
    }
    bool has(int i, int j) const { return i >= 0 && j >= 0 && i < data.rows && j < data.columns; }
};

int node_of(const Ground& g, int i, int j) { return i * g.data.columns + j; }

int fan_around_corner(const SurfaceTriangle& t, int corner, V3* out);

/// Return a triangle of cell (i, j) with the third corners of its neighbours.
SurfaceTriangle triangle_of(const Ground& g, int i, int j, bool upper) {
    static constexpr int kTriangleCorners[2][3][2] = {{{0, 0}, {0, 1}, {1, 1}},
                                                      {{0, 0}, {1, 1}, {1, 0}}};
    static constexpr int kOppositeCorners[2][3][2] = {{{-1, 0}, {1, 2}, {1, 0}},
                                                      {{0, 1}, {2, 1}, {0, -1}}};
    const auto& corner = kTriangleCorners[upper];
    SurfaceTriangle out{};
    out.triangle = make_triangle(g.node(i + corner[0][0], j + corner[0][1]),
                                 g.node(i + corner[1][0], j + corner[1][1]),
                                 g.node(i + corner[2][0], j + corner[2][1]));
    for (int k = 0; k < 3; ++k) {
        const int p = i + kOppositeCorners[upper][k][0], q = j + kOppositeCorners[upper][k][1];
        out.has_neighbour[k] = g.has(p, q);
        if (g.has(p, q)) out.opposite[k] = g.node(p, q);
    }
    out.solid = true;
    out.surface = &g;
    out.index = 2 * node_of(g, i, j) + upper;
    out.name = static_cast<std::uint32_t>(out.index);
    out.ring = fan_around_corner;
    return out;
}

int fan_around_corner(const SurfaceTriangle& t, int corner, V3* out) {
    const Ground& g = *static_cast<const Ground*>(t.surface);
    const int node = t.index / 2, upper = t.index % 2;
    const int i = node / g.data.columns + (corner == 0 ? 0 : (corner == 1 ? upper : 1));
    const int j = node % g.data.columns + (corner == 0 ? 0 : (corner == 1 ? 1 : 1 - upper));
    static constexpr int kAdjacentNodes[6][2] = {{0, 1},  {1, 1},   {1, 0},
                                                 {0, -1}, {-1, -1}, {-1, 0}};
    int count = 0;
    for (const auto& d : kAdjacentNodes)
        if (g.has(i + d[0], j + d[1])) out[count++] = g.node(i + d[0], j + d[1]);
    return count;
}

/// Range of cells under a shape, both ends included.
struct Cells {
    int first_i, last_i, first_j, last_j;
};

/// Add the contact of a shape below the surface for which no triangle has a contact (see the head
/// of this file).
void add_ground_contact(const Convex& shape, const Ground& g, const Cells& cells, Points& out) {
    const V3 local = middle_of(shape), middle = local + g.centre;
    const double u = middle.x / g.data.cell[0] + 0.5 * (g.data.columns - 1);
    const double v = middle.y / g.data.cell[1] + 0.5 * (g.data.rows - 1);
    Point found{};
    for (int i = cells.first_i; i <= cells.last_i; ++i)
        for (int j = cells.first_j; j <= cells.last_j; ++j)
            for (const bool upper : {false, true}) {
                const SurfaceTriangle t = triangle_of(g, i, j, upper);
                const Point p = deepest_along_normal(shape, t, t.triangle.face);
                if (p.gap >= 0.0 || (found.gap < 0.0 && p.gap <= found.gap)) continue;
                const bool above = std::floor(v) == i && std::floor(u) == j &&
                                   (v - i > u - j) == upper &&
                                   dot(t.triangle.face, local - t.triangle.corner[0]) < 0.0;
                if (!above && separate(shape, t.triangle, 0.0).s >= shape.rounding) continue;
                found = p;
            }
    if (found.gap < 0.0) out.add(found);
}

}  // namespace

void make_heightfield(const ShapeDef& def, ShapeData& out) {
    const long nodes = static_cast<long>(def.rows) * def.columns;
    if (def.rows < 2 || def.columns < 2)
        throw_shape_error(def, "rows = " + std::to_string(def.rows) +
                                   ", columns = " + std::to_string(def.columns) +
                                   "; a heightfield needs 2 of each or more");
    if (nodes > kMaxNodes)
        throw_shape_error(def, "rows × columns = " + std::to_string(nodes) + "; at most " +
                                   std::to_string(kMaxNodes));
    if (static_cast<long>(def.heights.size()) != nodes)
        throw_shape_error(def, "heights has " + std::to_string(def.heights.size()) +
                                   " entries; rows × columns = " + std::to_string(nodes));
    for (int k = 0; k < 2; ++k)
        if (!(def.cell[k] > 0.0) || !std::isfinite(def.cell[k]))
            throw_shape_error(def, "cell[" + std::to_string(k) +
                                       "] = " + std::to_string(def.cell[k]) + " must be positive");
    for (std::size_t i = 0; i < def.heights.size(); ++i)
        if (!std::isfinite(def.heights[i]))
            throw_shape_error(def, "heights[" + std::to_string(i) + "] is not finite");
    out.rows = def.rows;
    out.columns = def.columns;
    out.cell[0] = def.cell[0];
    out.cell[1] = def.cell[1];
    out.heights = def.heights;
    const auto [low, high] = std::minmax_element(out.heights.begin(), out.heights.end());
    out.high[0] = 0.5 * (out.columns - 1) * out.cell[0];
    out.high[1] = 0.5 * (out.rows - 1) * out.cell[1];
    out.high[2] = *high;
    out.low[0] = -out.high[0];
    out.low[1] = -out.high[1];
    out.low[2] = *low - kDepthBelowGround;
}

HAWSER_PAIR(convex_heightfield) {
    out.count = 0;
    const ShapeData& data = *b.data;
    const Placement local = view_from(pa, pb);
    const Bounds box = bounds(a, local);
    if (box.low[2] >= data.high[2] + margin) return;
    const auto cell = [&](double x, int axis_index, int count) {
        const double i = std::floor(x / data.cell[axis_index] + 0.5 * (count - 1));
        return static_cast<int>(clamp(i, -1.0, static_cast<double>(count - 1)));
    };
    const int first_j = std::max(0, cell(box.low[0] - margin, 0, data.columns));
    const int last_j = std::min(data.columns - 2, cell(box.high[0] + margin, 0, data.columns));
    const int first_i = std::max(0, cell(box.low[1] - margin, 1, data.rows));
    const int last_i = std::min(data.rows - 2, cell(box.high[1] + margin, 1, data.rows));
    const Ground ground{data, generic::load3(local.x)};
    const Convex shape = make_convex(a, local, local.x);
    const double lowest = box.low[2] - margin - local.x[2];
    Points points;
    Point nearest{};  // unused for a solid
    for (int i = first_i; i <= last_i; ++i)
        for (int j = first_j; j <= last_j; ++j) {
            const double top = std::max({ground.node(i, j).z, ground.node(i, j + 1).z,
                                         ground.node(i + 1, j).z, ground.node(i + 1, j + 1).z});
            if (top <= lowest) continue;
            for (const bool upper : {false, true}) {
                reduce_if_full(points, shape);
                touch_triangle(shape, triangle_of(ground, i, j, upper), margin, points, nearest);
            }
        }
    if (none_overlaps(points))
        add_ground_contact(shape, ground, {first_i, last_i, first_j, last_j}, points);
    finish_surface(points, pb, ground.centre, shape, out);
}

}  // namespace hawser::collide::narrow
