// SPDX-License-Identifier: Apache-2.0
#include "wire/drum_geometry.h"

#include "wire/bounds.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {
namespace {

/// Tolerance of a quotient that is a whole number except for rounding.
constexpr double kRounding = 1e-9;

/// Return a quotient as a whole number, at most the largest count of layers or wraps; NaN gives 0.
int integer_part(double quotient) noexcept {
    const double whole = std::floor(quotient + kRounding);
    return whole >= 0.0 ? static_cast<int>(std::min(whole, 1.0 * DrumGeometry::kMaxLayers)) : 0;
}

}  // namespace

int DrumGeometry::wraps_a_layer() const noexcept { return integer_part(width / wire_diameter); }

int DrumGeometry::layers() const noexcept {
    const double above = flange_radius - core_radius - wire_diameter;  // of the first layer
    if (above < -kRounding) return 0;
    return std::min(1 + integer_part(above / layer_pitch), kMaxLayers);
}

double DrumGeometry::radius(int layer) const noexcept {
    return core_radius + 0.5 * wire_diameter + (layer - 1) * layer_pitch;
}

double DrumGeometry::length_in_layers(int layers) const noexcept {
    const double k = layers;
    return kTurn * wraps_a_layer() * (k * radius(1) + 0.5 * layer_pitch * k * (k - 1.0));
}

DrumGeometry::Place DrumGeometry::wire_end(double length) const noexcept {
    Place out{.radius = radius(1)};
    const double n = wraps_a_layer();
    // A length above any capacity ends in the last layer. NaN ends in the first.
    const double l = length > 0.0 ? std::min(length, length_in_layers(kMaxLayers)) : 0.0;
    // Take the larger root of S(K) = l and correct the whole number for rounding.
    const double a = 0.5 * layer_pitch, b = radius(1) - a, c = l / (kTurn * n);
    const double root = 2.0 * c / (b + std::sqrt(b * b + 4.0 * a * c));
    out.layer = root > 1.0 ? static_cast<int>(std::min(std::ceil(root), 1.0 * kMaxLayers)) : 1;
    while (out.layer > 1 && length_in_layers(out.layer - 1) >= l) --out.layer;
    while (out.layer < kMaxLayers && length_in_layers(out.layer) < l) ++out.layer;
    out.radius = radius(out.layer);
    const double here = (l - length_in_layers(out.layer - 1)) / (kTurn * out.radius);
    out.wraps = (out.layer - 1) * n + here;
    // Layers are wound back and forth, between the middles of the first and the last wrap.
    const double way = std::min(here / n, 1.0) * (width - wire_diameter);
    const double from_flange = out.layer % 2 == 1 ? way : width - wire_diameter - way;
    out.across = from_flange - 0.5 * (width - wire_diameter);
    return out;
}

double DrumGeometry::leaving_radius(double length) const noexcept {
    const Place at = wire_end(length);
    const double here = length - length_in_layers(at.layer - 1),
                 whole = kTurn * at.radius * wraps_a_layer();
    // Half of the wire of a wrap between both layers; for a narrow drum half of the layer.
    const auto half = [&](int below) {
        const double r = radius(below) + 0.5 * layer_pitch;
        return kTurn * r * std::min(0.5, 0.25 * wraps_a_layer());
    };
    if (at.layer > 1 && here < half(at.layer - 1))
        return at.radius - 0.5 * layer_pitch * (1.0 - here / half(at.layer - 1));
    if (at.layer < layers() && whole - here < half(at.layer))
        return at.radius + 0.5 * layer_pitch * (1.0 - (whole - here) / half(at.layer));
    return at.radius;
}

double DrumGeometry::angle(double length) const noexcept { return kTurn * wire_end(length).wraps; }

double DrumGeometry::length(double angle) const noexcept {
    const double wraps = std::max(angle, 0.0) / kTurn, n = wraps_a_layer();
    const double full = std::min(std::floor(wraps / n), kMaxLayers - 1.0);
    const int layers = static_cast<int>(full);
    return length_in_layers(layers) + kTurn * radius(layers + 1) * (wraps - n * full);
}

double DrumGeometry::inertia(double length, double mass_per_length) const noexcept {
    const Place last = wire_end(length);
    const auto ring = [&](double r) { return r * r + 3.0 / 16.0 * wire_diameter * wire_diameter; };
    double sum = (std::max(length, 0.0) - length_in_layers(last.layer - 1)) * ring(last.radius);
    for (int k = 1; k < last.layer; ++k)
        sum += kTurn * wraps_a_layer() * radius(k) * ring(radius(k));
    return mass_per_length * sum;
}

}  // namespace hawser::wire
