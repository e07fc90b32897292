// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file allocation_counter.h
/// malloc and its relatives are replaced in this executable and count while a guard is on; operator
/// new ends in them.

namespace hawser::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kCountsAllocations = false;  // sanitizers replace malloc themselves
#else
inline constexpr bool kCountsAllocations = true;
#endif

/// Allocations of all threads count from 0 while one of these lives.
class AllocationGuard {
  public:
    /// @param fails_at  The allocation that fails; −1: none.
    explicit AllocationGuard(long fails_at = -1) noexcept;
    ~AllocationGuard();
    AllocationGuard(const AllocationGuard&) = delete;
    AllocationGuard& operator=(const AllocationGuard&) = delete;
    [[nodiscard]] static long seen() noexcept;
};

}  // namespace hawser::test
