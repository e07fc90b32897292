// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stream.h
/// Stores that bypass the caches (factor/kernels.h).

#include <cstdint>

namespace hawser::HAWSER_ISA {

void stream(double* to, const double* from, std::int64_t n) noexcept;

}  // namespace hawser::HAWSER_ISA
