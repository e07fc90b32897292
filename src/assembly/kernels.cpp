// SPDX-License-Identifier: Apache-2.0
#include "assembly/view.h"
#include "base/isa.h"

namespace hawser::assembly {

const Kernels& kernels() noexcept {
    switch (base::isa()) {
        case base::Isa::avx512:
            return avx512::kAssemblyKernels;
        case base::Isa::avx2:
#if !defined(HAWSER_NO_AVX2)
            return avx2::kAssemblyKernels;
#endif
        case base::Isa::sse2:
            break;
    }
    return sse2::kAssemblyKernels;
}

}  // namespace hawser::assembly
