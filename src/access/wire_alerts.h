// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_alerts.h
/// Wires that have been refused are stepped more calmly for a while: their elements know of it.

#include "context/context.h"

namespace hawser::stepper {

/// Steps that a wire is stepped more calmly for after it has been refused.
[[nodiscard]] std::int32_t most_alert(double step) noexcept;

/// What a restored state says of alerts becomes the elements'; what cannot be is mended.
void follow_alerts(Model& model) noexcept;

}  // namespace hawser::stepper
