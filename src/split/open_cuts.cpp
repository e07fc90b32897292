// SPDX-License-Identifier: Apache-2.0
/// Determine the cuts in force. A split is valid only between parts that nothing else connects.
/// Bodies are therefore united over all interactions that are not cut. A cut whose sides have
/// become one part is closed. This repeats until no cut closes.
#include "split/cuts.h"

#include "base/index.h"
#include "context/copies.h"
#include "context/cuts_data.h"
#include "split/split.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace hawser::split {
namespace {

std::int32_t root(std::vector<std::int32_t>& part, std::int32_t b) {
    while (part[at(b)] != b) b = part[at(b)] = part[at(part[at(b)])];
    return b;
}

/// Merge the parts of all moving bodies in a list to one part.
void unite_parts(context::Model& model, std::span<const std::int32_t> bodies) {
    std::int32_t first = -1;
    for (const std::int32_t b : bodies) {
        if (model.bodies.dof(b) == 0) continue;
        const std::int32_t r = root(model.cuts.part, b);
        if (first >= 0) model.cuts.part[at(std::max(r, first))] = std::min(r, first);
        first = first < 0 ? r : std::min(r, first);
    }
}

/// True if two bodies of different groups are connected without this cut.
bool is_coupled_without(context::Model& model, const context::Cut& cut) {
    const auto bodies = context::bodies_of(model.interactions, cut.id);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::int32_t a = bodies[i], b = bodies[j];
            if (model.bodies.dof(a) == 0 || model.bodies.dof(b) == 0) continue;
            if (model.cuts.group[at(a)] != model.cuts.group[at(b)] &&
                root(model.cuts.part, a) == root(model.cuts.part, b))
                return true;
        }
    return false;
}

}  // namespace

bool open_cuts(context::Model& model) {
    context::Cuts& cuts = model.cuts;
    assembly::System& system = model.system;
    if (cuts.list.empty()) return false;
    const std::vector<std::int32_t> before = std::move(system.left_out);
    system.left_out.clear();
    system.sides.clear();
    std::iota(cuts.part.begin(), cuts.part.end(), 0);
    // Bodies of one group are one part only if something joins them; copies join the bodies of
    // their side.
    auto cut = cuts.list.begin();
    for (std::int32_t id = 0; id < cuts.interactions; ++id) {
        if (cut != cuts.list.end() && cut->id == id)
            ++cut;
        else
            unite_parts(model, context::bodies_of(model.interactions, id));
    }
    for (std::size_t k = 0; k < cuts.of.size(); ++k) {
        std::vector<std::int32_t> own;
        for (const std::int32_t b : context::bodies_of(
                 model.interactions, cuts.interactions + static_cast<std::int32_t>(k)))
            if (b < cuts.bodies) own.push_back(b);
        unite_parts(model, own);
    }
    for (const assembly::Contacts::Link& l : system.contacts.links)
        unite_parts(model, std::array<std::int32_t, 2>{l.first, l.second});
    for (context::Cut& c : cuts.list) {
        c.open = cuts.coupling[at(c.id)] != Coupling::deadline || (cuts.asked >> c.interface & 1U);
        if (!c.open) unite_parts(model, context::bodies_of(model.interactions, c.id));
    }
    for (bool again = true; again;) {
        again = false;
        for (context::Cut& c : cuts.list) {
            if (!c.open || !is_coupled_without(model, c)) continue;
            c.open = false;
            unite_parts(model, context::bodies_of(model.interactions, c.id));
            again = true;
        }
    }
    for (const context::Cut& c : cuts.list) {
        if (c.open) {
            system.left_out.push_back(c.id);
            const bool soften = cuts.coupling[at(c.id)] != Coupling::kinematic;
            system.sides.push_back({c.first, c.sides, soften});
        } else {
            for (std::int32_t i = 0; i < c.sides; ++i) system.left_out.push_back(c.first + i);
        }
    }
    return before != system.left_out;
}

std::uint64_t open_interfaces(const context::Model& model) noexcept {
    std::uint64_t interfaces = 0;
    for (const context::Cut& c : model.cuts.list)
        if (c.open && model.cuts.coupling[at(c.id)] == Coupling::deadline)
            interfaces |= std::uint64_t{1} << c.interface;
    return interfaces;
}

void remove_cut_interactions(context::Model& model, std::uint64_t interfaces,
                             assembly::System& beside) {
    const std::uint64_t previous_request = std::exchange(model.cuts.asked, interfaces);
    (void)open_cuts(model);
    beside.left_out = model.system.left_out;
    beside.sides = model.system.sides;
    model.cuts.asked = previous_request;
    (void)open_cuts(model);
}

}  // namespace hawser::split
