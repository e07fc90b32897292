// SPDX-License-Identifier: Apache-2.0
#include "marine/fast_wave_sums.h"

#include "base/isa.h"

namespace hawser::marine {

const FastWaveKernels& fast_wave_kernels() noexcept {
    return base::chosen(&sse2::kFastWaveKernels, &with_avx2::kFastWaveKernels,
                        &with_avx512::kFastWaveKernels);
}

}  // namespace hawser::marine
