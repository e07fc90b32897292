// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file memory.h
/// Arrays aligned for SIMD whose capacity only grows, between steps.

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace hawser::base {

inline constexpr std::size_t kAlign = 64;  ///< One cache line, one AVX-512 register.

/// Standard allocator with 64-byte alignment.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    constexpr AlignedAllocator(const AlignedAllocator<U>&) noexcept {}
    [[nodiscard]] T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t{kAlign}));
    }
    void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, std::align_val_t{kAlign}); }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

template <class T>
using Array = std::vector<T, AlignedAllocator<T>>;

/// Bytes held by an array, for memory reports.
template <class T, class A>
[[nodiscard]] std::size_t bytes(const std::vector<T, A>& v) noexcept {
    return v.capacity() * sizeof(T);
}

}  // namespace hawser::base
