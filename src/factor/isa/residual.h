// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file residual.h
/// Kernel of factor/residual.h.

#include "factor/residual.h"

namespace hawser::HAWSER_ISA {

factor::ResidualSize residual(const factor::ResidualView& view, std::int32_t begin,
                              std::int32_t end) noexcept;

}  // namespace hawser::HAWSER_ISA
