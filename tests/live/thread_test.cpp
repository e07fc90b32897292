// SPDX-License-Identifier: Apache-2.0
/// Data shared by two threads: none is lost, mixed or out of order.
#include "live/frame_swap.h"
#include "live/ring.h"
#include "live/web_rules.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <string>
#include <thread>

namespace hawser::test {
namespace {

TEST(LiveThreads, a_ring_keeps_order_and_says_when_it_is_full) {
    constexpr int kCount = 100'000;
    live::Ring<std::string> ring(64);
    std::thread writer([&] {
        for (int k = 0; k < kCount;) {
            std::string value = "a text that is longer than a short one " + std::to_string(k);
            if (ring.push(std::move(value)))
                ++k;
            else
                std::this_thread::yield();
        }
    });
    std::string got;
    for (int k = 0; k < kCount;) {
        if (!ring.pop(got)) {
            std::this_thread::yield();
            continue;
        }
        ASSERT_EQ(got, "a text that is longer than a short one " + std::to_string(k));
        ++k;
    }
    writer.join();
    EXPECT_EQ(ring.free_slots(), 64U);
    for (int k = 0; k < 64; ++k) EXPECT_TRUE(ring.push("x"));
    EXPECT_FALSE(ring.push("y"));
}

TEST(LiveThreads, frames_are_whole_and_never_go_back) {
    constexpr std::uint32_t kFrames = 20'000;
    live::FrameSwap swap;
    std::thread writer([&] {
        for (std::uint32_t n = 1; n <= kFrames; ++n) {
            live::Bytes& frame = swap.back();
            frame.resize(4 * (100 + n % 50));
            for (std::size_t at = 0; at < frame.size(); at += 4)
                std::memcpy(&frame[at], &n, sizeof n);
            swap.publish();
        }
    });
    std::uint32_t last = 0, seen = 0;
    while (last < kFrames) {
        const live::Bytes* frame = swap.newest_frame();
        if (!frame) continue;
        std::uint32_t first = 0;
        std::memcpy(&first, frame->data(), sizeof first);
        ASSERT_GT(first, last);
        ASSERT_EQ(frame->size(), 4 * (100 + first % 50));
        for (std::size_t at = 0; at < frame->size(); at += 4)
            ASSERT_EQ(std::memcmp(&(*frame)[at], &first, sizeof first), 0);
        last = first;
        ++seen;
    }
    writer.join();
    EXPECT_GT(seen, 0U);
    EXPECT_EQ(swap.newest_frame(), nullptr);
}

}  // namespace
}  // namespace hawser::test
