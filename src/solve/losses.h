// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file losses.h
/// Energy that rows absorb.
///
/// An elastic row with violation g and rate ġ has the half-step violations g⁻ = g − hġ/2 and g⁺ = g
/// + hġ₊/2. Its impulse is λ = −(h/ε)((g⁻ + g⁺)/2 + τr), r = θġ₊ + (1 − θ)ġ (model/damping.h). So
/// the energy −λ(ġ + ġ₊)/2 that it absorbs from the motion is exactly (g⁺² − g⁻²)/2ε, stored, plus
/// τr(g⁺ − g⁻)/ε, lost.

#include "context/context.h"

namespace hawser::solve {

/// Return the energy lost in rows in the step [J], see Energy::damped: the energy absorbed from the
/// motion less the increase of the stored energy. Call before velocities are overwritten.
[[nodiscard]] double row_losses(context::Model& model, context::SolveWork& solve,
                                runtime::Pool& pool) noexcept;

/// Return the contribution of interactions [begin, end) of a row block to row_losses(). The norms
/// of a solution are computed at the same time, while rows are in the cache
/// (SolveWork::losses_known).
[[nodiscard]] double losses_between(const context::Model& model, const assembly::View& v,
                                    std::int32_t begin, std::int32_t end) noexcept;

/// Return the energy lost in the rows of a cut interaction, with the mean of the impulses of both
/// sides (split/cuts.h) [J].
[[nodiscard]] double cut_losses(context::Model& model, std::int32_t id) noexcept;

/// Return the elastic energy of a line at the half-step position after the step [J]. It is lost if
/// the line breaks.
[[nodiscard]] double held_by_line(context::Model& model, std::int32_t id) noexcept;

}  // namespace hawser::solve
