// SPDX-License-Identifier: Apache-2.0
#include "report/start/cable_starts.h"

#include "record/units.h"
#include "report/start/parts.h"
#include "report/start/start_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace hawser::report::start {
namespace {

/// Strain within rounding of the coordinates of its nodes.
constexpr double kDigits = 1e-11;

bool is_stretch(const World& world, InteractionId id) {
    return kind_info(world.interaction_def(id).kind).is(kWireElement);
}

std::string words(const CableStart& c) {
    const std::string name = "  cable " + record::name_in_quotes(c.name);
    if (!c.known) return name + ": the tension it starts with could not be computed\n";
    std::string out = name;
    if (c.where.empty()) {
        out += " starts slack";
    } else {
        out += fmt::format(" starts with {} at its first end, {} at its last, {} at most, in {}",
                           record::with_unit(c.first, "N"), record::with_unit(c.last, "N"),
                           record::with_unit(c.largest, "N"), record::name_in_quotes(c.where));
        if (c.breaking_load > 0.0)
            out +=
                fmt::format(", {:.3g} % of its breaking load", 100.0 * c.largest / c.breaking_load);
    }
    if (c.laid_from == c.laid_from)
        out += fmt::format("; it lies on its seabed from {} to {} along it",
                           record::with_unit(c.laid_from, "m"), record::with_unit(c.laid_to, "m"));
    return out + "\n";
}

}  // namespace

std::vector<CableStart> cable_starts(const record::SceneInfo& scene, const World& world) {
    std::unique_ptr<StartForces> forces;  // for the whole scene, computed only if links need them
    std::vector<CableStart> out;
    for (const record::CableInfo& cable : scene.cables) {
        CableStart c;
        c.name = cable.name;
        c.breaking_load = cable.breaking_load;
        c.laid_from = cable.laid_from;
        c.laid_to = cable.laid_to;
        c.known = true;
        for (const InteractionId id : cable.elements) {
            double tension = 0.0;
            if (is_stretch(world, id)) {
                tension = start_tension(world, id);
                if (tension < kDigits * cable.EA) tension = 0.0;
            } else {
                if (!forces) forces = std::make_unique<StartForces>(world);
                c.known = forces->known();
                if (!c.known) break;
                tension = forces->push(id);
            }
            if (id == cable.elements.front()) c.first = tension;
            if (id == cable.elements.back()) c.last = tension;
            if (!(tension > c.largest)) continue;
            c.largest = tension;
            c.where = record::interaction_label(world, id);
        }
        out.push_back(std::move(c));
    }
    return out;
}

std::string to_text(const std::vector<CableStart>& starts, std::size_t most) {
    std::vector<const CableStart*> shown;
    for (const CableStart& c : starts) shown.push_back(&c);
    if (shown.size() > most) {
        std::vector<const CableStart*> order = shown;
        std::stable_sort(order.begin(), order.end(), [](const CableStart* a, const CableStart* b) {
            return a->largest > b->largest;
        });
        order.resize(most);
        std::sort(order.begin(), order.end());  // restore the order of the scene
        shown = std::move(order);
    }
    std::string out;
    for (const CableStart* c : shown) out += words(*c);
    if (shown.size() < starts.size())
        out += fmt::format("  and {} cables with less\n", starts.size() - shown.size());
    return out;
}

}  // namespace hawser::report::start
