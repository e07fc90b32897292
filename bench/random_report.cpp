// SPDX-License-Identifier: Apache-2.0
#include "random_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace hawser::bench {
namespace {

constexpr std::array<const char*, 4> kOutcomes{"ok", "doubtful", "failed", "refused"};

const char* name_of(Outcome outcome) { return kOutcomes[static_cast<std::size_t>(outcome)]; }

/// Return a letter for each category, as in the legend.
std::string category_letters(const RandomCase& c) {
    return fmt::format("{}{}{}{}{}", c.loops ? 'L' : '-', c.repeated ? 'R' : '-',
                       c.contradictory ? 'C' : '-', c.wires ? 'W' : '-', c.extreme ? 'E' : '-');
}

struct Category {
    const char* name;
    bool (*has)(const RandomCase&);
};

constexpr std::array<Category, kCategoryCount> kCategories{{
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

/// Return the check that reports that a case is not ok.
std::string reason_of(const Ended& e) {
    if (e.outcome == Outcome::refused) return "the scene is refused";
    if (e.status != Status::ok && e.status != Status::diverged) return to_string(e.status);
    const Finding& f = e.verdict.of(e.verdict.judge);
    const bool lost = e.verdict.judge == Judge::energy && f.value < 0.0;
    return lost ? "energy lost" : to_string(e.verdict.judge);
}

}  // namespace

std::string reported(const Ended& e) {
    const JointErrors& j = e.judged;
    std::string text = fmt::format(
        "{:>6} {} {:<8} h {:.3e} s, energy {:.1e} of what was exchanged at {:.3g} s (swung "
        "{:.1e}), open {:.1e} m "
        "at {:.3g} s ({})",
        e.number, category_letters(e.of), name_of(e.outcome), e.of.step, j.created_fraction,
        j.created_at, j.oscillation_fraction, j.violation, j.violation_at,
        e.worst.empty() ? "-" : e.worst);
    if (!j.finite) text += ", not finite";
    if (!e.why.empty()) text += ": " + e.why;
    return text;
}

void Tally::add(const Ended& e) {
    ++cases;
    ok += e.outcome == Outcome::ok;
    doubtful += e.outcome == Outcome::doubtful;
    failed += e.outcome == Outcome::failed;
    refused += e.outcome == Outcome::refused;
    wrong += e.wrong();
    swung += e.outcome == Outcome::ok && e.judged.oscillation_fraction > 0.01;
    if (e.wrong()) {
        energy += e.judged.created_fraction > 0.01;
        open += e.judged.violation_fraction > 1.0;
        infinite += !e.judged.finite;
    }
    if (e.of.contradictory) return;
    ++consistent;
    // A wrong case did not end ok, whatever its status.
    consistent_ok += e.outcome == Outcome::ok && !e.wrong();
}
double Tally::fraction_ok() const {
    return consistent > 0 ? static_cast<double>(consistent_ok) / consistent : 1.0;
}

void RandomReport::add(const Ended& e) {
    if (e.wrong()) wrong_.push_back(e.number);
    Reason* reason = nullptr;
    if (e.outcome != Outcome::ok && !e.of.contradictory) reason = &reasons_[reason_of(e)];
    if (reason) reason->unseen += !e.judged.wrong();
    for (std::size_t i = 0; i < kCategories.size(); ++i) {
        if (!kCategories[i].has(e.of)) continue;
        tallies_[i].add(e);
        if (reason) ++reason->cases[i];
    }
}

void RandomReport::print_outcomes() const {
    fmt::print("{:<22}{:>7}{:>7}{:>10}{:>8}{:>9}{:>14}{:>9}{:>7}{:>9}{:>18}\n", "", "cases", "ok",
               "doubtful", "failed", "refused", "ok but wrong", "energy", "open", "not fin.",
               "consistent ok %");
    for (std::size_t i = 0; i < kCategories.size(); ++i) {
        const Tally& t = tallies_[i];
        fmt::print("{:<22}{:>7}{:>7}{:>10}{:>8}{:>9}{:>14}{:>9}{:>7}{:>9}{:>18}\n",
                   kCategories[i].name, t.cases, t.ok, t.doubtful, t.failed, t.refused, t.wrong,
                   t.energy, t.open, t.infinite,
                   t.consistent > 0 ? fmt::format("{:.1f}", 100.0 * t.fraction_ok()) : "-");
    }
}

void RandomReport::print_reasons() const {
    if (reasons_.empty()) return;
    fmt::print("\nWhy {} without contradictory joints did not end ok\n{:<22}{:>7}{:>9}",
               all().consistent - all().consistent_ok, "", "cases", "unseen");
    constexpr std::array<std::size_t, 8> kShown{2, 3, 5, 6, 7, 8, 9, 10};
    for (const std::size_t i : kShown) fmt::print("  {}", kCategories[i].name);
    fmt::print("\n");
    for (const auto& [name, reason] : reasons_) {
        fmt::print("{:<22}{:>7}{:>9}", name, reason.cases[0], reason.unseen);
        for (const std::size_t i : kShown)
            fmt::print("  {:>{}}", reason.cases[i], std::string_view(kCategories[i].name).size());
        fmt::print("\n");
    }
    fmt::print("unseen: of those, the judge of this command sees nothing wrong\n");
}

void RandomReport::write_json(const std::string& path, std::uint64_t seed, int count) const {
    if (path.empty()) return;
    nlohmann::ordered_json out{{"seed", seed}, {"count", count}, {"wrong", wrong_}};
    for (std::size_t i = 0; i < kCategories.size(); ++i) {
        const Tally& t = tallies_[i];
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
    for (const auto& [name, reason] : reasons_) {
        nlohmann::ordered_json& r = out["reasons"][name] = {{"unseen", reason.unseen}};
        for (std::size_t i = 0; i < kCategories.size(); ++i)
            r[kCategories[i].name] = reason.cases[i];
    }
    std::ofstream file(path);
    file << out.dump(1) << '\n';
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

CaseList::CaseList(const std::string& path) : path_(path) {
    if (path_.empty()) return;
    file_.open(path_);
    file_ << "case,kinds,outcome,reason,step_s,energy,energy_at_s,swung,open,open_at_s,joint,"
             "energy_limit,violation_limit,cable_limit,certificate_limit,step_turn_rad,seconds\n";
    if (!file_) throw std::runtime_error(path_ + ": cannot be written");
}

void CaseList::add(const Ended& e) {
    if (path_.empty()) return;
    const JointErrors& j = e.judged;
    const auto of = [&](Judge judge) { return e.verdict.of(judge).doubtful; };
    file_ << fmt::format("{},{},{},{},{:.4g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{},", e.number,
                         category_letters(e.of), name_of(e.outcome),
                         e.outcome == Outcome::ok ? "" : reason_of(e), e.of.step,
                         j.created_fraction, j.created_at, j.oscillation_fraction,
                         j.violation_fraction, j.violation_at, e.worst);
    file_ << fmt::format("{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.2g}\n", of(Judge::energy),
                         of(Judge::violation), of(Judge::cable), of(Judge::certificate),
                         e.verdict.of(Judge::speed).value, e.seconds);
}

void CaseList::close() {
    if (path_.empty()) return;
    file_.close();
    if (!file_) throw std::runtime_error(path_ + ": cannot be written");
}

}  // namespace hawser::bench
