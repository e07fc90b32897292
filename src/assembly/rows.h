// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rows.h
/// Read rows outside the solver: compute their speeds, and evaluate them without a change of the
/// state.

#include "assembly/view.h"
#include "base/index.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser::assembly {

/// Return `sum` + G u of one row of an interaction.
/// @param jac  The packed row (packed_rows()); advanced to the next row.
/// @param u, begin  A vector of velocities, and the offset of each body in it. Either v.v and
/// v.dof_begin, or v.solution and v.body_offset.
[[nodiscard]] inline double along_row(const assembly::View& v, std::int32_t id, const double*& jac,
                                      const double* u, const std::int32_t* begin,
                                      double sum = 0.0) noexcept {
    for (int b = 0; b < v.bodies[id]; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        for (int j = 0; j < v.dof[body]; ++j) sum += *jac++ * u[begin[body] + j];
    }
    return sum;
}

/// Return G v₊ of an interaction with one row.
[[nodiscard]] double row_speed(const assembly::View& v, std::int32_t id) noexcept;

/// Guard of the active flags of ranges. evaluate_rows() overwrites these flags; the destructor
/// restores their values.
class KeptRanges {
  public:
    /// Save the active flags of bounded rows; the destructor restores them.
    /// @param buffer  Buffer with one value for each interaction that may be inactive. Only one
    /// guard at a time may use it.
    KeptRanges(std::span<double> buffer, double* active,
               std::span<const std::int32_t> bounded) noexcept
        : buffer_(buffer), active_(active), bounded_(bounded) {
        for (std::size_t i = 0; i < buffer_.size(); ++i) buffer_[i] = active_[at(bounded_[i])];
    }
    ~KeptRanges() {
        for (std::size_t i = 0; i < buffer_.size(); ++i) active_[at(bounded_[i])] = buffer_[i];
    }
    KeptRanges(const KeptRanges&) = delete;
    KeptRanges& operator=(const KeptRanges&) = delete;

  private:
    std::span<double> buffer_;
    double* active_;
    std::span<const std::int32_t> bounded_;
};

}  // namespace hawser::assembly
