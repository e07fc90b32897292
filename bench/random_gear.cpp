// SPDX-License-Identifier: Apache-2.0
#include "random_gear.h"

#include "passive_energy.h"
#include "random_passive_cases.h"

#include "record/scene_info.h"
#include "report/start/check.h"
#include "verify/certificate.h"
#include "verify/sampled.h"

#include <hawser/scene.h>
#include <hawser/session.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

namespace hawser::bench {
namespace {

constexpr double kInterval = 0.5;  ///< interval of averages of outputs [s]
constexpr std::size_t kTensionIntervals = 4;
constexpr double kPowerExcess = 1e-4;  ///< relative excess of the motor's power

/// Passes steps to a verifier and keeps its first error, so that the run continues.
class StepRecorder : public Observer {
  public:
    explicit StepRecorder(const World& world) : verifier_(world) {}
    void before_step(const World& world) override { verifier_.before_step(world); }
    void after_step(const World& world, std::span<const Event>) override {
        const std::string said = verifier_.after_step(world);
        if (said.empty() || !first_.empty()) return;
        first_ = fmt::format("at {:.4g} s: {}", world.time(), said);
    }
    [[nodiscard]] const std::string& first() const { return first_; }

  private:
    verify::Verifier verifier_;
    std::string first_;
};

enum class GearEnd : std::uint8_t { ok, suspect, failed, refused };

struct GearRun {
    GearEnd end = GearEnd::ok;
    std::string reason;                      ///< Empty if the run ended ok.
    std::string objection;                   ///< First error of the full verifier.
    double power = 0.0;                      ///< Largest power of the motor [W].
    double parted = 1e300;                   ///< Time at which a wire breaks [s].
    PassiveEnergy::Rise rise;                ///< Rise of energy in a passive scene.
    std::vector<std::vector<double>> means;  ///< By probe and interval.
};

/// Averages outputs over intervals.
class Averages {
  public:
    Averages(const World& world, const GearCase& c) : sums_(c.probes.size()) {
        for (const Probe& p : c.probes) {
            ids_.push_back(world.find_output(p.output));
            if (!ids_.back().valid()) throw std::logic_error("no output " + p.output);
        }
    }
    void add(const World& world) {
        const auto interval = static_cast<std::size_t>((world.time() - 1e-9) / kInterval);
        if (interval >= counts_.size()) {
            counts_.resize(interval + 1, 0);
            for (auto& s : sums_) s.resize(interval + 1, 0.0);
        }
        ++counts_[interval];
        for (std::size_t i = 0; i < ids_.size(); ++i) sums_[i][interval] += world.output(ids_[i]);
    }
    [[nodiscard]] std::vector<std::vector<double>> means() const {
        auto out = sums_;
        for (auto& s : out)
            for (std::size_t k = 0; k < s.size(); ++k) s[k] /= std::max(1, counts_[k]);
        return out;
    }

  private:
    std::vector<OutputId> ids_;
    std::vector<std::vector<double>> sums_;
    std::vector<int> counts_;
};

/// Return the power of the winch's motor at the velocities after a step [W].
double motor_power(const World& world) {
    const InteractionId motor = world.find_interaction("winch/motor");
    const BodyId drum = world.find_body("winch/drum");
    if (!motor.valid() || !drum.valid()) return 0.0;
    return world.force(motor)[0] * world.velocity(drum).linear.x();
}

void step_to_the_end(Session& session, const GearCase& c, Observer* witness, GearRun& out) {
    const World& world = session.world();
    const auto steps = static_cast<std::int64_t>(std::ceil(c.duration / world.settings().step));
    verify::SampledVerifier sampled(world, steps);
    session.observe(sampled);
    if (witness) session.observe(*witness);
    Averages averages(world, c);
    PassiveEnergy energy;
    for (std::int64_t i = 0; i < steps; ++i) {
        const Status status = session.step();
        if (!session.objection().empty()) {
            out.end = GearEnd::failed;
            out.reason =
                fmt::format("sampled steps at {:.4g} s: {}", world.time(), session.objection());
            break;
        }
        if (status != Status::ok) {
            out.end = GearEnd::failed;
            out.reason = fmt::format("{} at {:.4g} s", to_string(status), world.time());
            break;
        }
        out.power = std::max(out.power, motor_power(world));
        for (const Event& event : session.events())
            if (event.kind == EventKind::line_break) out.parted = std::min(out.parted, event.time);
        averages.add(world);
        if (c.passive && witness) energy.sample(world);
    }
    if (c.passive) out.rise = energy.largest(world.settings().step);
    out.means = averages.means();
    const hawser::Verdict& verdict = world.verdict();
    if (out.end == GearEnd::ok && verdict.grade != Grade::good) {
        out.end = verdict.grade == Grade::wrong ? GearEnd::failed : GearEnd::suspect;
        out.reason = fmt::format("{} {:.3g} at {:.4g} s", to_string(verdict.judge),
                                 verdict.of(verdict.judge).value, verdict.of(verdict.judge).time);
    }
}

/// Run a case. @param divide  Divides the step.  @param verify  Check each step by the full
/// verifier.
GearRun run_once(const GearCase& c, int divide, bool verify) {
    GearRun out;
    try {
        scene::Options options;
        options.step = c.step / divide;
        scene::Scene scene = scene::load_text(c.text, "random scene", options);
        scene.world.prepare();
        const auto findings =
            report::start::check_start(record::make_scene_info(scene), scene.world);
        if (findings.errors() > 0) {
            out.end = GearEnd::refused;
            out.reason = report::start::to_text(findings, "");
            return out;
        }
        std::optional<StepRecorder> witness;
        if (verify) witness.emplace(scene.world);
        Session session(std::move(scene));
        step_to_the_end(session, c, verify ? &*witness : nullptr, out);
        if (verify) out.objection = witness->first();
    } catch (const scene::SceneError& e) {
        out.end = GearEnd::refused;
        out.reason = e.what();
    } catch (const DefError& e) {
        out.end = GearEnd::failed;
        out.reason = e.what();
    }
    return out;
}

/// Largest difference of a probe over its tolerance.
struct Difference {
    double share = 0.0, value = 0.0, reference = 0.0, at = 0.0;
    std::string output;
};

double mean(const std::vector<double>& values, std::size_t from, std::size_t count) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(from);
    return std::accumulate(first, first + static_cast<std::ptrdiff_t>(count), 0.0) /
           static_cast<double>(count);
}

/// Return the number of intervals up to which two runs of a passive scene at finer steps agree
/// within a quarter of the tolerances. Beyond, the motion is too sensitive to serve as a reference.
std::size_t predictable(const GearCase& c, const GearRun& half, const GearRun& fine) {
    std::size_t many = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < c.probes.size(); ++i) {
        const std::vector<double>&a = half.means[i], &b = fine.means[i];
        double scale = 0.0;
        for (std::size_t k = 0; k < std::min({many, a.size(), b.size()}); ++k) {
            scale = std::max(scale, std::abs(b[k] - b[0]));
            const double allowed = c.probes[i].absolute + c.probes[i].relative * scale;
            if (std::abs(a[k] - b[k]) > 0.25 * allowed) many = k;
        }
        many = std::min({many, a.size(), b.size()});
    }
    return many;
}

Difference compare(const GearCase& c, const GearRun& run, const GearRun& fine, std::size_t most) {
    Difference worst;
    for (std::size_t i = 0; i < c.probes.size(); ++i) {
        const Probe& p = c.probes[i];
        const std::vector<double>&a = run.means[i], &b = fine.means[i];
        double scale = 0.0;
        for (const double x : b) scale = std::max(scale, std::abs(p.tension ? x : x - b[0]));
        const double allowed = p.absolute + p.relative * scale;
        // Tensions vary as loads bounce: average them over several intervals.
        const std::size_t many = p.tension ? kTensionIntervals : 1;
        // A wire near its breaking load breaks in one run and not in the other.
        const double last = std::min({c.duration, run.parted, fine.parted});
        const auto whole = static_cast<std::size_t>(last / kInterval + 1e-9);
        for (std::size_t k = 0; k + many <= std::min({a.size(), b.size(), whole, most});
             k += many) {
            const double x = mean(a, k, many), y = mean(b, k, many);
            const double share = std::abs(x - y) / allowed;
            if (!(share > worst.share)) continue;
            const double middle = static_cast<double>(k) + 0.5 * static_cast<double>(many);
            worst = {share, x, y, middle * kInterval, p.output};
        }
    }
    return worst;
}

const char* name_of(GearEnd end) {
    constexpr std::array<const char*, 4> kNames{"ok", "suspect", "failed", "refused"};
    return kNames[static_cast<std::size_t>(end)];
}

/// Counts of a family, and printed lines about single cases.
struct GearTally {
    int cases = 0, ends[4]{}, failed_by_verify = 0, failed_by_step = 0, failed_by_power = 0,
        failed_by_energy = 0, no_reference = 0;
    struct AtStep {
        int cases = 0, ok = 0, suspect = 0, wrong = 0, energy = 0;
    };
    std::map<double, AtStep> by_step;  ///< Counts by step.
    std::vector<std::string> wrong, not_ok;
    [[nodiscard]] int ok() const { return ends[0]; }
    [[nodiscard]] int all_failed() const { return static_cast<int>(wrong.size()); }
};

void count(const GearCase& c, std::uint64_t number, GearTally& tally, bool print) {
    const GearRun run = run_once(c, 1, true);
    ++tally.cases;
    ++tally.ends[static_cast<std::size_t>(run.end)];
    GearTally::AtStep& of_step = tally.by_step[c.step];
    ++of_step.cases;
    of_step.ok += run.end == GearEnd::ok;
    of_step.suspect += run.end == GearEnd::suspect;
    const std::string head =
        fmt::format("{:>6} h {:.3e} s {:<8}", number, c.step, name_of(run.end));
    if (run.end != GearEnd::ok) {
        tally.not_ok.push_back(fmt::format("{} {}", head, run.reason));
        if (!print) return;
    }
    std::string faults;
    if (!run.objection.empty()) {
        ++tally.failed_by_verify;
        faults += fmt::format("; --verify {}", run.objection);
    }
    if (run.power > c.motor_power * (1.0 + kPowerExcess)) {
        ++tally.failed_by_power;
        faults += fmt::format("; motor {:.6g} W, limit {:.6g} W", run.power, c.motor_power);
    }
    if (run.rise.fraction > PassiveEnergy::kLimit) {
        ++tally.failed_by_energy;
        of_step.energy += run.end == GearEnd::ok;
        faults += fmt::format("; energy rose by {:.3g} J, {:.3g} of the exchanged, up to {:.3g} s",
                              run.rise.joules, run.rise.fraction, run.rise.at);
    }
    const GearRun fine = run_once(c, 4, false);
    if (fine.end == GearEnd::ok || print) {
        const std::size_t most = c.passive ? predictable(c, run_once(c, 2, false), fine)
                                           : std::numeric_limits<std::size_t>::max();
        const Difference d = compare(c, run, fine, most);
        const std::string text =
            fmt::format("{} {:.6g} at {:.3g} s, quarter step {:.6g}: {:.2f} of what is allowed",
                        d.output, d.value, d.at, d.reference, d.share);
        if (d.share > 1.0) {
            ++tally.failed_by_step;
            faults += "; " + text;
        }
        if (print)
            fmt::print("{}; {}; quarter step {} {}\n", head, text, name_of(fine.end), fine.reason);
    } else {
        ++tally.no_reference;
    }
    if (print && c.passive)
        fmt::print(
            "energy rose by {:.3g} J, {:.3g} of the exchanged, up to {:.3g} s; --verify {}\n",
            run.rise.joules, run.rise.fraction, run.rise.at, run.objection);
    if (run.end != GearEnd::ok || faults.empty()) return;
    tally.wrong.push_back(head + faults);
    ++of_step.wrong;
}

void show(const char* title, const std::vector<std::string>& lines, int most) {
    if (lines.empty()) return;
    fmt::print("\n{}\n", title);
    for (std::size_t i = 0; i < lines.size() && i < static_cast<std::size_t>(most); ++i)
        fmt::print("{}\n", lines[i]);
}

void write_json(const GearOptions& o, const GearTally& t) {
    if (o.json.empty()) return;
    const nlohmann::ordered_json out{{"family", to_string(o.family)},
                                     {"seed", o.seed},
                                     {"cases", t.cases},
                                     {"ok", t.ends[0]},
                                     {"suspect", t.ends[1]},
                                     {"failed", t.ends[2]},
                                     {"refused", t.ends[3]},
                                     {"ok_but_wrong", t.all_failed()},
                                     {"wrong_by_verify", t.failed_by_verify},
                                     {"wrong_by_step", t.failed_by_step},
                                     {"wrong_by_power", t.failed_by_power},
                                     {"wrong_by_energy", t.failed_by_energy},
                                     {"no_reference", t.no_reference},
                                     {"wrong", t.wrong},
                                     {"not_ok", t.not_ok}};
    std::ofstream file(o.json);
    file << out.dump(1) << '\n';
    if (!file) throw std::runtime_error(o.json + ": cannot be written");
}

/// Print the table by steps of a passive family. @return true if enough runs end ok at each step.
bool enough_by_step(const GearTally& tally) {
    constexpr double kFine = 0.95, kCoarse = 0.85, kCoarseStep = 0.04;
    bool enough = true;
    fmt::print("\n{:>10}{:>7}{:>7}{:>9}{:>14}{:>11}{:>8}{:>8}\n", "step [s]", "cases", "ok",
               "suspect", "ok but wrong", "by energy", "ok %", "limit");
    for (const auto& [step, t] : tally.by_step) {
        const double share = static_cast<double>(t.ok) / t.cases;
        const double least = step < kCoarseStep ? kFine : kCoarse;
        enough = enough && share >= least;
        fmt::print("{:>10.5f}{:>7}{:>7}{:>9}{:>14}{:>11}{:>8.1f}{:>8.0f}\n", step, t.cases, t.ok,
                   t.suspect, t.wrong, t.energy, 100.0 * share, 100.0 * least);
    }
    return enough;
}

}  // namespace

int run_gear(const GearOptions& o) {
    GearTally tally;
    if (o.only >= 0) {
        const auto number = static_cast<std::uint64_t>(o.only);
        count(make_gear_case(o.family, o.seed, number), number, tally, true);
    } else {
        for (int k = 0; k < o.count; ++k) {
            const auto number = static_cast<std::uint64_t>(k);
            count(make_gear_case(o.family, o.seed, number), number, tally, false);
        }
    }
    show("Ended ok although wrong:", tally.wrong, o.shown);
    show("Not ok:", tally.not_ok, o.shown);
    write_json(o, tally);
    // Wires gain energy at guides: fewer of these runs end ok.
    const double least = o.family == GearFamily::guides ? 0.6 : 0.9;
    const double share = static_cast<double>(tally.ok()) / std::max(1, tally.cases);
    const bool passive = is_passive(o.family), none_wrong = tally.wrong.empty();
    const bool enough = passive ? enough_by_step(tally) : share >= least;
    fmt::print(
        "\n{} cases: {} ok, {} suspect, {} failed, {} refused; {} ok without a quarter-step "
        "run that ends ok\n",
        tally.cases, tally.ends[0], tally.ends[1], tally.ends[2], tally.ends[3],
        tally.no_reference);
    fmt::print("{:<7} {} of {} runs ended ok although wrong (limit: none)\n",
               none_wrong ? "ok" : "MISSED", tally.all_failed(), tally.cases);
    if (passive)
        fmt::print("{:<7} ended ok at each step (limits: table)\n", enough ? "ok" : "MISSED");
    else
        fmt::print("{:<7} {:.1f} % of {} ended ok (limit: {:.0f} %)\n", enough ? "ok" : "MISSED",
                   100.0 * share, tally.cases, 100.0 * least);
    return none_wrong && enough ? 0 : 1;
}

}  // namespace hawser::bench
