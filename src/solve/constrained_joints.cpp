// SPDX-License-Identifier: Apache-2.0
#include "solve/constrained_joints.h"

#include "base/index.h"
#include "context/copies.h"
#include "context/timer.h"
#include "context/view.h"
#include "solve/joints.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

using assembly::View;

/// Largest number of joints that are measured in a step. A measurement costs three substitutions
/// for each of the two bodies.
constexpr std::size_t kMaxMeasured = 16;
constexpr std::int64_t kEvery = 16;  ///< Steps between measurements.
/// Ratio up to which other joints hold a body. A link of a chain of equal links has 0.2 to 1.
constexpr double kHeld = 0.125;

/// Return the largest code whose ratio is at least `ratio`.
std::uint8_t code_of(double ratio) noexcept {
    std::uint8_t code = kConstrained;
    while (code < 255 && constrained_ratio(static_cast<std::uint8_t>(code + 1)) >= ratio) ++code;
    return code;
}

/// Return an upper bound of the geometric terms in the rotation of a body (assembly/geo.h) [kg m²].
double geometric_terms(const context::Model& model, std::int32_t body) noexcept {
    const model::Interactions& in = model.interactions;
    const double h = model.def.step;
    const double stiff = 0.375 * model.def.geometric_stiffness;
    const double damping = 20.0 * model.def.rotation_damping;
    double sum = 0.0;
    in.for_each_holder(body, model.bodies, [&](int id, std::size_t) {
        double square = 0.0, arm = 0.0, least = HUGE_VAL;
        const std::int32_t row = in.row_begin[at(id)];
        for (std::int32_t r = row; r < row + std::min<std::int32_t>(in.rows[at(id)], 3); ++r)
            square += in.lambda[at(r)] * in.lambda[at(r)];
        for (int b = 0; b < std::min<int>(in.bodies[at(id)], 2); ++b) {
            const double length = in.def[at(id)].point[at(b)].norm();
            if (in.body[at(kMaxInteractionBodies * id + b)] == body) arm = std::max(arm, length);
            least = std::min(least, length);
        }
        sum += h * std::sqrt(square) * (stiff * arm + damping * least);
    });
    return sum;
}

/// Return the largest response of a body to a unit torque across an arm [1/(kg m²)]; negative if
/// the solution is not finite. @param arm  World frame.
double turning_response(context::StepContext& ctx, const View& v, std::int32_t body,
                        const Vec3& arm) noexcept {
    const Vec3 first = arm.unitOrthogonal(), second = arm.normalized().cross(first);
    const Vec3 across[2] = {first, second};
    double w[2][2];
    for (int k = 0; k < 2; ++k) {
        std::fill_n(v.solution, ctx.model.system.symbolic.scalars, 0.0);
        double* turn = v.solution + v.body_offset[body] + 3;
        for (int i = 0; i < 3; ++i) turn[i] = across[k][i];
        ctx.model.system.numeric.solve(ctx.model.system.symbolic, v.solution, ctx.pool);
        ++ctx.work.stats.substitutions;
        const Eigen::Map<const Vec3> u(turn);
        for (int i = 0; i < 2; ++i) w[i][k] = across[i].dot(u);
    }
    ctx.work.solve.rhs_ready = false;
    const double mean = 0.5 * (w[0][0] + w[1][1]), half = 0.5 * (w[0][0] - w[1][1]);
    const double mixed = 0.5 * (w[0][1] + w[1][0]);
    const double most = mean + std::sqrt(half * half + mixed * mixed);
    return std::isfinite(most) ? most : -1.0;
}

/// Return max r/Ĩ over the bodies of a joint [1/(kg m)], at most its free rate.
double constrained_rate(context::StepContext& ctx, const View& v, std::size_t k) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const std::int32_t id = ctx.model.completion.joints[k];
    const double free = ctx.model.completion.rates[k];
    double most = 0.0;
    for (int b = 0; b < std::min<int>(in.bodies[at(id)], 2); ++b) {
        const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
        if (v.dof[body] == 3) return free;  // a rod between point masses
        const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(
            &ctx.model.bodies.r[at(9 * body)]);
        const Vec3 arm = turn * in.def[at(id)].point[at(b)];
        const double length = arm.norm();
        if (v.dof[body] != 6 || length == 0.0) continue;
        const double response = turning_response(ctx, v, body, arm);
        const double inertia = 1.0 / response - geometric_terms(ctx.model, body);
        if (!(response > 0.0 && inertia > 0.0)) return free;
        most = std::max(most, length / inertia);
    }
    return std::min(most, free);
}

/// Return s² of a joint whose bodies turn freely.
double free_vibration(const context::Model& model, std::size_t k) noexcept {
    const context::Completion& c = model.completion;
    const double rate = model.def.step * c.rates[k];
    return rate * rate * squared_impulse(c.joint_slots[k], model.interactions.lambda.data());
}

/// True if a joint is to be measured in this step: when it has become too fast, and at intervals.
bool needs_measurement(const context::State& state, const context::Model& model,
                       std::size_t k) noexcept {
    constexpr double kMaximum = kResolvedVibration * kResolvedVibration;
    if (free_vibration(model, k) <= kMaximum) return false;
    const std::int32_t id = model.completion.joints[k];
    return model.interactions.coarse[at(id)] == 0 || state.step % kEvery == 0;
}

}  // namespace

void measure_constrained_joints(context::StepContext& ctx) noexcept {
    context::Completion& c = ctx.model.completion;
    if (context::has_cuts(ctx.model) || ctx.model.def.nonsmooth != Nonsmooth::newton) return;
    std::size_t count = 0;
    for (std::size_t k = 0; k < c.joints.size(); ++k)
        if (needs_measurement(ctx.state, ctx.model, k)) ++count;
    if (count == 0 || count > kMaxMeasured) return;
    const context::StageTimer timer(ctx, Stage::factor);
    const View v = context::view(ctx);
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        if (!needs_measurement(ctx.state, ctx.model, k)) continue;
        const double ratio = constrained_rate(ctx, v, k) / c.rates[k];
        if (!(ratio <= kHeld)) continue;
        const std::uint8_t code = code_of(ratio);
        // A force may grow until the next measurement.
        constexpr double kMaximum = 0.25 * kResolvedVibration * kResolvedVibration;
        const double least = constrained_ratio(code);
        if (least * least * free_vibration(ctx.model, k) <= kMaximum) c.coarse_next[k] = code;
    }
}

}  // namespace hawser::solve
