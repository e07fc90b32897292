// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file isa.h
/// Which instruction set to use; decided once per process.

#include <cstdint>
#include <string>

namespace hawser::base {

enum class Isa : std::uint8_t { sse2, avx2, avx512 };

/// An instruction set, and what is wrong with the wish for it; "": nothing.
struct IsaChoice {
    Isa isa;
    std::string problem;
};

/// The wish, which names one up to the best; null or empty: the best.
[[nodiscard]] IsaChoice choose_isa(const char* wish, Isa best);

/// What the environment variable HAWSER_ISA names, else the best that processor and build offer;
/// that too where it names none.
[[nodiscard]] Isa isa() noexcept;
/// @throws EnvironmentError where HAWSER_ISA names none that there is.
void require_isa();
[[nodiscard]] const char* to_string(Isa isa) noexcept;

}  // namespace hawser::base
