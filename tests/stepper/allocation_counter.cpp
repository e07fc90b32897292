// SPDX-License-Identifier: Apache-2.0
#include "stepper/allocation_counter.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};
std::atomic<long> failing{-1};

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// NOLINTBEGIN(bugprone-reserved-identifier): the names under which glibc exports its own malloc.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

static bool count_one() {
    if (!counting.load(std::memory_order_relaxed)) return true;
    return allocations.fetch_add(1) != failing.load(std::memory_order_relaxed);
}
void* malloc(std::size_t n) { return count_one() ? __libc_malloc(n) : nullptr; }
void* calloc(std::size_t n, std::size_t size) {
    return count_one() ? __libc_calloc(n, size) : nullptr;
}
void* realloc(void* p, std::size_t n) { return count_one() ? __libc_realloc(p, n) : nullptr; }
void* aligned_alloc(std::size_t alignment, std::size_t n) {
    return count_one() ? __libc_memalign(alignment, n) : nullptr;
}
int posix_memalign(void** p, std::size_t alignment, std::size_t n) {
    *p = count_one() ? __libc_memalign(alignment, n) : nullptr;
    return *p == nullptr ? ENOMEM : 0;
}
}
// NOLINTEND(bugprone-reserved-identifier)
#endif

namespace hawser::test {

AllocationGuard::AllocationGuard(long fails_at) noexcept {
    failing = fails_at;
    allocations = 0;
    counting = true;
}

AllocationGuard::~AllocationGuard() {
    counting = false;
    failing = -1;
}

long AllocationGuard::seen() noexcept { return allocations.load(); }

}  // namespace hawser::test
