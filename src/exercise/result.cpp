// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>

#include <nlohmann/json.hpp>

namespace hawser::exercise {
namespace {

using Ordered = nlohmann::ordered_json;

Ordered tallies_json(const std::vector<Tally>& list, bool goals) {
    Ordered out = Ordered::array();
    for (const Tally& t : list) {
        Ordered one{{"name", t.name}};
        if (goals) {
            one["reached"] = t.reached;
            if (t.reached) one["time"] = t.time;
            one["points"] = t.points;
            one["possible"] = t.possible;
        } else {
            one["times"] = t.times;
            if (t.times > 0) one["first"] = t.time;
            one["seconds"] = t.seconds;
            one["points"] = t.points;
        }
        out.push_back(std::move(one));
    }
    return out;
}

}  // namespace

const char* to_string(EntryKind kind) noexcept {
    constexpr const char* kNames[] = {"goal",  "penalty",   "alarm",    "alarm_end",
                                      "fault", "fault_end", "restored", "end"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* to_string(Outcome outcome) noexcept {
    constexpr const char* kNames[] = {"running", "passed", "failed"};
    return kNames[static_cast<std::size_t>(outcome)];
}

std::string to_json(const Result& result) {
    Ordered out{{"exercise", result.exercise}, {"outcome", to_string(result.outcome)},
                {"end", result.end},           {"time", result.time},
                {"points", result.points},     {"possible", result.possible},
                {"pass", result.pass}};
    out["goals"] = tallies_json(result.goals, true);
    out["penalties"] = tallies_json(result.penalties, false);
    out["alarms"] = tallies_json(result.alarms, false);
    Ordered entries = Ordered::array();
    for (const Entry& e : result.entries) {
        Ordered one{{"time", e.time}, {"kind", to_string(e.kind)}, {"name", e.name}};
        if (!e.by.empty()) one["by"] = e.by;
        if (e.points != 0.0) one["points"] = e.points;
        entries.push_back(std::move(one));
    }
    out["entries"] = std::move(entries);
    return out.dump(1, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace hawser::exercise
