// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_laws.h
/// Laws of contacts and resistances about an iterate, and how far an iterate is from obeying them.

#include "context/context.h"

namespace hawser::stepper {

/// Linear laws of all contacts about the iterate. @return contacts whose status changed.
std::int32_t linearise(Model& model, Work& work, runtime::Pool& pool) noexcept;
/// Σ (W + Σ) ‖λ − P‖² over all, a share t of the way: an energy [J].
[[nodiscard]] double merit(const Model& model, const Newton& newton, double t) noexcept;

}  // namespace hawser::stepper
