// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file losses.h
/// Energy that rows take. An elastic row with violation g and rate ġ, at half-step positions
/// g⁻ = g − hġ/2 and g⁺ = g + hġ₊/2, has the impulse λ = −(h/ε)((g⁻ + g⁺)/2 + τr), r = θġ₊ + (1 −
/// θ)ġ (model/damping.h), so that −λ(ġ + ġ₊)/2, taken from the motion, is exactly (g⁺² − g⁻²)/2ε,
/// held, plus τr(g⁺ − g⁻)/ε, lost.

#include "context/context.h"

namespace hawser::stepper {

/// Energy that rows took in the step [J], see Energy::damped: what their impulses took from the
/// motion less what elastic rows hold more than before. Before velocities are overwritten.
[[nodiscard]] double row_losses(Model& model, SolveWork& solve, runtime::Pool& pool) noexcept;

/// Share of interactions [begin, end) of a strip. A solution's norms are taken with it, while rows
/// are in the cache (SolveWork::losses_known).
[[nodiscard]] double losses_between(const Model& model, const assembly::View& v, std::int32_t begin,
                                    std::int32_t end) noexcept;

/// What the rows of a cut interaction took, with the mean of its sides' impulses (split/cuts.h)
/// [J].
[[nodiscard]] double cut_losses(Model& model, std::int32_t id) noexcept;

/// What a line holds at the half-step position after the step [J]: lost when it parts.
[[nodiscard]] double held_by_line(Model& model, std::int32_t id) noexcept;

}  // namespace hawser::stepper
