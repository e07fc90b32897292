// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file player.h
/// Shows a recording to clients: plays, pauses, steps, seeks. All clients see the same.

#include "live/hub.h"
#include "live/outbox.h"
#include "live/playing.h"
#include "live/recorded_scene.h"

#include <hawser/recording.h>

#include <functional>

namespace hawser::live {

class Player {
  public:
    /// @param recording  Has to outlive it. @throws RecordingError where it has no frame.
    Player(const record::Recording& recording, Hub& hub);

    /// Serve the recording to the clients of the hub until `stop` returns true.
    void run(const std::function<bool()>& stop);
    /// What is waiting, the next frame where it plays, and a frame; without a clock.
    void advance();
    /// The frame at or before a time, of the last take that has one.
    [[nodiscard]] std::size_t frame_at(double time) const;
    /// What was wrong with the scene in the recording; "": nothing.
    [[nodiscard]] const std::string& fault() const noexcept { return scene_.fault(); }

  private:
    void perform(const Command& command);
    void take_commands();
    void publish();
    void tell_state();
    void tell_timeline();
    [[nodiscard]] double gap() const;  ///< To the next frame [s].

    const record::Recording& recording_;
    Hub& hub_;
    Outbox out_;
    RecordedScene scene_;
    Playing playing_;
    std::size_t frame_ = 0;
    std::uint32_t number_ = 0;
    bool changed_ = true;
    int clients_ = 0;
};

}  // namespace hawser::live
