// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file failing.h
/// A machine that fails on request: operator new and pthread_create of this executable.

#include <atomic>

namespace hawser::test::failing {

/// During its lifetime, request n for memory fails, counted from 0; −1: none fails. All requests
/// are counted.
class Memory {
  public:
    explicit Memory(long at) noexcept;
    ~Memory();
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    /// Return the number of requests since the start.
    [[nodiscard]] static long seen() noexcept;
};

/// During its lifetime, a number of threads can be started; starting more fails.
class Threads {
  public:
    explicit Threads(int most) noexcept;
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
};

}  // namespace hawser::test::failing
