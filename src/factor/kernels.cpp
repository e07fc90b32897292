// SPDX-License-Identifier: Apache-2.0
#include "factor/kernels.h"

#include "base/isa.h"

namespace hawser::factor {

const Kernels& factor_kernels() noexcept {
    return base::chosen(&sse2::kKernels, &with_avx2::kKernels, &with_avx512::kKernels);
}

}  // namespace hawser::factor
