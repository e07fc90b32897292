// SPDX-License-Identifier: Apache-2.0
#include "record/verdict_words.h"

#include "record/scene_info.h"
#include "record/units.h"

#include <hawser/interactions.h>
#include <hawser/world.h>

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace hawser::record {

namespace {

/// Return the unit of the opening of a joint's rows; a joint may have rows of both units.
const char* opening_unit(const World& world, InteractionId id) {
    if (!world.alive(id)) return "m or rad";
    const KindInfo& kind = kind_info(world.interaction_def(id).kind);
    if (kind.is(kMotorKind) && kind.coordinate != KindCoordinate::scalar)
        return kind.coordinate == KindCoordinate::about ? "rad" : "m";
    const std::string_view units(kind.row_units);
    if (kind.coordinate == KindCoordinate::scalar || units.empty()) return "m or rad";
    return units.find('r') == units.npos ? "m" : units.find('m') == units.npos ? "rad" : "m or rad";
}

}  // namespace

std::string energy_change(double value, const char* tense) {
    return fmt::format("the whole world {}{} {} of mechanical energy without a cause", tense,
                       value < 0.0 ? "lost" : "gained", with_unit(std::abs(value), "J"));
}

const char* remedy_for(const World& world, Judge judge) {
    const WorldDef& settings = world.settings();
    if (judge == Judge::certificate && settings.budget == 0.0 && settings.budget_work == 0.0)
        return "use a smaller step (settings.step)";
    return remedy(judge);
}

std::string finding_sentence(const World& world, Judge judge, const Finding& f,
                             const std::string& where) {
    const bool of_body = !f.interaction.valid() && f.body.valid();
    const std::string when = fmt::format("at {:.6g} s", f.time);
    const std::string at = "'" + where + "'" + origin(world, where);
    switch (judge) {
        case Judge::energy:
            return energy_change(f.value, "had ") + " " + when;
        case Judge::violation:
            if (of_body)
                return fmt::format("{} and the body that it touches overlapped by {} {}", at,
                                   with_unit(f.value, "m"), when);
            if (f.value < 0.0)
                return fmt::format("element {} had the negative length {} {}", at,
                                   with_unit(f.value, "m"), when);
            if (world.alive(f.interaction) &&
                kind_info(world.interaction_def(f.interaction).kind).is(kMotorKind))
                return fmt::format(
                    "motor {} drove its joint beyond the end of a range by {:.4g} "
                    "{} {}",
                    at, f.value, opening_unit(world, f.interaction), when);
            return fmt::format("joint {} was open by {:.4g} {} {}", at, f.value,
                               opening_unit(world, f.interaction), when);
        case Judge::cable:
            if (f.value < 0.0)
                return fmt::format(
                    "element {} was stretched by {:.3g} % of its length, more than any material "
                    "allows, {}",
                    at, -100.0 * f.value, when);
            return fmt::format(
                "the tension of element {} did not match its length, with a relative error of "
                "{:.4g}, {}",
                at, f.value, when);
        case Judge::certificate:
            return fmt::format("the equations of the step had a relative error of {:.2e} {}",
                               f.value, when);
        case Judge::speed:
            return fmt::format("{} turned by {:.3g} rad in one step {}", at, f.value, when);
    }
    return {};
}

}  // namespace hawser::record
