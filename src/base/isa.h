// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file isa.h
/// Which instruction set to use; decided once per process.

#include <cstdint>

namespace hawser::base {

enum class Isa : std::uint8_t { sse2, avx2, avx512 };

/// Best the processor offers, lowered by the environment variable HAWSER_ISA if that names a
/// lesser one.
[[nodiscard]] Isa isa() noexcept;
[[nodiscard]] const char* to_string(Isa isa) noexcept;

}  // namespace hawser::base
