// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file memory.h
/// Arrays aligned for SIMD. Their capacity only grows, and only between steps.

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace hawser::base {

inline constexpr std::size_t kAlign = 64;  ///< One cache line or one AVX-512 register [bytes].

/// Minimum size of arrays that begin on a huge page and request huge pages [bytes]. A step of
/// 100,000 bodies reads hundreds of megabytes and would otherwise wait for page tables.
inline constexpr std::size_t kMinHugeArray = std::size_t{1} << 22;
inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// Request huge pages for a range of memory. The request is advice and has no effect on systems
/// without huge pages.
void request_huge_pages(void* begin, std::size_t bytes) noexcept;

/// Standard allocator with 64-byte alignment.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    constexpr AlignedAllocator(const AlignedAllocator<U>&) noexcept {}
    [[nodiscard]] T* allocate(std::size_t n) {
        const std::size_t bytes = n * sizeof(T);
        if (bytes < kMinHugeArray)
            return static_cast<T*>(::operator new(bytes, std::align_val_t{kAlign}));
        void* const p = ::operator new(bytes, std::align_val_t{kHugePage});
        request_huge_pages(p, bytes);
        return static_cast<T*>(p);
    }
    void deallocate(T* p, std::size_t n) noexcept {
        const bool huge = n * sizeof(T) >= kMinHugeArray;
        ::operator delete(p, std::align_val_t{huge ? kHugePage : kAlign});
    }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

template <class T>
using Array = std::vector<T, AlignedAllocator<T>>;

/// Reserve capacity for `more` further entries. Grows geometrically.
template <class T, class A>
void reserve_more(std::vector<T, A>& v, std::size_t more) {
    if (v.capacity() - v.size() >= more) return;
    v.reserve(2 * v.capacity() > v.size() + more ? 2 * v.capacity() : v.size() + more);
}

/// Return the bytes allocated by an array, for memory reports.
template <class T, class A>
[[nodiscard]] std::size_t bytes(const std::vector<T, A>& v) noexcept {
    return v.capacity() * sizeof(T);
}

}  // namespace hawser::base
