// SPDX-License-Identifier: Apache-2.0
/// Divide the volume of a hull into cells: vertical lines on an even grid, cut at the mesh.
#include <hawser/hull.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kCellsAlongBox =
    200.0;                     ///< Number of cells along the longest side of the mesh's box.
constexpr int kMaxAlong = 64;  ///< Cells along an axis.

/// List the heights at which the vertical line through (x, y) crosses the mesh, ascending.
void crossings(const HullMesh& mesh, double x, double y, std::vector<double>& out) {
    out.clear();
    for (const auto& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
        const Vec3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
        const Vec3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
        const auto side = [&](const Vec3& p, const Vec3& q) {
            return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
        };
        const double u = side(b, c), v = side(c, a), w = side(a, b), sum = u + v + w;
        if (sum == 0.0 || (sum > 0.0 ? std::min({u, v, w}) < 0.0 : std::max({u, v, w}) > 0.0))
            continue;
        out.push_back((u * a.z() + v * b.z() + w * c.z()) / sum);
    }
    std::sort(out.begin(), out.end());
}

}  // namespace

std::vector<HullCell> hull_cells(const HullMesh& mesh) {
    std::vector<HullCell> cells;
    if (mesh.vertices.empty()) return cells;
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& v : mesh.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    const Vec3 box = high - low;
    const double edge = std::cbrt(std::max(box.prod(), 0.0) / kCellsAlongBox);
    std::array<int, 3> count{};
    Vec3 size = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double n = edge > 0.0 ? std::round(box[k] / edge) : 1.0;
        count[static_cast<std::size_t>(k)] = std::clamp(static_cast<int>(n), 1, kMaxAlong);
        size[k] = box[k] / count[static_cast<std::size_t>(k)];
    }
    std::vector<double> at;
    for (int i = 0; i < count[0]; ++i)
        for (int j = 0; j < count[1]; ++j) {
            const double x = low.x() + (i + 0.5) * size.x(), y = low.y() + (j + 0.5) * size.y();
            // A little off the middle, where meshes often have edges.
            crossings(mesh, x + 1.37e-4 * size.x(), y + 0.79e-4 * size.y(), at);
            for (std::size_t c = 0; c + 1 < at.size(); c += 2)
                for (int k = 0; k < count[2]; ++k) {
                    const double bottom = std::max(at[c], low.z() + k * size.z());
                    const double top = std::min(at[c + 1], low.z() + (k + 1) * size.z());
                    if (!(top > bottom)) continue;
                    cells.push_back({{x, y, 0.5 * (bottom + top)},
                                     {size.x(), size.y(), top - bottom},
                                     {i, j, k}});
                }
        }
    if (cells.empty()) cells.push_back({0.5 * (low + high), box, {0, 0, 0}});
    return cells;
}

}  // namespace hawser
