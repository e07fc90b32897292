// SPDX-License-Identifier: Apache-2.0
#include "scene/cable_layout.h"
#include "scene/cable_shape.h"

#include <hawser/sea.h>

#include <algorithm>

namespace hawser::scene {

std::optional<StillSea> still_sea(const Document& document) {
    const auto sea = document.root.find("sea");
    if (sea == document.root.end() || !sea->is_object()) return {};
    StillSea out;
    out.density = number_or(*sea, "density", out.density);
    const auto list = sea->find("level");
    if (list == sea->end() || !list->is_array() || list->empty()) return out;
    // Compute the tide at time 0, as Sea::tide().
    std::vector<SeaLevel> tide;
    for (const Json& l : *list) {
        if (!l.is_object()) return out;  // rejected by the reader of the sea
        tide.push_back({l["time"].get<double>(), l["level"].get<double>()});
    }
    out.level = tide.front().level;
    for (std::size_t i = 1; i < tide.size() && tide[i - 1].time < 0.0; ++i) {
        const SeaLevel &a = tide[i - 1], &b = tide[i];
        const double share = std::clamp(-a.time / (b.time - a.time), 0.0, 1.0);
        out.level = a.level + share * (b.level - a.level);
    }
    return out;
}

bool in_water(const CableLayout& c) noexcept {
    return !c.links && std::any_of(c.sections.begin(), c.sections.end(),
                                   [](const auto& s) { return s.water.diameter > 0.0; });
}

void read_water(Description& out, const CableLayout& c, const Document& document,
                const SourceLocation& location) {
    if (c.links || !document.root.contains("sea")) return;
    CableWater water{.cable = c.name,
                     .free_first = c.from.kind == CableEnd::Kind::free,
                     .free_last = c.to.kind == CableEnd::Kind::free,
                     .location = location};
    bool any = false, all = true;
    for (const LayoutSection& s : c.sections) {
        const bool wet = s.water.diameter > 0.0;
        any = any || wet;
        all = all && wet;
        if (wet && s.submerged_factor != 1.0)
            throw_error(location,
                        "its line type has \"submerged_factor\" and \"cd_normal\": the sea makes "
                        "the buoyancy; leave out \"submerged_factor\"");
        water.sections.push_back({static_cast<int>(s.line.elements), s.water});
    }
    if (any && !all)
        throw_error(location / "sections",
                    "some of its line types have \"cd_normal\", others do not: a "
                    "cable is in the water as a whole; give all of them one");
    store_water(out, water);
}

}  // namespace hawser::scene
