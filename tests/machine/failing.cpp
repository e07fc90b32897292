// SPDX-License-Identifier: Apache-2.0
#include "machine/failing.h"

#include <dlfcn.h>
#include <pthread.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::atomic<bool> armed{false};
std::atomic<long> requests{0};
std::atomic<long> fails_at{-1};
std::atomic<int> threads_left{std::numeric_limits<int>::max()};

void* plain(std::size_t bytes, std::size_t alignment) noexcept {
    if (bytes == 0) bytes = 1;
    if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes);
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

/// Free memory in a separate function, which compilers cannot inline.
[[gnu::noinline]] void give_back(void* p) noexcept { std::free(p); }

void* get_or_throw(std::size_t bytes, std::size_t alignment) {
    const bool fails =
        armed.load(std::memory_order_relaxed) && requests.fetch_add(1) == fails_at.load();
    void* const p = fails ? nullptr : plain(bytes, alignment);
    if (p == nullptr) throw std::bad_alloc();
    return p;
}

}  // namespace

void* operator new(std::size_t n) { return get_or_throw(n, 1); }
void* operator new[](std::size_t n) { return get_or_throw(n, 1); }
void* operator new(std::size_t n, std::align_val_t a) {
    return get_or_throw(n, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t n, std::align_val_t a) {
    return get_or_throw(n, static_cast<std::size_t>(a));
}
// Callers of this form continue with less memory after a failure (std::stable_sort). They always
// succeed here; otherwise later requests of a call would not be tested.
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return plain(n, 1); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return plain(n, 1); }
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return plain(n, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return plain(n, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept { give_back(p); }
void operator delete[](void* p) noexcept { give_back(p); }
void operator delete(void* p, std::size_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t) noexcept { give_back(p); }
void operator delete(void* p, std::align_val_t) noexcept { give_back(p); }
void operator delete[](void* p, std::align_val_t) noexcept { give_back(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { give_back(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { give_back(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { give_back(p); }

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*start)(void*), void* argument) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    if (threads_left.fetch_sub(1) <= 0) return EAGAIN;
    return create(thread, attributes, start, argument);
}

namespace hawser::test::failing {

Memory::Memory(long at) noexcept {
    requests = 0;
    fails_at = at;
    armed = true;
}
Memory::~Memory() { armed = false; }
long Memory::seen() noexcept { return requests.load(); }

Threads::Threads(int most) noexcept { threads_left = most; }
Threads::~Threads() { threads_left = std::numeric_limits<int>::max(); }

}  // namespace hawser::test::failing
