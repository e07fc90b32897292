// SPDX-License-Identifier: Apache-2.0
#include "scene/cable_layout.h"

namespace hawser::scene {

void read_water(Description& out, const CableLayout& c, const Document& document,
                const Place& place) {
    if (c.links || !document.root.contains("sea")) return;
    CableWater water{.cable = c.name,
                     .free_first = c.from.kind == CableEnd::Kind::free,
                     .free_last = c.to.kind == CableEnd::Kind::free,
                     .place = place};
    bool any = false, all = true;
    for (const LayoutSection& s : c.sections) {
        const bool wet = s.water.diameter > 0.0;
        any = any || wet;
        all = all && wet;
        if (wet && s.submerged_factor != 1.0)
            refuse(place,
                   "its line type has \"submerged_factor\" and \"cd_normal\": the sea makes "
                   "the buoyancy; leave out \"submerged_factor\"");
        water.sections.push_back({static_cast<int>(s.line.elements), s.water});
    }
    if (any && !all)
        refuse(place / "sections",
               "some of its line types have \"cd_normal\", others do not: a "
               "cable is in the water as a whole; give all of them one");
    keep_water(out, water);
}

}  // namespace hawser::scene
