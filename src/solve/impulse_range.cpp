// SPDX-License-Identifier: Apache-2.0
#include "solve/impulse_range.h"

#include "assembly/rows.h"
#include "base/index.h"
#include "context/newton_data.h"
#include "context/view.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

/// Return the sum of the impulses on which the bound of a friction depends [N s].
double load_of(const context::Model& model, std::int32_t id) noexcept {
    const model::Interactions& in = model.interactions;
    if (in.load_begin[at(id)] < 0) return 0.0;
    double sum = 0.0;
    for (int i = 0; i < kMaxFrictionLoads; ++i) {
        const model::Load& load = in.loads[at(in.load_begin[at(id)] + i)];
        double square = 0.0;
        for (std::int32_t r = load.row_begin; r < load.row_begin + load.rows; ++r)
            square += in.lambda[at(r)] * in.lambda[at(r)];
        sum += load.factor * std::sqrt(square);
    }
    return sum;
}

/// Return the impulse λ with which a motor drives with power P at the resulting speed:
/// ```
///     λ (w + W (λ − λ_k)) = h P        λ_k, w present impulse and speed, W mobility of the row
/// ```
/// This is the positive root. It is exact if W is the mobility of the whole system. A larger W
/// converges to the same λ over the iterations, since λ = λ_k there.
double impulse_of_power(double work, double w, double lambda, double mobility) noexcept {
    const double b = w - mobility * lambda;
    const double root = std::sqrt(b * b + 4.0 * mobility * work);
    // This form avoids cancellation.
    return b > 0.0 ? 2.0 * work / (b + root) : (root - b) / (2.0 * mobility);
}

/// Return the speed of the first row of an interaction at the current velocities.
double speed_of_row(const context::Model& model, std::int32_t id) noexcept {
    return assembly::row_speed(context::row_view(const_cast<context::Model&>(model)),
                               id);  // reads only
}

/// Limit both ends of a motor's range to the impulses that its power allows. If both ends of the
/// range have one sign and exceed these impulses (a rendering winch that pulls between two
/// tensions), the range shrinks to the power limit.
void limit_power(const context::Model& model, const context::Newton& newton, std::int32_t id,
                 ImpulseRange& range) noexcept {
    const model::Interactions& in = model.interactions;
    const double work = newton.bound_time * in.power[at(id)];
    const auto found =
        std::lower_bound(model.system.bounded.begin(), model.system.bounded.end(), id);
    if (found == model.system.bounded.end() || *found != id) return;
    const double mobility = model.system.bounded_mobility[at(found - model.system.bounded.begin())];
    const double w = speed_of_row(model, id), lambda = in.lambda[at(in.row_begin[at(id)])];
    const double most = impulse_of_power(work, w, lambda, mobility);
    const double least = -impulse_of_power(work, -w, -lambda, mobility);
    range = {std::clamp(range.low, least, most), std::clamp(range.high, least, most)};
}

}  // namespace

double power_excess(const context::Model& model, const context::Newton& newton,
                    std::int32_t id) noexcept {
    const model::Interactions& in = model.interactions;
    const double lambda = in.lambda[at(in.row_begin[at(id)])];
    const double work = lambda * speed_of_row(model, id);
    return work / (newton.bound_time * in.power[at(id)]) - 1.0;
}

ImpulseRange impulse_range(const context::Model& model, const context::Newton& newton,
                           std::int32_t id) noexcept {
    const model::Interactions& in = model.interactions;
    const int flags = in.flags[at(id)];
    if (in.parted[at(id)] || model.wires.is_replaced(id)) return {0.0, 0.0};
    if (flags & model::kRange) {
        constexpr double kNoBound = model::kUnbounded;
        if (in.low[at(id)] + in.high[at(id)] <= model::kNoWidth) return {-kNoBound, kNoBound};
        const bool upper = in.upper[at(id)] != 0;
        // In an impact only an end acts that the coordinate has reached.
        const double inside = upper ? in.high[at(id)] : in.low[at(id)];
        if (newton.bound_time == 0.0 && inside > 0.0) return {0.0, 0.0};
        return {upper ? -kNoBound : 0.0, upper ? 0.0 : kNoBound};
    }
    // The force of a line is also unbounded in an impact.
    const double time = flags & (model::kMotor | model::kFriction) ? newton.bound_time : 1.0;
    ImpulseRange range{time * in.low[at(id)], time * in.high[at(id)]};
    if ((flags & model::kMotor) && in.power[at(id)] < model::kUnbounded && time > 0.0)
        limit_power(model, newton, id, range);
    if (flags & model::kFriction) {
        const double load = load_of(model, id);
        range.low -= load;
        range.high += load;
    }
    range.low = std::min(range.low, range.high);
    return range;
}

}  // namespace hawser::solve
