// SPDX-License-Identifier: Apache-2.0
#include <hawser/world.h>

#include "base/index.h"
#include "marine/hull_kernels.h"
#include "marine/sea_system.h"
#include "marine/spectra.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace hawser::marine {
namespace {

int chunks_of(std::size_t count) noexcept {
    return (static_cast<int>(count) + HullWater::kChunk - 1) / HullWater::kChunk;
}

/// Add Σ c_k a_k a_kᵀ to the triangle `to` at rows from `first` on.
void add_axes(const Mat3& axes, const double* c, int first, std::array<double, 21>& to) noexcept {
    Sym3 sum;
    for (int k = 0; k < 3; ++k) sum.add(c[k], axes.col(k));
    for (int i = 0, n = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j, ++n)
            to[static_cast<std::size_t>(triangle(first + i, first + j))] += sum.m[n];
}

double volume_of(const HullMesh& mesh) noexcept {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const auto at = [&](int k) -> const Vec3& {
            return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
        };
        sum += at(0).dot(at(1).cross(at(2))) / 6.0;
    }
    return sum;
}

/// Return the product m v of a rotation matrix and a vector. This function is inlined, unlike
/// Eigen's product.
Vec3 turned(const Mat3& m, const Vec3& v) noexcept {
    return m.col(0) * v.x() + m.col(1) * v.y() + m.col(2) * v.z();
}

/// Return an order of the corners in which consecutive corners are near each other. Squares of the
/// waterplane, with diagonals shorter than a cluster, are visited along a row and back along the
/// next one, each from its lowest corner: corners of one batch are all wet or all dry if possible.
/// Without clusters it is the order of the mesh.
std::vector<std::int32_t> corner_order(const HullMesh& mesh, double reach) {
    std::vector<std::int32_t> out(mesh.vertices.size());
    std::iota(out.begin(), out.end(), 0);
    if (!(reach > 0.0)) return out;
    struct Key {
        std::int64_t row, column;
    };
    const auto key = [&](std::int32_t i) {
        const Vec3& v = mesh.vertices[static_cast<std::size_t>(i)];
        const auto row = static_cast<std::int64_t>(std::floor(v.x() / (1.2 * reach)));
        const auto column = static_cast<std::int64_t>(std::floor(v.y() / (1.2 * reach)));
        return Key{row, row % 2 == 0 ? column : -column};
    };
    std::stable_sort(out.begin(), out.end(), [&](std::int32_t i, std::int32_t j) {
        const Key a = key(i), b = key(j);
        if (a.row != b.row) return a.row < b.row;
        if (a.column != b.column) return a.column < b.column;
        return mesh.vertices[static_cast<std::size_t>(i)].z() <
               mesh.vertices[static_cast<std::size_t>(j)].z();
    });
    return out;
}

}  // namespace

HullWater::HullWater(const WaterHull& def, const Sea& sea, double step, double heading,
                     double reach)
    : def_(&def),
      volume_(volume_of(def.mesh)),
      corners_(def.mesh.vertices.size()),
      order_(corner_order(def.mesh, reach)),
      parts_(static_cast<std::size_t>(chunks_of(def.mesh.triangles.size()))),
      flows_(def.strips.size(), Vec3::Zero()),
      flow_(def),
      weight_(def.linear.weight),
      memory_(def, step),
      waves_(def, sea, step, heading) {
    if (!def.coefficients) return;
    const WaveCoefficients& c = *def.coefficients;
    const Matrix6 t = motion_at(c.reference);
    if (def.radiation == RadiationKind::constant) {
        const double omega = kTwoPi / def.constant_period;
        added_ = without_negative(linear_at(c.frequency, c.added_mass, omega));
        constant_ = linear_at(c.frequency, c.damping, omega);
    } else if (def.radiation != RadiationKind::none) {
        added_ = c.infinite;
        constant_ = memory_.damping();
    }
    for (Matrix6* m : {&added_, &constant_}) *m = t.transpose() * (0.5 * (*m + m->transpose())) * t;
    statics_ = t.transpose() * (0.5 * (c.stiffness + c.stiffness.transpose())) * t;
}

int HullWater::corner_chunks() const noexcept { return chunks_of(corners_.size()); }
int HullWater::strip_chunks() const noexcept { return chunks_of(flows_.size()); }
int HullWater::cell_chunks() const noexcept { return chunks_of(flow_.count()); }
int HullWater::triangle_chunks() const noexcept { return static_cast<int>(parts_.size()); }

void HullWater::begin(const World& world, bool convective) noexcept {
    convective_ = convective;
    pose_ = world.pose(def_->body);
    twist_ = world.velocity(def_->body);
    axes_ = pose_.orientation.toRotationMatrix();
}

void HullWater::press(const WaterField& field, int chunk) noexcept {
    // If the coefficients contain all effects of waves, the mesh is in still water.
    const bool waves = def_->excitation != ExcitationKind::full;
    const double weight = field.sea().density() * field.sea().gravity(), level = field.now().level;
    const int first = chunk * kChunk;
    const int count = std::min(kChunk, static_cast<int>(corners_.size()) - first);
    FieldPoint points[kChunk];
    double surface[kChunk], rise[kChunk] = {};
    const std::int32_t* const own = &order_[static_cast<std::size_t>(first)];
    for (int i = 0; i < count; ++i) {
        HullCorner& corner = corners_[at(own[i])];
        corner.x = turned(axes_, def_->mesh.vertices[at(own[i])]);
        points[i] = {pose_.position + corner.x, 0.0};
    }
    field.press(points, count, waves, surface, def_->wave_pressure ? rise : nullptr);
    for (int i = 0; i < count; ++i) {
        const double z = points[i].z, depth = surface[i] - z;
        HullCorner& corner = corners_[at(own[i])];
        corner.depth = depth;
        if (!def_->wave_pressure)
            corner.pressure = weight * std::max(depth, 0.0);
        else
            corner.pressure = z < surface[i] ? weight * (level - z) + rise[i] : 0.0;
    }
}

void HullWater::sum(int chunk) noexcept {
    static_assert(kChunk <= kHullBlock && sizeof(HullCorner) == 5 * sizeof(double));
    const auto& triangles = def_->mesh.triangles;
    const int first = chunk * kChunk;
    const int count = std::min(kChunk, static_cast<int>(triangles.size()) - first);
    int cut[kChunk];
    double s[kHullSums];
    const int cuts =
        hull_kernels().wet(corners_.front().x.data(),
                           triangles[static_cast<std::size_t>(first)].data(), count, cut, s);
    HullSums& out = parts_[static_cast<std::size_t>(chunk)];
    out = {.force = Vec3(s[kForce], s[kForce + 1], s[kForce + 2]),
           .torque = Vec3(s[kTorque], s[kTorque + 1], s[kTorque + 2]),
           .volume = s[kVolume],
           .moment = Vec3(s[kMoment], s[kMoment + 1], s[kMoment + 2]),
           .plane = s[kPlane],
           .x = s[kPlaneX],
           .y = s[kPlaneY],
           .xx = s[kPlaneXX],
           .yy = s[kPlaneYY],
           .xy = s[kPlaneXY]};
    for (int i = 0; i < cuts; ++i) {
        const auto& t = triangles[at(first + cut[i])];
        out.add_triangle(corners_[static_cast<std::size_t>(t[0])],
                         corners_[static_cast<std::size_t>(t[1])],
                         corners_[static_cast<std::size_t>(t[2])]);
    }
}

void HullWater::finish(const WaterField& field, double air) noexcept {
    const Sea& sea = field.sea();
    const SeaMoment& now = field.now();
    force.fill(0.0);
    mass.fill(0.0);
    damping.fill(0.0);
    stiffness.fill(0.0);
    HullSums all;
    for (const HullSums& part : parts_) all.add(part);
    const bool linear = def_->linear.on;
    const double wet = linear ? 1.0 : std::clamp(all.volume / volume_, 0.0, 1.0);
    if (linear)
        add_linear(sea, now);
    else if (wet > 0.0)
        add_pressure(sea, all);
    WaterPoint centre = sea.water(now, pose_.position);
    if (convective_) centre.acceleration += sea.convection(now, pose_.position);
    flow_.finish(axes_, centre);
    if (wet > 0.0) {
        add_coefficients(sea, now);
        add_strips(sea);
    }
    add_motion(sea, now, wet, air);
    any_ = wet > 0.0 || (def_->wind_area.array() != 0.0).any();
}

void HullWater::add_pressure(const Sea& sea, const HullSums& all) noexcept {
    const double weight = sea.density() * sea.gravity();
    for (int k = 0; k < 3; ++k) {
        force[at(k)] = all.force[k];
        force[at(3 + k)] = all.torque[k];
    }
    double plane[6];
    plane_stiffness(all, plane);
    for (int i = 0, n = 0; i < 3; ++i)  // heave, turns about x and y are rows 2, 3, 4
        for (int j = 0; j <= i; ++j, ++n)
            stiffness[static_cast<std::size_t>(triangle(2 + i, 2 + j))] += weight * plane[n];
    // Use at least the secant to the position out of the water. Otherwise a step could throw out a
    // light hull below the surface.
    double deepest = 0.0;
    for (const HullCorner& c : corners_) deepest = std::max(deepest, c.depth);
    double& heave = stiffness[static_cast<std::size_t>(triangle(2, 2))];
    heave = std::max(heave, weight * all.volume / deepest);
    const double stable = weight * std::max(all.moment.z(), 0.0);
    stiffness[static_cast<std::size_t>(triangle(3, 3))] += stable;
    stiffness[static_cast<std::size_t>(triangle(4, 4))] += stable;
}

void HullWater::flow_over(const WaterField& field, int chunk) noexcept {
    const auto first = static_cast<std::size_t>(chunk) * kChunk;
    flow_.sample(field, convective_, def_->excitation == ExcitationKind::full, pose_, axes_, first,
                 std::min(first + kChunk, flow_.count()));
}

/// Add the forces of added mass and linear damping, relative to the mean motion of the water, and
/// the drag.
void HullWater::add_motion(const Sea& sea, const SeaMoment& now, double wet, double air) noexcept {
    Vec3 push = Vec3::Zero(), moment = Vec3::Zero();
    Sym3 drag;
    if (wet > 0.0) {
        const auto& m = def_->added_mass;
        const auto& d = def_->damping;
        add_axes(axes_, m.data(), 0, mass);
        add_axes(axes_, m.data() + 3, 3, mass);
        add_axes(axes_, d.data(), 0, damping);
        add_axes(axes_, d.data() + 3, 3, damping);
        for (int k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const auto axis = axes_.col(k);
            push += (m[i] * axis.dot(flow_.acceleration) + d[i] * axis.dot(flow_.velocity)) * axis;
            moment +=
                (m[3 + i] * axis.dot(flow_.turn_rate) + d[3 + i] * axis.dot(flow_.turn)) * axis;
        }
        add_body_drag(axes_, def_->drag_area.cwiseProduct(flow_.wet_fraction), 0.5 * sea.density(),
                      flow_.velocity, twist_.linear, push, drag);
    }
    if (wet < 1.0)
        add_body_drag(axes_, def_->wind_area.cwiseProduct(flow_.dry_fraction), 0.5 * air,
                      sea.wind(now, std::max(pose_.position.z(), now.level + 10.0)), twist_.linear,
                      push, drag);
    add_force(push, moment);
    for (int i = 0, n = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j, ++n)
            damping[static_cast<std::size_t>(triangle(i, j))] += drag.m[n];
}

}  // namespace hawser::marine
