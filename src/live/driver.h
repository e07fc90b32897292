// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file driver.h
/// Steps a session for clients: what they ask for between two steps, a frame after each.
///
/// ```
///     commands ─► drag forces ─► Session::step() ─► events, frame ─► wait until the next is due
///         ▲                                                               │
///         └───────────────────────────────────────────────────────────────┘
/// ```
/// All of it is one thread, which waits for the clock alone. What clients do goes through the
/// session, so that a recording repeats it; of an exercise through its run (lesson.h). A step that
/// fails pauses the run, with a message that says when, where and what to do.

#include "live/drag.h"
#include "live/frame_plan.h"
#include "live/frame_writer.h"
#include "live/hub.h"
#include "live/lesson.h"
#include "live/outbox.h"
#include "live/playing.h"
#include "live/told.h"

#include <hawser/session.h>
#include <hawser/structure.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hawser::live {

struct DriverOptions {
    std::string recording{};  ///< File that the session records to, for clients; "": none.
    bool paused = false;      ///< At the start.
    /// An exercise that the session is of, and its run; null: it is of none.
    const exercise::Exercise* exercise = nullptr;
    exercise::Run* run = nullptr;
};

/// What a run came to.
struct DriverFigures {
    std::int64_t steps = 0, frames = 0;
    std::size_t frame_bytes = 0;  ///< Of the largest frame.
};

class Driver {
  public:
    Driver(Session& session, Hub& hub, const DriverOptions& options);

    /// Until `stop` says so. @throws std::exception where a recording cannot be written.
    void run(const std::function<bool()>& stop);
    /// What is waiting, one step where the run is not paused, and a frame; without a clock.
    void advance();
    [[nodiscard]] bool paused() const noexcept { return playing_.paused(); }
    [[nodiscard]] const DriverFigures& figures() const noexcept { return figures_; }

  private:
    /// A state to go back to.
    struct Point {
        std::string name;
        double time = 0.0;
        int mark = 0;  ///< Of the exercise.
        Structure made_of;
        std::vector<std::byte> state;
    };

    void take_commands();
    void perform(const Command& command);
    void set_input(const Command& command);
    void drag(const Command& command);
    void part(const Command& command);
    void save(const std::string& name);
    void restore(const Command& command);
    /// @throws DefError while saving and restoring would take more than a fifth of the time.
    void afford_states(const char* what) const;
    void count_states(double begun);
    Lesson& lesson();
    void after_exercise_step();
    void step();
    void follow_pieces();
    void follow_origin();
    void publish();
    void fail(Failure failure);
    void tell_state();
    void tell_scene();

    Session& session_;
    Hub& hub_;
    DriverOptions options_;
    Outbox out_;
    std::optional<Lesson> lesson_;
    FramePlan plan_;
    FrameWriter writer_;
    FrameNotes notes_;
    Vec3 origin_{0.0, 0.0, 0.0};
    Drags drags_;
    Playing playing_;
    std::vector<Point> points_;
    double states_took_ = 0.0;  ///< Saving or restoring, last [s].
    double states_free_ = 0.0;  ///< Time of clock_now() from which another one may come [s].
    std::optional<Failure> failure_;
    bool told_ = false, changed_ = true;
    bool over_ = false;  ///< The exercise had ended when it was last looked at.
    int clients_ = 0;
    DriverFigures figures_;
};

}  // namespace hawser::live
