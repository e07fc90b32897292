// SPDX-License-Identifier: Apache-2.0
/// Read access of clients to a world, without a copy or into their own memory.
#include <hawser/world.h>

#include "world/impl.h"
#include "world/lookup.h"

namespace hawser {

StateView WorldStateView::arrays() const noexcept {
    const context::StepContext& ctx = impl().ctx;
    const model::Bodies& b = ctx.model.bodies;
    // Ghost bodies (split/cuts.h) stand behind the user bodies.
    const auto n = at(world_->body_count());
    const auto first = [](const auto& array, std::size_t count) {
        return std::span(array).first(count);
    };
    return {.time = ctx.state.time,
            .kinds = first(b.kind, n),
            .positions = first(b.x, 3 * n),
            .orientations = first(b.q, 4 * n),
            .velocities = std::span(b.v),
            .velocity_begin = first(b.dof_begin, n),
            .prescribed = first(b.v_fixed, 6 * n)};
}

Twist World::predicted_velocity(BodyId id) const {
    const std::size_t b = impl_->index_of(id);
    const model::Bodies& s = impl_->ctx.model.bodies;
    const int dof = s.dof(id.index);
    if (dof == 0) return velocity(id);
    Twist twist;
    const double* v = &s.v_start[at(s.dof_begin[b])];
    for (int i = 0; i < dof; ++i) (i < 3 ? twist.linear[i] : twist.angular[i - 3]) = v[i];
    return twist;
}

Vec3 World::local_point(BodyId id, const Vec3& point) const {
    const Pose p = pose(id);
    return p.orientation.conjugate() * (point - p.position);
}

std::vector<Event> WorldEvents::take() {
    const world::Using use(impl().use, "events().take");
    return impl().ctx.state.events.take();
}

std::uint64_t WorldEventsView::since(std::uint64_t& cursor, std::vector<Event>& out) const {
    const world::Using use(impl().use, "events().since");
    return impl().ctx.state.events.since(cursor, out);
}

std::uint64_t WorldEventsView::cursor() const noexcept { return impl().ctx.state.events.count(); }

}  // namespace hawser
