// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scorer.h
/// Evaluate alarms, goals, penalties and ends of an exercise, step by step.
///
/// The inputs are channels: outputs, and numbers of events of a kind in a step. The score depends
/// on their values alone, so equal values give equal scores. The run reads them from its world.
/// rescore() reads them from the world of a replay and from notes in the recording.

#include <hawser/exercise.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hawser::exercise {

struct Channel {
    std::string output;  ///< Name of the output; empty: the channel counts events.
    EventKind event = EventKind::line_break;  ///< Kind of the events counted.
    std::string of;                           ///< Prefix of the names that count.
    friend bool operator==(const Channel&, const Channel&) = default;
};

/// Return every output and kind of event that an exercise names, in the order of their first use.
[[nodiscard]] std::vector<Channel> list_channels(const Exercise& exercise);

/// Scorer of an exercise. A copy is a state that can be restored.
class Scorer {
  public:
    /// Start a score. @param step  Step of the world [s].
    Scorer(const Exercise& exercise, double step);

    /// Evaluate a step. @param time  Time at its end [s]. @param values  Values of the channels.
    void after_step(double time, std::span<const double> values);
    void fault(double time, const Fault& fault, std::string_view by, bool begins);
    void end(double time, const std::string& why, bool failed);
    void restored(double time);
    [[nodiscard]] bool ended() const noexcept { return result_.outcome != Outcome::running; }
    [[nodiscard]] const Result& result() const noexcept { return result_; }
    /// Return the frozen value of an output; NaN if it is not frozen.
    [[nodiscard]] double frozen_value(std::string_view output) const noexcept;
    /// Set an output that has no channel at a value from its owner.
    void freeze_output(const std::string& output, double value) { frozen_[output] = value; }

    /// Largest number of entries in a result; later ones are counted in tallies only.
    static constexpr std::size_t kMaxLogged = 4096;

  private:
    /// State of a trigger.
    struct Watch {
        /// Channels of its conditions, or the channel of its events.
        std::vector<std::size_t> channels;
        double held_time = 0.0;  ///< Time for which all conditions have held [s].
        bool holds = false;      ///< True if all conditions hold.
        bool active = false;
    };
    [[nodiscard]] std::vector<Watch> make_watches(const auto& list) const;
    /// Return 1 if the trigger is active, else 0; for events their number. @param shown  Use the
    /// values on displays, which may be frozen.
    double sample(const Trigger& trigger, Watch& watch, std::span<const double> values, bool shown);
    void update_alarms(double time, std::span<const double> values);
    void update_penalties(double time, std::span<const double> values);
    void update_goals(double time, std::span<const double> values);
    void update_ends(double time, std::span<const double> values);
    void log(Entry entry);
    void add_points(double points) { result_.points += points; }

    const Exercise* exercise_;
    double step_;
    std::vector<Channel> channels_;
    std::vector<Watch> alarm_, goal_, penalty_, end_;
    std::map<std::string, double, std::less<>> frozen_;  ///< Frozen values by output.
    std::vector<double> last_;                           ///< Values of the last step.
    Result result_;
};

}  // namespace hawser::exercise
