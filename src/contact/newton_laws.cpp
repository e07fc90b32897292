// SPDX-License-Identifier: Apache-2.0
#include "contact/newton_laws.h"

#include "base/index.h"
#include "contact/convex_phase.h"
#include "contact/iterate.h"
#include "context/sweeps.h"
#include "solve/bounds.h"

#include <cstdint>
#include <functional>

namespace hawser::contact {

using assembly::Contacts;
using nonsmooth::Cone;

namespace {

/// Changes of status within the iterations of one solve after which the coupling is lagged.
constexpr int kMaxChanges = 6;

}  // namespace

void renew_law(Cone& c, nonsmooth::Law& law, std::uint8_t& changes) noexcept {
    const nonsmooth::Touch before = c.touch;
    const nonsmooth::Law last = law;
    law = nonsmooth::linearise(c, c.touch);
    if (c.coupling != nonsmooth::Coupling::exact) return;
    const bool turned = nonsmooth::sliding_reversed(last, law);
    if (turned || c.touch != before) ++changes;
    if (changes > kMaxChanges) {
        c.coupling = nonsmooth::Coupling::lagged;
        law = nonsmooth::linearise(c, c.touch);
    } else if (turned) {
        law = nonsmooth::sticking_law(c);
        c.touch = nonsmooth::Touch::stick;
    }
}

std::int32_t linearise(context::Model& model, context::Work& work, runtime::Pool& pool,
                       LastLaws last) noexcept {
    Contacts& contacts = model.system.contacts;
    context::Newton& newton = work.newton;
    auto some = [&](std::int32_t begin, std::int32_t end) {
        std::int32_t changed = 0;
        for (std::size_t k = at(begin); k < at(end); ++k) {
            Cone& c = contacts.cones[k];
            const nonsmooth::Touch before = c.touch;
            if (newton.convex)
                newton.laws[k] = nonsmooth::linearise(convex_cone(c), c.touch);
            else if (last == LastLaws::known)
                renew_law(c, newton.laws[k], newton.changes[k]);
            else
                newton.laws[k] = nonsmooth::linearise(c, c.touch);
            changed += c.touch != before ? 1 : 0;
        }
        return static_cast<double>(changed);
    };
    auto flips = static_cast<std::int32_t>(context::merged_over(
        work.solve, pool, static_cast<std::int32_t>(contacts.count()), some, std::plus<double>()));
    assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        nonsmooth::Resistance& a = resistances.laws[k];
        const nonsmooth::Touch spun = a.spins, rolled = a.rolls;
        const Cone& c = contacts.cones[at(resistances.rows[k].contact)];
        newton.turns[k] =
            nonsmooth::linearise(a, newton.convex ? convex_cone(c) : c, a.spins, a.rolls);
        flips += a.spins != spun || a.rolls != rolled ? 1 : 0;
    }
    return flips;
}

double merit(const context::Model& model, const context::Newton& newton, double t) noexcept {
    return solve::bounds_merit(model, newton, t) + contacts_merit(model, newton, t);
}

}  // namespace hawser::contact
