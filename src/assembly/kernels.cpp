// SPDX-License-Identifier: Apache-2.0
#include "assembly/kernels.h"

#include "assembly/contact_rows.h"
#include "base/isa.h"

namespace hawser::assembly {

const Kernels& kernels() noexcept {
    return base::chosen(&sse2::kAssemblyKernels, &with_avx2::kAssemblyKernels,
                        &with_avx512::kAssemblyKernels);
}

const ContactKernels& contact_kernels() noexcept {
    return base::chosen(&sse2::kContactKernels, &with_avx2::kContactKernels,
                        &with_avx512::kContactKernels);
}

}  // namespace hawser::assembly
