// SPDX-License-Identifier: Apache-2.0
#include "record/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hawser::record {
namespace {

constexpr double kMinRelativeEdge =
    1e-9;  ///< Relative to the extent: limit of a zero volume, and of a point in a face.
constexpr std::size_t kMaxSolidPoints =
    1024;  ///< Limit of points, because the cost of a point grows with the number of faces.
constexpr std::size_t kFewPoints = 24;  ///< Limit of points for balls of 42 corners each.

using Corner = std::array<std::uint32_t, 3>;

struct Face {
    Corner corner;
    Vec3 normal;  ///< Unit vector, outwards.
    double offset = 0.0;
    bool is_removed = false;
};

/// Builds the surface around points.
class Hull {
  public:
    explicit Hull(std::span<const Vec3> points) : p_(points) {}

    bool start() {
        Vec3 low = p_[0], high = p_[0];
        for (const Vec3& q : p_) {
            low = low.cwiseMin(q);
            high = high.cwiseMax(q);
        }
        extent_ = (high - low).norm();
        if (!(extent_ > 0.0) || !std::isfinite(extent_)) return false;
        const auto farthest = [&](const auto& distance) {
            std::uint32_t best = 0;
            double most = -1.0;
            for (std::uint32_t i = 0; i < p_.size(); ++i)
                if (const double d = distance(p_[i]); d > most) {
                    most = d;
                    best = i;
                }
            return std::pair(best, most);
        };
        const std::uint32_t a = farthest([&](const Vec3& q) { return (q - p_[0]).norm(); }).first;
        const auto [b, ab] = farthest([&](const Vec3& q) { return (q - p_[a]).norm(); });
        if (ab <= kMinRelativeEdge * extent_) return false;
        const Vec3 along = (p_[b] - p_[a]).normalized();
        const auto [c, off] =
            farthest([&](const Vec3& q) { return along.cross(q - p_[a]).norm(); });
        if (off <= kMinRelativeEdge * extent_) return false;
        const Vec3 normal = along.cross(p_[c] - p_[a]).normalized();
        const auto [d, high_off] =
            farthest([&](const Vec3& q) { return std::abs(normal.dot(q - p_[a])); });
        if (high_off <= kMinRelativeEdge * extent_) return false;
        inside_ = 0.25 * (p_[a] + p_[b] + p_[c] + p_[d]);
        for (const Corner& f : {Corner{a, b, c}, Corner{a, b, d}, Corner{a, c, d}, Corner{b, c, d}})
            add(f);
        return true;
    }

    void enclose_point(std::uint32_t point) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> seen_edges;
        bool removes_face = false;
        for (Face& face : faces_) {
            if (face.normal.dot(p_[point]) - face.offset <= kMinRelativeEdge * extent_) continue;
            face.is_removed = removes_face = true;
            for (std::size_t k = 0; k < 3; ++k)
                seen_edges[{face.corner[k], face.corner[(k + 1) % 3]}] = 1;
        }
        if (!removes_face) return;
        std::erase_if(faces_, [](const Face& f) { return f.is_removed; });
        for (const auto& [edge, one] : seen_edges)
            if (!seen_edges.contains({edge.second, edge.first}))
                add({edge.first, edge.second, point});
    }

    [[nodiscard]] Triangles result() const {
        Triangles out;
        std::map<std::uint32_t, std::uint32_t> place;
        for (const Face& face : faces_) {
            Corner corner{};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [at, fresh] = place.try_emplace(
                    face.corner[k], static_cast<std::uint32_t>(out.points.size()));
                if (fresh) out.points.push_back(p_[face.corner[k]]);
                corner[k] = at->second;
            }
            out.corners.push_back(corner);
        }
        return out;
    }

  private:
    void add(Corner c) {
        Vec3 normal = (p_[c[1]] - p_[c[0]]).cross(p_[c[2]] - p_[c[0]]);
        const double size = normal.norm();
        if (size > 0.0) normal /= size;
        if (normal.dot(inside_ - p_[c[0]]) > 0.0) {
            std::swap(c[1], c[2]);
            normal = -normal;
        }
        faces_.push_back({c, normal, normal.dot(p_[c[0]])});
    }

    std::span<const Vec3> p_;
    double extent_ = 0.0;
    Vec3 inside_ = Vec3::Zero();
    std::vector<Face> faces_;
};

/// Return 42 points on the unit sphere: the corners of an icosahedron and the middles of its edges.
std::vector<Vec3> ball_corners() {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<Vec3> out;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-g, g}) {
            out.emplace_back(Vec3(0, s, t).normalized());
            out.emplace_back(Vec3(s, t, 0).normalized());
            out.emplace_back(Vec3(t, 0, s).normalized());
        }
    const double edge = 2.0 / std::hypot(1.0, g);
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = i + 1; j < 12; ++j)
            if ((out[i] - out[j]).norm() < 1.01 * edge)
                out.push_back((out[i] + out[j]).normalized());
    return out;
}

}  // namespace

Triangles convex_surface(std::span<const Vec3> points) {
    if (points.size() < 4) return {};
    Hull hull(points);
    if (!hull.start()) return {};
    for (std::uint32_t i = 0; i < points.size(); ++i) hull.enclose_point(i);
    return hull.result();
}

Triangles box_surface(const Vec3& half_size) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(half_size.x() * ((i & 1) != 0 ? 1 : -1),
                             half_size.y() * ((i & 2) != 0 ? 1 : -1),
                             half_size.z() * ((i & 4) != 0 ? 1 : -1));
    return convex_surface(corners);
}

Triangles outline_surface(const RecordedOutline& outline) {
    if (outline.kind != OutlineKind::solid) return {};
    const std::size_t every = 1 + outline.points.size() / kMaxSolidPoints;
    std::vector<Vec3> all;
    static const std::vector<Vec3> kBall = ball_corners();
    for (std::size_t i = 0; i < outline.points.size(); i += every) {
        const Vec3& p = outline.points[i];
        if (outline.radius <= 0.0) {
            all.push_back(p);
        } else if (outline.points.size() <= kFewPoints) {
            for (const Vec3& d : kBall) all.push_back(p + outline.radius * d);
        } else if (all.size() + 6 <= kMaxSolidPoints) {
            for (int k = 0; k < 3; ++k)
                for (const double s : {-1.0, 1.0})
                    all.push_back(p + s * outline.radius * Vec3::Unit(k));
        }
    }
    return convex_surface(all);
}

std::vector<Triangles> body_surfaces(const Recording& recording, std::size_t body) {
    std::vector<Triangles> out;
    const RecordedBody& b = recording.bodies[body];
    if (b.kind == BodyKind::scalar) return out;
    for (const RecordedOutline& o : recording.outlines) {
        if (static_cast<std::size_t>(o.body) != body) continue;
        if (Triangles t = outline_surface(o); !t.empty()) out.push_back(std::move(t));
    }
    // A hull in the water usually has contact shapes for small parts only: add its box.
    if (b.half_size.minCoeff() > 0.0) {
        Vec3 reach = Vec3::Zero();
        for (const Triangles& t : out)
            for (const Vec3& p : t.points) reach = reach.cwiseMax(p.cwiseAbs());
        if ((reach.array() < 0.9 * b.half_size.array()).any())
            out.push_back(box_surface(b.half_size));
    }
    return out;
}

}  // namespace hawser::record
