// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file substitution.h
/// Forward and backward substitution with fronts, see factor/kernels.h for what each does. There
/// are instances for double and float.

#include "factor/kernels.h"

namespace hawser::HAWSER_ISA {

template <class Real>
void forward_fronts(const factor::FactorView<Real>& view, std::int32_t begin, std::int32_t end,
                    Real* x, Real* scratch) noexcept;
template <class Real>
void backward_fronts(const factor::FactorView<Real>& view, std::int32_t begin, std::int32_t end,
                     Real* x, Real* scratch) noexcept;

}  // namespace hawser::HAWSER_ISA
