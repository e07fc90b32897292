// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file allocation_counter.h
/// This executable replaces malloc and related functions by functions that count while a guard
/// exists; operator new calls them.

namespace hawser::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kCountsAllocations = false;  // sanitizers replace malloc themselves
#else
inline constexpr bool kCountsAllocations = true;
#endif

/// Counts allocations of all threads from 0 during its lifetime.
class AllocationGuard {
  public:
    /// Start counting. @param fails_at  Allocation that fails; −1: none.
    explicit AllocationGuard(long fails_at = -1) noexcept;
    ~AllocationGuard();
    AllocationGuard(const AllocationGuard&) = delete;
    AllocationGuard& operator=(const AllocationGuard&) = delete;
    [[nodiscard]] static long seen() noexcept;
};

}  // namespace hawser::test
