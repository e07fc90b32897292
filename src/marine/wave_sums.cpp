// SPDX-License-Identifier: Apache-2.0
#include "marine/wave_sums.h"

#include "base/isa.h"

namespace hawser::marine {

const WaveKernels& wave_kernels() noexcept {
    return base::chosen(&sse2::kWaveKernels, &with_avx2::kWaveKernels, &with_avx512::kWaveKernels);
}

}  // namespace hawser::marine
