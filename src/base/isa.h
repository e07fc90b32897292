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

/// The table of kernels of the instruction set in use; each of the three is there.
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

// What is not in this build has the tables of SSE2.
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
