// SPDX-License-Identifier: Apache-2.0
/// Predict the state that each side of a cut assumes of the other sides: poses and velocities of
/// ghost bodies.
#include "split/split.h"

#include "base/index.h"
#include "context/cuts_data.h"
#include "split/clique.h"

#include <algorithm>

namespace hawser::split {
namespace {

/// Copy the velocity v_k of the original of a ghost body to six entries.
void copy_original_velocity(const model::Bodies& b, std::int32_t body, double* out) noexcept {
    std::fill_n(out, 6, 0.0);
    std::copy_n(&b.v[at(b.dof_begin[at(body)])], b.dof(body), out);
}

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Add the velocity change M⁻¹ (p + h (f − D v + m g) − h ω × Iω) of a rigid body to v, for an
/// impulse p of rows and contacts.
void add_impulse_to_rigid(const context::Model& model, const context::State& state,
                          std::int32_t body, const double* p, double* v) noexcept {
    const model::Bodies& b = model.bodies;
    const auto i = at(body);
    const double h = model.def.step;
    const Eigen::Map<const RowMajor> r(&b.r[9 * i]), inertia(&b.inertia[9 * i]),
        inverse(&b.inv_inertia[9 * i]);
    Eigen::Map<Vec3> lin(v), ang(v + 3);
    const Eigen::Map<const Vec3> f(&b.force[6 * i]), t(&b.force[6 * i + 3]);
    const Eigen::Map<const Vec3> d(&b.damping[6 * i]), dt(&b.damping[6 * i + 3]);
    const Vec3 drag = r * d.cwiseProduct(r.transpose() * lin);
    const Vec3 weight = b.weight[i] ? Vec3(b.mass[i] * model.def.gravity) : Vec3(Vec3::Zero());
    const Vec3 push = Eigen::Map<const Vec3>(p) + h * (f - drag + weight);
    const Vec3 w = r.transpose() * ang;
    const Vec3 torque = r.transpose() * (Eigen::Map<const Vec3>(p + 3) + h * t) -
                        h * dt.cwiseProduct(w) - h * w.cross(inertia * w);
    if (state.loads.loaded(body)) {
        double all[6];
        Eigen::Map<Vec3>(all, 3) = push;
        Eigen::Map<Vec3>(all + 3, 3) = r * torque;
        state.loads.push(b, body, h, all, v);
        return;
    }
    lin += push / b.mass[i];
    ang += r * (inverse * torque);
}

/// Add the velocity change (p + h (f − D v + m g))/m of a node or a scalar body to v, for an
/// impulse p of rows and contacts. Scalar bodies have no weight.
void add_impulse_to_point(const context::Model& model, const context::State& state,
                          std::int32_t body, const double* p, double* v) noexcept {
    const model::Bodies& b = model.bodies;
    const auto i = at(body);
    const double h = model.def.step;
    const int dof = b.dof(body);
    double all[3] = {};
    for (int k = 0; k < dof; ++k) {
        const double weight = b.weight[i] && dof == 3 ? b.mass[i] * model.def.gravity[k] : 0.0;
        all[k] = p[k] + h * (b.force[6 * i + at(k)] - b.damping[6 * i + at(k)] * v[k] + weight);
    }
    if (state.loads.loaded(body)) return state.loads.push(b, body, h, all, v);
    for (int k = 0; k < dof; ++k) v[k] += all[k] / b.mass[i];
}

/// Predict the velocities of ghost bodies from current velocities and forces, as the paper states.
void predict_by_forces(context::Model& model, const context::State& state) noexcept {
    const model::Interactions& in = model.interactions;
    model::Bodies& b = model.bodies;
    std::size_t pull = 0;
    for (std::size_t k = 0; k < model.cuts.ghosts.size(); ++k) {
        const context::GhostBody ghost = model.cuts.ghosts[k];
        double impulse[6] = {};
        std::copy_n(&model.cuts.touch[at(b.dof_begin[at(ghost.of)])], b.dof(ghost.of), impulse);
        for (; pull < model.cuts.pulls.size() &&
               model.cuts.pulls[pull].ghost == static_cast<std::int32_t>(k);
             ++pull) {
            const context::Pull& p = model.cuts.pulls[pull];
            if (model.system.rests(p.id)) continue;
            in.add_impulse(p.id, p.slot, b, &in.lambda[at(in.row_begin[at(p.id)])], impulse);
        }
        double* v = &b.v_fixed[6 * at(ghost.body)];
        if (b.dof(ghost.of) == 6)
            add_impulse_to_rigid(model, state, ghost.of, impulse, v);
        else
            add_impulse_to_point(model, state, ghost.of, impulse, v);
    }
}

}  // namespace

void copy_ghost_poses(context::Model& model) noexcept {
    model::Bodies& b = model.bodies;
    for (const context::GhostBody& ghost : model.cuts.ghosts) {
        const auto to = at(ghost.body), from = at(ghost.of);
        std::copy_n(&b.x[3 * from], 3, &b.x[3 * to]);
        std::copy_n(&b.q[4 * from], 4, &b.q[4 * to]);
        std::copy_n(&b.r[9 * from], 9, &b.r[9 * to]);
    }
}

void predict(context::Model& model, const context::State& state) noexcept {
    if (model.cuts.list.empty()) return;
    model::Bodies& b = model.bodies;
    for (const std::int32_t body : b.driven)
        std::copy_n(&b.v_fixed[6 * at(body)], 6, &b.v_before[6 * at(body)]);
    copy_ghost_poses(model);
    for (const context::GhostBody& ghost : model.cuts.ghosts) {
        double* v = &b.v_fixed[6 * at(ghost.body)];
        copy_original_velocity(b, ghost.of, v);
        std::copy_n(v, 6, &b.v_before[6 * at(ghost.body)]);
    }
    for (const context::Cut& cut : model.cuts.list)
        for (std::int32_t i = 0; i < cut.sides; ++i)
            model.interactions.mirror(cut.first + i, cut.id, b, model.def.step);
    if (model.def.predictor == Predictor::forces) predict_by_forces(model, state);
    if (model.def.predictor == Predictor::clique) (void)solve_clique(model, state);
}

void sum_contact_impulses(context::Model& model, std::vector<double>& room) noexcept {
    if (model.cuts.list.empty()) return;
    const assembly::Contacts& c = model.system.contacts;
    for (std::size_t k = 0; k < c.count(); ++k) std::copy_n(c.cones[k].lambda, 3, &room[3 * k]);
    for (std::size_t k = 0; k < c.resistances.count(); ++k)
        std::copy_n(c.resistances.laws[k].lambda, 3, &room[3 * (c.count() + k)]);
    std::fill(model.cuts.touch.begin(), model.cuts.touch.end(), 0.0);
    c.scatter(room.data(), model.cuts.touch.data(), model.bodies.dof_begin.data());
}

}  // namespace hawser::split
