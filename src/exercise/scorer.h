// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scorer.h
/// Alarms, goals, penalties and ends from what an exercise watches, step by step.
///
/// What is watched are channels: outputs, and numbers of events of a kind in a step. The score
/// follows from their values alone, so that whoever has the same values has the same score: the run
/// takes them from its world, rescore() from the world of a replay and from notes in the recording.

#include <hawser/exercise.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hawser::exercise {

struct Channel {
    std::string output;                       ///< "": events.
    EventKind event = EventKind::line_break;  ///< Of these …
    std::string of;                           ///< … of what has a name that begins so.
    friend bool operator==(const Channel&, const Channel&) = default;
};

/// Every output and kind of event that an exercise names, in the order in which it does.
[[nodiscard]] std::vector<Channel> channels_of(const Exercise& exercise);

/// Copies are states to go back to.
class Scorer {
  public:
    /// @param step  Of the world [s].
    Scorer(const Exercise& exercise, double step);

    /// @param values  Of the channels, after a step to this time.
    void after_step(double time, std::span<const double> values);
    void fault(double time, const Fault& fault, std::string_view by, bool begins);
    void end(double time, const std::string& why, bool failed);
    void restored(double time);
    [[nodiscard]] bool ended() const noexcept { return result_.outcome != Outcome::running; }
    [[nodiscard]] const Result& result() const noexcept { return result_; }
    /// Frozen value of an output; NaN where it is not frozen.
    [[nodiscard]] double frozen(std::string_view output) const noexcept;
    /// An output that no channel has is frozen at a value that its owner knows.
    void freeze(const std::string& output, double value) { frozen_[output] = value; }

    /// Entries that a result keeps; later ones are counted in tallies only.
    static constexpr std::size_t kMostLogged = 4096;

  private:
    /// How a trigger stands.
    struct Watch {
        std::vector<std::size_t> channels;  ///< Of its conditions, or the one of its events.
        double held = 0.0;                  ///< [s]
        bool holds = false;                 ///< All conditions do.
        bool active = false;
    };
    [[nodiscard]] std::vector<Watch> watches(const auto& list) const;
    /// Active now; for events the number of them. @param shown  As displays have it.
    double look(const Trigger& trigger, Watch& watch, std::span<const double> values, bool shown);
    void alarms(double time, std::span<const double> values);
    void penalties(double time, std::span<const double> values);
    void goals(double time, std::span<const double> values);
    void ends(double time, std::span<const double> values);
    void log(Entry entry);
    void add_points(double points) { result_.points += points; }

    const Exercise* exercise_;
    double step_;
    std::vector<Channel> channels_;
    std::vector<Watch> alarm_, goal_, penalty_, end_;
    std::map<std::string, double, std::less<>> frozen_;  ///< By output.
    std::vector<double> last_;                           ///< Values of the last step.
    Result result_;
};

}  // namespace hawser::exercise
