// SPDX-License-Identifier: Apache-2.0
#include "model/line_ends.h"

#include "base/index.h"
#include "model/interactions.h"

#include <algorithm>

namespace hawser::model {

double lightest_end(const InteractionDef& d, const Bodies& b) {
    double most = 0.0;
    const bool rigid = b.dof(d.body[0].index) == 6 && b.dof(d.body[1].index) == 6;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const auto body = at(d.body[slot].index);
        const int dof = b.dof(d.body[slot].index);
        if (dof < 3) continue;
        double end = 1.0 / b.mass[body];
        const Vec3& arm = d.point[slot];
        const double square = arm.squaredNorm();
        if (rigid && square > 0.0) {
            const Eigen::Map<const Mat3> inertia(&b.inertia[9 * body]);
            end += 2.0 * square / (inertia.trace() - arm.dot(inertia * arm) / square);
        }
        for (std::size_t i = 0; i < 3 && dof == 6 && !rigid; ++i)
            end += square * b.inv_inertia[9 * body + 4 * i];
        most = std::max(most, end);
    }
    return most;
}

double wheel_at(const InteractionDef& d, std::size_t slot) noexcept {
    if (d.kind == InteractionKind::Span) return d.params[6 + slot];
    if (d.kind != InteractionKind::EndSpan || slot > 1) return 0.0;
    return (slot == 0) == (d.params[4] > 0.0) ? d.params[6] : 0.0;
}

void Interactions::rewire(int id, std::size_t slot, BodyId to, Bodies& bodies_in) noexcept {
    InteractionDef& d = def[at(id)];
    const bool on_wheel = wheel_at(d, 0) != 0.0 || wheel_at(d, 1) != 0.0;
    const std::array<double, 2> before =
        on_wheel ? wheel_angles(id, bodies_in) : std::array<double, 2>{};
    d.body[slot] = to;
    const std::size_t place = kMaxInteractionBodies * at(id) + slot;
    if (body[place] != to.index) {
        unlink(place, bodies_in);
        body[place] = to.index;
        link(place, bodies_in);
    }
    if (!bodies_in.turns(to.index)) d.point[slot].setZero();
    write_data(id);
    if (on_wheel) update_whole_turns(id, before, bodies_in);
    if (kind_info(d.kind).is(kAlongLine)) lightness[at(id)] = lightest_end(d, bodies_in);
}

void Interactions::set_mass(int id, double mass) noexcept {
    const int param = kind_info(def[at(id)].kind).mass_param;
    if (param < 0) return;
    def[at(id)].params[at(param)] = mass;
    pair_mass[at(id)] = mass / 6.0;
}

}  // namespace hawser::model
