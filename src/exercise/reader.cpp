// SPDX-License-Identifier: Apache-2.0
#include "exercise/reader.h"

#include "exercise/format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace hawser::exercise {
namespace {

using scene::Json;
using scene::SourceLocation;

std::string word(const Json& json, const char* key) {
    const auto at = json.find(key);
    return at == json.end() ? std::string() : at->get<std::string>();
}

double value(const Json& json, const char* key, double fallback) {
    const auto at = json.find(key);
    return at == json.end() ? fallback : at->get<double>();
}

std::optional<double> optional_number(const Json& json, const char* key) {
    const auto at = json.find(key);
    return at == json.end() ? std::nullopt : std::optional(at->get<double>());
}

std::vector<std::string> words(const Json& json, const char* key) {
    const auto at = json.find(key);
    return at == json.end() ? std::vector<std::string>() : at->get<std::vector<std::string>>();
}

Trigger read_trigger(const Json& json, const SourceLocation& location) {
    Trigger out;
    out.hold = value(json, "hold", 0.0);
    out.of = word(json, "of");
    if (json.contains("event")) {
        const std::vector<std::string> known = event_words();
        const auto at = std::find(known.begin(), known.end(), json["event"].get<std::string>());
        out.event = static_cast<EventKind>(at - known.begin());
        return out;
    }
    if (!json.contains("when")) scene::throw_error(location, "needs \"when\" or \"event\"");
    for (std::size_t i = 0; i < json["when"].size(); ++i) {
        const Json& one = json["when"][i];
        Condition c;
        c.output = word(one, "output");
        c.above = value(one, "above", c.above);
        c.below = value(one, "below", c.below);
        if (!one.contains("above") && !one.contains("below"))
            scene::throw_error(location / "when" / i, "needs \"above\" or \"below\"");
        if (c.above > c.below)
            scene::throw_error(location / "when" / i,
                               "this condition is never met: \"above\" is greater than \"below\"");
        out.conditions.push_back(std::move(c));
    }
    return out;
}

Fault read_fault(const Json& json, const SourceLocation&) {
    Fault out;
    const std::string kind = word(json, "kind");
    const auto known = fault_words();
    out.kind = static_cast<FaultKind>(std::find(known.begin(), known.end(), kind) - known.begin());
    for (const char* key : {"wire", "motor", "brake", "input", "output"})
        if (json.contains(key)) out.target = word(json, key);
    out.s = value(json, "s", out.s);
    out.share = value(json, "share", out.share);
    out.value = value(json, "value", out.value);
    out.delay = value(json, "delay", out.delay);
    out.at = optional_number(json, "at");
    out.lasts = value(json, "lasts", out.lasts);
    return out;
}

Alarm read_alarm(const Json& json, const SourceLocation& location) {
    return {"", "", read_trigger(json, location)};
}

Goal read_goal(const Json& json, const SourceLocation& location) {
    Goal out;
    out.when = read_trigger(json, location);
    out.points = value(json, "points", 0.0);
    out.after = word(json, "after");
    out.by = optional_number(json, "by");
    return out;
}

Phase read_phase(const Json& json, const SourceLocation&) { return {"", "", word(json, "goal")}; }

Penalty read_penalty(const Json& json, const SourceLocation& location) {
    Penalty out;
    out.when = read_trigger(json, location);
    out.points = value(json, "points", 0.0);
    out.per_second = value(json, "per_second", 0.0);
    out.most = value(json, "most", out.most);
    return out;
}

End read_end(const Json& json, const SourceLocation& location) {
    End out;
    out.when = read_trigger(json, location);
    out.failed = json.value("failed", false);
    return out;
}

Station read_station(const Json& json, const SourceLocation& location) {
    Station out;
    out.inputs = words(json, "inputs");
    out.layout = word(json, "layout");
    if (const std::string name = word(json, "name"); name == kInstructor || name == kWatcher)
        scene::throw_error(location / "name",
                           scene::in_quotes(name) + " is a role of every exercise");
    return out;
}

/// Read a list of entries with unique names.
template <class T, class Read>
void read_list(const Json& root, const char* key, const SourceLocation& location,
               std::vector<T>& out, const Read& read) {
    const auto list = root.find(key);
    if (list == root.end()) return;
    std::set<std::string> names;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const SourceLocation at = location / key / i;
        T one = read((*list)[i], at);
        one.name = word((*list)[i], "name");
        one.text = word((*list)[i], "text");
        if (!names.insert(one.name).second)
            scene::throw_error(at / "name", scene::in_quotes(one.name) + " is there already");
        out.push_back(std::move(one));
    }
}

/// Check goals that follow others: the other goal must come earlier in the list, so that no goal
/// depends on itself.
void check_order(const Exercise& e, const SourceLocation& location) {
    std::vector<std::string> before;
    for (std::size_t i = 0; i < e.goals.size(); ++i) {
        const std::string& after = e.goals[i].after;
        if (!after.empty() && std::find(before.begin(), before.end(), after) == before.end())
            scene::throw_error(location / "goals" / i / "after",
                               "there is no goal " + scene::in_quotes(after) +
                                   " above it in the list" + scene::suggestion(after, before));
        before.push_back(e.goals[i].name);
    }
}

/// Check that the goals of phases exist.
void check_phases(const Exercise& e, const SourceLocation& location) {
    std::vector<std::string> goals;
    for (const Goal& goal : e.goals) goals.push_back(goal.name);
    for (std::size_t i = 0; i < e.phases.size(); ++i) {
        const std::string& goal = e.phases[i].goal;
        if (!goal.empty() && std::find(goals.begin(), goals.end(), goal) == goals.end())
            scene::throw_error(
                location / "phases" / i / "goal",
                "there is no goal " + scene::in_quotes(goal) + scene::suggestion(goal, goals));
    }
}

}  // namespace

Exercise read_exercise(const Json& root, const SourceLocation& location) {
    Exercise out;
    out.name = word(root, "exercise");
    out.description = word(root, "description");
    out.file = location.file;
    out.duration = value(root, "duration", out.duration);
    out.pass = value(root, "pass", out.pass);
    out.until_done = root.value("until_done", true);
    out.displays = words(root, "displays");
    read_list(root, "stations", location, out.stations, read_station);
    read_list(root, "faults", location, out.faults, read_fault);
    read_list(root, "alarms", location, out.alarms, read_alarm);
    read_list(root, "goals", location, out.goals, read_goal);
    read_list(root, "phases", location, out.phases, read_phase);
    read_list(root, "penalties", location, out.penalties, read_penalty);
    read_list(root, "ends", location, out.ends, read_end);
    check_order(out, location);
    check_phases(out, location);
    return out;
}

Exercise parse_exercise(const std::string& text, const std::string& name) {
    const Json root = scene::parse_json(text, name, {});
    scene::check_shape(root, *exercise_shape(), {name, ""});
    Exercise out = read_exercise(root, {name, ""});
    out.text = text;
    return out;
}

}  // namespace hawser::exercise
