// SPDX-License-Identifier: Apache-2.0
#include "base/isa.h"

#include <hawser/world.h>

#include <cstdlib>
#include <cstring>

namespace hawser::base {
namespace {

Isa detect() noexcept {
    Isa best = Isa::sse2;
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) best = Isa::avx2;
    if (best == Isa::avx2 && __builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw"))
        best = Isa::avx512;
    if (const char* wish = std::getenv("HAWSER_ISA")) {
        for (Isa i : {Isa::sse2, Isa::avx2})
            if (std::strcmp(wish, to_string(i)) == 0 && i < best) best = i;
    }
#if defined(HAWSER_NO_AVX512)
    if (best == Isa::avx512) best = Isa::avx2;
#endif
#if defined(HAWSER_NO_AVX2)
    if (best == Isa::avx2) best = Isa::sse2;
#endif
    return best;
}

}  // namespace

Isa isa() noexcept {
    static const Isa chosen = detect();
    return chosen;
}

const char* to_string(Isa isa) noexcept {
    switch (isa) {
        case Isa::sse2:
            return "sse2";
        case Isa::avx2:
            return "avx2";
        case Isa::avx512:
            return "avx512";
    }
    return "?";
}

}  // namespace hawser::base

namespace hawser {

const char* instruction_set() noexcept { return base::to_string(base::isa()); }

}  // namespace hawser
