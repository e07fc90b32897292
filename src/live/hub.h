// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hub.h
/// What the thread that steps and the thread that sends share.
///
/// ```
///     steps                                                     sends
///     frame of each step ──── FrameSwap ───────────────────────► newest to all clients
///     scenes, states, events, answers ── Ring of Message ──────► text to one or all
///     between two steps ◄──── Ring of Command ────────────────── what clients ask for
/// ```
/// Neither waits for the other. A descriptor of the kernel (eventfd) wakes the one that sends.

#include "live/command.h"
#include "live/frame_swap.h"
#include "live/ring.h"

#include <atomic>
#include <cstdint>
#include <string>

namespace hawser::live {

enum class MessageKind : std::uint8_t {
    text,      ///< To one or all.
    scene,     ///< To all, and to who comes later. Without its opening brace: the role goes first.
    state,     ///< To all, and to who comes later.
    timeline,  ///< To who comes later, behind the state.
    exercise,  ///< To all, and to who comes later.
    faults,    ///< To roles with control, also those who come later.
};

struct Message {
    MessageKind kind = MessageKind::text;
    std::uint32_t to = 0;  ///< Number of a client; 0: all.
    bool control = false;  ///< Only to roles with control.
    std::string text{};    ///< JSON.
};

class Hub {
  public:
    /// @throws std::runtime_error where the kernel has no descriptor left.
    Hub();
    ~Hub();
    Hub(const Hub&) = delete;
    Hub& operator=(const Hub&) = delete;

    FrameSwap frames;
    Ring<Command> commands{2048};
    Ring<Message> messages{8192};
    std::atomic<int> clients{0};  ///< Who have said hello.

    /// Tell the one that sends that there is something.
    void wake() noexcept;
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    /// By the one that was woken.
    void clear() noexcept;

  private:
    int descriptor_ = -1;
};

/// Seconds of CLOCK_MONOTONIC, as in frames.
[[nodiscard]] double clock_now() noexcept;

}  // namespace hawser::live
