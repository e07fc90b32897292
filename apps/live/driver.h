// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file driver.h
/// Step a session for clients: perform their commands between steps, publish a frame after each.
///
/// ```
///     commands ─► drag forces ─► Session::step() ─► events, frame ─► wait until the next is due
///         ▲                                                               │
///         └───────────────────────────────────────────────────────────────┘
/// ```
/// One thread does all of this, and it waits only for the clock. Commands of clients go through the
/// session, so that a recording repeats them; in an exercise they go through its run (lesson.h). A
/// failed step pauses the run, with a message about the time, the cause and the remedy.

#include "live/drag.h"
#include "live/event_reports.h"
#include "live/frame_plan.h"
#include "live/frame_writer.h"
#include "live/hub.h"
#include "live/lesson.h"
#include "live/outbox.h"
#include "live/playing.h"

#include <hawser/session.h>
#include <hawser/structure.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hawser::live {

struct DriverOptions {
    std::string recording{};       ///< File that the session records to, for clients; "": none.
    bool paused = false;           ///< At the start.
    double states_fraction = 0.2;  ///< Largest fraction of time for saving and restoring.
    /// Exercise of the session, and its run; null: none.
    const exercise::Exercise* exercise = nullptr;
    exercise::Run* run = nullptr;
    /// Write the report of the exercise (HTML). @param people  Names and date for its heading.
    std::function<std::string(const std::string& people)> report{};
};

/// Figures of a run.
struct DriverFigures {
    std::int64_t steps = 0, frames = 0;
    std::size_t frame_bytes = 0;  ///< Size of the largest frame.
};

class Driver {
  public:
    Driver(Session& session, Hub& hub, const DriverOptions& options);

    /// Run until `stop` returns true. @throws std::exception if a recording cannot be written.
    void run(const std::function<bool()>& stop);
    /// Perform pending commands, make one step unless the run is paused, and publish a frame. This
    /// function does not wait for the clock.
    void advance();
    [[nodiscard]] bool paused() const noexcept { return playing_.paused(); }
    [[nodiscard]] const DriverFigures& figures() const noexcept { return figures_; }

  private:
    /// A state that can be restored.
    struct Point {
        std::string name;
        double time = 0.0;
        int mark = 0;  ///< Mark of the exercise.
        Structure made_of;
        std::vector<std::byte> state;
    };

    void perform_commands();
    void perform(const Command& command);
    void set_input(const Command& command);
    void drag(const Command& command);
    void part(const Command& command);
    void note(const Command& command);
    void save(const std::string& name);
    void restore(const Command& command);
    /// Check that saving and restoring states need at most a fifth of the run time. @throws
    /// DefError otherwise.
    void check_state_cost(const char* what) const;
    void count_states(double begun);
    Lesson& lesson();
    void after_exercise_step();
    void step();
    void follow_pieces();
    void follow_origin();
    void publish();
    void fail(Failure failure);
    void send_state();
    void send_scene();

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
    double state_seconds_ = 0.0;  ///< Time of the last saving or restoring [s].
    double states_free_ = 0.0;    ///< Time of clock_now() from which the next one is allowed [s].
    std::optional<Failure> failure_;
    bool reported_ = false, changed_ = true;
    bool over_ = false;  ///< True if the exercise had ended at the last check.
    int clients_ = 0;
    DriverFigures figures_;
};

}  // namespace hawser::live
