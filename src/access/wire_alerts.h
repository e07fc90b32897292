// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_alerts.h
/// Wires that have been refused are stepped more calmly for a while, wires that have parted recoil:
/// their elements know of it.

#include "context/context.h"
#include "context/wires_data.h"

#include <algorithm>

namespace hawser::stepper {

/// Steps that a wire is stepped more calmly for after it has been refused.
[[nodiscard]] std::int32_t most_alert(double step) noexcept;

/// Steps that a wire recoils at most after it has parted.
[[nodiscard]] std::int32_t most_recoil(double step) noexcept;

/// An element parts: its wire recoils for as long as a wave along takes from end to end, from the
/// next step on (docs/wires.md). Elements that are new since the last preparation have no wire yet.
/// @param fresh  Wires are those of the model as it is: nothing was added or removed since.
void begin_recoil(Model& model, std::int32_t id, bool fresh) noexcept;

/// The longer one of Wires::recoil; what is still to be found counts as longest.
[[nodiscard]] inline std::int32_t longer_recoil(std::int32_t a, std::int32_t b) noexcept {
    return a < 0 || b < 0 ? Wires::kBeginsToRecoil : std::max(a, b);
}

/// What a restored state says of alerts and recoils becomes the elements'; what cannot be is
/// mended.
void follow_alerts(Model& model) noexcept;

}  // namespace hawser::stepper
