// SPDX-License-Identifier: Apache-2.0
#include "live/debriefing.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::live {
namespace {

using Json = nlohmann::json;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json tallies_json(const std::vector<exercise::Tally>& tallies) {
    Json out = Json::array();
    for (const exercise::Tally& t : tallies)
        out.push_back({{"name", t.name},
                       {"text", t.text},
                       {"reached", t.reached ? Json(t.time) : Json(nullptr)},
                       {"times", t.times},
                       {"seconds", t.seconds},
                       {"points", t.points},
                       {"possible", t.possible}});
    return out;
}

Json entries_json(const exercise::Result& result) {
    Json out = Json::array();
    for (const exercise::Entry& e : result.entries)
        out.push_back({{"time", e.time},
                       {"kind", exercise::to_string(e.kind)},
                       {"name", e.name},
                       {"text", e.text},
                       {"by", e.by},
                       {"points", e.points}});
    return out;
}

}  // namespace

Json debriefing_json(const exercise::Exercise& exercise, const exercise::Result& result,
                     const exercise::Curves& curves,
                     const std::vector<exercise::ControlRequest>& requests, std::size_t most) {
    // The last sample is kept, so that curves end with the run.
    const std::size_t count = curves.time.size(), every = std::max<std::size_t>(1, count / most);
    const auto thinned = [&](const std::vector<double>& values) {
        Json out = Json::array();
        for (std::size_t k = (count + every - 1) % every; k < values.size(); k += every)
            out.push_back(finite_or_null(values[k]));
        return out;
    };
    Json values = Json::array();
    for (const auto& one : curves.values) values.push_back(thinned(one));
    Json controls = Json::array();
    for (const exercise::ControlRequest& r : requests) {
        if (controls.size() >= 16 * most) break;
        controls.push_back({r.time, r.role, r.input, r.value});
    }
    return {{"type", "debriefing"},
            {"name", exercise.name},
            {"description", exercise.description},
            {"outcome", exercise::to_string(result.outcome)},
            {"end", result.end},
            {"time", result.time},
            {"points", result.points},
            {"possible", result.possible},
            {"pass", result.pass},
            {"goals", tallies_json(result.goals)},
            {"penalties", tallies_json(result.penalties)},
            {"alarms", tallies_json(result.alarms)},
            {"entries", entries_json(result)},
            {"displays", exercise.displays},
            {"times", thinned(curves.time)},
            {"values", std::move(values)},
            {"controls", std::move(controls)}};
}

}  // namespace hawser::live
