// SPDX-License-Identifier: Apache-2.0
#include "wire/touch.h"

#include "wire/hang.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {

std::optional<Plane> touch_once(const Chain& chain, double x, double sunk, double last) {
    if (chain.elements() < 2) return {};
    Chain rest = chain;  // from the first node on
    rest.s.erase(rest.s.begin());
    for (double& s : rest.s) s -= chain.s[1];
    rest.length.erase(rest.length.begin());
    rest.compliance.erase(rest.compliance.begin());
    rest.weight.erase(rest.weight.begin());
    rest.weight.front() = 0.0;
    // The first element stretches under the horizontal pull of the others. This changes their
    // distance very little, so a few iterations suffice.
    const double length = chain.length[0], compliance = chain.compliance[0];
    double h = 0.0, level = 0.0, tension = 0.0;
    Plane shape;
    for (int i = 0; i < 60; ++i) {
        for (int k = 0; k < 30; ++k) {
            const double stretched = length + compliance * tension;
            level = std::sqrt(std::max(0.0, (stretched - sunk) * (stretched + sunk)));
            if (!(level > 0.0)) return {};
            const double next = h * (stretched / level);
            if (next == tension) break;
            tension = next;
        }
        if (!(x - level > 0.0)) return {};
        shape = hang_between(rest, x - level, last);
        const Vec3& d = shape.chord[0];
        const double next = d.norm() > 0.0 ? shape.tension[0] * d.x() / d.norm() : 0.0;
        if (std::abs(next - h) <= 1e-15 * h) break;
        h = next;
    }
    double z = 0.0;
    for (const Vec3& d : shape.chord) {
        if (z < -1e-9 * chain.total_length()) return {};
        z += d.z();
    }
    const Vec3& d = shape.chord[0];
    const double lift = d.norm() > 0.0 ? shape.tension[0] * d.z() / d.norm() : 0.0;
    if (lift > chain.weight[1] + h * sunk / level) return {};
    shape.chord.insert(shape.chord.begin(), Vec3(level, 0.0, sunk));
    shape.tension.insert(shape.tension.begin(), tension);
    shape.laid_first = shape.laid_last = 1;
    return shape;
}

Plane reversed(const Plane& shape) {
    Plane out = shape;
    std::reverse(out.chord.begin(), out.chord.end());
    std::reverse(out.tension.begin(), out.tension.end());
    for (Vec3& d : out.chord) d.z() = -d.z();
    if (shape.laid_first <= shape.laid_last) {
        out.laid_first = shape.chord.size() - shape.laid_last;
        out.laid_last = shape.chord.size() - shape.laid_first;
    }
    return out;
}

}  // namespace hawser::wire
