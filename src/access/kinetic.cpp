// SPDX-License-Identifier: Apache-2.0
#include "access/kinetic.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::stepper {
namespace {

double quadratic(const double* s, const double* v) {
    return v[0] * (s[0] * v[0] + s[1] * v[1] + s[2] * v[2]) +
           v[1] * (s[3] * v[0] + s[4] * v[1] + s[5] * v[2]) +
           v[2] * (s[6] * v[0] + s[7] * v[1] + s[8] * v[2]);
}

}  // namespace

double kinetic_energy_of(const model::Bodies& b, std::int32_t body,
                         const double* velocity) noexcept {
    const auto i = at(body);
    const double* v = velocity + b.dof_begin[i];
    const int dof = b.dof(body);
    double sum = 0.0;
    for (int k = 0; k < std::min(dof, 3); ++k) sum += 0.5 * b.mass[i] * v[k] * v[k];
    if (dof < 6) return sum;
    const double* r = &b.r[9 * i];
    double w[3];
    for (int k = 0; k < 3; ++k) w[k] = r[k] * v[3] + r[3 + k] * v[4] + r[6 + k] * v[5];
    return sum + 0.5 * quadratic(&b.inertia[9 * i], w);
}

double pair_energy(const assembly::View& view, std::int32_t id, const double* velocity) noexcept {
    const double pair = pair_mass_of(view, id);
    if (pair == 0.0) return 0.0;
    const std::int32_t* body = view.body + kMaxInteractionBodies * id;
    const double *a = velocity + view.dof_begin[body[0]], *b = velocity + view.dof_begin[body[1]];
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += (b[k] - a[k]) * (b[k] - a[k]);
    return 0.5 * pair * sum;
}

double kinetic_energy(const model::Bodies& b, const double* velocity) noexcept {
    double sum = 0.0;
    for (std::int32_t body : b.moving) sum += kinetic_energy_of(b, body, velocity);
    return sum;
}

}  // namespace hawser::stepper
