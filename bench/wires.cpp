// SPDX-License-Identifier: Apache-2.0
// hawser-bench wires: a wire around a bollard, by Hawser's methods and those of other engines.
#include "commands.h"
#include "wires/measure.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace hawser::bench {
namespace {

using nlohmann::json;
using wires::WireFigures;
using wires::WireMethod;
using wires::WirePlan;

constexpr const char* kWiresFooter =
    R"(A wire of 23 kg/m and EA 2.33e8 N turns round a fixed post of 0.5 m by half a turn, one and a half
and three, mu = 0.25: a weight of 1 t on one leg, a pull on the other, frames of 1/60 s, one thread.
  slips   ratio of the forces at which the weight begins to run, by halving; exact: e^(mu theta)
  error   of that ratio; own: what a polygon of lumps makes of it by its closed form (ours)
  creep   way of the weight in 10 s at 99 % of that ratio
  ms      median CPU time of a frame, with as many substeps as it takes to stand half-way to slipping
          (ours: one)
Exit code 1 where a route of ours is off by more than 1e-4 or creeps by more than 1e-9 m.)";

struct WiresOptions {
    std::vector<std::string> engines;
    std::vector<double> turns{0.5, 1.5, 3.0};
    std::string json_file;
    bool quick = false;
    WirePlan plan;
};

/// Return the methods whose names begin with one of the requested names.
std::vector<WireMethod> chosen_methods(const WiresOptions& o) {
    std::vector<WireMethod> out;
    const std::vector<WireMethod> all = wires::methods();
    for (const std::string& name : o.engines) {
        const auto named = [&](const WireMethod& m) { return m.name.rfind(name, 0) == 0; };
        if (name.empty() || std::none_of(all.begin(), all.end(), named)) {
            std::string known;
            for (const WireMethod& m : all) known += (known.empty() ? "" : ", ") + m.name;
            throw std::invalid_argument(
                fmt::format("--engines: none begins with '{}'; there are: {}", name, known));
        }
    }
    for (const WireMethod& m : all) {
        const auto asks = [&](const std::string& name) { return m.name.rfind(name, 0) == 0; };
        if (!o.engines.empty() && std::none_of(o.engines.begin(), o.engines.end(), asks)) continue;
        if (!o.quick || m.quick) out.push_back(m);
    }
    return out;
}

void print_figures(const WireFigures& f, double creep_asked) {
    if (!f.has_case) {
        fmt::print("{:<19}  has no such case\n", f.method);
        return;
    }
    if (!f.holds) {
        fmt::print("{:<19} {:>8}  does not hold: {} ({:.3g} ms a frame, gap {:.1e} m)\n", f.method,
                   f.substeps, f.reason_unusable, f.ms, f.gap);
        return;
    }
    const std::string own = f.ours ? fmt::format("{:.1e}", f.own_error) : "-";
    const bool cut = f.creep_seconds < creep_asked - 0.1;
    const std::string creep =
        f.creep_seconds > 0.0 ? fmt::format("{:.1e}{}", f.creep, cut ? "*" : " ") : "lost ";
    fmt::print("{:<19} {:>8} {:>9.3f} {:>10.1e} {:>9.0e} {:>9} {:>10} {:>9.1e} {:>8.3f}\n",
               f.method, f.substeps, f.ratio, f.error, f.width, own, creep, f.gap, f.ms);
}

json figures_json(const WireFigures& f) {
    json j{{"method", f.method}, {"turns", f.turns},       {"has_case", f.has_case},
           {"holds", f.holds},   {"settings", f.settings}, {"substeps", f.substeps}};
    if (!f.has_case) return j;
    j["ms_per_frame"] = f.ms;
    j["gap_m"] = f.gap;
    if (!f.holds) {
        j["why_not"] = f.reason_unusable;
        return j;
    }
    j["slip_ratio"] = f.ratio;
    j["slip_ratio_relative_width"] = f.width;
    j["capstan_error"] = f.error;
    if (f.ours) j["capstan_error_of_geometry"] = f.own_error;
    j["creep_m"] = f.creep_seconds > 0.0 ? json(f.creep) : json();  // null: lost before
    j["creep_seconds"] = f.creep_seconds;
    return j;
}

/// True if the result is exact, for Hawser: routes have no geometry of their own.
bool is_good(const WireFigures& f) {
    if (f.method.rfind("hawser-route", 0) != 0) return true;
    return f.holds && std::abs(f.error) <= 1e-4 && f.creep <= 1e-9;
}

json units() {
    return {{"turns", "1"},
            {"substeps", "per frame of 1/60 s"},
            {"slip_ratio", "1, pull over weight"},
            {"slip_ratio_relative_width", "1"},
            {"capstan_error", "1, slip_ratio/exp(mu theta) - 1"},
            {"capstan_error_of_geometry", "1"},
            {"creep_m", "m"},
            {"creep_seconds", "s"},
            {"gap_m", "m"},
            {"ms_per_frame", "ms, CPU time, median"}};
}

int compare_wires(const WiresOptions& o) {
    const std::vector<WireMethod> all = chosen_methods(o);
    json rows = json::array(), absent = json::array();
    for (const WireMethod& m : all) {
        if (m.in_build) continue;
        fmt::print("{:<19}  not installed\n", m.name);
        absent.push_back(m.name);
    }
    bool good = true;
    for (const double turns : o.turns) {
        fmt::print("\n{:g} turn(s), e^(mu theta) = {:.4f}\n", turns,
                   std::exp(wires::kRub * 2.0 * wires::kPi * turns));
        fmt::print("{:<19} {:>8} {:>9} {:>10} {:>9} {:>9} {:>9}  {:>9} {:>8}\n", "", "substeps",
                   "slips", "error", "+-", "own", "creep [m]", "gap [m]", "ms");
        for (const WireMethod& m : all) {
            if (!m.in_build) continue;
            const WireFigures f = wires::measure(m, turns, o.plan);
            print_figures(f, o.plan.creep);
            rows.push_back(figures_json(f));
            if (is_good(f)) continue;
            good = false;
            fmt::print("  MISSED: {} at {:g} turns\n", m.name, turns);
        }
    }
    fmt::print("\n* it was lost (0.2 m) before {:g} s were over; lost: before they began\n",
               o.plan.creep);
    if (o.json_file.empty()) return good ? 0 : 1;
    std::ofstream out(o.json_file);
    out << json{{"step_s", wires::kFrame}, {"friction", wires::kRub},
                {"units", units()},        {"rows", rows},
                {"not_installed", absent}, {"good", good}}
               .dump(1)
        << '\n';
    if (!out) throw std::runtime_error("cannot write " + o.json_file);
    return good ? 0 : 1;
}

}  // namespace

int wires_command(int argc, char** argv) {
    CLI::App app("A wire round a post: capstan error, creep and cost, beside other engines.",
                 "hawser-bench wires");
    std::string known;
    for (const WireMethod& m : wires::methods())
        known += fmt::format("\n  {}: {}{}", m.name, m.description,
                             m.in_build ? "" : " (not installed)");
    app.footer(kWiresFooter);
    WiresOptions o;
    app.add_option("--engines", o.engines,
                   "Comma-separated beginnings of names, default all:" + known)
        ->delimiter(',');
    app.add_option("--turns", o.turns, "Comma-separated")
        ->delimiter(',')
        ->check(CLI::IsMember(std::vector<double>{0.5, 1.5, 3.0}));
    app.add_option("--budget", o.plan.budget, "CPU time of a search before it ends as it is [s]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--max-substeps", o.plan.max_substeps, "Of peers")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_option("--substeps", o.plan.substeps, "No search of the least: peers take this many")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--quick", o.quick, "Some of ours, short runs: seconds");
    app.add_option("--json", o.json_file, "Write the figures to this file, with units");
    CLI11_PARSE(app, argc, argv);
    o.plan.max_substeps = std::max(o.plan.max_substeps, o.plan.substeps);
    if (o.quick) {
        o.plan.wait = 2.0;
        o.plan.creep = 2.0;
    }
    return compare_wires(o);
}

}  // namespace hawser::bench
