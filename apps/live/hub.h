// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hub.h
/// Data that the stepping thread and the sending thread exchange.
///
/// ```
///     steps                                                     sends
///     frame of each step ──── FrameSwap ───────────────────────► newest to all clients
///     scenes, states, events, answers ── Ring of Message ──────► text to one or all
///     between two steps ◄──── Ring of Command ────────────────── requests of clients
/// ```
/// Neither waits for the other. A descriptor of the kernel (eventfd) wakes the sending thread.

#include "live/command.h"
#include "live/frame_swap.h"
#include "live/ring.h"

#include <atomic>
#include <cstdint>
#include <string>

namespace hawser::live {

enum class MessageKind : std::uint8_t {
    text,   ///< Text for one client or all.
    scene,  ///< For all clients, also later ones. Without its opening brace: the role goes first.
    state,  ///< For all clients, also later ones.
    timeline,  ///< For later clients, after the state.
    exercise,  ///< For all clients, also later ones.
    faults,    ///< For roles with control, also later clients.
};

struct Message {
    MessageKind kind = MessageKind::text;
    std::uint32_t to = 0;  ///< Number of a client; 0: all.
    bool control = false;  ///< True: only for roles with control.
    std::string text{};    ///< JSON.
};

class Hub {
  public:
    /// Create the hub with its event descriptor. @throws std::runtime_error if the kernel has no
    /// free descriptor.
    Hub();
    ~Hub();
    Hub(const Hub&) = delete;
    Hub& operator=(const Hub&) = delete;

    FrameSwap frames;
    Ring<Command> commands{2048};
    Ring<Message> messages{8192};
    std::atomic<int> clients{0};  ///< Number of clients after hello.

    /// Notify the sending thread that messages or frames are ready to be sent.
    void wake() noexcept;
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    /// Reset the notification of wake(). Called by the sending thread.
    void clear() noexcept;

  private:
    int descriptor_ = -1;
};

/// Return the seconds of CLOCK_MONOTONIC, as in frames.
[[nodiscard]] double clock_now() noexcept;

}  // namespace hawser::live
