// SPDX-License-Identifier: Apache-2.0
#include "assembly/kernels.h"

#include "assembly/contact_rows.h"
#include "base/isa.h"

namespace hawser::assembly {

namespace {

/// The table of the instruction set in use.
template <class T>
const T& chosen(const T* sse2, const T* avx2, const T* avx512) noexcept {
    switch (base::isa()) {
        case base::Isa::avx512:
            return *avx512;
        case base::Isa::avx2:
            return *avx2;
        case base::Isa::sse2:
            break;
    }
    return *sse2;
}

}  // namespace

#if defined(HAWSER_NO_AVX2)
namespace with_avx2 = sse2;
#else
namespace with_avx2 = avx2;
#endif
#if defined(HAWSER_NO_AVX512)
namespace with_avx512 = sse2;
#else
namespace with_avx512 = avx512;
#endif

const Kernels& kernels() noexcept {
    return chosen(&sse2::kAssemblyKernels, &with_avx2::kAssemblyKernels,
                  &with_avx512::kAssemblyKernels);
}

const ContactKernels& contact_kernels() noexcept {
    return chosen(&sse2::kContactKernels, &with_avx2::kContactKernels,
                  &with_avx512::kContactKernels);
}

}  // namespace hawser::assembly
