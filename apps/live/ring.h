// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ring.h
/// A bounded queue between two threads without waiting and locks.
///
/// ```
///     ┌───┬───┬───┬───┬───┬───┐     head: the next slot to read, tail: the next slot to write;
///     │   │ a │ b │ c │   │   │     both only grow, a slot is their value modulo the size.
///     └───┴───┴───┴───┴───┴───┘     The writer publishes an entry by storing tail, the reader
///           head        tail        releases its slot by storing head.
/// ```
/// Source: L. Lamport, "Specifying concurrent program modules" (1983).

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace hawser::live {

template <class T>
class Ring {
  public:
    explicit Ring(std::size_t capacity) : slots_(capacity) {}

    /// Append a value. Called by the writer. @return false if the ring is full; `value` is then
    /// unchanged.
    bool push(T&& value) noexcept {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        if (tail - head_.load(std::memory_order_acquire) == slots_.size()) return false;
        slots_[tail % slots_.size()] = std::move(value);
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }
    /// Remove the first value. Called by the reader. @return false if the ring is empty.
    bool pop(T& value) noexcept {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        if (head == tail_.load(std::memory_order_acquire)) return false;
        value = std::move(slots_[head % slots_.size()]);
        head_.store(head + 1, std::memory_order_release);
        return true;
    }
    /// Return a lower bound of the free slots. Called by the writer.
    [[nodiscard]] std::size_t free_slots() const noexcept {
        return slots_.size() -
               (tail_.load(std::memory_order_relaxed) - head_.load(std::memory_order_acquire));
    }

  private:
    std::vector<T> slots_;
    alignas(64) std::atomic<std::size_t> head_{0};
    alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace hawser::live
