// SPDX-License-Identifier: Apache-2.0
#include "factor/isa/stream.h"

#include "base/simd.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace hawser::HAWSER_ISA {

void stream(double* to, const double* from, std::int64_t n) noexcept {
    for (std::int64_t i = 0; i < n; i += kLanes) {
#if defined(__AVX512F__)
        _mm512_stream_pd(to + i, load(from + i));
#elif defined(__SSE2__)
        for (int k = 0; k < kLanes; k += 2) _mm_stream_pd(to + i + k, _mm_load_pd(from + i + k));
#else
        store(to + i, load(from + i));
#endif
    }
#if defined(__SSE2__)
    _mm_sfence();
#endif
}

}  // namespace hawser::HAWSER_ISA
