// SPDX-License-Identifier: Apache-2.0
#include "world/wheel_momentum.h"

#include "base/index.h"
#include "context/context.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"

#include <algorithm>

namespace hawser::world {
namespace {

/// Slot of the wheel in the part before it, and in the part behind.
constexpr std::array<std::size_t, 2> kWheelSlot{1, 0};

/// Return the direction of a part from the first end of the wire to the last.
Vec3 direction(const context::StepContext& ctx, std::int32_t part) noexcept {
    return (edit::point_of(ctx, part, 1) - edit::point_of(ctx, part, 0)).normalized();
}

}  // namespace

WireAtWheel read_wire_at_wheel(const context::StepContext& ctx, std::array<std::int32_t, 2> part,
                               double mass) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const model::Bodies& b = ctx.model.bodies;
    const double rest[2] = {in.rest_length[at(part[0])], in.rest_length[at(part[1])]};
    const auto slide = at(b.dof_begin[at(edit::end_of(ctx, part[0], 2))]);
    WireAtWheel out;
    for (const std::size_t end : {0U, 1U}) {
        const double other = rest[1 - end] / std::max(rest[0] + rest[1], 1e-300);
        out.mass[end] = 0.5 * mass * std::clamp(other, 0.0, 1.0);
        const Vec3 u = direction(ctx, part[end]);
        out.speed[end] = edit::speed_of(ctx, part[end], kWheelSlot[end], b.v) + b.v[slide] * u;
        out.ahead[end] =
            edit::speed_of(ctx, part[end], kWheelSlot[end], b.v_start) + b.v_start[slide] * u;
    }
    return out;
}

void divide_momentum(context::StepContext& ctx, std::int32_t lump, const WireAtWheel& wheel,
                     std::size_t end) noexcept {
    model::Bodies& b = ctx.model.bodies;
    const auto dof = at(b.dof_begin[at(lump)]);
    const double share = std::min(1.0, wheel.mass[end] / b.mass[at(lump)]);
    ctx.state.ledger.edited.given -= edit::energy_of_body(ctx, lump);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        b.v[dof + k] += share * (wheel.speed[end][i] - b.v[dof + k]);
        b.v_start[dof + k] += share * (wheel.ahead[end][i] - b.v_start[dof + k]);
    }
    ctx.state.ledger.edited.given += edit::energy_of_body(ctx, lump);
}

void apply_lateral_impulse(context::StepContext& ctx, std::array<std::int32_t, 2> part,
                           const std::array<Vec3, 2>& speed, double mass) noexcept {
    model::Bodies& b = ctx.model.bodies;
    const model::Interactions& in = ctx.model.interactions;
    const std::int32_t body = edit::end_of(ctx, part[0], 1);
    if (b.kind[at(body)] != BodyKind::rigid || !ctx.state.started) return;
    const double first = in.rest_length[at(part[0])];
    const double share = first / std::max(first + in.rest_length[at(part[1])], 1e-300);
    const Vec3 u = (edit::point_of(ctx, part[1], 1) - edit::point_of(ctx, part[0], 0)).normalized();
    const Vec3 relative = (1.0 - share) * speed[0] + share * speed[1] -
                          edit::speed_of(ctx, part[0], kWheelSlot[0], b.v);
    const Vec3 impulse = mass * (relative - relative.dot(u) * u);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> r(&b.r[9 * at(body)]);
    const Eigen::Map<const Vec3> centre(&b.x[3 * at(body)]);
    const Vec3 arm = edit::point_of(ctx, part[0], kWheelSlot[0]) - centre;
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> inverse(
        &b.inv_inertia[9 * at(body)]);
    const Vec3 turn = r * (inverse * (r.transpose() * arm.cross(impulse)));
    const auto dof = at(b.dof_begin[at(body)]);
    ctx.state.ledger.edited.given -= edit::energy_of_body(ctx, body);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        for (double* v : {&b.v[dof], &b.v_start[dof]}) {
            v[k] += impulse[i] / b.mass[at(body)];
            v[3 + k] += turn[i];
        }
    }
    ctx.state.ledger.edited.given += edit::energy_of_body(ctx, body);
}

}  // namespace hawser::world
