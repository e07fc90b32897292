// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lesson.h
/// Connect an exercise to the clients of `hawser view` (docs/live.md, "Exercises").
///
/// ```
///     set, fault, end ──► exercise::Run ──► levers, faults ──► Session::step() ──► score
///                                                                                   │
///     all: score, goals, penalties, alarms, end      roles with control: faults ◄───┘
/// ```
/// A station notices faults by their effects only: outputs that are frozen are frozen in frames,
/// too.

#include "live/command.h"
#include "live/frame_plan.h"
#include "live/frame_writer.h"
#include "live/outbox.h"
#include "live/roles.h"

#include <hawser/exercise.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::live {

/// Return the roles: the instructor, each station with its inputs, the watcher. @throws
/// exercise::Refused if a station's name is too long for messages.
[[nodiscard]] std::vector<Role> roles_of(const exercise::Exercise& exercise);

class Lesson {
  public:
    /// Connect an exercise. @param exercise, run  Must outlive this object; `run` belongs to this
    /// exercise.
    Lesson(const exercise::Exercise& exercise, exercise::Run& run) noexcept
        : exercise_(exercise), run_(run) {}

    Status step() { return run_.step(); }
    /// Set an input for a role. @throws exercise::Refused, DefError
    void set_input(const Command& command);
    /// Begin or end a fault. @throws exercise::Refused, DefError
    void fault(const Command& command);
    /// End the exercise for the instructor. @throws DefError if it has ended.
    void end(const Command& command);
    [[nodiscard]] bool ended() const noexcept { return run_.ended(); }

    [[nodiscard]] int mark() { return run_.mark(); }
    void return_to_mark(int mark);

    /// Report news: entries at once; points, seconds and active items four times a second.
    void report_news(const World& world, Outbox& out);
    /// Report everything, after commands.
    void send_now(Outbox& out);
    /// Return the outputs whose frame values are those of frozen displays.
    [[nodiscard]] const std::vector<ShownOutput>& frozen(const World& world, const FramePlan& plan);

  private:
    void send_entries(Outbox& out);
    [[nodiscard]] Json state() const;
    [[nodiscard]] Json faults() const;

    const exercise::Exercise& exercise_;
    exercise::Run& run_;
    std::size_t reported_ = 0;        ///< Number of reported entries of the result.
    std::int64_t reported_step_ = 0;  ///< Step of the last message.
    std::string last_;                ///< The last message.
    std::vector<ShownOutput> frozen_;
};

}  // namespace hawser::live
