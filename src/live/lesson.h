// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lesson.h
/// An exercise as clients of `hawser view` drive and see it (docs/live.md, "Exercises").
///
/// ```
///     set, fault, end ──► exercise::Run ──► levers, faults ──► Session::step() ──► score
///                                                                                   │
///     all: score, goals, penalties, alarms, end      roles with control: faults ◄───┘
/// ```
/// Who has a station does not hear of faults but by what they do: outputs that are frozen are
/// frozen in frames, too.

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

/// The instructor, each station with its inputs, the watcher. @throws exercise::Refused where a
/// station's name does not fit into messages.
[[nodiscard]] std::vector<Role> roles_of(const exercise::Exercise& exercise);

class Lesson {
  public:
    /// @param exercise, run  Have to outlive it; `run` is of this exercise.
    Lesson(const exercise::Exercise& exercise, exercise::Run& run) noexcept
        : exercise_(exercise), run_(run) {}

    Status step() { return run_.step(); }
    /// Set an input for a role. @throws exercise::Refused, DefError
    void set_input(const Command& command);
    /// Begins or ends one. @throws exercise::Refused, DefError
    void fault(const Command& command);
    /// The instructor ends the exercise. @throws DefError where it has ended.
    void end(const Command& command);
    [[nodiscard]] bool ended() const noexcept { return run_.ended(); }

    [[nodiscard]] int mark() { return run_.mark(); }
    void back_to(int mark);

    /// What is new: entries at once; points, seconds and what is active four times a second.
    void tell(const World& world, Outbox& out);
    /// All of it, after commands.
    void tell_now(Outbox& out);
    /// Outputs of frames that are to show what displays show.
    [[nodiscard]] const std::vector<ShownOutput>& frozen(const World& world, const FramePlan& plan);

  private:
    void tell_entries(Outbox& out);
    [[nodiscard]] Json state() const;
    [[nodiscard]] Json faults() const;

    const exercise::Exercise& exercise_;
    exercise::Run& run_;
    std::size_t told_ = 0;        ///< Entries of the result.
    std::int64_t told_step_ = 0;  ///< When the last message was made.
    std::string last_;            ///< It.
    std::vector<ShownOutput> frozen_;
};

}  // namespace hawser::live
