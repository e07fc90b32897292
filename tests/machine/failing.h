// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file failing.h
/// Failures of the machine on request: operator new and pthread_create of this executable.

#include <atomic>

namespace hawser::test::failing {

/// While it lives, the n-th request for memory fails, from 0 on; −1: none. All are counted.
class Memory {
  public:
    explicit Memory(long at) noexcept;
    ~Memory();
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    /// Requests so far.
    [[nodiscard]] static long seen() noexcept;
};

/// Limits the number of threads that can be started during its lifetime.
class Threads {
  public:
    explicit Threads(int most) noexcept;
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
};

}  // namespace hawser::test::failing
