// SPDX-License-Identifier: Apache-2.0
#include "collide/materials.h"

#include <algorithm>
#include <cmath>

namespace hawser::collide {
namespace {

double damping_time(const MaterialDef& m, double h) noexcept {
    return std::isnan(m.damping_time) ? 2.0 * h : m.damping_time;
}

/// Return √(ab); exactly a if both are equal.
double geometric_mean(double a, double b) noexcept { return a == b ? a : std::sqrt(a * b); }

Surface surface_of_material(const MaterialDef& m, double h) noexcept {
    return {
        m.friction,         m.restitution, 1.0 / m.stiffness, 1.0 / (m.tangential * m.stiffness),
        damping_time(m, h), m.rolling,     m.torsional};
}

Surface mixed_surface(const MaterialDef& a, const MaterialDef& b, double h) noexcept {
    const Surface p = surface_of_material(a, h), q = surface_of_material(b, h);
    return {geometric_mean(p.friction, q.friction),
            std::max(p.restitution, q.restitution),
            p.compliance + q.compliance,
            p.tangential_compliance + q.tangential_compliance,
            std::max(p.damping_time, q.damping_time),
            geometric_mean(p.rolling, q.rolling),
            geometric_mean(p.torsional, q.torsional)};
}

}  // namespace

Materials::Materials() {
    defs_.emplace_back();
    defs_.back().name = "default";
}

std::int32_t Materials::add(const MaterialDef& def) {
    defs_.push_back(def);
    return count() - 1;
}

void Materials::add_pair(const MaterialPairDef& def) { pairs_.push_back(def); }

void Materials::surfaces(double h, std::vector<Surface>& out) const {
    out.resize(defs_.size() * (defs_.size() + 1) / 2);
    for (std::int32_t b = 0; b < count(); ++b)
        for (std::int32_t a = 0; a <= b; ++a)
            out[static_cast<std::size_t>(surface(a, b))] = mixed_surface(def(a), def(b), h);
    for (const MaterialPairDef& pair : pairs_)
        out[static_cast<std::size_t>(surface(pair.a.index, pair.b.index))] =
            surface_of_material(pair.values, h);
}

}  // namespace hawser::collide
