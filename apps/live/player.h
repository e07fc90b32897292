// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file player.h
/// Show a recording to clients: play, pause, step, seek. All clients see the same frame.

#include "live/debriefing.h"
#include "live/hub.h"
#include "live/outbox.h"
#include "live/playing.h"
#include "live/recorded_scene.h"

#include <hawser/recording.h>

#include <functional>

namespace hawser::live {

class Player {
  public:
    /// Create a player. @param recording  Must outlive the player. @throws RecordingError if it has
    /// no frame. @param debriefing  Debriefing of an exercise; empty for scenes.
    Player(const record::Recording& recording, Hub& hub, Debriefing debriefing = {});

    /// Serve the recording to the clients of the hub until `stop` returns true.
    void run(const std::function<bool()>& stop);
    /// Perform pending commands, move to the next frame during playback, and publish a frame;
    /// without a clock.
    void advance();
    /// Return the frame at or before a time, in the last branch that has one.
    [[nodiscard]] std::size_t frame_at(double time) const;
    /// Return the fault of the recording's scene; "": none.
    [[nodiscard]] const std::string& fault() const noexcept { return scene_.fault(); }

  private:
    void perform(const Command& command);
    void perform_commands();
    void publish();
    void send_state();
    void send_timeline();
    [[nodiscard]] double gap() const;  ///< Return the time to the next frame [s].

    const record::Recording& recording_;
    Hub& hub_;
    Outbox out_;
    Debriefing debriefing_;
    RecordedScene scene_;
    Playing playing_;
    std::size_t frame_ = 0;
    std::uint32_t number_ = 0;
    bool changed_ = true;
    int clients_ = 0;
};

}  // namespace hawser::live
