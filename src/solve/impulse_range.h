// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impulse_range.h
/// Allowed impulses of rows with a bounded force, for the current loads (bounds.h).

#include "context/context.h"

namespace hawser::solve {

struct ImpulseRange {
    double low, high;  ///< [N s or N m s]
};
/// Return the allowed impulses of the first row of an interaction, for the current loads. If inputs
/// have set a minimum above the maximum, both ends are equal to the maximum.
[[nodiscard]] ImpulseRange impulse_range(const context::Model& model, const context::Newton& newton,
                                         std::int32_t id) noexcept;

/// Return λ w/(h P) − 1 of a motor with a power limit P: positive if it exceeds the limit.
[[nodiscard]] double power_excess(const context::Model& model, const context::Newton& newton,
                                  std::int32_t id) noexcept;

}  // namespace hawser::solve
