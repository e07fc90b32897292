// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame_swap.h
/// The newest frame, from the thread that makes frames to the one that sends them.
///
/// Three buffers: the writer fills one, the reader reads one, the third is in the middle. Whoever
/// is done exchanges his own for the middle one by one atomic operation, so that the writer never
/// waits and the reader always gets the newest complete frame; older ones are overwritten.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::live {

using Bytes = std::vector<std::byte>;

class FrameSwap {
  public:
    /// The writer's buffer. Its capacity stays, so that filling it allocates nothing once warm.
    [[nodiscard]] Bytes& back() noexcept { return buffers_[writing_]; }
    void publish() noexcept {
        writing_ = middle_.exchange(writing_ | kFresh, std::memory_order_acq_rel) & kIndex;
    }
    /// @return the newest frame, the reader's until the next call; null: none since the last call.
    [[nodiscard]] const Bytes* take() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return nullptr;
        reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
        return &buffers_[reading_];
    }

  private:
    static constexpr std::uint8_t kIndex = 3, kFresh = 4;
    std::array<Bytes, 3> buffers_;
    std::uint8_t writing_ = 0, reading_ = 1;
    std::atomic<std::uint8_t> middle_{2};
};

}  // namespace hawser::live
