// SPDX-License-Identifier: Apache-2.0
#include "marine/memory_sums.h"

#include "base/isa.h"

namespace hawser::marine {

const MemoryKernels& memory_kernels() noexcept {
    switch (base::isa()) {
        case base::Isa::avx512:
#if !defined(HAWSER_NO_AVX512)
            return avx512::kMemoryKernels;
#endif
        case base::Isa::avx2:
#if !defined(HAWSER_NO_AVX2)
            return avx2::kMemoryKernels;
#endif
        case base::Isa::sse2:
            break;
    }
    return sse2::kMemoryKernels;
}

}  // namespace hawser::marine
