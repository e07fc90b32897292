// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rows.h
/// Rows read outside of the solver: their speeds, and a look at them that leaves the state alone.

#include "assembly/view.h"
#include "base/index.h"

#include <cstddef>
#include <cstdint>
#include <span>

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

/// G v₊ of a one-row interaction.
[[nodiscard]] double row_speed(const assembly::View& v, std::int32_t id) noexcept;

/// Which ranges are active: evaluate_rows() decides that afresh, and the state has back what it had
/// when this ends.
class KeptRanges {
  public:
    /// @param room  For a number of each of the interactions that may be inactive. One of these at
    ///              a time has it.
    KeptRanges(std::span<double> room, double* active,
               std::span<const std::int32_t> bounded) noexcept
        : room_(room), active_(active), bounded_(bounded) {
        for (std::size_t i = 0; i < room_.size(); ++i) room_[i] = active_[at(bounded_[i])];
    }
    ~KeptRanges() {
        for (std::size_t i = 0; i < room_.size(); ++i) active_[at(bounded_[i])] = room_[i];
    }
    KeptRanges(const KeptRanges&) = delete;
    KeptRanges& operator=(const KeptRanges&) = delete;

  private:
    std::span<double> room_;
    double* active_;
    std::span<const std::int32_t> bounded_;
};

}  // namespace hawser::stepper
