// SPDX-License-Identifier: Apache-2.0
#include "contact/convex_phase.h"

#include "base/index.h"
#include "context/newton_data.h"
#include "solve/bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser::contact {
namespace {

using nonsmooth::Cone;
using nonsmooth::Resistance;

/// Velocity and impulse of three rows at a fraction of the way, and the change of u over the whole
/// way.
struct Along {
    double u[3], lambda[3], change[3];
};
Along residual_along(const double* from, const double u[3], const double lambda[3],
                     double t) noexcept {
    Along a{};
    for (int i = 0; i < 3; ++i) {
        a.change[i] = u[i] - from[i];
        a.u[i] = from[i] + t * a.change[i];
        a.lambda[i] = from[3 + i] + t * (lambda[i] - from[3 + i]);
    }
    return a;
}

/// Shorten two tangential components to a radius.
void shorten_step_to(double radius, double& a, double& b) noexcept {
    const double length = std::sqrt(a * a + b * b);
    if (length <= radius) return;
    a *= radius / length;
    b *= radius / length;
}

double slope_along(const Along& a, const double impulse[3]) noexcept {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += (a.lambda[i] - impulse[i]) * a.change[i];
    return sum;
}

/// Return the part of a resistance in the slope ψ.
/// @param normal  Impulse that determines the bounds.
double resistance_slope(const Resistance& r, double normal, const double* from, double t) noexcept {
    const Along a = residual_along(from, r.u, r.lambda, t);
    double impulse[3];
    for (int i = 0; i < 3; ++i) impulse[i] = (r.b[i] - a.u[i]) / r.sigma;
    nonsmooth::limit(r, normal, impulse);
    return slope_along(a, impulse);
}

}  // namespace

Cone convex_cone(const Cone& cone) noexcept {
    Cone c = cone;
    c.mobility *= context::kConvexFraction;
    c.coupling = nonsmooth::Coupling::lagged;
    return c;
}

double contact_slope(const Cone& c, const double from[6], double t) noexcept {
    const Along a = residual_along(from, c.u, c.lambda, t);
    double impulse[3];
    for (int i = 0; i < 3; ++i) impulse[i] = (c.b[i] - a.u[i]) / (i == 0 ? c.sigma_n : c.sigma_t);
    impulse[0] = std::max(0.0, impulse[0]);
    shorten_step_to(nonsmooth::disk_radius(convex_cone(c), from, from + 3), impulse[1], impulse[2]);
    return slope_along(a, impulse);
}

double convex_slope(const context::Model& model, const context::Newton& newton, double t) noexcept {
    const assembly::Contacts& contacts = model.system.contacts;
    double sum = solve::bounds_slope(model, newton, t);
    for (std::size_t k = 0; k < contacts.count(); ++k)
        sum += contact_slope(contacts.cones[k], &newton.contact[6 * k], t);
    const assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        const std::size_t contact = at(resistances.rows[k].contact);
        const double* from = &newton.contact[6 * contact];
        Cone c = convex_cone(contacts.cones[contact]);
        c.friction = 1.0;
        sum += resistance_slope(resistances.laws[k], nonsmooth::disk_radius(c, from, from + 3),
                                &newton.contact[6 * (contacts.count() + k)], t);
    }
    return sum;
}

}  // namespace hawser::contact
