// SPDX-License-Identifier: Apache-2.0
#include "marine/hull_kernels.h"

#include "base/isa.h"

namespace hawser::marine {

const HullKernels& hull_kernels() noexcept {
    switch (base::isa()) {
        case base::Isa::avx512:
#if !defined(HAWSER_NO_AVX512)
            return avx512::kHullKernels;
#endif
        case base::Isa::avx2:
#if !defined(HAWSER_NO_AVX2)
            return avx2::kHullKernels;
#endif
        case base::Isa::sse2:
            break;
    }
    return sse2::kHullKernels;
}

}  // namespace hawser::marine
