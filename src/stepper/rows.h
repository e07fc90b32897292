// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rows.h
/// Rows read outside of the solver: their speeds, and a look at them that leaves the state alone.

#include "base/index.h"
#include "stepper/context.h"
#include "stepper/step.h"

#include <cstddef>
#include <cstdint>

namespace hawser::stepper {

/// `sum` + G u of one row of an interaction.
/// @param jac  The packed row (packed_rows()); goes on to the next one.
/// @param u, begin  A vector of velocities, and where in it those of each body begin:
///                  v.v and v.dof_begin, or v.solution and v.body_offset.
[[nodiscard]] inline double along_row(const assembly::View& v, std::int32_t id, const double*& jac,
                                      const double* u, const std::int32_t* begin,
                                      double sum = 0.0) noexcept {
    for (int b = 0; b < v.bodies[id]; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        for (int j = 0; j < v.dof[body]; ++j) sum += *jac++ * u[begin[body] + j];
    }
    return sum;
}

/// Which ranges are active: evaluate_rows() decides that afresh, and the state has back what it had
/// when this ends. One at a time, since they share ctx.active_before.
class KeptRanges {
  public:
    explicit KeptRanges(StepContext& ctx) noexcept : ctx_(ctx) {
        for (std::size_t i = 0; i < ctx_.active_before.size(); ++i)
            ctx_.active_before[i] = ctx_.interactions.active[at(ctx_.system.bounded[i])];
    }
    ~KeptRanges() {
        for (std::size_t i = 0; i < ctx_.active_before.size(); ++i)
            ctx_.interactions.active[at(ctx_.system.bounded[i])] = ctx_.active_before[i];
    }
    KeptRanges(const KeptRanges&) = delete;
    KeptRanges& operator=(const KeptRanges&) = delete;

  private:
    StepContext& ctx_;
};

}  // namespace hawser::stepper
