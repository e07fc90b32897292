// SPDX-License-Identifier: Apache-2.0
/// Friction whose bound enters the matrix, and its entries.
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>

namespace hawser::assembly {

/// Find capstans: frictions of a slide whose bound depends on the tensions of the two spans before
/// and behind it.
void System::find_capstans(const model::Interactions& in, const WorldDef& def) {
    capstans.clear();
    capstan_entries.clear();
    if (def.nonsmooth != Nonsmooth::newton) return;
    for (const std::int32_t id : in.frictions) {
        if (rests(id) || in.load_begin[at(id)] < 0 ||
            kind_info(in.kinds[at(id)]).coordinate != KindCoordinate::scalar)
            continue;
        const std::int32_t body = in.body[at(kMaxInteractionBodies * id)];
        const InteractionDef& d = in.def[at(id)];
        Capstan c{id, body, 0, 0.0, 0.0};
        const auto is_routed = [&](const FrictionLoad& load) {
            if (!load.interaction.valid()) return true;
            const std::int32_t i = load.interaction.index;
            const std::int32_t* of = &in.body[at(kMaxInteractionBodies * i)];
            return kind_info(in.kinds[at(i)]).is(kRouted) && !rests(i) &&
                   std::find(of, of + in.bodies[at(i)], body) != of + in.bodies[at(i)];
        };
        if (!std::all_of(d.load.begin(), d.load.end(), is_routed)) continue;
        for (const FrictionLoad& load : d.load) {
            if (!load.interaction.valid()) continue;
            capstan_entries.push_back({load.interaction.index, load.factor, 0.0, -1, -1, false, 0});
            ++c.entries;
        }
        capstans.push_back(c);
    }
}

void System::place_capstans(const model::Interactions&) {
    auto entry = capstan_entries.begin();
    for (const Capstan& c : capstans)
        for (const auto end = entry + c.entries; entry != end; ++entry) {
            const std::int32_t slide = node_of_body[at(c.body)],
                               load = node_of_interaction[at(entry->load)];
            if (slide < 0 || load < 0) continue;  // asleep
            // The written half contains the rows of nodes that are eliminated later.
            entry->upper = symbolic.position[at(load)] > symbolic.position[at(slide)];
            const auto target =
                entry->upper ? symbolic.target(load, slide) : symbolic.target(slide, load);
            entry->address = target.address;
            entry->column = factor::DirtyParts::column(symbolic, slide, load);
        }
}

void System::write_capstans(int piece, double* panel, double* upper) const noexcept {
    const factor::Piece& p = numeric.pieces()[at(piece)];
    for (const CapstanEntry& e : capstan_entries) {
        if (e.value == 0.0 || e.address < p.panel_begin || e.address >= p.panel_end) continue;
        (e.upper ? upper : panel)[e.address] += e.value;
    }
}

}  // namespace hawser::assembly
