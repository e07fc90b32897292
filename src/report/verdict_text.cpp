// SPDX-License-Identifier: Apache-2.0
#include "report/verdict_text.h"

#include "record/scene_info.h"
#include "record/verdict_words.h"

#include <fmt/format.h>

#include <cmath>

namespace hawser::report {

namespace {

std::size_t verdict_index(Judge judge) { return static_cast<std::size_t>(judge); }

std::string percent_of_limit(double of_limit) {
    return std::isfinite(of_limit) ? fmt::format("{:.2g} %", 100.0 * of_limit) : "beyond";
}

}  // namespace

VerdictText verdict_in_words(const World& world, const Verdict& verdict) {
    VerdictText out{.verdict = verdict, .where = {}, .description = {}};
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = verdict.worst[k];
        if (f.interaction.valid() || f.body.valid())
            out.where[k] = record::position_label(world, f.interaction, f.body);
    }
    if (verdict.grade == Grade::good) return out;
    const Finding& f = verdict.of(verdict.judge);
    out.description = fmt::format(
        "{}; {}",
        record::finding_sentence(world, verdict.judge, f, out.where[verdict_index(verdict.judge)]),
        record::remedy_for(world, verdict.judge));
    return out;
}

std::string margins(const VerdictText& text) {
    std::string out;
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = text.verdict.worst[k];
        out += fmt::format("{}{} {}", k == 0 ? "" : ", ", to_string(static_cast<Judge>(k)),
                           percent_of_limit(f.wrong));
        if (f.wrong > 1e-4)
            out += fmt::format(" ({}{:.4g} s)", text.where[k].empty() ? "" : text.where[k] + ", ",
                               f.time);
    }
    return out;
}

}  // namespace hawser::report
