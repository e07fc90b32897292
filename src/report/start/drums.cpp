// SPDX-License-Identifier: Apache-2.0
/// Warn about bare drums that feed no elements: cables with the key "winch" in version 1.
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::report::start {

void check_drums(const record::SceneInfo& scene, const World& world, Findings& out) {
    for (const record::CableInfo& cable : scene.cables) {
        if (!cable.keeps_drum_element || cable.elements.empty()) continue;
        const InteractionDef& line = world.interaction_def(cable.elements.front());
        if (!kind_info(line.kind).is(kWoundUp)) continue;
        const double length = line.get("length"), turned = world.pose(line.body[2]).position.x();
        const double rest = length + line.get("radius") * (turned - line.get("drum_zero"));
        const double hauled = std::max(0.0, rest - kLeastOfDrumElement * length);
        out.add(false, FindingKind::drum, {cable.name}, hauled,
                fmt::format("the cable {} keeps one element at its drum, which stops after hauling "
                            "{}; set \"version\": 2 to feed elements",
                            record::name_in_quotes(cable.name), record::with_unit(hauled, "m")));
    }
}

}  // namespace hawser::report::start
