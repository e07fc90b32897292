// SPDX-License-Identifier: Apache-2.0
/// Float hulls: sinkage and trim by Newton's method, and decks for meshes that end at the
/// waterline.
#include <hawser/def.h>
#include <hawser/hull.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace hawser {
namespace {

/// Find the draught at which a hull of given orientation displaces the volume `wanted`. @return
/// true if the hull floats.
bool find_sinkage(const HullMesh& mesh, double wanted, Flotation& out) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& v : mesh.vertices) {
        const double z = (out.pose.orientation * v).z();
        low = std::min(low, z);
        high = std::max(high, z);
    }
    // The volume grows from 0 to its total as the origin sinks from −low to −high. Use Newton's
    // method, and bisection if an iterate leaves the bracket.
    double above = -low, below = -high, z = 0.5 * (above + below);
    const auto volume = [&](double at) {
        out.pose.position = {0.0, 0.0, at};
        out.statics = hull_statics(mesh, out.pose);
        return out.statics.volume;
    };
    if (!(volume(below) > wanted)) return false;
    for (int i = 0; i < 200; ++i) {
        const double excess = volume(z) - wanted;
        (excess > 0.0 ? below : above) = z;
        const double change = out.statics.plane_area > 0.0 ? excess / out.statics.plane_area : 0.0;
        double next = z + change;
        if (!(next > below && next < above)) next = 0.5 * (above + below);
        if (std::abs(next - z) <= 1e-15 * (high - low) || next == z) break;
        z = next;
    }
    return true;
}

Quat heeled(double heel) { return Quat(std::cos(0.5 * heel), std::sin(0.5 * heel), 0.0, 0.0); }
Quat trimmed(double trim) { return Quat(std::cos(0.5 * trim), 0.0, std::sin(0.5 * trim), 0.0); }

/// Return the edges that belong to one triangle only, from their first to their second vertex.
std::map<std::int32_t, std::int32_t> open_edges(const HullMesh& mesh) {
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    std::map<std::int32_t, std::int32_t> open;
    for (const auto& [edge, count] : edges)
        if (edges.find({edge.second, edge.first}) == edges.end())
            if (!open.emplace(edge.first, edge.second).second)
                throw DefError("close_hull: two open edges leave vertex " +
                               std::to_string(edge.first) + "; corners there do not match");
    return open;
}

}  // namespace

Flotation float_hull(const HullMesh& mesh, double mass, double density, double heel, bool trims) {
    Flotation out;
    const double required_volume = mass / density;
    out.pose.orientation = heeled(heel);
    out.floats = find_sinkage(mesh, required_volume, out);
    if (!out.floats) return out;
    // If B is forward of G, the bow rises by the lever over the longitudinal metacentric height.
    for (int i = 0; trims && i < 60; ++i) {
        const HullStatics& s = out.statics;
        const double lever = s.buoyancy.x();
        const double height = s.inertia_y / s.volume + s.buoyancy.z() - out.pose.position.z();
        if (std::abs(lever) <= 1e-13 * std::cbrt(s.volume) || !(height > 0.0)) break;
        out.trim -= std::clamp(lever / height, -0.1, 0.1);
        out.pose.orientation = heeled(heel) * trimmed(out.trim);
        out.floats = find_sinkage(mesh, required_volume, out);
        if (!out.floats) return out;
    }
    const HullStatics& s = out.statics;
    out.draught = -s.lowest;
    out.kb = s.buoyancy.z() - s.lowest;
    out.bm = s.inertia_x / s.volume;
    out.bm_long = s.inertia_y / s.volume;
    out.kg = out.pose.position.z() - s.lowest;
    out.gm = out.kb + out.bm - out.kg;
    return out;
}

double righting_lever(const HullMesh& mesh, double mass, double density, double heel, bool trims) {
    const Flotation at = float_hull(mesh, mass, density, heel, trims);
    return at.floats ? -at.statics.buoyancy.y() : 0.0;
}

void close_hull(HullMesh& mesh, double top) {
    auto open = open_edges(mesh);
    if (open.empty()) return;
    double edge = -std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : open)
        edge = std::max(edge, mesh.vertices[static_cast<std::size_t>(a)].z());
    for (const auto& [a, b] : open) {
        const Vec3& x = mesh.vertices[static_cast<std::size_t>(a)];
        if (edge - x.z() > 1e-3)
            throw DefError("close_hull: the mesh is open at (" + std::to_string(x.x()) + ", " +
                           std::to_string(x.y()) + ", " + std::to_string(x.z()) +
                           "), below its waterline at z = " + std::to_string(edge));
    }
    if (!(top >= edge))
        throw DefError("close_hull: a deck at " + std::to_string(top) +
                       " m lies below the open edge at " + std::to_string(edge) + " m");
    const bool walls = top > edge;
    while (!open.empty()) {
        std::vector<std::int32_t> loop;
        const std::int32_t start = open.begin()->first;
        for (std::int32_t at = start;;) {
            const auto next = open.find(at);
            if (next == open.end()) throw DefError("close_hull: an open edge leads nowhere");
            loop.push_back(at);
            at = next->second;
            open.erase(next);
            if (at == start) break;
        }
        const auto place = [&](std::int32_t i) {
            return mesh.vertices[static_cast<std::size_t>(i)];
        };
        const auto add = [&](const Vec3& x) {
            mesh.vertices.push_back(x);
            return static_cast<std::int32_t>(mesh.vertices.size()) - 1;
        };
        std::vector<std::int32_t> deck = loop;
        Vec3 middle = Vec3::Zero();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            Vec3 x = place(loop[i]);
            middle += x / static_cast<double>(loop.size());
            x.z() = top;
            if (walls) deck[i] = add(x);
        }
        middle.z() = walls ? top : edge;
        const std::int32_t centre = add(middle);
        // The triangle has the edge in this direction. The closing triangle needs the opposite one.
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::size_t j = (i + 1) % loop.size();
            if (walls) {
                mesh.triangles.push_back({loop[j], loop[i], deck[i]});
                mesh.triangles.push_back({loop[j], deck[i], deck[j]});
            }
            mesh.triangles.push_back({deck[j], deck[i], centre});
        }
    }
}

}  // namespace hawser
