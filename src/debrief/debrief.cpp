// SPDX-License-Identifier: Apache-2.0
#include "debrief/debrief.h"

#include "debrief/curve_plots.h"
#include "draw/plots.h"
#include "draw/svg.h"
#include "record/series.h"

#include <hawser/hawser.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace hawser::debrief {
namespace {

using exercise::EntryKind;
using exercise::Outcome;
using exercise::Tally;

constexpr const char* kStyle = R"(
:root{color-scheme:light}
body{font:15px/1.5 Roboto,Helvetica,Arial,sans-serif;color:#20242a;background:#fff;margin:0 auto;
max-width:1180px;padding:28px}
h1{font-size:26px;margin:0 0 4px}h2{font-size:19px;margin:36px 0 8px;border-bottom:1px solid #d5dae1}
.soft{color:#5a626c}.badge{display:inline-block;padding:3px 14px;border-radius:4px;color:#fff;
font-weight:700}.passed{background:#0a6b4e}.failed{background:#a32020}.running{background:#5a626c}
.score{display:flex;gap:36px;margin:18px 0;flex-wrap:wrap}.score div{min-width:110px}
.score b{display:block;font-size:30px;font-variant-numeric:tabular-nums}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:5px 12px 5px 0;border-bottom:1px solid #e6eaef;vertical-align:top}
th{font-weight:600;color:#5a626c}td.n,th.n{text-align:right;padding-right:24px}
tr.bad td{background:#fdf0ef}tr.good td{background:#eef7f3}
svg{max-width:100%;height:auto;display:block}figure{margin:18px 0}figcaption{color:#5a626c}
@media print{body{max-width:none;padding:0}h2{break-after:avoid}figure,tr{break-inside:avoid}}
)";

std::string text(const std::string& s) { return draw::escape_xml(s); }

std::string clock(double time) {
    if (!std::isfinite(time)) return "–";
    const auto tenths = static_cast<std::int64_t>(std::llround(10.0 * std::clamp(time, 0.0, 1e9)));
    return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

std::string points(double value) {
    return value == 0.0 ? "0" : fmt::format("{}{:.4g}", value > 0.0 ? "+" : "−", std::abs(value));
}

std::string output_label(const std::string& name, const std::string& words) {
    return words.empty()
               ? text(name)
               : fmt::format("{}<br><span class=\"soft\">{}</span>", text(words), text(name));
}

std::string heading(const exercise::Exercise& e, const exercise::Result& r) {
    std::string out =
        fmt::format("<h1>{} <span class=\"badge {}\">{}</span></h1>\n<p class=\"soft\">{}</p>\n",
                    text(e.name), to_string(r.outcome), to_string(r.outcome), text(e.description));
    out += fmt::format(
        "<div class=\"score\"><div><b>{:.4g}</b>points of {:.4g}</div><div><b>{:.4g}</b>needed "
        "to pass</div><div><b>{}</b>min:s taken</div><div><b>{}</b>alarms</div></div>\n",
        r.points, r.possible, r.pass, clock(r.time), [&] {
            int n = 0;
            for (const Tally& t : r.alarms) n += t.times;
            return n;
        }());
    return out + fmt::format("<p>It ended at {}: {}.</p>\n", clock(r.time), text(r.end));
}

std::string goal_table(const exercise::Result& r) {
    if (r.goals.empty()) return "";
    std::string out =
        "<h2>Goals</h2>\n<table><tr><th>goal</th><th class=\"n\">reached at</th><th "
        "class=\"n\">points</th><th class=\"n\">of</th></tr>\n";
    for (const Tally& t : r.goals)
        out += fmt::format(
            "<tr class=\"{}\"><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
            "class=\"n\">{:.4g}</td></tr>\n",
            t.reached ? "good" : "bad", output_label(t.name, t.text),
            t.reached ? clock(t.time) : "not reached", points(t.points), t.possible);
    return out + "</table>\n";
}

std::string tally_table(const char* title, const std::vector<Tally>& list, bool cost) {
    if (list.empty()) return "";
    std::string out = fmt::format(
        "<h2>{}</h2>\n<table><tr><th>what</th><th class=\"n\">times</th><th class=\"n\">first "
        "at</th><th class=\"n\">seconds in all</th>{}</tr>\n",
        title, cost ? "<th class=\"n\">points</th>" : "");
    for (const Tally& t : list)
        out += fmt::format(
            "<tr class=\"{}\"><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
            "class=\"n\">{:.1f}</td>{}</tr>\n",
            t.times > 0 ? "bad" : "", output_label(t.name, t.text), t.times,
            t.times > 0 ? clock(t.time) : "–", t.seconds,
            cost ? fmt::format("<td class=\"n\">{}</td>", points(t.points)) : "");
    return out + "</table>\n";
}

std::string entry_table(const exercise::Result& r) {
    static constexpr const char* kEntryWords[] = {"goal reached", "penalty", "alarm",
                                                  "alarm over",   "fault",   "fault over",
                                                  "went back",    "end"};
    std::string out =
        "<h2>What happened</h2>\n<table><tr><th class=\"n\">at</th><th></th><th>what</th><th>by"
        "</th><th class=\"n\">points</th></tr>\n";
    for (const exercise::Entry& e : r.entries) {
        const bool bad = e.kind == EntryKind::penalty || e.kind == EntryKind::alarm ||
                         e.kind == EntryKind::fault;
        out += fmt::format(
            "<tr class=\"{}\"><td class=\"n\">{}</td><td>{}</td><td>{}</td><td>{}</td><td "
            "class=\"n\">{}</td></tr>\n",
            e.kind == EntryKind::goal ? "good"
            : bad                     ? "bad"
                                      : "",
            clock(e.time), kEntryWords[static_cast<std::size_t>(e.kind)],
            text(e.text.empty() ? e.name : e.text), text(e.by),
            e.points != 0.0 ? points(e.points) : "");
    }
    return out + "</table>\n";
}

/// Return an HTML figure with an embedded SVG, without the XML declaration that a separate file
/// needs.
std::string figure(const draw::Drawing& drawing, const std::string& caption) {
    const std::string svg = draw::to_svg(drawing);
    return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n",
                       svg.substr(svg.find("<svg")), text(caption));
}

std::string pictures(const record::Recording& recording) {
    if (recording.frame_count() == 0) return "";
    const record::Series series = record::collect_series(recording);
    std::string out = "<h2>Pictures</h2>\n";
    const std::size_t last = recording.frame_count() - 1;
    for (const std::size_t frame : {last / 2, last})
        if (const auto view = draw::plot_space(recording, series, frame, {}))
            out += figure(*view,
                          fmt::format("The scene at {}.", clock(recording.frame_head(frame).time)));
    if (const auto view = draw::plot_views(recording, series, last))
        out += figure(*view, "From the side and from above, at the end.");
    if (const auto tensions = draw::plot_tensions(recording, series))
        out += figure(*tensions, "Tensions of the wires.");
    return out;
}

}  // namespace

std::string to_html(const exercise::Exercise& exercise, const exercise::Result& result,
                    const exercise::Curves& curves, const record::Recording* recording,
                    const std::string& people) {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
        text(exercise.name) + ": debriefing</title>\n<style>" + kStyle +
        "</style>\n</head>\n<body>\n";
    out += heading(exercise, result);
    if (!people.empty()) out += fmt::format("<p><b>{}</b></p>\n", text(people));
    out += goal_table(result);
    out += tally_table("Penalties", result.penalties, true);
    out += tally_table("Alarms", result.alarms, false);
    out += entry_table(result);
    if (const auto plot = plot_curves(exercise, result, curves))
        out += "<h2>Displays</h2>\n" +
               figure(*plot,
                      "What the stations saw. Grey lines: limits of goals, alarms and "
                      "penalties; marks below: what happened.");
    if (recording != nullptr) out += pictures(*recording);
    out += fmt::format("<p class=\"soft\">hawser {}</p>\n</body>\n</html>\n", version());
    return out;
}

}  // namespace hawser::debrief
