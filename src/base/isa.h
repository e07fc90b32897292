// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file isa.h
/// Choice of the instruction set, once per process.

#include <cstdint>
#include <string>

namespace hawser::base {

enum class Isa : std::uint8_t { sse2, avx2, avx512 };

/// An instruction set, and the problem with the requested one ("" if none).
struct IsaChoice {
    Isa isa;
    std::string problem;
};

/// Choose the requested instruction set, which must not exceed `best`. @param wish  Name of the
/// instruction set; null or empty: use `best`.
[[nodiscard]] IsaChoice choose_isa(const char* wish, Isa best);

/// Return the instruction set that the environment variable HAWSER_ISA names. If it is unset or
/// names none, return the best one that processor and build support.
[[nodiscard]] Isa isa() noexcept;
/// Check HAWSER_ISA. @throws EnvironmentError if HAWSER_ISA names no available instruction set.
void require_isa();
[[nodiscard]] const char* to_string(Isa isa) noexcept;

/// Return the kernel table of the instruction set in use. No table may be null.
template <class Kernels>
[[nodiscard]] const Kernels& chosen(const Kernels* sse2, const Kernels* avx2,
                                    const Kernels* avx512) noexcept {
    switch (isa()) {
        case Isa::avx512:
            return *avx512;
        case Isa::avx2:
            return *avx2;
        case Isa::sse2:
            break;
    }
    return *sse2;
}

}  // namespace hawser::base

// Instruction sets outside this build use the tables of SSE2.
namespace hawser::sse2 {}
namespace hawser::avx2 {}
namespace hawser::avx512 {}
namespace hawser {
#if defined(HAWSER_NO_AVX2)
namespace with_avx2 = sse2;
#else
namespace with_avx2 = avx2;
#endif
#if defined(HAWSER_NO_AVX512)
namespace with_avx512 = sse2;
#else
namespace with_avx512 = avx512;
#endif
}  // namespace hawser
