// SPDX-License-Identifier: Apache-2.0
// Convex hull of points, with flat faces of any number of corners.
//
// First step: triangles by Quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, ACM TOMS 22, 1996).
// The furthest outside point replaces the patch of triangles that face it. Points nearer than 1e-9
// of the size count as inside. Second step: coplanar triangles, to 1e-8 of the size, are merged
// into one face.
#include "collide/narrow/convex.h"
#include "collide/narrow/shape_data.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace hawser::collide::narrow {
namespace {

constexpr std::size_t kMaxInput = 65'536, kMaxHull = 4'096;

struct Triangle {
    std::array<int, 3> v;
    V3 n;
    double d;
    std::vector<int> outside;  ///< Points above this triangle and above no earlier one.
    bool is_alive = true;
};

class Builder {
  public:
    Builder(const ShapeDef& def, std::vector<V3> points) : def_(def), p_(std::move(points)) {}

    void triangles() {
        start();
        for (std::size_t f = 0; f < faces_.size(); ++f)
            while (faces_[f].is_alive && !faces_[f].outside.empty()) expand(f);
        std::erase_if(faces_, [](const Triangle& t) { return !t.is_alive; });
    }
    void merge(ShapeData& out);

  private:
    double height_above(const Triangle& t, int i) const { return dot(t.n, p_[i]) - t.d; }
    bool add(int i, int j, int k) {
        const V3 n = cross(p_[j] - p_[i], p_[k] - p_[i]);
        const double length = norm(n);
        if (!(length > 0.0)) return false;
        Triangle t{{i, j, k}, (1.0 / length) * n, 0.0, {}};
        t.d = dot(t.n, (1.0 / 3.0) * (p_[i] + p_[j] + p_[k]));
        faces_.push_back(std::move(t));
        return true;
    }
    /// Assign each point to the first triangle from `first` on that it is above.
    void assign_points(const std::vector<int>& points, std::size_t first) {
        for (const int i : points)
            for (std::size_t f = first; f < faces_.size(); ++f)
                if (height_above(faces_[f], i) > tolerance_) {
                    faces_[f].outside.push_back(i);
                    break;
                }
    }
    void start();
    void expand(std::size_t seed);

    const ShapeDef& def_;
    std::vector<V3> p_;
    std::vector<Triangle> faces_;
    double size_ = 0.0, tolerance_ = 0.0;
};

void Builder::start() {
    const int count = static_cast<int>(p_.size());
    const auto furthest = [&](auto&& measure) {
        int best = 0;
        for (int i = 1; i < count; ++i)
            if (measure(p_[i]) > measure(p_[best])) best = i;
        return best;
    };
    const V3 o = p_[0];
    const int a = furthest([&](const V3& q) { return norm(q - o); });
    const int b = furthest([&](const V3& q) { return norm(q - p_[a]); });
    size_ = norm(p_[b] - p_[a]);
    tolerance_ = 1e-9 * size_;
    const char* const flat = "vertices lie in one plane; a hull needs four that do not";
    if (!(size_ > 0.0)) throw_shape_error(def_, flat);
    const V3 u = normalized(p_[b] - p_[a]);
    const int c = furthest([&](const V3& q) { return norm(cross(q - p_[a], u)); });
    if (norm(cross(p_[c] - p_[a], u)) < 1e-6 * size_) throw_shape_error(def_, flat);
    const V3 n = normalized(cross(p_[b] - p_[a], p_[c] - p_[a]));
    const int d = furthest([&](const V3& q) { return std::fabs(dot(q - p_[a], n)); });
    const double height = dot(p_[d] - p_[a], n);
    if (std::fabs(height) < 1e-6 * size_) throw_shape_error(def_, flat);
    const int x = height > 0.0 ? c : b, y = height > 0.0 ? b : c;
    add(a, x, y);
    add(a, y, d);
    add(y, x, d);
    add(x, a, d);
    std::vector<int> all(p_.size());
    for (int i = 0; i < count; ++i) all[i] = i;
    assign_points(all, 0);
}

void Builder::expand(std::size_t seed) {
    int apex = faces_[seed].outside[0];
    for (const int i : faces_[seed].outside)
        if (height_above(faces_[seed], i) > height_above(faces_[seed], apex)) apex = i;
    // Grow the patch below the apex from the seed over shared edges.
    std::map<std::pair<int, int>, int> rim;
    std::vector<int> loose;
    const auto remove = [&](Triangle& t) {
        t.is_alive = false;
        loose.insert(loose.end(), t.outside.begin(), t.outside.end());
        t.outside.clear();
        for (int k = 0; k < 3; ++k) {
            const int i = t.v[k], j = t.v[(k + 1) % 3];
            if (rim.erase({j, i}) == 0) rim[{i, j}] = 1;
        }
    };
    remove(faces_[seed]);
    for (bool grown = true; grown;) {
        grown = false;
        for (Triangle& t : faces_) {
            if (!t.is_alive || height_above(t, apex) <= 1e-3 * tolerance_) continue;
            for (int k = 0; k < 3 && t.is_alive; ++k)
                if (rim.contains({t.v[(k + 1) % 3], t.v[k]})) remove(t), grown = true;
        }
    }
    const std::size_t first = faces_.size();
    for (const auto& [edge, one] : rim)
        if (!add(edge.first, edge.second, apex))
            throw_shape_error(def_, "vertices are too close to each other for a hull");
    std::erase(loose, apex);
    assign_points(loose, first);
}

/// Merge coplanar triangles into faces, largest triangles first.
void Builder::merge(ShapeData& out) {
    std::map<std::pair<int, int>, int> owner;
    const int count = static_cast<int>(faces_.size());
    std::vector<int> order(faces_.size()), group(faces_.size(), -1);
    std::vector<double> area(faces_.size());
    for (int f = 0; f < count; ++f) {
        const auto& v = faces_[f].v;
        order[f] = f;
        area[f] = norm(cross(p_[v[1]] - p_[v[0]], p_[v[2]] - p_[v[0]]));
        for (int k = 0; k < 3; ++k) owner[{v[k], v[(k + 1) % 3]}] = f;
    }
    std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return area[f] > area[g]; });
    std::vector<int> name(p_.size(), -1);
    const auto vertex = [&](int i) {
        if (name[i] < 0) {
            name[i] = static_cast<int>(out.vertices.size());
            out.vertices.push_back(p_[i]);
        }
        return name[i];
    };
    for (const int seed : order) {
        if (group[seed] >= 0) continue;
        std::vector<int> members{seed};
        group[seed] = seed;
        std::map<int, int> next;
        for (std::size_t m = 0; m < members.size(); ++m) {
            const auto& v = faces_[members[m]].v;
            for (int k = 0; k < 3; ++k) {
                const int g = owner.at({v[(k + 1) % 3], v[k]});
                if (group[g] >= 0) continue;
                bool flat = dot(faces_[g].n, faces_[seed].n) > 0.99;
                for (const int i : faces_[g].v)
                    flat = flat && std::fabs(height_above(faces_[seed], i)) < 10.0 * tolerance_;
                if (flat) group[g] = seed, members.push_back(g);
            }
        }
        for (const int f : members)
            for (int k = 0; k < 3; ++k) {
                const int i = faces_[f].v[k], j = faces_[f].v[(k + 1) % 3];
                if (group[owner.at({j, i})] != seed) next[i] = j;
            }
        HullFace face{static_cast<int>(out.loop.size()), 0, faces_[seed].n, faces_[seed].d};
        const int first = next.begin()->first;
        int i = first;
        do {
            out.loop.push_back(vertex(i));
            ++face.count;
            i = next.at(i);
        } while (i != first && face.count <= count + 3);
        out.faces.push_back(face);
    }
}

/// Find the edges between faces, and the edges of each vertex.
void link(const ShapeDef& def, ShapeData& out) {
    std::map<std::pair<int, int>, int> known;
    out.loop_edge.assign(out.loop.size(), 0);
    for (int f = 0; f < static_cast<int>(out.faces.size()); ++f) {
        const HullFace& face = out.faces[f];
        for (int k = 0; k < face.count; ++k) {
            const int i = out.loop[face.first + k], j = out.loop[face.first + (k + 1) % face.count];
            const auto [it, fresh] =
                known.try_emplace(std::minmax(i, j), static_cast<int>(out.edges.size()));
            if (fresh)
                out.edges.push_back({{i, j}, {f, f}});
            else
                out.edges[it->second].face[1] = f;
            out.loop_edge[face.first + k] = it->second;
        }
    }
    const std::size_t v = out.vertices.size(), e = out.edges.size(), f = out.faces.size();
    if (v + f != e + 2) throw_shape_error(def, "vertices are too close to each other for a hull");
    out.star.assign(v + 1, 0);
    for (const HullEdge& edge : out.edges)
        for (const int i : edge.vertex) ++out.star[i + 1];
    for (std::size_t i = 0; i < v; ++i) out.star[i + 1] += out.star[i];
    out.star_edge.assign(2 * e, 0);
    std::vector<int> fill(out.star.begin(), out.star.end());
    for (std::size_t i = 0; i < e; ++i)
        for (const int w : out.edges[i].vertex) out.star_edge[fill[w]++] = static_cast<int>(i);
}

}  // namespace

void make_hull(const ShapeDef& def, ShapeData& out) {
    if (def.vertices.size() < 4)
        throw_shape_error(def, "vertices has " + std::to_string(def.vertices.size()) +
                                   " points; a hull needs four that do not lie in one plane");
    if (def.vertices.size() > kMaxInput)
        throw_shape_error(def, "vertices has " + std::to_string(def.vertices.size()) +
                                   " points; at most " + std::to_string(kMaxInput));
    std::vector<V3> points;
    for (const Vec3& v : def.vertices) points.push_back({v.x(), v.y(), v.z()});
    Builder builder(def, std::move(points));
    builder.triangles();
    builder.merge(out);
    if (out.vertices.size() > kMaxHull)
        throw_shape_error(def, "vertices has " + std::to_string(out.vertices.size()) +
                                   " points on its hull; at most " + std::to_string(kMaxHull));
    link(def, out);
    for (const V3& v : out.vertices) out.middle = out.middle + v;
    out.middle = (1.0 / static_cast<double>(out.vertices.size())) * out.middle;
}

}  // namespace hawser::collide::narrow
