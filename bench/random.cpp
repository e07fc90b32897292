// SPDX-License-Identifier: Apache-2.0
// hawser-bench random: mechanisms that no one has tuned, and whether runs that end ok are right.
#include <hawser/scene.h>

#include "commands.h"
#include "random_cases.h"
#include "random_judge.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
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
round within two steps, energy comes and goes, by a quarter at half the step. The exit code is 0 where no run ended ok although wrong, and at least 90 % of those without contradictory
joints ended ok.)";

enum class Outcome { ok, doubtful, failed, refused };

struct Ended {
    RandomCase of;
    std::uint64_t number = 0;
    Outcome outcome = Outcome::ok;
    std::string why;    ///< Of a failure or a refusal.
    std::string worst;  ///< Name of the joint that is open furthest.
    Judged judged;
    double seconds = 0.0;  ///< Wall time.
    [[nodiscard]] bool wrong() const { return outcome == Outcome::ok && judged.wrong(); }
};

/// Run a case to its end.
Ended run_case(std::uint64_t seed, std::uint64_t number, int divide) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    Ended out;
    out.of = make_random_case(seed, number);
    out.number = number;
    out.of.step /= divide;
    try {
        scene::Options options;
        options.step = out.of.step;
        scene::Scene scene =
            scene::load_text(out.of.text, fmt::format("random {}", number), options);
        RandomJudge judge(scene.world);
        while (scene.world.time() < scene.duration - 0.5 * out.of.step) {
            if (const Status status = scene.world.step(); status != Status::ok) {
                out.outcome = Outcome::failed;
                out.why = fmt::format("{} at {:.4g} s", to_string(status), scene.world.time());
                break;
            }
            judge.look(scene.world);
            if (!judge.figures().finite) break;
        }
        out.judged = judge.figures();
        const hawser::Verdict verdict = scene.world.verdict();
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
    out.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return out;
}

/// A letter for each category, as the legend says.
std::string letters(const RandomCase& c) {
    return fmt::format("{}{}{}{}{}", c.loops ? 'L' : '-', c.repeated ? 'R' : '-',
                       c.contradictory ? 'C' : '-', c.wires ? 'W' : '-', c.extreme ? 'E' : '-');
}

std::string told(const Ended& e) {
    const Judged& j = e.judged;
    constexpr const char* kOutcomes[] = {"ok", "doubtful", "failed", "refused"};
    const char* how = kOutcomes[static_cast<int>(e.outcome)];
    std::string text = fmt::format(
        "{:>6} {} {:<8} h {:.3e} s, energy {:.1e} of what was exchanged at {:.3g} s (swung "
        "{:.1e}), open {:.1e} m "
        "at {:.3g} s ({})",
        e.number, letters(e.of), how, e.of.step, j.created_share, j.created_at, j.swing_share,
        j.violation, j.violation_at, e.worst.empty() ? "-" : e.worst);
    if (!j.finite) text += ", not finite";
    if (!e.why.empty()) text += ": " + e.why;
    return text;
}

struct Tally {
    int cases = 0, ok = 0, doubtful = 0, failed = 0, refused = 0, wrong = 0, energy = 0, open = 0,
        infinite = 0;
    int consistent = 0, consistent_ok = 0;  ///< Without contradictory joints.
    int swung = 0;  ///< Of those that ended ok: energy swung by more than 1 % in one state.
    void add(const Ended& e) {
        ++cases;
        ok += e.outcome == Outcome::ok;
        doubtful += e.outcome == Outcome::doubtful;
        failed += e.outcome == Outcome::failed;
        refused += e.outcome == Outcome::refused;
        wrong += e.wrong();
        swung += e.outcome == Outcome::ok && e.judged.swing_share > 0.01;
        if (e.wrong()) {
            energy += e.judged.created_share > 0.01;
            open += e.judged.violation_share > 1.0;
            infinite += !e.judged.finite;
        }
        if (e.of.contradictory) return;
        ++consistent;
        // What is wrong did not end ok, whatever it says.
        consistent_ok += e.outcome == Outcome::ok && !e.wrong();
    }
    [[nodiscard]] double share_ok() const {
        return consistent > 0 ? static_cast<double>(consistent_ok) / consistent : 1.0;
    }
};

struct Category {
    const char* name;
    bool (*has)(const RandomCase&);
};

constexpr std::array<Category, 11> kCategories{{
    {"all", [](const RandomCase&) { return true; }},
    {"plain trees",
     [](const RandomCase& c) {
         return !c.loops && !c.repeated && !c.contradictory && !c.wires && !c.extreme;
     }},
    {"loops", [](const RandomCase& c) { return c.loops; }},
    {"repeated joints", [](const RandomCase& c) { return c.repeated; }},
    {"contradictory joints", [](const RandomCase& c) { return c.contradictory; }},
    {"wires", [](const RandomCase& c) { return c.wires; }},
    {"ratios of 1e6", [](const RandomCase& c) { return c.extreme; }},
    {"step below 1/60 s", [](const RandomCase& c) { return c.step < 1.0 / 60.0; }},
    {"1/60 to 0.05 s", [](const RandomCase& c) { return c.step >= 1.0 / 60.0 && c.step < 0.05; }},
    {"0.05 to 0.1 s", [](const RandomCase& c) { return c.step >= 0.05 && c.step < 0.1; }},
    {"0.1 to 0.2 s", [](const RandomCase& c) { return c.step >= 0.1; }},
}};

struct RandomOptions {
    std::uint64_t seed = 1;
    int count = 2000, shown = 20, divide = 1;
    std::int64_t only = -1;
    std::vector<std::string> save;
    std::string json;
};

void print_table(const std::array<Tally, kCategories.size()>& tallies) {
    fmt::print("{:<22}{:>7}{:>7}{:>10}{:>8}{:>9}{:>14}{:>9}{:>7}{:>9}{:>18}\n", "", "cases", "ok",
               "doubtful", "failed", "refused", "ok but wrong", "energy", "open", "not fin.",
               "consistent ok %");
    for (std::size_t i = 0; i < kCategories.size(); ++i) {
        const Tally& t = tallies[i];
        fmt::print("{:<22}{:>7}{:>7}{:>10}{:>8}{:>9}{:>14}{:>9}{:>7}{:>9}{:>18}\n",
                   kCategories[i].name, t.cases, t.ok, t.doubtful, t.failed, t.refused, t.wrong,
                   t.energy, t.open, t.infinite,
                   t.consistent > 0 ? fmt::format("{:.1f}", 100.0 * t.share_ok()) : "-");
    }
}

void write_json(const RandomOptions& o, const std::array<Tally, kCategories.size()>& tallies,
                const std::vector<std::uint64_t>& wrong) {
    if (o.json.empty()) return;
    nlohmann::ordered_json out{{"seed", o.seed}, {"count", o.count}, {"wrong", wrong}};
    for (std::size_t i = 0; i < kCategories.size(); ++i) {
        const Tally& t = tallies[i];
        out["categories"][kCategories[i].name] = {{"cases", t.cases},
                                                  {"ok", t.ok},
                                                  {"doubtful", t.doubtful},
                                                  {"failed", t.failed},
                                                  {"refused", t.refused},
                                                  {"wrong", t.wrong},
                                                  {"energy", t.energy},
                                                  {"open", t.open},
                                                  {"swung", t.swung},
                                                  {"consistent", t.consistent},
                                                  {"consistent_ok", t.consistent_ok}};
    }
    std::ofstream file(o.json);
    file << out.dump(1) << '\n';
    if (!file) throw std::runtime_error(o.json + ": cannot be written");
}

int run_all(const RandomOptions& o) {
    std::array<Tally, kCategories.size()> tallies{};
    std::vector<std::uint64_t> wrong;
    std::vector<std::string> wrong_told, failed_told;
    double slowest = 0.0;
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(o.count); ++k) {
        const Ended e = run_case(o.seed, k, o.divide);
        for (std::size_t i = 0; i < kCategories.size(); ++i)
            if (kCategories[i].has(e.of)) tallies[i].add(e);
        slowest = std::max(slowest, e.seconds);
        const auto room = static_cast<std::size_t>(o.shown);
        if (e.wrong()) {
            wrong.push_back(k);
            if (wrong_told.size() < room) wrong_told.push_back(told(e));
        } else if (e.outcome != Outcome::ok && !e.of.contradictory && failed_told.size() < room) {
            failed_told.push_back(told(e));
        }
    }
    print_table(tallies);
    fmt::print("Slowest case: {:.2f} s.\n", slowest);
    auto show = [](const char* title, const std::vector<std::string>& lines) {
        if (lines.empty()) return;
        fmt::print("\n{}\n", title);
        for (const std::string& line : lines) fmt::print("{}\n", line);
    };
    if (!wrong_told.empty() || !failed_told.empty())
        fmt::print(
            "L loops, R repeated joints, C contradictory joints, W wires, E ratios of 1e6\n");
    show("Ended ok although wrong, the first of them:", wrong_told);
    show("Not ok although nothing contradicts, the first of them:", failed_told);
    write_json(o, tallies, wrong);
    const Tally& all = tallies[0];
    constexpr double kShareOk = 0.9;
    const bool none_wrong = all.wrong == 0, enough = all.share_ok() >= kShareOk;
    fmt::print("\n{:<7} {} of {} runs ended ok although wrong (bar: none)\n",
               none_wrong ? "ok" : "MISSED", all.wrong, all.cases);
    fmt::print("{:<7} {:.1f} % of {} without contradictory joints ended ok and right (bar: 90 %)\n",
               enough ? "ok" : "MISSED", 100.0 * all.share_ok(), all.consistent);
    fmt::print("        energy of {} that ended ok swung by more than 1 % in a single state\n",
               all.swung);
    if (!none_wrong || !failed_told.empty())
        fmt::print("One again: hawser bench random --seed {} --only NUMBER [--save NUMBER FILE]\n",
                   o.seed);
    return none_wrong && enough ? 0 : 1;
}

/// What --save asks for: a number and a file.
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
    std::ofstream file(o.save[1]);
    file << make_random_case(o.seed, number).text << '\n';
    file.close();
    if (!file) throw std::runtime_error(o.save[1] + ": cannot be written");
    fmt::print("{}: case {} of seed {}\n", o.save[1], number, o.seed);
}

}  // namespace

int random_command(int argc, char** argv) {
    CLI::App app(kRandomDescription, "hawser-bench random");
    RandomOptions o;
    app.add_option("--seed", o.seed, "Of the random numbers")->capture_default_str();
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
    if (o.only < 0) return run_all(o);
    const Ended e = run_case(o.seed, static_cast<std::uint64_t>(o.only), o.divide);
    fmt::print("{}\n", told(e));
    return e.wrong() || (e.outcome != Outcome::ok && !e.of.contradictory) ? 1 : 0;
}

}  // namespace hawser::bench
