// SPDX-License-Identifier: Apache-2.0
/// Coordinates of joints and of the limits, drives and friction on them.
#include <hawser/world.h>

#include "world/checks.h"
#include "world/impl.h"

#include <string>

namespace hawser {
namespace world {

std::string no_coordinate(const KindInfo& kind) {
    std::string those;
    for (const KindInfo& k : interaction_kinds())
        if (k.coordinate != KindCoordinate::none)
            those += (those.empty() ? "" : ", ") + std::string(k.name);
    return std::string("a ") + kind.name + " has no coordinate; those that have one are " + those;
}

std::string no_motor(const KindInfo& kind) {
    for (const KindInfo& k : interaction_kinds())
        if (k.is(kMotorKind) && k.coordinate == kind.coordinate)
            return std::string("a ") + kind.name + " is no motor; the " + k.name +
                   " that drives its coordinate is";
    return std::string("a ") + kind.name + " is no motor; its forces are World::force()";
}

}  // namespace world

namespace {

/// Return the coordinate of an interaction.
/// @throws DefError for a kind without a coordinate.
model::Coordinate interaction_coordinate(const context::StepContext& ctx, std::size_t i) {
    const InteractionDef& def = ctx.model.interactions.def[i];
    const KindInfo& kind = kind_info(def.kind);
    if (kind.coordinate == KindCoordinate::none)
        throw DefError(world::label("interaction", def.name) + ": " + world::no_coordinate(kind));
    return ctx.model.interactions.coordinate(static_cast<int>(i), ctx.model.bodies);
}

}  // namespace

double World::coordinate(InteractionId id) const {
    return interaction_coordinate(impl_->ctx, impl_->index_of(id)).value;
}

double World::speed(InteractionId id) const {
    return interaction_coordinate(impl_->ctx, impl_->index_of(id)).rate;
}

double World::motor_force(InteractionId id) const {
    const InteractionDef& def = interaction_def(id);
    const KindInfo& kind = kind_info(def.kind);
    if (!kind.is(kMotorKind))
        throw DefError(world::label("interaction", def.name) + ": " + world::no_motor(kind));
    return force(id)[0];
}

}  // namespace hawser
