// SPDX-License-Identifier: Apache-2.0
#include "marine/hull_kernels.h"

#include "base/isa.h"

namespace hawser::marine {

const HullKernels& hull_kernels() noexcept {
    return base::chosen(&sse2::kHullKernels, &with_avx2::kHullKernels, &with_avx512::kHullKernels);
}

}  // namespace hawser::marine
