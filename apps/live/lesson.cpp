// SPDX-License-Identifier: Apache-2.0
#include "live/lesson.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

namespace hawser::live {
namespace {

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Convert the points and counts of an exercise to JSON, without empty fields.
Json tally_json(const exercise::Tally& tally) {
    return {{"name", tally.name}, {"text", tally.text}, {"points", tally.points}};
}

bool of_faults(exercise::EntryKind kind) {
    return kind == exercise::EntryKind::fault || kind == exercise::EntryKind::fault_end;
}

std::string entry_text(const exercise::Entry& entry) {
    using exercise::EntryKind;
    const std::string& what = entry.text.empty() ? entry.name : entry.text;
    switch (entry.kind) {
        case EntryKind::goal:
            return fmt::format("goal reached: {}, {:+.6g} points", what, entry.points);
        case EntryKind::penalty:
            return fmt::format("penalty: {}, {:+.6g} points", what, entry.points);
        case EntryKind::alarm:
            return "alarm: " + what;
        case EntryKind::alarm_end:
            return "alarm over: " + what;
        case EntryKind::fault:
            return "fault: " + what;
        case EntryKind::fault_end:
            return "fault over: " + what;
        case EntryKind::restored:
            return what;
        case EntryKind::end:
            return "the exercise ends: " + what;
    }
    return what;
}

Json goals_json(const exercise::Exercise& exercise, const exercise::Result& result) {
    Json out = Json::array();
    for (std::size_t i = 0; i < result.goals.size(); ++i) {
        const exercise::Tally& tally = result.goals[i];
        const exercise::Goal& goal = exercise.goals[i];
        Json one = tally_json(tally);
        one["possible"] = goal.points;
        one["reached"] = tally.reached ? Json(tally.time) : Json(nullptr);
        one["by"] = goal.by ? Json(*goal.by) : Json(nullptr);
        one["after"] = goal.after;
        one["late"] = !tally.reached && goal.by && result.time > *goal.by;
        out.push_back(std::move(one));
    }
    return out;
}

Json interval_tallies_json(const std::vector<exercise::Tally>& tallies, bool points) {
    Json out = Json::array();
    for (const exercise::Tally& tally : tallies) {
        Json one = tally_json(tally);
        if (!points) one.erase("points");
        one["times"] = tally.times;
        one["seconds"] = std::round(10.0 * tally.seconds) / 10.0;
        one["active"] = tally.active;
        out.push_back(std::move(one));
    }
    return out;
}

}  // namespace

std::vector<Role> roles_of(const exercise::Exercise& exercise) {
    std::vector<Role> out{instructor()};
    for (const exercise::Station& station : exercise.stations) {
        constexpr std::size_t kMaximum = decltype(Command::role)::kMaximum;
        if (station.name.size() > kMaximum)
            throw exercise::Refused(
                fmt::format("the station \"{}\" has a name of {} bytes; `hawser view` takes {}: "
                            "shorten it in {}",
                            station.name, station.name.size(), kMaximum, exercise.file));
        out.push_back({.name = station.name, .inputs = station.inputs, .token = make_token()});
    }
    out.push_back(watcher());
    return out;
}

void Lesson::set_input(const Command& command) {
    run_.set_input(command.role.view(), command.name.view(), command.value);
}

void Lesson::fault(const Command& command) {
    if (command.value != 0.0)
        run_.trigger(command.role.view(), command.name.view());
    else
        run_.clear(command.role.view(), command.name.view());
}

void Lesson::end(const Command& command) {
    if (run_.ended()) throw DefError("the exercise has ended already");
    run_.end(fmt::format("ended by the {}", command.role.view()), false);
}

void Lesson::return_to_mark(int mark) {
    run_.back_to(mark);
    // The last entry records the restored state. Clients receive it as a command instead.
    reported_ = run_.result().entries.size();
}

void Lesson::send_entries(Outbox& out) {
    const auto& entries = run_.result().entries;
    for (; reported_ < entries.size(); ++reported_) {
        const exercise::Entry& entry = entries[reported_];
        out.event(entry.time, exercise::to_string(entry.kind), entry.name, entry.points,
                  entry_text(entry), of_faults(entry.kind));
    }
}

Json Lesson::state() const {
    const exercise::Result& r = run_.result();
    Json stations = Json::array();
    for (const exercise::Station& station : exercise_.stations)
        stations.push_back({{"name", station.name},
                            {"text", station.text},
                            {"layout", station.layout},
                            {"inputs", station.inputs}});
    return {{"type", "exercise"},
            {"name", exercise_.name},
            {"description", exercise_.description},
            {"duration", number_or_null(exercise_.duration)},
            {"outcome", exercise::to_string(r.outcome)},
            {"end", r.end},
            {"ended", run_.ended() ? Json(r.time) : Json(nullptr)},
            {"points", r.points},
            {"possible", r.possible},
            {"pass", r.pass},
            {"goals", goals_json(exercise_, r)},
            {"penalties", interval_tallies_json(r.penalties, true)},
            {"alarms", interval_tallies_json(r.alarms, false)},
            {"stations", std::move(stations)},
            {"displays", exercise_.displays}};
}

Json Lesson::faults() const {
    Json out = Json::array();
    for (const exercise::Fault& fault : exercise_.faults)
        out.push_back({{"name", fault.name},
                       {"text", fault.text},
                       {"kind", exercise::to_string(fault.kind)},
                       {"target", fault.target},
                       {"at", fault.at ? Json(*fault.at) : Json(nullptr)},
                       {"lasts", number_or_null(fault.lasts)},
                       {"ends", fault.kind != exercise::FaultKind::line_parts},
                       {"active", run_.active(fault.name)}});
    return {{"type", "faults"}, {"faults", std::move(out)}};
}

void Lesson::send_now(Outbox& out) {
    send_entries(out);
    const Json now = state();
    std::string text = now.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text != last_) {
        out.exercise(now);
        last_ = std::move(text);
    }
    out.faults(faults());
}

void Lesson::report_news(const World& world, Outbox& out) {
    constexpr std::int64_t kStepsBetweenReports = 15;  // steps
    const std::int64_t step = world.step_count();
    const bool news = reported_ != run_.result().entries.size();
    if (!news && std::abs(step - reported_step_) < kStepsBetweenReports) return;
    reported_step_ = step;
    send_now(out);
}

const std::vector<ShownOutput>& Lesson::frozen(const World& world, const FramePlan& plan) {
    frozen_.clear();
    for (const exercise::Fault& fault : exercise_.faults) {
        if (fault.kind != exercise::FaultKind::output_frozen || !run_.active(fault.name)) continue;
        const OutputId id = world.find_output(fault.target);
        for (std::size_t k = 0; id.valid() && k < plan.outputs.size(); ++k)
            if (plan.outputs[k] == id) frozen_.push_back({k, run_.shown(fault.target)});
    }
    return frozen_;
}

}  // namespace hawser::live
