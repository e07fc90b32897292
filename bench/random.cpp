// SPDX-License-Identifier: Apache-2.0
// hawser-bench random: random mechanisms, and checks of runs that end ok.
#include <hawser/scene.h>

#include "commands.h"
#include "random_cases.h"
#include "random_gear.h"
#include "random_judge.h"
#include "random_report.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::bench {
namespace {

constexpr const char* kRandomDescription =
    R"(Random trees and loops of all joints, with wires, repeated and contradictory joints and
ratios of masses or stiffnesses of 1e6 and more, at steps from 1/240 to 0.2 s, for 1 s each. Bodies
are 0.06 to 3 m large, at steps above 0.017 s larger, so that swinging stays within what a step
resolves.

A run ends ok, or says that it is doubtful, or that it failed (docs/limits.md). What ended ok is
judged by code of this command alone, from poses and velocities: it is wrong where mechanical
energy was higher in three states running by more than 1 % of what had been exchanged (kinetic
energy and the changes of all), or a joint was open by more than 1 cm and 1 % of the size of the
smaller body. Printed beside is how many swung by more than that in one state: where a body whips
round within two steps, energy comes and goes, by a quarter at half the step. The exit code is 0
where no run ended ok although wrong, and at least 90 % of those without contradictory joints ended
ok.

--family passive_posts, passive_guides or passive_hanging generates wires without motor and sea, 6 s
each at steps of 1/60, 1/30 and 0.05 s in turn: a wire between two masses that falls on bollards; a
wire over a roller between a mass on a table and one that hangs; a box on a wire, taut or slack at
the start. Kinetic, gravity and elastic energy at the half step, less the work of applied forces,
must not rise by more than 5 % for 0.3 s, relative to the larger of the largest kinetic energy and
the largest fall of that sum. The exit code is 0 if no run ended ok although wrong and 95 % ended ok
at 1/60 and 1/30 s, 85 % at 0.05 s. Positions, means over 0.5 s, may differ from those of the run at
a quarter of the step by 25 % of their largest change and 5 % of the wire's length. They are compared
as long as the run at half of the step agrees within a quarter of that.

--family winches, guides or hulls generates scenes with gear instead, 8 to 10 s each, at steps from
1/240 to 1/20 s: winches in changing modes with limits of torque and power; wires over and under a
roller, in a fifth of the cases hauled to their end; barges on two to four chains, in still water
and in waves. A run ends ok if `hawser run` would end with exit code 0 and the grade good. It is
wrong if --verify objects to one of its steps, if the motor exceeds its power by 1e-4, or if a mean
value differs from the run at a quarter of the step. Means over 0.5 s of places, angles and wire on
the drum may differ by 5 % of their largest change and 1 % of the wire's length (hulls: 5 cm, 2 % of
the draught, 2 mrad), means over 2 s of tensions by 10 % of the largest and 2 % of the typical one
(hauled to the roller: by the typical one), until a wire parts. Wires have an axial damping that
does not depend on the step; floats and loads are damped within some seconds. The exit code is 0 if
no run ended ok although wrong and 90 % ended ok (guides: 60 %).)";

/// Run a case to its end.
Ended run_case(std::uint64_t seed, std::uint64_t number, int divide) {
    using CaseClock = std::chrono::steady_clock;
    const CaseClock::time_point begin = CaseClock::now();
    Ended out;
    out.of = make_random_case(seed, number);
    out.number = number;
    out.of.step /= divide;
    try {
        scene::Options options;
        options.step = out.of.step;
        scene::Scene scene =
            scene::load_text(out.of.text, fmt::format("random {}", number), options);
        RandomMonitor judge(scene.world);
        while (scene.world.time() < scene.duration - 0.5 * out.of.step) {
            if (const Status status = scene.world.step(); status != Status::ok) {
                out.outcome = Outcome::failed;
                out.status = status;
                out.why = fmt::format("{} at {:.4g} s", to_string(status), scene.world.time());
                break;
            }
            judge.sample(scene.world);
            if (!judge.figures().finite) break;
        }
        out.judged = judge.figures();
        const hawser::Verdict& verdict = out.verdict = scene.world.verdict();
        if (out.outcome == Outcome::ok && verdict.grade != Grade::good) {
            const bool wrong = verdict.grade == Grade::wrong;
            out.outcome = wrong ? Outcome::failed : Outcome::doubtful;
        }
        if (verdict.grade != Grade::good)
            out.why += fmt::format("{}{}", out.why.empty() ? "" : ", ", to_string(verdict.judge));
        if (out.judged.worst.valid())
            out.worst = scene.world.interaction_def(out.judged.worst).name;
    } catch (const scene::SceneError& e) {
        out.outcome = Outcome::refused;
        out.why = e.what();
    }
    out.seconds = std::chrono::duration<double>(CaseClock::now() - begin).count();
    return out;
}

struct RandomOptions {
    std::uint64_t seed = 1;
    int count = 2000, shown = 20, divide = 1;
    std::int64_t only = -1;
    std::vector<std::string> save;
    std::string json, list, family = "mechanisms";
};

int run_all(const RandomOptions& o) {
    RandomReport report;
    CaseList list(o.list);
    std::vector<std::string> wrong_lines, failed_lines;
    double slowest = 0.0;
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(o.count); ++k) {
        const Ended e = run_case(o.seed, k, o.divide);
        report.add(e);
        list.add(e);
        slowest = std::max(slowest, e.seconds);
        const auto room = static_cast<std::size_t>(o.shown);
        if (e.wrong()) {
            if (wrong_lines.size() < room) wrong_lines.push_back(reported(e));
        } else if (e.outcome != Outcome::ok && !e.of.contradictory && failed_lines.size() < room) {
            failed_lines.push_back(reported(e));
        }
    }
    report.print_outcomes();
    report.print_reasons();
    fmt::print("Slowest case: {:.2f} s.\n", slowest);
    auto show = [](const char* title, const std::vector<std::string>& lines) {
        if (lines.empty()) return;
        fmt::print("\n{}\n", title);
        for (const std::string& line : lines) fmt::print("{}\n", line);
    };
    if (!wrong_lines.empty() || !failed_lines.empty())
        fmt::print(
            "L loops, R repeated joints, C contradictory joints, W wires, E ratios of 1e6\n");
    show("Ended ok although wrong, the first of them:", wrong_lines);
    show("Not ok although nothing contradicts, the first of them:", failed_lines);
    list.close();
    report.write_json(o.json, o.seed, o.count);
    const Tally& all = report.all();
    constexpr double kFractionOk = 0.9;
    const bool none_wrong = all.wrong == 0, enough = all.fraction_ok() >= kFractionOk;
    fmt::print("\n{:<7} {} of {} runs ended ok although wrong (bar: none)\n",
               none_wrong ? "ok" : "MISSED", all.wrong, all.cases);
    fmt::print("{:<7} {:.1f} % of {} without contradictory joints ended ok and right (bar: 90 %)\n",
               enough ? "ok" : "MISSED", 100.0 * all.fraction_ok(), all.consistent);
    fmt::print("        energy of {} that ended ok swung by more than 1 % in a single state\n",
               all.swung);
    if (!none_wrong || !failed_lines.empty())
        fmt::print("One again: hawser bench random --seed {} --only NUMBER [--save NUMBER FILE]\n",
                   o.seed);
    return none_wrong && enough ? 0 : 1;
}

/// Write the case that --save requests by a number and a file.
void save_case(const RandomOptions& o) {
    std::size_t read = 0;
    std::uint64_t number = 0;
    try {
        number = std::stoull(o.save[0], &read);
    } catch (const std::exception&) {
        read = 0;
    }
    if (read != o.save[0].size())
        throw std::runtime_error("--save: '" + o.save[0] + "' is not the number of a case");
    const auto family = gear_family(o.family);
    std::ofstream file(o.save[1]);
    file << (family ? make_gear_case(*family, o.seed, number).text
                    : make_random_case(o.seed, number).text)
         << '\n';
    file.close();
    if (!file) throw std::runtime_error(o.save[1] + ": cannot be written");
    fmt::print("{}: case {} of seed {}\n", o.save[1], number, o.seed);
}

}  // namespace

int random_command(int argc, char** argv) {
    CLI::App app(kRandomDescription, "hawser-bench random");
    RandomOptions o;
    app.add_option("--seed", o.seed, "Of the random numbers")->capture_default_str();
    app.add_option("--family", o.family, "Kind of scenes")
        ->check(CLI::IsMember({"mechanisms", "winches", "guides", "hulls", "ships", "passive_posts",
                               "passive_guides", "passive_hanging"}))
        ->capture_default_str();
    app.add_option("--count", o.count, "Cases")
        ->check(CLI::Range(1, 10'000'000))
        ->capture_default_str();
    app.add_option("--only", o.only, "Only the case of this number")->check(CLI::NonNegativeNumber);
    app.add_option("--save", o.save, "Write the case of this number to a scene file; runs nothing")
        ->expected(2)
        ->type_name("NUMBER FILE");
    app.add_option("--divide", o.divide, "Steps in place of one, to see what holds as it shrinks")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    app.add_option("--show", o.shown, "Cases to list of those that are wrong, or failed")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--list", o.list, "Write a line about each case to this file (CSV)");
    app.add_option("--json", o.json, "Write the figures to this file");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    if (!o.save.empty()) {
        save_case(o);
        return 0;
    }
    if (const auto family = gear_family(o.family))
        return run_gear({.family = *family,
                         .seed = o.seed,
                         .count = o.count,
                         .shown = o.shown,
                         .only = o.only,
                         .json = o.json});
    if (o.only < 0) return run_all(o);
    const Ended e = run_case(o.seed, static_cast<std::uint64_t>(o.only), o.divide);
    fmt::print("{}\n", reported(e));
    return e.wrong() || (e.outcome != Outcome::ok && !e.of.contradictory) ? 1 : 0;
}

}  // namespace hawser::bench
