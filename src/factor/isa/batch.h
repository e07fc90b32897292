// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file batch.h
/// Kernels of factor/batches.h. factor/kernels.h documents each.

#include "factor/kernels.h"

namespace hawser::HAWSER_ISA {

int factor_batch(const factor::FactorView& view, const factor::Batch& batch, std::int32_t begin,
                 std::int32_t end, double* scratch) noexcept;
void forward_batch(const factor::FactorView& view, const factor::Batch& batch, std::int32_t begin,
                   std::int32_t end, const double* x, double* scratch) noexcept;
void backward_batch(const factor::FactorView& view, const factor::Batch& batch, double* x,
                    double* scratch) noexcept;

}  // namespace hawser::HAWSER_ISA
