// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file substitution.h
/// Forward and backward substitution with fronts. factor/kernels.h documents each.

#include "factor/kernels.h"

namespace hawser::HAWSER_ISA {

void forward_fronts(const factor::FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                    double* scratch) noexcept;
void backward_fronts(const factor::FactorView& view, std::int32_t begin, std::int32_t end,
                     double* x, double* scratch) noexcept;

}  // namespace hawser::HAWSER_ISA
