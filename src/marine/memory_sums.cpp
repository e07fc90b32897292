// SPDX-License-Identifier: Apache-2.0
#include "marine/memory_sums.h"

#include "base/isa.h"

namespace hawser::marine {

const MemoryKernels& memory_kernels() noexcept {
    return base::chosen(&sse2::kMemoryKernels, &with_avx2::kMemoryKernels,
                        &with_avx512::kMemoryKernels);
}

}  // namespace hawser::marine
