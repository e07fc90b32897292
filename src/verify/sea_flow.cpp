// SPDX-License-Identifier: Apache-2.0
/// Mean motion of the water over a hull, and projected areas (hawser/water_hull.h), by
/// separate sums over the library's list of cells.
#include "verify/sea_loads.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hawser::verify {
namespace {

double fraction_below(double surface, double middle, double high) {
    return std::clamp((surface - middle) / high + 0.5, 0.0, 1.0);
}

/// Return the projected area along an axis, for fractions of cells.
double projected_area(const std::vector<HullCell>& cells, const std::vector<double>& fraction,
                      int axis) {
    std::map<std::pair<int, int>, std::pair<double, double>> rows;  // extent, width
    const auto a = static_cast<std::size_t>((axis + 1) % 3);
    const auto b = static_cast<std::size_t>((axis + 2) % 3);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        auto& [extent, width] = rows[{cells[c].index[a], cells[c].index[b]}];
        const Vec3& size = cells[c].size;
        width = axis == 0 ? size.y() : axis == 1 ? size.x() : size.x() * size.y();
        extent = std::max(extent,
                          axis == 2 ? std::min(1.0, 10.0 * fraction[c]) : fraction[c] * size.z());
    }
    double sum = 0.0;
    for (const auto& [row, value] : rows) sum += value.first * value.second;
    return sum;
}

}  // namespace

SeaVerifier::Flow SeaVerifier::flow_over(const WaterHull& def, const Pose& pose) const {
    Flow out;
    const auto add_water = [&](const Water& at, const Vec3& x, double part, Vec3& flow,
                               Vec3& rate) {
        flow += part * at.flow;
        rate += part * (def_->convective ? Vec3(at.rate + convection(x)) : at.rate);
    };
    const std::vector<HullCell>& cells =
        cells_[static_cast<std::size_t>(&def - def_->hulls.data())];
    const Mat3 axes = pose.orientation.toRotationMatrix();
    double low = 0.0;
    for (std::size_t i = 0; i < def.mesh.vertices.size(); ++i)
        low = i == 0 ? def.mesh.vertices[i].z() : std::min(low, def.mesh.vertices[i].z());
    std::vector<double> wet, dry, wet_then, dry_then, weight;
    std::vector<Water> waters;
    double all = 0.0;
    Vec3 middle = Vec3::Zero();
    for (const HullCell& cell : cells) {
        const Vec3 x = pose.position + axes * cell.at;
        double high = 0.0;
        for (int k = 0; k < 3; ++k) high += std::abs(axes(2, k)) * cell.size[k];
        waters.push_back(water(x));
        const double surface =
            def.excitation == ExcitationKind::full ? level_ : waters.back().surface;
        wet.push_back(fraction_below(surface, x.z(), high));
        wet_then.push_back(fraction_below(low + def.design_draught, cell.at.z(), cell.size.z()));
        dry.push_back(1.0 - wet.back());
        dry_then.push_back(1.0 - wet_then.back());
        weight.push_back(wet.back() * cell.size.prod());
        all += weight.back();
        middle += weight.back() * x;
    }
    for (int k = 0; k < 3 && !cells.empty() && !def.linear.on; ++k) {
        const double w = projected_area(cells, wet_then, k), d = projected_area(cells, dry_then, k);
        out.wet_fraction[k] = w > 0.0 ? projected_area(cells, wet, k) / w : 1.0;
        out.dry_fraction[k] = d > 0.0 ? projected_area(cells, dry, k) / d : 0.0;
    }
    if (!(all > 0.0)) {
        add_water(water(pose.position), pose.position, 1.0, out.velocity, out.rate);
        return out;
    }
    middle /= all;
    Vec3 spin = Vec3::Zero(), spin_rate = Vec3::Zero();
    Mat3 inertia = Mat3::Zero();
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Vec3 x = pose.position + axes * cells[c].at, r = x - middle;
        Vec3 flow = Vec3::Zero(), rate = Vec3::Zero();
        add_water(waters[c], x, weight[c], flow, rate);
        out.velocity += flow / all;
        out.rate += rate / all;
        spin += r.cross(flow);
        spin_rate += r.cross(rate);
        inertia += weight[c] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
    }
    const Mat3 own = axes.transpose() * inertia * axes;
    for (int k = 0; k < 3; ++k) {
        if (!(own(k, k) > 1e-12 * own.diagonal().maxCoeff())) continue;
        out.turn += axes.col(k).dot(spin) / own(k, k) * axes.col(k);
        out.turn_rate += axes.col(k).dot(spin_rate) / own(k, k) * axes.col(k);
    }
    return out;
}

}  // namespace hawser::verify
