// SPDX-License-Identifier: Apache-2.0
#include "validate/validate.h"

#include "record/files.h"
#include "validate/cases.h"
#include "validate/data.h"
#include "validate/firstday.h"
#include "validate/robust.h"
#include "validate/sea.h"
#include "validate/untuned.h"
#include "validate/vessels.h"
#include "validate/wires.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iterator>
#include <span>

namespace hawser::validate {
namespace {

constexpr Case kCases[] = {
    {"1", "pendulum", "period of a pendulum at 90 and 30 degrees and small", case_pendulum_period},
    {"2", "a01", "IFToMM A01, simple pendulum", case_pendulum_a01},
    {"3", "n_four_bar", "IFToMM A02, two four-bar windows", case_n_four_bar},
    {"4", "andrews_squeezer", "IFToMM A03, Andrews' squeezing mechanism", case_andrews},
    {"5", "bricard", "IFToMM A04, Bricard's mechanism", case_bricard},
    {"7", "dzhanibekov", "free body about its middle axis", case_dzhanibekov},
    {"8", "heavy_top", "steady precession of a heavy top", case_heavy_top},
    {"9", "catenary", "hanging cable, span 80 m, length 100 m", case_catenary},
    {"13", "hanging_chain", "frequencies of a hanging chain", case_hanging_chain},
    {"14", "taut_string", "frequencies of a taut string", case_taut_string},
    {"15", "beams", "sag of a cantilever and of a beam on two pins", case_beams},
    {"16", "euler_column", "buckling load of a pinned column", case_euler_column},
    {"17", "capstan", "wire pulled over a cylinder", case_capstan},
    {"17.1", "bollard", "line round a bollard, friction of its material", case_bollard},
    {"17.2", "tackle", "blocks of 2 to 16 parts with sheaves that rub", case_tackle},
    {"18", "incline", "boxes on slopes of eight headings", case_incline},
    {"18.1", "belt", "boxes put on a moving belt", case_belt},
    {"18.2", "joint_friction", "dry friction of slides and hinges", case_joint_friction},
    {"18.3", "joint_limits", "ends of travel", case_joint_limits},
    {"18.4", "motor_limits", "motors at the end of their force", case_motor_limits},
    {"19", "rolling_sphere", "sliding balls begin to roll", case_rolling_sphere},
    {"19.1", "spinning_disk", "disks that spin and slide", case_spinning_disk},
    {"19.2", "rolling_resistance", "balls with resistance to rolling and spinning",
     case_rolling_resistance},
    {"20", "bouncing_ball", "a ball bounces until it rests", case_bouncing_ball},
    {"21", "painleve", "Painleve's rod", case_painleve},
    {"22", "stacks", "ten boxes, the top one 1e3 and 1e6 times as heavy", case_stacks},
    {"22.1", "walls", "walls of 90 and 133 bricks", case_walls},
    {"23", "slider_crank", "kinematics of a slider-crank", case_slider_crank},
    {"26", "momentum", "momentum of a free cable scene", case_momentum},
    {"29", "winches", "layers, brake, constant tension and release of a winch", case_winches},
    {"30", "cranes", "falls, cylinders, alarms and hook of cranes", case_cranes},
    {"A.2.1", "static", "violation at rest is compliance times force", case_static_violation},
    {"A.2.2", "decay", "decay of a violation", case_violation_decay},
    {"A.2.3", "invariant", "quadratic invariant and frequency", case_linear_invariant},
    {"A.2.4", "stability", "linear stability for all damping and stiffness", case_linear_stability},
    {"A.2.5", "curvature", "violation caused by curvature", case_curvature_violation},
    {"A.2.6", "order", "second order with a staggered start, first without", case_order},
    {"A.2.7", "energy", "energy lost by a pendulum", case_energy_loss},
};

/// Cases that run by the name of their group.
struct CaseGroup {
    const char* name;  ///< Empty: cases run by their own names alone.
    const char* text;
    std::span<const Case> (*cases)();
};
constexpr CaseGroup kGroups[] = {
    {"robust", "robust: beyond what a step resolves, not among those that run unasked",
     robust_cases},
    {"wires", "wires: against closed forms, not among those that run unasked", wire_cases},
    {"sea", "sea: water against closed forms, not among those that run unasked", sea_cases},
    {"firstday", "firstday: what the first scenes of a user meet, not among those that run unasked",
     firstday_cases},
    {"untuned", "untuned: mechanisms and wires over ranges, not among those that run unasked",
     untuned_cases},
    {"vessels", "vessels: ships that manoeuvre, not among those that run unasked", vessel_cases},
    {"", "minutes long, by name alone", long_sea_cases},
    {"", "with data of others, --data DIR", data_cases},
};

const CaseGroup* find_group(const std::string& wanted) {
    for (const CaseGroup& group : kGroups)
        if (*group.name != '\0' && wanted == group.name) return &group;
    return nullptr;
}

void list_cases() {
    const auto print = [](std::span<const Case> cases) {
        for (const Case& c : cases) fmt::print("{:<6} {:<18} {}\n", c.id, c.name, c.text);
    };
    print(kCases);
    for (const CaseGroup& group : kGroups) {
        fmt::print("{}\n", group.text);
        print(group.cases());
    }
}

const Case* find(const std::string& wanted) {
    const auto among = [&](std::span<const Case> cases) -> const Case* {
        for (const Case& c : cases)
            if (wanted == c.id || wanted == c.name) return &c;
        return nullptr;
    };
    if (const Case* found = among(kCases); found != nullptr) return found;
    for (const CaseGroup& group : kGroups)
        if (const Case* found = among(group.cases()); found != nullptr) return found;
    return nullptr;
}

bool write_json(const std::string& file, const std::string& text) {
    if (file == "-") {
        fmt::print("{}", text);
        return true;
    }
    const std::string fault = record::write_file(file, text);
    if (!fault.empty()) fmt::print(stderr, "hawser validate: cannot write {}: {}\n", file, fault);
    return fault.empty();
}

void run_case(const Case& c, Report& report, bool quiet) {
    const std::size_t first = report.checks().size();
    report.begin(c.id, c.name);
    try {
        c.run(report);
    } catch (const std::exception& error) {
        report.fail(error.what());
    }
    if (!quiet) report.print(first);
}

}  // namespace

int run_cases(const std::vector<std::string>& cases, const std::string& json_file, bool list,
              const std::string& data) {
    set_data_folder(data);
    if (list) {
        list_cases();
        return 0;
    }
    std::vector<const Case*> chosen;
    for (const std::string& name : cases) {
        if (const CaseGroup* group = find_group(name); group != nullptr) {
            for (const Case& c : group->cases()) chosen.push_back(&c);
            continue;
        }
        chosen.push_back(find(name));
        if (chosen.back() == nullptr) {
            fmt::print(stderr, "hawser validate: no case {}; `hawser validate --list` names them\n",
                       name);
            return 1;
        }
    }
    if (chosen.empty()) {
        for (const Case& c : kCases) chosen.push_back(&c);
    }
    const bool quiet = json_file == "-";
    if (!quiet) {
        fmt::print("  {:<4}  {:<36} {:>30} {:>30} {:>9} {:>6} {:>8}  {}\n", "", "quantity",
                   "reference", "ours", "error", "order", "limit", "reason of the limit");
    }
    const auto start = std::chrono::steady_clock::now();
    Report report;
    for (const Case* c : chosen) run_case(*c, report, quiet);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (!quiet) {
        const auto failed = std::count_if(report.checks().begin(), report.checks().end(),
                                          [](const Check& check) { return !check.passed; });
        fmt::print("{} cases, {} checks, {} failed, {:.1f} s\n", chosen.size(),
                   report.checks().size(), failed, elapsed.count());
    }
    const bool written = json_file.empty() || write_json(json_file, report.json());
    return report.passed() && written ? 0 : 3;
}

}  // namespace hawser::validate
