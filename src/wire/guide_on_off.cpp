// SPDX-License-Identifier: Apache-2.0
#include "wire/guide_on_off.h"

#include "wire/lay_on.h"
#include "wire/lift.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hawser::wire {
namespace {

/// Factor of GuideDef::element_length. A released element with more material is divided by a node.
constexpr double kLongLifted = 1.5;
constexpr double kEndFraction = 0.25;  ///< Minimum fraction of the element next to that node.

}  // namespace

std::unique_ptr<GuideSystem> guide_without_wire(GuideDef def) {
    return std::make_unique<GuideSystem>(std::move(def), Guide{}, InputId{},
                                         std::array<double, 2>{});
}

std::unique_ptr<GuideSystem> engage_guide(NodeEdits& nodes, GuideDef def, double speed) {
    const World& world = nodes.world;
    const InteractionDef element = world.interaction_def(def.element);
    const EndNodes had = end_nodes(world, element);
    Guide made;
    double material[2] = {};
    if (!nodes.lay_over(def, speed, made, material)) return nullptr;
    const InputId stop = world.find_input(def.name + "/friction/force");
    const double whole = element.get("mass"),
                 mass = whole - mass_kept_by_nodes(had, end_nodes(world, element), whole);
    const double scale = mass / (def.mass_per_length * (material[0] + material[1]));
    auto out = std::make_unique<GuideSystem>(
        std::move(def), made, stop,
        std::array<double, 2>{scale * material[0], scale * material[1]});
    out->begin_at(speed);
    return out;
}

bool disengage_guide(NodeEdits& nodes, const GuideSystem& guide, const InteractionDef& element,
                     InteractionId* made) {
    const InteractionId whole = nodes.lift_off(guide.ids(), element);
    if (!whole.valid()) return false;
    if (made != nullptr) *made = whole;
    const double first = guide.material()[0], both = first + guide.material()[1];
    if (both <= kLongLifted * guide.def().element_length) return true;
    // A wire that leaves an open guide has a node where the wheel was, if that is not at an end.
    const double fraction =
        guide.def().closed ? 0.5 : std::clamp(first / both, kEndFraction, 1.0 - kEndFraction);
    (void)nodes.insert_node(whole, fraction);
    return true;
}

void GuideSystem::release_at_end(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (!parts_intact(world)) return;
    const auto ends = [&](std::size_t side) {
        const double length = def_.element_length > 0.0 ? length_[side] : material_[side];
        // The end of a fast wire may leave the wheel while its straight part still has length but
        // no material.
        const bool none_left =
            def_.element_length > 0.0 && !(material_[side] > 0.0) && runs_out(side);
        return (none_left || is_nearly_used_up(world, side)) &&
               ends_free(world, element(side), side, def_.mass_per_length, length);
    };
    if (!ends(0) && !ends(1)) return;
    InteractionDef lifted = lifted_element(world, *this, true);
    // The wire on the wheel comes off as well.
    if (const double whole = material_[0] + material_[1];
        def_.element_length > 0.0 && whole > lifted.get("length"))
        lifted.set("length", whole);
    parted_ = kRunsOff;  // the guide holds no wire any more
    if (!disengage_guide(nodes, *this, lifted)) {
        parted_ = 0;
        return;
    }
    tension_.fill(std::max(tension_[0], tension_[1]));  // for its report
    angle_ = speed_ = 0.0;
    used_up_side_ = -1;
}

}  // namespace hawser::wire
