// SPDX-License-Identifier: Apache-2.0
#include "draw/solids_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace hawser::draw {
namespace {

/// Compare the depth of two solids by the planes of the first one's faces. @return 1 if the second
/// is nearer, −1 if it is farther, 0 if undecided.
int compare_depth(const Solid& a, const Solid& b, const Camera& camera) {
    const double slack = 1e-6 * (1.0 + std::abs(a.depth) + std::abs(b.depth));
    for (std::size_t f = 0; f < a.normals.size(); ++f) {
        const Vec3& n = a.normals[f];
        const double facing = n.dot(camera.to_viewer);
        if (std::abs(facing) < 1e-9) continue;
        const bool beyond =
            std::all_of(b.surface.points.begin(), b.surface.points.end(),
                        [&](const Vec3& p) { return n.dot(p) >= a.offsets[f] - slack; });
        if (beyond) return facing > 0.0 ? 1 : -1;
    }
    return 0;
}

bool overlap(const Solid& a, const Solid& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

}  // namespace

Camera Camera::at(double azimuth, double elevation) {
    const double a = azimuth * std::numbers::pi / 180.0, e = elevation * std::numbers::pi / 180.0;
    Camera out;
    out.to_viewer = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    out.right = {-std::sin(a), std::cos(a), 0.0};
    out.up = out.to_viewer.cross(out.right);
    return out;
}

Solid make_solid(record::Triangles surface, Color color, const Camera& camera) {
    Solid out;
    out.color = color;
    out.x0 = out.y0 = std::numeric_limits<double>::infinity();
    out.x1 = out.y1 = -out.x0;
    for (const Vec3& p : surface.points) {
        const Point at = camera.flat(p);
        out.x0 = std::min(out.x0, at.x);
        out.x1 = std::max(out.x1, at.x);
        out.y0 = std::min(out.y0, at.y);
        out.y1 = std::max(out.y1, at.y);
        out.depth += p.dot(camera.to_viewer) / static_cast<double>(surface.points.size());
    }
    for (const auto& c : surface.corners) {
        const Vec3& a = surface.points[c[0]];
        Vec3 n = (surface.points[c[1]] - a).cross(surface.points[c[2]] - a);
        if (const double size = n.norm(); size > 0.0) n /= size;
        out.normals.push_back(n);
        out.offsets.push_back(n.dot(a));
    }
    out.surface = std::move(surface);
    return out;
}

/// Sort the solids for painting. Repeatedly choose the farthest solid that no unpainted solid must
/// precede.
std::vector<std::size_t> painting_order(const std::vector<Solid>& solids, const Camera& camera) {
    const std::size_t n = solids.size();
    std::vector<std::vector<std::size_t>> after(n);  // solids to be painted later than each solid
    std::vector<int> before(n, 0);
    // limit for comparing all pairs; larger sets are sorted by depth
    constexpr std::size_t kMaxCompared = 1500;
    for (std::size_t i = 0; n <= kMaxCompared && i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            if (!overlap(solids[i], solids[j])) continue;
            int order = compare_depth(solids[i], solids[j], camera);
            if (order == 0) order = -compare_depth(solids[j], solids[i], camera);
            if (order == 0) continue;
            const auto [first, second] = order > 0 ? std::pair(i, j) : std::pair(j, i);
            after[first].push_back(second);
            ++before[second];
        }
    std::vector<std::size_t> out;
    std::vector<bool> done(n, false);
    while (out.size() < n) {
        std::size_t best = n;
        bool free = false;
        for (std::size_t i = 0; i < n; ++i) {
            if (done[i]) continue;
            const bool open = before[i] == 0;
            if (best == n || (open && !free) ||
                (open == free && solids[i].depth < solids[best].depth)) {
                best = i;
                free = open;
            }
        }
        done[best] = true;
        out.push_back(best);
        for (const std::size_t next : after[best]) --before[next];
    }
    return out;
}

bool is_hidden(const Vec3& p, const std::vector<Solid>& solids, const Camera& camera) {
    const Point at = camera.flat(p);
    for (const Solid& s : solids) {
        if (at.x < s.x0 || at.x > s.x1 || at.y < s.y0 || at.y > s.y1) continue;
        // A point on a surface is not hidden by it.
        const double least = 1e-3 * (s.x1 - s.x0 + s.y1 - s.y0);
        double enter = 0.0, leave = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < s.normals.size() && enter < leave; ++f) {
            const double rate = s.normals[f].dot(camera.to_viewer);
            const double room = s.offsets[f] - s.normals[f].dot(p);
            if (rate > 1e-12)
                leave = std::min(leave, room / rate);
            else if (rate < -1e-12)
                enter = std::max(enter, room / rate);
            else if (room < 0.0)
                leave = -1.0;
        }
        if (leave - enter > least) return true;
    }
    return false;
}

std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, double level, bool above) {
    std::vector<Vec3> out;
    const double sign = above ? 1.0 : -1.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a.z() - level), db = sign * (b.z() - level);
        if (da >= 0.0) out.push_back(a);
        if ((da < 0.0) != (db < 0.0)) out.push_back(a + da / (da - db) * (b - a));
    }
    if (out.size() < 3) out.clear();
    return out;
}

std::vector<Crease> visible_creases(const Solid& solid, const Camera& camera) {
    constexpr double kMinSmoothCosine =
        0.94;  // cosine of 20 degrees: limit for facets of a round surface
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> sides;
    for (std::size_t f = 0; f < solid.surface.corners.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = solid.surface.corners[f][k],
                                b = solid.surface.corners[f][(k + 1) % 3];
            sides[std::minmax(a, b)].push_back(f);
        }
    std::vector<Crease> out;
    for (const auto& [edge, faces] : sides) {
        if (faces.size() != 2) continue;
        const bool faces_viewer[2] = {solid.normals[faces[0]].dot(camera.to_viewer) > 1e-9,
                                      solid.normals[faces[1]].dot(camera.to_viewer) > 1e-9};
        const bool rim = faces_viewer[0] != faces_viewer[1];
        const bool sharp = solid.normals[faces[0]].dot(solid.normals[faces[1]]) < kMinSmoothCosine;
        if (rim || (sharp && faces_viewer[0]))
            out.push_back({solid.surface.points[edge.first], solid.surface.points[edge.second]});
    }
    return out;
}

}  // namespace hawser::draw
