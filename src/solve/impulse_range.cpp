// SPDX-License-Identifier: Apache-2.0
#include "solve/impulse_range.h"

#include "base/index.h"
#include "context/newton_data.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

/// What others add to the bound of friction, by their impulses at hand [N s].
double load_of(const Model& model, std::int32_t id) noexcept {
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

}  // namespace

ImpulseRange impulse_range(const Model& model, const Newton& newton, std::int32_t id) noexcept {
    const model::Interactions& in = model.interactions;
    const int flags = in.flags[at(id)];
    if (in.parted[at(id)] || model.wires.gives_way(id)) return {0.0, 0.0};
    if (flags & model::kRange) {
        constexpr double kAll = model::kUnbounded;
        const double g = in.g[at(in.row_begin[at(id)])];
        return {g > 0.0 ? -kAll : 0.0, g < 0.0 ? kAll : 0.0};
    }
    // A line's force has no bound in an impact either.
    const double time = flags & (model::kMotor | model::kFriction) ? newton.bound_time : 1.0;
    ImpulseRange range{time * in.low[at(id)], time * in.high[at(id)]};
    if (flags & model::kFriction) {
        const double load = load_of(model, id);
        range.low -= load;
        range.high += load;
    }
    range.low = std::min(range.low, range.high);
    return range;
}

}  // namespace hawser::stepper
