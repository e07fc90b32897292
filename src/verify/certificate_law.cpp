// SPDX-License-Identifier: Apache-2.0
/// Check the law of a contact against its materials.
#include "verify/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

struct Law {
    double friction, rolling, torsional;
    double compliance, tangential_compliance;  // Compliances [m/N]
    double damping_time;                       // Damping time [s]
};

Law material_law(const MaterialDef& m, double h) {
    const double damping = std::isnan(m.damping_time) ? 2.0 * h : m.damping_time;
    return {
        m.friction, m.rolling, m.torsional, 1.0 / m.stiffness, 1.0 / (m.stiffness * m.tangential),
        damping};
}

// Return the law of two materials: the last given pair, or else geometric means, springs in series,
// and the larger damping time.
Law law_between(const World& world, ShapeId one, ShapeId other) {
    const auto material = [&](ShapeId shape) {
        const MaterialId id = world.shape_def(shape).material;
        return id.valid() ? id : MaterialId{0};
    };
    const MaterialId a = material(one), b = material(other);
    const double h = world.settings().step;
    Law law = material_law(world.material_def(a), h);
    const Law second = material_law(world.material_def(b), h);
    law.friction = std::sqrt(law.friction * second.friction);
    law.rolling = std::sqrt(law.rolling * second.rolling);
    law.torsional = std::sqrt(law.torsional * second.torsional);
    law.compliance += second.compliance;
    law.tangential_compliance += second.tangential_compliance;
    law.damping_time = std::max(law.damping_time, second.damping_time);
    for (const MaterialPairDef& pair : world.material_pairs())
        if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a))
            law = material_law(pair.values, h);
    return law;
}

bool differs_from_law(double ours, double theirs, double scale) {
    // The tolerance covers another order of a few products and sums.
    return !(std::abs(ours - theirs) <= 1e-9 * scale);
}

}  // namespace

void Verifier::check_law(const World& world, const ContactView& contact, double mobility,
                         double speed, double speeds) {
    if (!law_error_.empty()) return;
    const Law law = law_between(world, contact.shape[0], contact.shape[1]);
    const double h = step_, upsilon = 1.0 / (1.0 + 4.0 * law.damping_time / h);
    const auto wrong = [&](const char* what, double ours, double theirs) {
        law_error_ = fmt::format(
            "a contact between shapes {} and {} has a {} of {:.9g}, by its materials {:.9g}",
            contact.shape[0].index, contact.shape[1].index, what, theirs, ours);
    };
    // Softness is at least a ten-billionth of the mobility of the bodies.
    const auto softness = [&](double compliance) {
        return std::max(4.0 * compliance * upsilon / (h * h), 1e-10 * mobility);
    };
    const double sn = softness(law.compliance), st = softness(law.tangential_compliance);
    if (differs_from_law(law.friction, contact.friction, law.friction))
        return wrong("friction", law.friction, contact.friction);
    if (differs_from_law(sn, contact.softness[0], sn))
        return wrong("softness", sn, contact.softness[0]);
    if (differs_from_law(st, contact.softness[1], st))
        return wrong("tangential softness", st, contact.softness[1]);
    // Bodies without relative rotation have no resistance to it.
    if (contact.rolling != 0.0 && differs_from_law(law.rolling, contact.rolling, law.rolling))
        return wrong("rolling length", law.rolling, contact.rolling);
    if (contact.torsional != 0.0 &&
        differs_from_law(law.torsional, contact.torsional, law.torsional))
        return wrong("torsional length", law.torsional, contact.torsional);
    // A World does not show velocities before its first step, and between the stages of a step with
    // an impact.
    if (result_.steps == 0 || world.stats().impacts != impacts_) return;
    const double target = contact.gap > 0.0
                              ? -contact.gap / h
                              : upsilon * (std::max(0.0, speed) - 4.0 * contact.gap / h);
    const double said = contact.target.dot(contact.normal);
    // The speed is a weighted sum of the velocities of a segment's ends, whose terms may cancel.
    if (differs_from_law(target, said, std::abs(target) + speeds + contact.target.norm()))
        wrong("target velocity", target, said);
}

}  // namespace hawser::verify
