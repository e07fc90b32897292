// SPDX-License-Identifier: Apache-2.0
#include "report/wires_json.h"

#include <nlohmann/json.hpp>

namespace hawser::report {

using Json = nlohmann::ordered_json;

namespace {

Json course_json(const Course& c) {
    return {{"start", c.start}, {"end", c.now}, {"least", c.least}, {"most", c.most}};
}

}  // namespace

Json broken_json(const std::vector<BrokenWire>& all) {
    Json out = Json::array();
    for (const BrokenWire& p : all)
        out.push_back({{"time", p.time},
                       {"wire", p.wire.empty() ? Json() : Json(p.wire)},
                       {"s", p.wire.empty() ? Json() : Json(p.s)},
                       {"length", p.wire.empty() ? Json() : Json(p.length)},
                       {"element", p.element},
                       {"tension", p.tension}});
    return out;
}

Json wires_json(const std::vector<WireFigures>& wires) {
    Json out = Json::object();
    for (const WireFigures& w : wires) {
        Json least = Json::array(), mean = Json::array(), greatest = Json::array();
        for (const TensionAlong& t : w.along) {
            least.push_back(t.least);
            mean.push_back(t.mean);
            greatest.push_back(t.greatest);
        }
        Json time = Json::array(), nodes = Json::array(), shortest = Json::array(),
             longest = Json::array();
        for (const Resolved& r : w.times) {
            time.push_back(r.time);
            nodes.push_back(r.nodes);
            shortest.push_back(r.shortest);
            longest.push_back(r.longest);
        }
        out[w.name] = {
            {"since", w.since},
            {"nodes", course_json(w.nodes)},
            {"length", course_json(w.length)},
            {"shortest", course_json(w.shortest)},
            {"longest", course_json(w.longest)},
            {"mass", course_json(w.mass)},
            {"resolution",
             {{"time", time}, {"nodes", nodes}, {"shortest", shortest}, {"longest", longest}}},
            {"parted", broken_json(w.broken_wires)},
            {"tension_along", {{"least", least}, {"mean", mean}, {"greatest", greatest}}}};
    }
    return out;
}

}  // namespace hawser::report
