// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file batch.h
/// Kernels of factor/batches.h, see factor/kernels.h for what each does. There are instances for
/// double and float.

#include "factor/kernels.h"

namespace hawser::HAWSER_ISA {

template <class Real>
int factor_batch(const factor::FactorView<Real>& view, const factor::Batch& batch,
                 std::int32_t begin, std::int32_t end, Real* scratch) noexcept;
template <class Real>
void forward_batch(const factor::FactorView<Real>& view, const factor::Batch& batch,
                   std::int32_t begin, std::int32_t end, const Real* x, Real* scratch) noexcept;
template <class Real>
void backward_batch(const factor::FactorView<Real>& view, const factor::Batch& batch, Real* x,
                    Real* scratch) noexcept;

}  // namespace hawser::HAWSER_ISA
