// SPDX-License-Identifier: Apache-2.0
#include "base/memory.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hawser::base {

void request_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__)
    (void)madvise(begin, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace hawser::base
