// SPDX-License-Identifier: Apache-2.0
/// The law of a contact from its materials.
#include "verify/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

struct Law {
    double friction, rolling, torsional;
    double compliance, tangential_compliance;  // [m/N]
    double damping_time;                       // [s]
};

Law law_of(const MaterialDef& m, double h) {
    const double damping = std::isnan(m.damping_time) ? 2.0 * h : m.damping_time;
    return {
        m.friction, m.rolling, m.torsional, 1.0 / m.stiffness, 1.0 / (m.stiffness * m.tangential),
        damping};
}

// The last pair given of two materials decides; without one: geometric means, springs in series,
// the larger damping time.
Law law_between(const World& world, ShapeId one, ShapeId other) {
    const auto material = [&](ShapeId shape) {
        const MaterialId id = world.shape_def(shape).material;
        return id.valid() ? id : MaterialId{0};
    };
    const MaterialId a = material(one), b = material(other);
    const double h = world.settings().step;
    Law law = law_of(world.material_def(a), h);
    const Law second = law_of(world.material_def(b), h);
    law.friction = std::sqrt(law.friction * second.friction);
    law.rolling = std::sqrt(law.rolling * second.rolling);
    law.torsional = std::sqrt(law.torsional * second.torsional);
    law.compliance += second.compliance;
    law.tangential_compliance += second.tangential_compliance;
    law.damping_time = std::max(law.damping_time, second.damping_time);
    for (const MaterialPairDef& pair : world.material_pairs())
        if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a))
            law = law_of(pair.values, h);
    return law;
}

bool differ(double ours, double theirs, double scale) {
    // Another order of a few products and sums.
    return !(std::abs(ours - theirs) <= 1e-9 * scale);
}

}  // namespace

void Verifier::check_law(const World& world, const ContactView& contact, double mobility,
                         double speed, double speeds) {
    if (!wrong_law_.empty()) return;
    const Law law = law_between(world, contact.shape[0], contact.shape[1]);
    const double h = step_, upsilon = 1.0 / (1.0 + 4.0 * law.damping_time / h);
    const auto wrong = [&](const char* what, double ours, double theirs) {
        wrong_law_ = fmt::format(
            "a contact between shapes {} and {} has a {} of {:.9g}, by its materials {:.9g}",
            contact.shape[0].index, contact.shape[1].index, what, theirs, ours);
    };
    // Nothing is harder than a ten-billionth of what the bodies' masses give.
    const auto softness = [&](double compliance) {
        return std::max(4.0 * compliance * upsilon / (h * h), 1e-10 * mobility);
    };
    const double sn = softness(law.compliance), st = softness(law.tangential_compliance);
    if (differ(law.friction, contact.friction, law.friction))
        return wrong("friction", law.friction, contact.friction);
    if (differ(sn, contact.softness[0], sn)) return wrong("softness", sn, contact.softness[0]);
    if (differ(st, contact.softness[1], st))
        return wrong("tangential softness", st, contact.softness[1]);
    // Bodies that do not turn against each other have no resistance to it.
    if (contact.rolling != 0.0 && differ(law.rolling, contact.rolling, law.rolling))
        return wrong("rolling length", law.rolling, contact.rolling);
    if (contact.torsional != 0.0 && differ(law.torsional, contact.torsional, law.torsional))
        return wrong("torsional length", law.torsional, contact.torsional);
    // Velocities before the world's first step, and between the stages of one with an impact, are
    // not shown.
    if (result_.steps == 0 || world.stats().impacts != impacts_) return;
    const double target = contact.gap > 0.0
                              ? -contact.gap / h
                              : upsilon * (std::max(0.0, speed) - 4.0 * contact.gap / h);
    const double said = contact.target.dot(contact.normal);
    // A speed is a sum by shares of the velocities of a segment's ends, which may cancel.
    if (differ(target, said, std::abs(target) + speeds + contact.target.norm()))
        wrong("target velocity", target, said);
}

}  // namespace hawser::verify
