// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rows.h
/// Loops over interactions: evaluation and residuals.

#include "assembly/kernels.h"
#include "base/small.h"

namespace hawser::HAWSER_ISA {

void evaluate(const assembly::View&, InteractionKind, const std::int32_t*, const void*,
              std::int32_t, std::int32_t) noexcept;
assembly::Turning complete_rows(const assembly::View&, InteractionKind, const std::int32_t*,
                                const void*, std::int32_t, std::int32_t, const double*,
                                bool) noexcept;
assembly::Turning complete_spins(const assembly::View&, std::int32_t, std::int32_t, const double*,
                                 bool) noexcept;
void adopt_completed(const assembly::View&, const std::int32_t*, std::int32_t,
                     std::int32_t) noexcept;
void adopt_spins(const assembly::View&, std::int32_t, std::int32_t) noexcept;
void row_update(const assembly::View&, std::int32_t, std::int32_t, bool) noexcept;
void row_norms(const assembly::View&, std::int32_t, std::int32_t, assembly::Norms*) noexcept;
double row_losses(const assembly::View&, std::int32_t, std::int32_t, std::int32_t*, int*) noexcept;

void line_gains(const assembly::View&, const std::int32_t*, std::int32_t,
                assembly::LineGain*) noexcept;

void body_terms(const assembly::View&, std::int32_t, std::int32_t) noexcept;
void first_rhs(const assembly::View&, std::int32_t, std::int32_t, bool) noexcept;
void first_body_rhs(const assembly::View&, std::int32_t, std::int32_t, bool) noexcept;
void body_rhs(const assembly::View&, std::int32_t, std::int32_t) noexcept;
void add_solution(const assembly::View&, std::int32_t, std::int32_t) noexcept;
/// Compute a − M̃ v₊ + Gᵀλ of a body, `dof` entries of the output.
void momentum_residual(const assembly::View&, std::int32_t, double*) noexcept;
void body_norms(const assembly::View&, std::int32_t, std::int32_t, assembly::Norms*) noexcept;
std::int32_t rigid_energies(const assembly::View&, const std::int32_t*, std::int32_t, const double*,
                            double, assembly::BodyEnergies*) noexcept;
std::int32_t widest_row(const double*, const double*, std::int32_t, std::int32_t, double*) noexcept;
void integrate(const assembly::View&, std::int32_t, std::int32_t) noexcept;

void gather_blocks(const assembly::View&, const assembly::Op*, std::int64_t, std::int64_t,
                   double*) noexcept;
void gather_lane_blocks(const assembly::View&, const assembly::LaneOp*, std::int64_t, std::int64_t,
                        double*) noexcept;

}  // namespace hawser::HAWSER_ISA
