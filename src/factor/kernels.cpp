// SPDX-License-Identifier: Apache-2.0
#include "factor/kernels.h"

#include "base/isa.h"

namespace hawser::factor {

const Kernels& factor_kernels() noexcept {
    switch (base::isa()) {
        case base::Isa::avx512:
#if !defined(HAWSER_NO_AVX512)
            return avx512::kKernels;
#endif
        case base::Isa::avx2:
#if !defined(HAWSER_NO_AVX2)
            return avx2::kKernels;
#endif
        case base::Isa::sse2:
            break;
    }
    return sse2::kKernels;
}

}  // namespace hawser::factor
