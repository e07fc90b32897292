// SPDX-License-Identifier: Apache-2.0
#include <hawser/inspect.h>
#include <hawser/world.h>

#include "base/hash.h"
#include "context/asleep.h"
#include "monitor/energy.h"
#include "monitor/monitor.h"
#include "state/state_hash.h"
#include "step/ready.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace hawser {

using world::lookup;

World::World(const WorldDef& def) {
    check_environment();
    world::check(def);
    impl_ = std::make_unique<Impl>(def);
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::prepare() {
    const world::Using use(impl_->use, "prepare");
    step::ready(impl_->ctx);
}

Status World::step() noexcept {
    Impl& m = *impl_;
    const world::OptionalUse use(m.use);
    if (!use.is_outermost()) return Status::in_use;
    m.systems.use(*this);
    m.undo.holds = false;
    const std::size_t mark = m.listener != nullptr ? m.listener->mark() : 0;
    Status status = m.systems.begin_step(*this);
    m.ctx.work.limits.coarsening.possible = m.systems.coarsens();
    if (status == Status::ok) status = m.run_step();
    if (status == Status::bad_edit && m.systems.has_requested_edits()) {
        status = m.make_edits(*this);
        if (status == Status::ok) status = m.run_step();
    }
    m.ctx.work.stats.status = status;
    if (status != Status::ok) {
        m.undo_step(mark);
        return status;
    }
    m.outputs.store_figures(m.ctx.work.stats);
    evaluate_outputs();
    return status;
}

void World::cancel() noexcept { impl_->ctx.pool.stop(); }

void WorldSolver::degrade_next_step(const Degradation& degradation) noexcept {
    impl().ctx.state.imposed = degradation;
    // Clamped to 0, because bytes may not come from a step.
    impl().ctx.state.imposed.iterations = std::max(0, degradation.iterations);
    impl().ctx.state.imposed.wires =
        std::clamp(degradation.wires, 0, budget::Coarsening::kMaxLevel);
    if (impl().listener != nullptr) impl().listener->degraded(degradation);
}

int WorldSolverView::coarsening() const noexcept {
    const Degradation& imposed = impl().ctx.state.imposed;
    return imposed.any() ? imposed.wires : impl().ctx.work.limits.coarsening.level();
}

double World::time() const noexcept { return impl_->ctx.state.time; }
std::int64_t World::step_count() const noexcept { return impl_->ctx.state.step; }
const StepStats& World::stats() const noexcept { return impl_->ctx.work.stats; }
EventExtremes WorldEventsView::extremes(EventKind kind) const noexcept {
    return impl().ctx.state.events.extremes(kind);
}
const WorldDef& World::settings() const noexcept { return impl_->ctx.model.def; }

Energy World::energy() const noexcept {
    const world::OptionalUse use(impl_->use);
    if (!use.is_granted() || impl_->ctx.state.changed != context::Changed::nothing) return {};
    try {
        step::ready(impl_->ctx);
    } catch (const std::exception&) {
        return {};  // after a failed step
    }
    return monitor::energy(impl_->ctx);
}

Verdict World::verdict() const noexcept { return monitor::verdict(impl_->ctx); }

std::uint64_t WorldStateView::hash() const noexcept { return impl().systems.hash(motion_hash()); }

std::uint64_t WorldStateView::motion_hash() const noexcept {
    const std::vector<double>& inputs = impl().input_values;
    return base::fnv1a(inputs.data(), inputs.size() * sizeof(double),
                       state::state_hash(impl().ctx.model, impl().ctx.state));
}

void World::set_force(BodyId body, const Vec3& force, const Vec3& torque) {
    const world::Using use(impl_->use, "set_force");
    const std::size_t b = impl_->index_of(body);
    world::check_force(world::Where("body", impl_->body_defs[b].name), force, torque);
    BodyDef& def = impl_->body_defs[b];
    if (def.force != force || def.torque != torque)
        context::wake_island(impl_->ctx.model, body.index);
    def.force = force;
    def.torque = torque;
    for (int i = 0; i < 6; ++i) impl_->add_up_force(body, i);
    if (impl_->listener != nullptr) impl_->listener->set_force(body, force, torque);
}

int World::body_count() const noexcept { return context::body_count(impl_->ctx.model); }
const BodyDef& World::body_def(BodyId id) const { return impl_->body_defs[impl_->index_of(id)]; }
BodyId World::find_body(std::string_view name) const noexcept {
    return impl_->ctx.model.bodies.id(lookup(impl_->body_names, name));
}

Pose World::pose(BodyId id) const {
    const std::size_t b = impl_->index_of(id);
    const model::Bodies& s = impl_->ctx.model.bodies;
    const double* q = &s.q[4 * b];
    return {Vec3(s.x[3 * b], s.x[3 * b + 1], s.x[3 * b + 2]), Quat(q[0], q[1], q[2], q[3])};
}

Twist World::velocity(BodyId id) const {
    const std::size_t b = impl_->index_of(id);
    const model::Bodies& s = impl_->ctx.model.bodies;
    Twist t;
    const int dof = s.dof(id.index);
    const double* v = dof == 0 ? &s.v_fixed[6 * b] : &s.v[at(s.dof_begin[b])];
    const int count = dof == 0 ? 6 : dof;
    for (int i = 0; i < count; ++i) (i < 3 ? t.linear[i] : t.angular[i - 3]) = v[i];
    return t;
}

void World::set_pose(BodyId id, const Pose& pose) {
    const world::Using use(impl_->use, "set_pose");
    const std::size_t b = impl_->index_of(id);
    world::check_pose(world::Where("body", impl_->body_defs[b].name), pose.position,
                      pose.orientation);
    model::Bodies& s = impl_->ctx.model.bodies;
    impl_->ctx.state.monitor.state.begun = 0;  // not the work of a force
    // Bodies that leaned on it are unsupported now.
    if (s.dof(id.index) == 0 || s.asleep[b] != 0) context::wake_islands_of(impl_->ctx.model);
    context::wake_island(impl_->ctx.model, id.index);
    for (int i = 0; i < 3; ++i) s.x[3 * b + at(i)] = pose.position[i];
    if (s.kind[b] == BodyKind::scalar)
        for (const std::int32_t w : impl_->ctx.model.interactions.winches)
            impl_->ctx.model.interactions.update_length_at_drum(w, s, impl_->ctx.model.def.step);
    if (impl_->listener != nullptr) impl_->listener->set_pose(id, pose);
    if (s.kind[b] == BodyKind::lump || s.kind[b] == BodyKind::scalar) return;
    const Quat q = pose.orientation.normalized();
    const double values[4] = {q.w(), q.x(), q.y(), q.z()};
    for (std::size_t i = 0; i < 4; ++i) s.q[4 * b + i] = values[i];
    s.refresh_rotation(id.index);
}

void World::set_velocity(BodyId id, const Twist& twist) {
    const world::Using use(impl_->use, "set_velocity");
    const std::size_t b = impl_->index_of(id);
    const world::Where where("body", impl_->body_defs[b].name);
    world::check_velocity(where, twist.linear, twist.angular);
    model::Bodies& s = impl_->ctx.model.bodies;
    const int dof = s.dof(id.index);
    if (s.kind[b] == BodyKind::fixed)
        world::throw_def_error(where, "velocity: a fixed body has none; a kinematic one has");
    double* v = dof == 0 ? &s.v_fixed[6 * b] : &s.v[at(s.dof_begin[b])];
    const int count = dof == 0 ? 6 : dof;
    // A prescribed velocity wakes its contacts in the step (step/sleep.h).
    if (dof > 0) {
        context::wake_island(impl_->ctx.model, id.index);
        impl_->ctx.state.monitor.state.begun = 0;  // not the work of a force
    }
    for (int i = 0; i < count; ++i) v[i] = i < 3 ? twist.linear[i] : twist.angular[i - 3];
    // The start of the next step uses it too, for lack of a better value.
    if (dof > 0) std::copy_n(v, dof, &s.v_start[at(s.dof_begin[b])]);
    if (impl_->listener != nullptr) impl_->listener->set_velocity(id, twist);
}

bool World::asleep(BodyId id) const {
    return impl_->ctx.model.bodies.asleep[impl_->index_of(id)] != 0;
}

void World::wake(BodyId id) {
    const world::Using use(impl_->use, "wake");
    (void)impl_->index_of(id);
    if (impl_->ctx.model.bodies.dof(id.index) == 0) context::wake_islands_of(impl_->ctx.model);
    context::wake_island(impl_->ctx.model, id.index);
    if (impl_->listener != nullptr) impl_->listener->woken(id);
}

Vec3 World::world_point(BodyId id, const Vec3& local) const {
    const Pose p = pose(id);
    return p.position + p.orientation * local;
}

int World::interaction_count() const noexcept {
    return context::interaction_count(impl_->ctx.model);
}
const InteractionDef& World::interaction_def(InteractionId id) const {
    return impl_->ctx.model.interactions.def[impl_->index_of(id)];
}
InteractionId World::find_interaction(std::string_view name) const noexcept {
    return impl_->ctx.model.interactions.id(lookup(impl_->interaction_names, name));
}

std::span<const double> World::force(InteractionId id) const {
    const std::size_t i = impl_->index_of(id);
    const model::Interactions& in = impl_->ctx.model.interactions;
    return {in.force.data() + in.row_begin[i], in.rows[i]};
}

std::array<double, kMaxInteractionRows> World::violation(InteractionId id) const {
    const std::size_t i = impl_->index_of(id);
    const model::Interactions& in = impl_->ctx.model.interactions;
    const model::RowState s = in.row_state(id.index, impl_->ctx.model.bodies);
    std::array<double, kMaxInteractionRows> g{};
    for (std::size_t r = 0; r < in.rows[i]; ++r)
        if ((in.row_flags[at(in.row_begin[i]) + r] & model::kRowVelocity) == 0) g[r] = s.g[r];
    return g;
}

bool WorldSolverView::completed(InteractionId id) const {
    return impl().ctx.model.interactions.completed[impl().index_of(id)] != 0;
}

std::array<double, kMaxInteractionRows> WorldSolverView::stiffness_force(InteractionId id) const {
    const std::size_t i = impl().index_of(id);
    const model::Interactions& in = impl().ctx.model.interactions;
    const std::vector<double>& with = impl().ctx.model.completion.lambda_with;
    std::array<double, kMaxInteractionRows> f{};
    const auto row = at(in.row_begin[i]);
    for (std::size_t r = 0; r < in.rows[i] && row + r < with.size(); ++r)
        f[r] = with[row + r] / world_->settings().step;
    return f;
}

int WorldWiresView::damped_steps(InteractionId id) const {
    const context::Wires& wires = impl().ctx.model.wires;
    const std::size_t i = impl().index_of(id);
    if (i >= wires.wire_of.size() || wires.wire_of[i] < 0) return 0;
    return wires.flag_steps[static_cast<std::size_t>(wires.wire_of[i])];
}

bool World::intact(InteractionId id) const {
    return impl_->ctx.model.interactions.parted[impl_->index_of(id)] == 0;
}

SystemView WorldSolverView::matrix() const {
    const world::Using use(impl().use, "solver().matrix");
    WorldImpl& m = impl();
    step::ready(m.ctx);
    const assembly::System& s = m.ctx.model.system;
    SystemView v;
    v.nodes.resize(static_cast<std::size_t>(s.pattern.nodes()));
    for (std::size_t n = 0; n < v.nodes.size(); ++n)
        v.nodes[n] = {{}, {}, s.pattern.size[n], s.symbolic.node_front[n]};
    for (int b = 0; b < world_->body_count(); ++b)
        if (s.node_of_body[at(b)] >= 0)
            v.nodes[at(s.node_of_body[at(b)])].body = m.ctx.model.bodies.id(b);
    // Duplicated rows of a cut interaction show as their original.
    for (int i = 0; i < m.ctx.model.interactions.count(); ++i)
        if (s.node_of_interaction[at(i)] >= 0)
            v.nodes[at(s.node_of_interaction[at(i)])].interaction =
                m.ctx.model.interactions.id(context::original(m.ctx.model, i));
    v.edge_start = s.pattern.start;
    v.edges = s.pattern.adjacent;
    v.order = s.symbolic.order;
    for (const factor::Front& f : s.symbolic.fronts) {
        v.front_parent.push_back(f.parent);
        v.front_pivots.push_back(f.p);
        v.front_update.push_back(f.q);
    }
    v.body_island = s.islands.label;
    v.body_island.resize(at(world_->body_count()));
    v.matrix_nnz = s.symbolic.matrix_nnz;
    v.factor_nnz = s.symbolic.factor_nnz;
    v.flops = s.symbolic.flops;
    v.critical_flops = s.symbolic.critical_flops;
    return v;
}

std::size_t WorldSolverView::memory_bytes() const noexcept {
    const context::StepContext& c = impl().ctx;
    return c.model.bodies.bytes() + c.model.interactions.bytes() + c.model.system.bytes() +
           c.model.collider.bytes() + c.state.loads.bytes() +
           impl().body_defs.capacity() * sizeof(BodyDef);
}

}  // namespace hawser
