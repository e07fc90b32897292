// SPDX-License-Identifier: Apache-2.0
#include "assembly/kinetic.h"

namespace hawser::assembly {

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

}  // namespace hawser::assembly
