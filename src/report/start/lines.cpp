// SPDX-License-Identifier: Apache-2.0
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::report::start {

namespace {

/// Strain beyond which wires, chains and most ropes break, used if no breaking load is specified.
constexpr double kDefaultBreakingStrain = 0.05;

/// Breaking load from which a line counts as unbreakable [N].
constexpr double kUnbreakableLoad = 1e29;

struct Tightest {
    double tension = 0.0, most = 1.0;
    bool strain = false;  ///< True if `most` is derived from kDefaultBreakingStrain.
    InteractionId at{};
};

void keep_tightest(const World& world, InteractionId id, Tightest& worst) {
    const InteractionDef& def = world.interaction_def(id);
    if (!kind_info(def.kind).is(kWireElement)) return;
    const double breaking = def.get("breaking_load");
    const bool strain = !(breaking > 0.0) || breaking >= kUnbreakableLoad;
    const double most = strain ? kDefaultBreakingStrain * def.get("EA") : breaking;
    const double tension = start_tension(world, id);
    if (tension > most && tension * worst.most >= worst.tension * most)
        worst = {tension, most, strain, id};
}

void report(const World& world, const std::string& name, const std::string& what,
            const Tightest& worst, Findings& out) {
    const double ratio = worst.tension / worst.most;
    const std::string where = record::name_in_quotes(record::interaction_label(world, worst.at));
    out.add(
        false, FindingKind::tension, {name}, worst.tension,
        fmt::format(
            "{} starts with {} in {}, {}; give it more length, or start with its ends closer", what,
            record::with_unit(worst.tension, "N"), where,
            worst.strain
                ? fmt::format("stretched by {:.2g} %, which no wire or chain survives",
                              100.0 * kDefaultBreakingStrain * ratio)
                : fmt::format("{:.3g} times its breaking load of {}: it breaks in the first step",
                              ratio, record::with_unit(worst.most, "N"))));
}

}  // namespace

double start_tension(const World& world, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    if (!kind_info(def.kind).is(kWireElement)) return 0.0;
    const RowsView view = world.solver().rows(id);
    return view.compliance[0] > 0.0 ? std::max(0.0, view.violation[0] / view.compliance[0]) : 0.0;
}

void check_tensions(const record::SceneInfo& scene, const World& world, Findings& out) {
    std::vector<bool> of_cable(static_cast<std::size_t>(world.interaction_count()), false);
    for (const record::CableInfo& cable : scene.cables) {
        Tightest worst;
        for (const InteractionId id : cable.elements) {
            of_cable[static_cast<std::size_t>(id.index)] = true;
            keep_tightest(world, id, worst);
        }
        if (worst.at.valid())
            report(world, cable.name, "the cable " + record::name_in_quotes(cable.name), worst,
                   out);
    }
    for (const InteractionId id : world.interactions()) {
        if (of_cable[static_cast<std::size_t>(id.index)]) continue;
        Tightest worst;
        keep_tightest(world, id, worst);
        if (worst.at.valid())
            report(world, record::interaction_label(world, id),
                   record::interaction_in_words(world, id), worst, out);
    }
}

}  // namespace hawser::report::start
