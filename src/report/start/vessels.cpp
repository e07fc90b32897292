// SPDX-License-Identifier: Apache-2.0
#include <hawser/vessel.h>

#include "record/scene_info.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <string>

namespace hawser::report::start {

void check_vessels(const World& world, Findings& out) {
    for (const VesselDef* def : vessels_of(world))
        for (const std::string& what : unusual_values(world, *def))
            out.add(false, FindingKind::vessel, {def->name}, 0.0,
                    fmt::format("vessel {}: {}", record::name_in_quotes(def->name), what));
}

}  // namespace hawser::report::start
