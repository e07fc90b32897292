// SPDX-License-Identifier: Apache-2.0
#include "split/clique.h"

#include "base/index.h"
#include "context/cuts_data.h"
#include "context/view.h"
#include "solve/active_set.h"
#include "solve/analysis.h"
#include "solve/assemble.h"
#include "solve/solve.h"
#include "solve/wires.h"

#include <algorithm>

namespace hawser::split {
namespace {

WorldDef single_threaded(WorldDef def) {
    def.threads = 1;
    def.coupling = Coupling::exact;
    def.budget = def.budget_work = 0.0;
    return def;
}

/// Return the definition of a body of the clique. A member has its dynamics; another body is fixed
/// and has a prescribed velocity in each step.
BodyDef clique_body_def(const model::Bodies& b, std::int32_t body, bool member) {
    const auto i = at(body);
    BodyDef def;
    def.kind = member ? b.kind[i] : BodyKind::fixed;
    def.position = {b.x[3 * i], b.x[3 * i + 1], b.x[3 * i + 2]};
    def.orientation = Quat(b.q[4 * i], b.q[4 * i + 1], b.q[4 * i + 2], b.q[4 * i + 3]);
    if (!member) return def;
    def.mass = b.mass[i];
    for (std::size_t k = 0; k < 9; ++k)
        def.inertia(static_cast<int>(k) / 3, static_cast<int>(k) % 3) = b.inertia[9 * i + k];
    for (std::size_t k = 0; k < 3; ++k) {
        def.linear_damping[static_cast<int>(k)] = b.damping[6 * i + k];
        def.angular_damping[static_cast<int>(k)] = b.damping[6 * i + 3 + k];
    }
    def.gravity = b.weight[i] != 0;
    return def;
}

/// Return one mark per body: the bodies of cut interactions, and all bodies that share an
/// interaction with them.
std::vector<std::uint8_t> choose_members(const context::Model& model) {
    const model::Interactions& in = model.interactions;
    std::vector<std::uint8_t> near(at(model.cuts.bodies), 0), member;
    auto mark = [&](std::int32_t id, std::vector<std::uint8_t>& marks) {
        for (std::size_t b = 0; b < in.bodies[at(id)]; ++b) {
            const std::int32_t body = in.body[kMaxInteractionBodies * at(id) + b];
            if (model.bodies.dof(body) > 0) marks[at(body)] = 1;
        }
    };
    for (const context::Cut& cut : model.cuts.list) mark(cut.id, near);
    member = near;
    for (std::int32_t id = 0; id < model.cuts.interactions; ++id)
        for (std::size_t b = 0; b < in.bodies[at(id)]; ++b)
            if (near[at(in.body[kMaxInteractionBodies * at(id) + b])]) mark(id, member);
    return member;
}

void copy_pose(model::Bodies& to, std::int32_t t, const model::Bodies& from, std::int32_t f) {
    std::copy_n(&from.x[3 * at(f)], 3, &to.x[3 * at(t)]);
    std::copy_n(&from.q[4 * at(f)], 4, &to.q[4 * at(t)]);
    std::copy_n(&from.r[9 * at(f)], 9, &to.r[9 * at(t)]);
}

/// Copy the parameters and the multipliers of the last step from the world to the clique.
void copy_interactions(Clique& c, const context::Model& world) noexcept {
    model::Interactions& in = c.ctx.model.interactions;
    const model::Interactions& from = world.interactions;
    const double h = world.def.step;
    for (std::size_t i = 0; i < c.interaction.size(); ++i) {
        const std::int32_t id = c.interaction[i], own = static_cast<std::int32_t>(i);
        if (in.def[i].params != from.def[at(id)].params) {
            in.def[i].params = from.def[at(id)].params;
            in.refresh(own, c.ctx.model.bodies, h);
        }
        in.rest_length[i] = from.rest_length[at(id)];
        in.active[i] = from.active[at(id)];
        in.parted[i] = from.parted[at(id)];
        for (int r = 0; r < in.rows[i]; ++r) {
            const auto row = at(in.row_begin[i] + r), of = at(from.row_begin[at(id)] + r);
            in.lambda[row] = from.lambda[of];
            if (in.epsilon[row] == from.epsilon[of]) continue;
            in.epsilon[row] = from.epsilon[of];
            in.update_damping_of_row(row, in.rest_length[i] > 0.0, h);
        }
    }
}

/// Copy poses, velocities and forces of the members from the world. The forces include the contact
/// impulses of the last step.
void copy_bodies(Clique& c, const context::Model& world) noexcept {
    model::Bodies& b = c.ctx.model.bodies;
    const model::Bodies& from = world.bodies;
    const double per_h = 1.0 / world.def.step;
    for (std::size_t i = 0; i < c.body.size(); ++i) {
        const std::int32_t body = c.body[i], own = static_cast<std::int32_t>(i);
        const auto f = at(body);
        const int dof = from.dof(body);
        copy_pose(b, own, from, body);
        const double* v = dof > 0 ? &from.v[at(from.dof_begin[f])] : &from.v_fixed[6 * f];
        if (!c.member[i]) {
            std::copy_n(v, dof > 0 ? dof : 6, &b.v_fixed[6 * i]);
            continue;
        }
        std::copy_n(v, dof, &b.v[at(b.dof_begin[i])]);
        std::copy_n(&from.spin_change[3 * f], 3, &b.spin_change[3 * i]);
        for (int k = 0; k < 6; ++k) {
            const double touch = k < dof ? world.cuts.touch[at(from.dof_begin[f] + k)] : 0.0;
            b.force[6 * i + at(k)] = from.force[6 * f + at(k)] + per_h * touch;
        }
    }
    for (const Clique::Pull& p : c.pulls) {
        const auto row = at(world.interactions.row_begin[at(p.id)]);
        double impulse[6] = {};
        world.interactions.add_impulse(p.id, p.slot, from, &world.interactions.lambda[row],
                                       impulse);
        for (int k = 0; k < b.dof(p.body); ++k)
            b.force[6 * at(p.body) + at(k)] += per_h * impulse[k];
    }
}

/// Copy the loads of systems on the members from the world.
void copy_loads(Clique& c, const assembly::LoadStore& world) noexcept {
    c.ctx.state.loads.clear();
    if (!world.any()) return;
    c.ctx.state.loads.begin_system(0);
    for (std::size_t i = 0; i < c.body.size(); ++i)
        if (c.member[i])
            c.ctx.state.loads.copy_entry(world, c.body[i], static_cast<std::int32_t>(i));
    c.ctx.state.loads.finish(c.ctx.model.bodies, c.ctx.model.def.step, c.ctx.pool);
}

}  // namespace

void make_clique(context::Model& model) {
    auto clique = std::make_shared<Clique>(single_threaded(model.def));
    const model::Interactions& in = model.interactions;
    const std::vector<std::uint8_t> member = choose_members(model);
    std::vector<std::int32_t>& local = clique->local;
    local.assign(at(model.cuts.bodies), -1);
    for (std::int32_t id = 0; id < model.cuts.interactions; ++id) {
        bool touches = false;
        for (std::size_t b = 0; b < in.bodies[at(id)]; ++b)
            touches |= member[at(in.body[kMaxInteractionBodies * at(id) + b])] != 0;
        if (!touches) continue;
        InteractionDef def = in.def[at(id)];
        def.name.clear();
        const bool friction = (in.flags[at(id)] & model::kFriction) != 0;
        for (std::size_t b = 0; b < in.bodies[at(id)]; ++b) {
            const std::int32_t body = def.body[b].index;
            if (local[at(body)] < 0) {
                local[at(body)] = clique->ctx.model.bodies.add(
                    clique_body_def(model.bodies, body, member[at(body)] != 0));
                clique->body.push_back(body);
                clique->member.push_back(member[at(body)]);
            }
            if (friction && member[at(body)])
                clique->pulls.push_back({id, static_cast<std::int32_t>(b), local[at(body)]});
            const int dof = model.bodies.dof(body);
            if (!member[at(body)] && dof > 0 && dof < 6) def.point[b] = Vec3::Zero();
            def.body[b] = BodyId{local[at(body)]};
        }
        if (friction) continue;
        clique->interaction.push_back(id);
        const int own =
            clique->ctx.model.interactions.add(def, clique->ctx.model.bodies, model.def.step);
        if (in.flags[at(id)] & model::kByInput) clique->ctx.model.interactions.mark_driven(own);
    }
    clique->ctx.state.started = true;
    model.cuts.clique = std::move(clique);
}

void analyse_clique(context::Model& model) {
    if (!model.cuts.clique) return;
    Clique& c = *model.cuts.clique;
    for (std::size_t i = 0; i < c.body.size(); ++i)
        copy_pose(c.ctx.model.bodies, static_cast<std::int32_t>(i), model.bodies, c.body[i]);
    copy_interactions(c, model);
    solve::prepare_alone(c.ctx);
    // A clique solves once per step: its compliant joints are linearised. The first right-hand side
    // of an iteration would depend on the velocities at which the clique was made.
    context::Completion& completion = c.ctx.model.completion;
    for (std::size_t k = 0; k < completion.joints.size(); ++k)
        if (model::is_compliant(c.ctx.model.interactions, completion.joints[k]))
            completion.refused[k] = 1;
}

bool solve_clique(context::Model& model, const context::State& state) noexcept {
    Clique& c = *model.cuts.clique;
    copy_bodies(c, model);
    copy_interactions(c, model);
    copy_loads(c, state.loads);
    if (c.ctx.state.loads.out_of_memory()) return false;
    solve::release_wires(c.ctx.model);
    solve::assemble_system(c.ctx);
    c.ctx.state.refine_unasked = 1;  // its own count would need a field in the saved state
    Status status = solve::factor_and_solve(c.ctx);
    if (status == Status::ok) status = solve::settle_bounds(c.ctx);
    if (status != Status::ok) return false;
    const assembly::View v = context::view(c.ctx);
    for (const context::GhostBody& ghost : model.cuts.ghosts) {
        const std::int32_t own = c.local[at(ghost.of)];
        const int dof = v.dof[own];
        std::copy_n(v.v_new + v.dof_begin[own], dof, &model.bodies.v_fixed[6 * at(ghost.body)]);
    }
    return true;
}

}  // namespace hawser::split
