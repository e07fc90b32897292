// SPDX-License-Identifier: Apache-2.0
#include "contact/newton_laws.h"

#include "access/sweeps.h"
#include "base/index.h"
#include "contact/iterate.h"
#include "solve/bounds.h"

#include <functional>

namespace hawser::stepper {

using assembly::Contacts;
using nonsmooth::Cone;

std::int32_t linearise(Model& model, Work& work, runtime::Pool& pool) noexcept {
    Contacts& contacts = model.system.contacts;
    auto some = [&](std::int32_t begin, std::int32_t end) {
        std::int32_t changed = 0;
        for (std::size_t k = at(begin); k < at(end); ++k) {
            Cone& c = contacts.cones[k];
            const nonsmooth::Touch before = c.touch;
            work.newton.laws[k] = nonsmooth::linearise(c, c.touch);
            changed += c.touch != before ? 1 : 0;
        }
        return static_cast<double>(changed);
    };
    auto flips = static_cast<std::int32_t>(merged_over(
        work.solve, pool, static_cast<std::int32_t>(contacts.count()), some, std::plus<double>()));
    assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        nonsmooth::Resistance& a = resistances.laws[k];
        const nonsmooth::Touch spun = a.spins, rolled = a.rolls;
        work.newton.turns[k] = nonsmooth::linearise(
            a, contacts.cones[at(resistances.rows[k].contact)], a.spins, a.rolls);
        flips += a.spins != spun || a.rolls != rolled ? 1 : 0;
    }
    return flips;
}

double merit(const Model& model, const Newton& newton, double t) noexcept {
    return bounds_merit(model, newton, t) + contacts_merit(model, newton, t);
}

}  // namespace hawser::stepper
