// SPDX-License-Identifier: Apache-2.0
/// Check the mechanical energy of states against the work of all sources.
#include "verify/certificate_state.h"

#include "record/units.h"
#include "verify/contact_side.h"
#include "verify/interaction_forces.h"
#include "verify/load_impulses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

std::size_t array_index(std::int32_t i) { return static_cast<std::size_t>(i); }

// Return ½ g²/ε of the rows of an interaction at the present poses. A tension-only line that is
// shorter than its rest length stores no energy.
double energy_of_spring(const World& world, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    if (!world.intact(id)) return 0.0;
    const auto g = world.violation(id);
    double sum = 0.0;
    for (std::size_t r = 0; r < array_index(kind_info(def.kind).rows); ++r) {
        if (is_elastic_line(def.kind) && g[r] < 0.0 && def.get("tension_only") != 0.0) continue;
        const double compliance = is_elastic_line(def.kind)
                                      ? parameter(world, id, "length") / def.get("EA")
                                      : def.compliance[r];
        sum += 0.5 * g[r] * g[r] / compliance;
    }
    return sum;
}

/// Displacement [m] and rotation [rad] of a body from one pose to another.
struct Displacement {
    Vec3 moved_by, turned_by;
};
Displacement displacement_between(const Pose& from, const Pose& to) {
    const Eigen::AngleAxisd turn(to.orientation * from.orientation.conjugate());
    return {to.position - from.position, turn.angle() * turn.axis()};
}

}  // namespace

double StateVerifier::kinetic(const World& world) const {
    double sum = 0.0;
    for (const BodyId id : moving_) {
        const BodyDef& def = world.body_def(id);
        const Twist v = world.velocity(id);
        sum += 0.5 * def.mass * v.linear.squaredNorm();
        if (def.kind != BodyKind::rigid) continue;
        const Vec3 w = world.pose(id).orientation.conjugate() * v.angular;
        sum += 0.5 * w.dot(def.inertia * w);
    }
    for (const InteractionId id : interactions_) {
        const double mass = piece_mass(world, id);
        if (mass == 0.0 || !world.intact(id)) continue;
        const auto& body = world.interaction_def(id).body;
        const Vec3 separation = world.velocity(body[1]).linear - world.velocity(body[0]).linear;
        sum -= mass / 12.0 * separation.squaredNorm();
    }
    return sum;
}

double StateVerifier::gravity(const World& world) const {
    double sum = 0.0;
    for (const BodyId id : moving_) {
        const BodyDef& def = world.body_def(id);
        if (def.gravity && def.kind != BodyKind::scalar)
            sum -= def.mass * world.settings().gravity.dot(world.pose(id).position);
    }
    return sum;
}

double StateVerifier::elastic(const World& world) const {
    double sum = 0.0;
    for (const InteractionId id : interactions_)
        if (role_[array_index(id.index)] == Role::spring) sum += energy_of_spring(world, id);
    return sum;
}

void StateVerifier::count_edit_energy(const World& world) {
    const auto same = [](const auto& a, const auto& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    };
    if (same(bodies_, world.bodies()) && same(interactions_, world.interactions()) &&
        same(inputs_, world.inputs()))
        return;
    // Half of a step's force acts on the path before the step, half on the path after it. A removed
    // body has no path after it.
    for (const BodyId id : moving_) {
        if (world.alive(id)) continue;
        const std::size_t b = array_index(id.index);
        const Displacement way = displacement_between(pose_[b], arrived_[b]);
        work_ += 0.5 * (force_[b].dot(way.moved_by) + torque_[b].dot(way.turned_by));
    }
    const std::vector<BodyId> bodies = bodies_;
    const std::vector<InteractionId> interactions = interactions_;
    update_tables(world);
    const double h = world.settings().step;
    for (const BodyId id : bodies_) {
        if (std::binary_search(bodies.begin(), bodies.end(), id)) continue;
        // Treat a new body as if it had moved at its velocity without force.
        const std::size_t b = array_index(id.index);
        force_[b].setZero();
        torque_[b].setZero();
        pose_[b] = arrived_[b] = world.pose(id);
        const Twist twist = world.velocity(id);
        pose_[b].position -= h * twist.linear;
        if (const double turn = h * twist.angular.norm(); turn > 0.0)
            pose_[b].orientation =
                Quat(Eigen::AngleAxisd(-turn, twist.angular.normalized())) * pose_[b].orientation;
    }
    allow_initial_gaps(world, interactions);
    loss_ends_ = true;
}

void StateVerifier::add_sources(const World& world) {
    force_before_ = force_;
    torque_before_ = torque_;
    for (const BodyId id : moving_) {
        force_[array_index(id.index)] = world.body_def(id).force;
        torque_[array_index(id.index)] = world.body_def(id).torque;
    }
    for (const InputId id : inputs_) {
        const InputDef& input = world.input_def(id);
        if (!input.body.valid()) continue;
        const std::size_t b = array_index(input.body.index);
        const Vec3 axis = Vec3::Unit(input.component % 3);
        (input.component < 3 ? force_ : torque_)[b] +=
            world.input(id) * (input.local ? Vec3(pose_[b].orientation * axis) : axis);
    }
    for (const InteractionId id : interactions_) {
        if (role_[array_index(id.index)] != Role::source) continue;
        const InteractionDef& def = world.interaction_def(id);
        const Wrenches w = row_wrenches(world, id, pose_, world.force(id));
        for (int k = 0; k < kind_info(def.kind).bodies; ++k) {
            force_[array_index(def.body[array_index(k)].index)] += w.on[array_index(k)].force;
            torque_[array_index(def.body[array_index(k)].index)] += w.on[array_index(k)].torque;
        }
    }
    for (const LoadImpulse& load : load_impulses(world, pose_, twist_)) {
        force_[array_index(load.body.index)] += load.linear / world.settings().step;
        torque_[array_index(load.body.index)] += load.angular / world.settings().step;
    }
    for (const ContactView& c : world.contacts())
        for (int k = 0; k < 2; ++k) {
            const double sign = k == 0 ? -1.0 : 1.0;
            const double to_axis = 0.5 * c.gap + world.shape_def(c.shape[k]).radius;
            const ContactSide side = contact_side(
                world, c.shape[k], c.point + sign * to_axis * c.normal, c.point, pose_);
            for (int i = 0; i < side.count; ++i) {
                const Vec3 force = sign * side.fraction[i] * c.force;
                force_[array_index(side.body[i].index)] += force;
                torque_[array_index(side.body[i].index)] += side.arm[i].cross(force);
            }
            torque_[array_index(side.body[0].index)] += sign * c.moment;
        }
}

void StateVerifier::add_springs_and_drag(const World& world) {
    other_force_before_ = other_force_;
    other_torque_before_ = other_torque_;
    for (const BodyId id : moving_) {
        const std::size_t b = array_index(id.index);
        const BodyDef& def = world.body_def(id);
        const Twist v = world.velocity(id);
        const Quat& turned_by = pose_[b].orientation;
        const auto along_axes = [&](const Vec3& c, const Vec3& a, const Vec3& z) -> Vec3 {
            return turned_by * Vec3(-c.cwiseProduct(turned_by.conjugate() * Vec3(0.5 * (a + z))));
        };
        const double h = world.settings().step;
        other_force_[b] =
            along_axes(def.linear_damping, twist_[b].linear, v.linear) + impulse_[b] / h;
        other_torque_[b] =
            along_axes(def.angular_damping, twist_[b].angular, v.angular) + turn_impulse_[b] / h;
    }
    for (const InteractionId id : interactions_) {
        if (role_[array_index(id.index)] != Role::spring) continue;
        const InteractionDef& def = world.interaction_def(id);
        const Wrenches w = row_wrenches(world, id, pose_, world.force(id));
        for (int k = 0; k < kind_info(def.kind).bodies; ++k) {
            const std::size_t b = array_index(def.body[array_index(k)].index);
            other_force_[b] += w.on[array_index(k)].force;
            other_torque_[b] += w.on[array_index(k)].torque;
            if (is_elastic_line(def.kind))
                line_work_ += std::abs(
                    w.on[array_index(k)].force.dot(arrived_[b].position - pose_[b].position));
        }
    }
}

/// Check for a loss of kinetic and gravity energy that no work of a force explains.
std::string StateVerifier::check_loss(const World& world, double kinetic_now) {
    const double h = world.settings().step, forgotten = std::min(1.0, h / limit::kMemory);
    if (loss_ends_) return {};
    line_work_ -= forgotten * line_work_;
    add_springs_and_drag(world);
    if (steps_ > 0)
        for (const BodyId id : moving_) {
            const std::size_t b = array_index(id.index);
            const Displacement way = displacement_between(pose_before_[b], arrived_[b]);
            other_work_ += 0.5 * (other_force_[b] + other_force_before_[b]).dot(way.moved_by);
            if (world.body_def(id).kind == BodyKind::rigid)
                other_work_ +=
                    0.5 * (other_torque_[b] + other_torque_before_[b]).dot(way.turned_by);
        }
    const double energy = 0.5 * (kinetic_ + kinetic_now) + gravity_;
    double left = energy - work_ - other_work_;
    // An impact removes energy that no force of the step explains: half of it in this step, half in
    // the next one.
    const bool impact = world.stats().impacts != impacts_;
    if ((impact || impact_before_) && steps_ > 0) {
        other_work_ += left - mean_moving_;
        left = mean_moving_;
    }
    impact_before_ = impact;
    moved_ +=
        (steps_ > 0 ? 0.5 * (std::abs(energy - moving_energy_) + std::abs(kinetic_now - kinetic_))
                    : 0.0) -
        forgotten * moved_;
    moving_energy_ = energy;
    const double fraction = 1.0 - std::exp(-h / limit::kMean);
    // Joints that the scene or an edit opened dissipate energy until they are closed.
    constexpr double kMaxClosedGap = 0.01;
    if (steps_ == 0 || gap_allowance_ > kMaxClosedGap) {
        mean_moving_ = most_ = left;
    } else {
        mean_moving_ += fraction * (left - mean_moving_);
        most_ = std::max(mean_moving_, most_ + forgotten * (mean_moving_ - most_));
    }
    // Scale of the loss: the present kinetic energy, or a part of the exchanged energy, whose work
    // has its own errors. The tension of a stiff line changes within a step, so its work is known
    // to some per cent only.
    constexpr double kOfExchanged = 0.5, kOfLineWork = 0.05;
    peak_ = std::max(kinetic_now, (1.0 - forgotten) * peak_);
    const double fall = most_ - mean_moving_,
                 scale = std::max({peak_, kOfExchanged * moved_, kOfLineWork * line_work_});
    if (fall <= limit::kNothing * (kinetic_now + std::abs(gravity_))) return {};
    result_.lost = std::max(result_.lost, fall / scale / limit::kLost.wrong);
    if (fall <= limit::kLost.wrong * scale) return {};
    return fmt::format(
        "the whole world lost {} of mechanical energy that no force took, of {} in motion; use a "
        "smaller step (settings.step)",
        record::with_unit(fall, "J"), record::with_unit(scale, "J"));
}

/// Check the elastic energy that edits of wires add by changing lengths, divided by the exchanged
/// energy. The monitors have no such account, and rows may absorb the stretch in the next steps.
/// Runs with the grade `good` are therefore not rejected, but the figure is reported.
std::string StateVerifier::check_edits(const World& world) {
    const double forgotten = std::min(1.0, world.settings().step / limit::kMemory);
    exchanged_ += std::abs(kinetic(world) - kinetic_) - forgotten * exchanged_;
    edited_ += edited_stretch_.elastic_change(world, pose_);
    min_edited_ = std::min(edited_, min_edited_ + forgotten * (edited_ - min_edited_));
    const double rise = edited_ - min_edited_, scale = kinetic_ + exchanged_;
    if (rise <= limit::kNothing * (kinetic_ + std::abs(potential_))) return {};
    result_.edited = std::max(result_.edited, rise / scale / limit::kHeld.wrong);
    if (rise <= limit::kHeld.wrong * scale || world.verdict().grade == Grade::good) return {};
    return fmt::format(
        "edits of wires added {} of stretch, where {} were exchanged; use a smaller step "
        "(settings.step)",
        record::with_unit(rise, "J"), record::with_unit(scale, "J"));
}

std::string StateVerifier::check_energy(const World& world) {
    const double now = kinetic(world), energy = 0.5 * (kinetic_ + now) + potential_;
    const double h = world.settings().step;
    add_sources(world);
    if (steps_ > 0) {
        for (const BodyId id : moving_) {
            const std::size_t b = array_index(id.index);
            const Displacement way = displacement_between(pose_before_[b], arrived_[b]);
            work_ += 0.5 * (force_[b] + force_before_[b]).dot(way.moved_by);
            if (world.body_def(id).kind == BodyKind::rigid)
                work_ += 0.5 * (torque_[b] + torque_before_[b]).dot(way.turned_by);
        }
    }
    const double left = energy - work_, forgotten = std::min(1.0, h / limit::kMemory);
    exchanged_ +=
        (steps_ > 0 ? 0.5 * (std::abs(energy - energy_) + std::abs(now - kinetic_)) : 0.0) -
        forgotten * exchanged_;
    // The mean of the kinetic energies before and after the start is higher than the energy at the
    // start.
    mean_ = steps_ == 0 ? left : mean_ + (1.0 - std::exp(-h / limit::kMean)) * (left - mean_);
    least_ = steps_ == 0 || gap_allowance_ > 1.0
                 ? mean_
                 : std::min(mean_, least_ + forgotten * (mean_ - least_));
    energy_ = energy;
    std::string lost = check_loss(world, now);
    kinetic_ = now;
    const double rise = mean_ - least_, scale = now + exchanged_;
    if (rise <= limit::kNothing * (now + std::abs(potential_))) return lost;
    result_.created = std::max(result_.created, rise / scale / limit::kHeld.wrong);
    if (rise <= limit::kHeld.wrong * scale) return lost;
    return fmt::format(
        "the whole world gained {} of mechanical energy without a cause, where {} were exchanged; "
        "use a smaller step (settings.step)",
        record::with_unit(rise, "J"), record::with_unit(scale, "J"));
}

}  // namespace hawser::verify
