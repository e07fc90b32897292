// SPDX-License-Identifier: Apache-2.0
#include "report/verdict_text.h"

#include "record/scene_info.h"
#include "record/units.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace hawser::report {

namespace {

std::size_t place_of(Judge judge) { return static_cast<std::size_t>(judge); }

std::string share(double of_limit) {
    return std::isfinite(of_limit) ? fmt::format("{:.2g} %", 100.0 * of_limit) : "beyond";
}

/// Of the rows of a joint; some have rows of both.
const char* opening_unit(const World& world, InteractionId id) {
    if (!world.alive(id)) return "m or rad";
    const KindInfo& kind = kind_info(world.interaction_def(id).kind);
    const std::string_view units(kind.row_units);
    if (kind.coordinate == KindCoordinate::scalar || units.empty()) return "m or rad";
    return units.find('r') == units.npos ? "m" : units.find('m') == units.npos ? "rad" : "m or rad";
}

}  // namespace

std::string sentence(const World& world, Judge judge, const Finding& f, const std::string& where) {
    const bool of_body = !f.interaction.valid() && f.body.valid();
    const std::string when = fmt::format("at {:.6g} s", f.time);
    switch (judge) {
        case Judge::energy:
            return fmt::format(
                "{} of mechanical energy {} {}", record::with_unit(std::abs(f.value), "J"),
                f.value < 0.0 ? "had vanished without reason" : "had come out of nothing", when);
        case Judge::violation:
            if (of_body)
                return fmt::format("'{}' and what it touches lay {} in each other {}", where,
                                   record::with_unit(f.value, "m"), when);
            return fmt::format("joint '{}' stood open by {:.4g} {} {}", where, f.value,
                               opening_unit(world, f.interaction), when);
        case Judge::cable:
            return fmt::format(
                "the tension of element '{}' was off by what {:.4g} of its length makes {}", where,
                f.value, when);
        case Judge::certificate:
            return fmt::format("the step's equations were left unsolved by {:.2e}, relative, {}",
                               f.value, when);
        case Judge::speed:
            return fmt::format("'{}' turned by {:.3g} rad in a step {}", where, f.value, when);
    }
    return {};
}

VerdictText in_words(const World& world, const Verdict& verdict) {
    VerdictText out{.verdict = verdict, .where = {}, .said = {}};
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = verdict.worst[k];
        if (f.interaction.valid() || f.body.valid())
            out.where[k] = record::place_label(world, f.interaction, f.body);
    }
    if (verdict.grade == Grade::good) return out;
    const Finding& f = verdict.of(verdict.judge);
    out.said =
        fmt::format("{}; {}", sentence(world, verdict.judge, f, out.where[place_of(verdict.judge)]),
                    remedy(verdict.judge));
    return out;
}

std::string margins(const VerdictText& text) {
    std::string out;
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = text.verdict.worst[k];
        out += fmt::format("{}{} {}", k == 0 ? "" : ", ", to_string(static_cast<Judge>(k)),
                           share(f.wrong));
        if (f.wrong > 1e-4)
            out += fmt::format(" ({}{:.4g} s)", text.where[k].empty() ? "" : text.where[k] + ", ",
                               f.time);
    }
    return out;
}

}  // namespace hawser::report
