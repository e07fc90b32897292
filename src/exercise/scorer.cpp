// SPDX-License-Identifier: Apache-2.0
#include "exercise/scorer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hawser::exercise {
namespace {

/// Tolerance of times, which are sums of steps up to rounding [s].
constexpr double kTimeRounding = 1e-9;

template <class T>
std::vector<Tally> make_tallies(const std::vector<T>& list) {
    std::vector<Tally> out;
    for (const T& one : list) out.push_back({.name = one.name, .text = one.text});
    return out;
}

void add(std::vector<Channel>& out, Channel channel) {
    if (std::find(out.begin(), out.end(), channel) == out.end()) out.push_back(std::move(channel));
}

void add(std::vector<Channel>& out, const Trigger& when) {
    for (const Condition& c : when.conditions) add(out, Channel{c.output, {}, {}});
    if (when.conditions.empty()) add(out, Channel{"", when.event, when.of});
}

}  // namespace

std::vector<Channel> list_channels(const Exercise& exercise) {
    std::vector<Channel> out;
    for (const std::string& display : exercise.displays) add(out, Channel{display, {}, {}});
    for (const Alarm& one : exercise.alarms) add(out, one.when);
    for (const Goal& one : exercise.goals) add(out, one.when);
    for (const Penalty& one : exercise.penalties) add(out, one.when);
    for (const End& one : exercise.ends) add(out, one.when);
    return out;
}

Scorer::Scorer(const Exercise& exercise, double step)
    : exercise_(&exercise),
      step_(step),
      channels_(list_channels(exercise)),
      alarm_(make_watches(exercise.alarms)),
      goal_(make_watches(exercise.goals)),
      penalty_(make_watches(exercise.penalties)),
      end_(make_watches(exercise.ends)),
      last_(channels_.size(), std::numeric_limits<double>::quiet_NaN()) {
    result_.exercise = exercise.name;
    result_.pass = exercise.pass;
    result_.alarms = make_tallies(exercise.alarms);
    result_.goals = make_tallies(exercise.goals);
    result_.penalties = make_tallies(exercise.penalties);
    for (std::size_t i = 0; i < exercise.goals.size(); ++i) {
        result_.goals[i].possible = exercise.goals[i].points;
        result_.possible += exercise.goals[i].points;
    }
}

std::vector<Scorer::Watch> Scorer::make_watches(const auto& list) const {
    std::vector<Watch> out;
    const auto channel_index = [&](const Channel& channel) {
        return static_cast<std::size_t>(std::find(channels_.begin(), channels_.end(), channel) -
                                        channels_.begin());
    };
    for (const auto& one : list) {
        Watch watch;
        for (const Condition& c : one.when.conditions)
            watch.channels.push_back(channel_index({c.output, {}, {}}));
        if (one.when.conditions.empty())
            watch.channels.push_back(channel_index({"", one.when.event, one.when.of}));
        out.push_back(std::move(watch));
    }
    return out;
}

double Scorer::frozen_value(std::string_view output) const noexcept {
    const auto at = frozen_.find(output);
    return at == frozen_.end() ? std::numeric_limits<double>::quiet_NaN() : at->second;
}

double Scorer::sample(const Trigger& trigger, Watch& watch, std::span<const double> values,
                      bool shown) {
    if (trigger.conditions.empty()) {
        const double count = values[watch.channels[0]];
        watch.active = count > 0.0;
        return count;
    }
    bool holds = true;
    for (std::size_t i = 0; i < trigger.conditions.size(); ++i) {
        const Condition& c = trigger.conditions[i];
        double value = values[watch.channels[i]];
        if (shown)
            if (const auto at = frozen_.find(c.output); at != frozen_.end()) value = at->second;
        holds = holds && value >= c.above && value <= c.below;
    }
    watch.held_time = holds && watch.holds ? watch.held_time + step_ : 0.0;
    watch.holds = holds;
    watch.active = holds && watch.held_time + kTimeRounding >= trigger.hold;
    return watch.active ? 1.0 : 0.0;
}

void Scorer::log(Entry entry) {
    if (result_.entries.size() < kMaxLogged || entry.kind == EntryKind::end)
        result_.entries.push_back(std::move(entry));
}

void Scorer::update_alarms(double time, std::span<const double> values) {
    for (std::size_t i = 0; i < alarm_.size(); ++i) {
        const Alarm& alarm = exercise_->alarms[i];
        Tally& tally = result_.alarms[i];
        const bool before = alarm_[i].active;
        const double now = sample(alarm.when, alarm_[i], values, true);
        tally.active = now > 0.0;
        if (tally.active) tally.seconds += step_;
        if (tally.active && !before) {
            if (tally.times++ == 0) tally.time = time;
            log({time, EntryKind::alarm, alarm.name, alarm.text, "", 0.0});
        } else if (!tally.active && before && !alarm.when.conditions.empty()) {
            log({time, EntryKind::alarm_end, alarm.name, alarm.text, "", 0.0});
        }
    }
}

void Scorer::update_penalties(double time, std::span<const double> values) {
    for (std::size_t i = 0; i < penalty_.size(); ++i) {
        const Penalty& penalty = exercise_->penalties[i];
        Tally& tally = result_.penalties[i];
        const bool before = penalty_[i].active && !penalty.when.conditions.empty();
        const double now = sample(penalty.when, penalty_[i], values, false);
        tally.active = now > 0.0;
        if (!tally.active) continue;
        const double times = before ? 0.0 : now;
        if (times > 0.0 && tally.times == 0) tally.time = time;
        tally.times += static_cast<std::int32_t>(std::min(times, 1e6));
        if (!penalty.when.conditions.empty()) tally.seconds += step_;
        const double cost = penalty.points * times + penalty.per_second * step_;
        const double deducted = std::min(cost, penalty.most + tally.points);
        tally.points -= deducted;
        add_points(-deducted);
        if (times > 0.0) log({time, EntryKind::penalty, penalty.name, penalty.text, "", -deducted});
    }
}

void Scorer::update_goals(double time, std::span<const double> values) {
    for (std::size_t i = 0; i < goal_.size(); ++i) {
        const Goal& goal = exercise_->goals[i];
        Tally& tally = result_.goals[i];
        // A goal counts no holding time before the goal that precedes it is reached.
        const auto first =
            std::find_if(exercise_->goals.begin(), exercise_->goals.end(),
                         [&](const Goal& other) { return other.name == goal.after; });
        const bool due =
            goal.after.empty() ||
            result_.goals[static_cast<std::size_t>(first - exercise_->goals.begin())].reached;
        if (tally.reached || !due) continue;
        const bool reached = sample(goal.when, goal_[i], values, false) > 0.0;
        if (!reached || (goal.by && time > *goal.by + kTimeRounding)) continue;
        tally.reached = true;
        tally.time = time;
        tally.times = 1;
        tally.points = goal.points;
        add_points(goal.points);
        log({time, EntryKind::goal, goal.name, goal.text, "", goal.points});
    }
}

void Scorer::update_ends(double time, std::span<const double> values) {
    for (std::size_t i = 0; i < end_.size(); ++i) {
        const End& one = exercise_->ends[i];
        if (sample(one.when, end_[i], values, false) > 0.0)
            return end(time, one.text.empty() ? one.name : one.text, one.failed);
    }
    const auto decided = [&](std::size_t i) {
        const std::optional<double>& by = exercise_->goals[i].by;
        return result_.goals[i].reached || (by && time > *by + kTimeRounding);
    };
    bool all = exercise_->until_done && !exercise_->goals.empty();
    for (std::size_t i = 0; i < exercise_->goals.size(); ++i) all = all && decided(i);
    if (all) return end(time, "all goals are decided", false);
    if (time + kTimeRounding >= exercise_->duration) end(time, "the time is over", false);
}

void Scorer::after_step(double time, std::span<const double> values) {
    if (ended()) return;
    last_.assign(values.begin(), values.end());
    result_.time = time;
    update_alarms(time, values);
    update_penalties(time, values);
    update_goals(time, values);
    update_ends(time, values);
}

void Scorer::fault(double time, const Fault& fault, std::string_view by, bool begins) {
    if (fault.kind == FaultKind::output_frozen) {
        if (!begins) frozen_.erase(fault.target);
        for (std::size_t i = 0; begins && i < channels_.size(); ++i)
            if (channels_[i].output == fault.target && !std::isnan(last_[i]))
                frozen_[fault.target] = last_[i];
    }
    if (ended()) return;
    log({time, begins ? EntryKind::fault : EntryKind::fault_end, fault.name, fault.text,
         std::string(by), 0.0});
}

void Scorer::end(double time, const std::string& why, bool failed) {
    if (ended()) return;
    result_.time = time;
    result_.end = why;
    result_.outcome = failed || result_.points < result_.pass ? Outcome::failed : Outcome::passed;
    log({time, EntryKind::end, why, why, "", 0.0});
}

void Scorer::restored(double time) {
    result_.time = time;
    log({time, EntryKind::restored, "restored", "went back", std::string(kInstructor), 0.0});
}

}  // namespace hawser::exercise
