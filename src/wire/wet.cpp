// SPDX-License-Identifier: Apache-2.0
#include "wire/wet.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {

double wet_fraction(double depth, double spread) {
    return depth >= spread ? 1.0 : std::clamp(depth / spread, 0.0, 1.0);
}

HalfForm half_element_form(double z, double middle, double diameter) {
    HalfForm out;
    out.spread = std::abs(middle - z) + diameter;
    out.below = std::max(0.0, z - middle) + 0.5 * diameter;
    return out;
}

WetHalves wet_halves(const Chain& chain, const Plane& shape, double water) {
    WetHalves out;
    double z = 0.0;
    for (std::size_t e = 0; e < chain.elements(); ++e) {
        const double rise = shape.chord[e].z(), middle = z + 0.5 * rise, d = chain.diameter[e];
        const HalfForm a = half_element_form(z, middle, d),
                       b = half_element_form(z + rise, middle, d);
        out.first.push_back(wet_fraction(water - z + a.below, a.spread));
        out.last.push_back(wet_fraction(water - z - rise + b.below, b.spread));
        z += rise;
    }
    return out;
}

bool resists_bending(const Chain& chain) noexcept {
    return std::any_of(chain.bend.begin(), chain.bend.end(), [](double k) { return k > 0.0; });
}

std::vector<Vec3> bending_forces(const Chain& chain, const std::vector<Vec3>& nodes) {
    std::vector<Vec3> out(nodes.size(), Vec3::Zero());
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        if (!(chain.bend[i] > 0.0)) continue;
        const Vec3 a = nodes[i] - nodes[i - 1], b = nodes[i + 1] - nodes[i];
        const double la = a.norm(), lb = b.norm();
        const Vec3 e = a / la, f = b / lb;
        const double c = e.dot(f);
        const Vec3 on_first = chain.bend[i] / la * (f - c * e);   // −∂E/∂a
        const Vec3 on_second = chain.bend[i] / lb * (e - c * f);  // −∂E/∂b
        out[i - 1] -= on_first;
        out[i] += on_first - on_second;
        out[i + 1] += on_second;
    }
    return out;
}

}  // namespace hawser::wire
