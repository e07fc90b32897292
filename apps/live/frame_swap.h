// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame_swap.h
/// Transfer the newest frame from the stepping thread to the sending thread.
///
/// The writer fills one buffer, the reader reads a second one, and a middle buffer is idle. When
/// the writer or the reader has finished, it exchanges its buffer for the middle one in one atomic
/// operation. The writer never waits, and the reader always gets the newest complete frame; older
/// ones are overwritten.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::live {

using Bytes = std::vector<std::byte>;

class FrameSwap {
  public:
    /// Return the buffer that the writer fills. Its capacity is kept, so that filling it does not
    /// allocate after the first frames.
    [[nodiscard]] Bytes& back() noexcept { return buffers_[writing_]; }
    void publish() noexcept {
        writing_ = middle_.exchange(writing_ | kFreshFlag, std::memory_order_acq_rel) & kIndexBits;
    }
    /// Return the newest frame, which the reader may use until the next call.
    /// @return null if there is no new frame since the last call.
    [[nodiscard]] const Bytes* newest_frame() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kFreshFlag) == 0) return nullptr;
        reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndexBits;
        return &buffers_[reading_];
    }

  private:
    static constexpr std::uint8_t kIndexBits = 3, kFreshFlag = 4;
    std::array<Bytes, 3> buffers_;
    std::uint8_t writing_ = 0, reading_ = 1;
    std::atomic<std::uint8_t> middle_{2};
};

}  // namespace hawser::live
