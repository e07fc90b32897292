// SPDX-License-Identifier: Apache-2.0
/// The end of a wire comes to lie on a drum.
#include <hawser/world.h>

#include "world/checks.h"
#include "world/impl.h"

namespace hawser {

InteractionId World::wind_up(WireId id, int end, BodyId drum, double radius) {
    const world::Using use(impl_->use, "wind_up");
    const world::Wire& wire = impl_->wire(id);
    const std::string where = world::label("wire", wire.name);
    if (end != 0 && end != 1) world::refuse(where, "end must be 0, the first one, or 1");
    const std::size_t place = end == 0 ? 0 : wire.elements.size() - 1;
    const InteractionId old = wire.elements[place];
    if (!alive(old)) world::refuse(where, "the element at this end has been removed");
    if (!intact(old)) world::refuse(where, "the element at this end has parted");
    InteractionDef d = interaction_def(old);
    if (kind_info(d.kind).is(kWoundUp))
        world::refuse(where, "this end lies on a drum already; one drum an end");
    if (!alive(drum) || body_def(drum).kind != BodyKind::scalar)
        world::refuse(where, "its drum must be a scalar body");
    if (!(radius >= -1e3 && radius <= 1e3))
        world::refuse(where, "radius = " + world::number(radius) + " m; give -1000 to 1000");
    const auto& in = impl_->ctx.model.interactions;
    d.kind = InteractionKind::WinchStretch;
    d.body[2] = drum;
    d.set("radius", radius).set("drum_zero", pose(drum).position.x());
    // A compliance that came from the length follows it.
    if ((in.flags[at(old.index)] & model::kFromLength) != 0) d.compliance[0] = kDefault;
    (void)remove_interaction(old);  // the name is free then, and nothing else can be refused
    const InteractionId out = add_interaction(d);
    impl_->wires.wires[at(id.index)].elements[place] = out;
    return out;
}

}  // namespace hawser
