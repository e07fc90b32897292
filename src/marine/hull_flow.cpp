// SPDX-License-Identifier: Apache-2.0
#include "marine/hull_flow.h"

#include "marine/drag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace hawser::marine {
namespace {

/// Wetted fraction from which a cell counts in full for the area along z.
constexpr double kWholeGround = 0.1;

double lowest_of(const HullMesh& mesh) {
    double low = std::numeric_limits<double>::infinity();
    for (const Vec3& v : mesh.vertices) low = std::min(low, v.z());
    return low;
}

bool moves_with_water(const WaterHull& def) {
    const auto any = [](const std::array<double, 6>& six) {
        return std::any_of(six.begin(), six.end(), [](double x) { return x != 0.0; });
    };
    return any(def.added_mass) || any(def.damping) || !def.drag_area.isZero(0.0) ||
           !def.wind_area.isZero(0.0) || !def.strips.empty();
}

}  // namespace

HullFlow::HullFlow(const WaterHull& def) : small_(def.linear.on) {
    if (def.mesh.triangles.empty() || !moves_with_water(def)) return;
    cells_ = hull_cells(def.mesh);
    samples_.resize(cells_.size());
    row_.resize(cells_.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::map<std::array<std::int32_t, 2>, std::int32_t> known;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            const HullCell& cell = cells_[c];
            const auto [at, first] = known.try_emplace({cell.index[u], cell.index[v]},
                                                       static_cast<std::int32_t>(known.size()));
            row_[c][axis] = at->second;
            if (first)
                width_[axis].push_back(axis == 0   ? cell.size.y()
                                       : axis == 1 ? cell.size.x()
                                                   : cell.size.x() * cell.size.y());
        }
        wet_row_[axis].resize(known.size());
        dry_row_[axis].resize(known.size());
    }
    const double surface = lowest_of(def.mesh) + def.design_draught;
    for (std::size_t c = 0; c < cells_.size(); ++c)
        samples_[c].wet = marine::wet_fraction(surface, cells_[c].at.z() - 0.5 * cells_[c].size.z(),
                                               cells_[c].size.z());
    design_ = project();
}

void HullFlow::sample(const WaterField& field, bool convective, bool still, const Pose& pose,
                      const Mat3& axes, std::size_t begin, std::size_t end) noexcept {
    const auto count = static_cast<int>(end - begin);
    FieldPoint points[WaterField::kMostPoints];
    WaterPoint water[WaterField::kMostPoints];
    for (int i = 0; i < count; ++i) {
        const HullCell& cell = cells_[begin + static_cast<std::size_t>(i)];
        const Vec3 place = pose.position + axes * cell.at;
        points[i] = {place, place.z() + 0.5 * axes.row(2).cwiseAbs().dot(cell.size)};
    }
    field.water(points, count, water);
    for (int i = 0; i < count; ++i) {
        const HullCell& cell = cells_[begin + static_cast<std::size_t>(i)];
        const Vec3 place = pose.position + axes * cell.at;
        const double spread = axes.row(2).cwiseAbs().dot(cell.size);
        Sample& out = samples_[begin + static_cast<std::size_t>(i)];
        const double surface = still ? field.now().level : water[i].elevation;
        out.wet = marine::wet_fraction(surface, place.z() - 0.5 * spread, spread);
        out.arm = place - pose.position;
        out.velocity = water[i].velocity;
        out.acceleration = water[i].acceleration;
        if (convective) out.acceleration += field.sea().convection(field.now(), place);
    }
}

double HullFlow::velocity_error(const WaterField& field, const Pose& pose,
                                std::int64_t& points) const {
    double worst = 0.0;
    for (const Sample& sample : samples_) {
        const Vec3 exact = field.sea().water(field.now(), pose.position + sample.arm).velocity;
        worst = std::max(worst, (sample.velocity - exact).norm());
    }
    points += static_cast<std::int64_t>(samples_.size());
    return worst;
}

ProjectedAreas HullFlow::project() noexcept {
    ProjectedAreas out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::fill(wet_row_[axis].begin(), wet_row_[axis].end(), 0.0);
        std::fill(dry_row_[axis].begin(), dry_row_[axis].end(), 0.0);
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            const auto row = static_cast<std::size_t>(row_[c][axis]);
            const double w = samples_[c].wet, high = cells_[c].size.z();
            const double wet = axis < 2 ? w * high : std::min(1.0, w / kWholeGround);
            const double dry =
                axis < 2 ? (1.0 - w) * high : std::min(1.0, (1.0 - w) / kWholeGround);
            wet_row_[axis][row] = std::max(wet_row_[axis][row], wet);
            dry_row_[axis][row] = std::max(dry_row_[axis][row], dry);
        }
        for (std::size_t r = 0; r < width_[axis].size(); ++r) {
            out.wet[static_cast<Eigen::Index>(axis)] += width_[axis][r] * wet_row_[axis][r];
            out.dry[static_cast<Eigen::Index>(axis)] += width_[axis][r] * dry_row_[axis][r];
        }
    }
    return out;
}

void HullFlow::finish(const Mat3& axes, const WaterPoint& at_centre) noexcept {
    velocity = at_centre.velocity;
    acceleration = at_centre.acceleration;
    turn.setZero();
    turn_rate.setZero();
    if (cells_.empty()) return;
    const ProjectedAreas now = project();
    for (int k = 0; k < 3 && !small_; ++k) {
        wet_fraction[k] = design_.wet[k] > 0.0 ? now.wet[k] / design_.wet[k] : 1.0;
        dry_fraction[k] = design_.dry[k] > 0.0 ? now.dry[k] / design_.dry[k] : 0.0;
    }
    double volume = 0.0;
    Vec3 flow = Vec3::Zero(), rate = Vec3::Zero(), middle = Vec3::Zero();
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const double v = samples_[c].wet * cells_[c].volume();
        volume += v;
        flow += v * samples_[c].velocity;
        rate += v * samples_[c].acceleration;
        middle += v * samples_[c].arm;
    }
    if (!(volume > 0.0)) return;
    velocity = flow / volume;
    acceleration = rate / volume;
    middle /= volume;
    Vec3 spin = Vec3::Zero(), spin_rate = Vec3::Zero(), inertia = Vec3::Zero();
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const double v = samples_[c].wet * cells_[c].volume();
        const Vec3 r = samples_[c].arm - middle;
        spin += v * r.cross(samples_[c].velocity - velocity);
        spin_rate += v * r.cross(samples_[c].acceleration - acceleration);
        const Vec3 own = axes.transpose() * r;
        inertia += v * (Vec3::Constant(r.squaredNorm()) - own.cwiseProduct(own));
    }
    const double least = 1e-12 * inertia.maxCoeff();
    for (int k = 0; k < 3; ++k) {
        if (!(inertia[k] > least)) continue;
        turn += axes.col(k).dot(spin) / inertia[k] * axes.col(k);
        turn_rate += axes.col(k).dot(spin_rate) / inertia[k] * axes.col(k);
    }
}

}  // namespace hawser::marine
