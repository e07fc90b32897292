// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bits.h
/// Sets of nodes as rows of bits (factor/minimum_degree.h).

#include "factor/kernels.h"

#include <cstdint>

namespace hawser::HAWSER_ISA {

void unite_rows(std::uint64_t* rows, std::int32_t words, const std::int32_t* nodes,
                std::int32_t count, const std::uint64_t* with, const std::uint64_t* among,
                const factor::NodeWeights& weights, std::int32_t* sizes,
                std::uint64_t* folds) noexcept;

}  // namespace hawser::HAWSER_ISA
