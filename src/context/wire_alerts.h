// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_alerts.h
/// Transfer the modes of wires to their elements: rejected wires are flagged and damped for a
/// while, broken wires recoil.

#include "context/context.h"
#include "context/wires_data.h"

#include <algorithm>

namespace hawser::context {

/// Return the number of steps for which a wire stays damped after it was rejected.
[[nodiscard]] std::int32_t max_flag_steps(double step) noexcept;

/// Return the largest number of steps for which a broken wire recoils.
[[nodiscard]] std::int32_t max_recoil(double step) noexcept;

/// Start the recoil of a wire when an element breaks. It begins with the next step and lasts for
/// the travel time of a wave from end to end (docs/theory/parting.md). Elements added since the
/// last preparation belong to no wire yet.
/// @param fresh  True if the wires are up to date: nothing was added or removed since.
void begin_recoil(Model& model, std::int32_t id, bool fresh) noexcept;

/// Return the longer of two remaining durations of recoil, in steps. An unknown duration counts as
/// longest.
[[nodiscard]] inline std::int32_t longer_recoil(std::int32_t a, std::int32_t b) noexcept {
    return a < 0 || b < 0 ? Wires::kBeginsToRecoil : std::max(a, b);
}

/// Copy the flags and recoils of wires to their elements after a restore. Invalid values are
/// repaired.
void update_wire_flags(Model& model) noexcept;

}  // namespace hawser::context
