// SPDX-License-Identifier: Apache-2.0
/// Samples of a resolution: material lengths, angles and tension of its wire.
#include "wire/wire_resolution.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>

namespace hawser::wire {

/// Return the mass per length of the line type to which an element belongs, by its EA. Among
/// several line types of this EA, the one that best matches the element's mass over its rest length
/// is used. 0: the element belongs to another wire that was spliced to this one.
double WireResolution::matching_mass_per_length(const InteractionDef& element) const noexcept {
    if (lines_.size() == 1) return lines_[0].mass_per_length;
    const double EA = element.get("EA"), now = element.get("mass") / element.get("length");
    double best = 0.0;
    for (const Line& line : lines_)
        if (line.EA == EA && std::abs(line.mass_per_length - now) < std::abs(best - now))
            best = line.mass_per_length;
    return best;
}

/// Read the state of all elements and nodes of the wire: chord, tension, length, mass per length
/// and bending.
void WireResolution::sample(const World& world) {
    const auto elements = world.wires().elements(def_.wire);
    const auto nodes = world.wires().nodes(def_.wire);
    elements_.assign(elements.size(), {});
    at_.assign(nodes.size(), {});
    for (std::size_t i = 0; i < nodes.size(); ++i) at_[i].id = nodes[i];
    for (std::size_t i = 0; i < elements.size(); ++i) {
        Element& e = elements_[i];
        e.id = elements[i];
        if (!world.alive(e.id) || !world.intact(e.id)) continue;
        const InteractionDef& d = world.interaction_def(e.id);
        e.whole = true;
        e.wound = kind_info(d.kind).is(kWoundUp);
        e.chord =
            world.world_point(d.body[1], d.point[1]) - world.world_point(d.body[0], d.point[0]);
        e.tension = std::max(0.0, -world.force(e.id)[0]);
        if (e.wound) continue;
        const double mass = d.get("mass");
        e.mass_per_length = mass > 0.0 ? matching_mass_per_length(d) : 0.0;
        e.plain = e.mass_per_length > 0.0;
        e.length = e.plain ? mass / e.mass_per_length : d.get("length");
    }
    compute_bending(world);
}

/// Compute angles and curvatures at nodes.
void WireResolution::compute_bending(const World& world) noexcept {
    for (std::size_t k = 1; k < elements_.size(); ++k) {
        const Element &a = elements_[k - 1], &b = elements_[k];
        if (!a.whole || !b.whole) continue;
        at_[k].angle = std::atan2(a.chord.cross(b.chord).norm(), a.chord.dot(b.chord));
        // The material of the element at a drum is not known here.
        const auto length = [&](const Element& e) {
            return e.wound ? world.interaction_def(e.id).get("length") : e.length;
        };
        at_[k].curvature = at_[k].angle / std::max(0.5 * (length(a) + length(b)), 1e-9);
    }
}

void WireResolution::average_tension(const World& world) noexcept {
    double sum = 0.0, length = 0.0;
    for (const Element& e : elements_) {
        if (!e.plain) continue;
        sum += e.tension * e.length;
        length += e.length;
    }
    if (!(length > 0.0)) return;
    const double mean = sum / length, since = def_.interval * world.settings().step;
    const double fraction = tension_ < 0.0 ? 1.0 : -std::expm1(-since / def_.averaging);
    tension_ += fraction * (mean - tension_);
}

}  // namespace hawser::wire
