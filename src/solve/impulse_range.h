// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impulse_range.h
/// Impulses that rows with a bounded force may have, for loads as they are at hand (bounds.h).

#include "context/context.h"

namespace hawser::stepper {

struct ImpulseRange {
    double low, high;  ///< [N s or N m s]
};
/// Impulses that the first row of an interaction may have, for loads as they are at hand. Ends
/// that inputs have crossed are both the upper one.
[[nodiscard]] ImpulseRange impulse_range(const Model& model, const Newton& newton,
                                         std::int32_t id) noexcept;

/// λ w/(h P) − 1 of a motor with a limit of power P: above 0 it drives with more than that.
[[nodiscard]] double power_excess(const Model& model, const Newton& newton,
                                  std::int32_t id) noexcept;

}  // namespace hawser::stepper
