// SPDX-License-Identifier: Apache-2.0
#include "verify/certificate_state.h"

#include "record/scene_info.h"
#include "record/units.h"
#include "verify/interaction_forces.h"
#include "verify/joint_gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

std::size_t number(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Opening of a rigid joint relative to the limit of failure.
struct Opening {
    JointGap gap;
    double part = 0.0;
};
Opening joint_opening(const World& world, InteractionId id, const std::vector<Pose>& pose) {
    Opening out{joint_gap(world, id, pose)};
    if (!out.gap.rigid) return out;
    const double size = joint_size(world, id);
    out.part = std::max(out.gap.separation, 0.5 * size * out.gap.turned) /
               (limit::kOpen.wrong * std::max(1.0, size));
    return out;
}

}  // namespace

StateVerifier::StateVerifier(const World& world) { update_tables(world); }

void StateVerifier::update_tables(const World& world) {
    bodies_.assign(world.bodies().begin(), world.bodies().end());
    interactions_.assign(world.interactions().begin(), world.interactions().end());
    moving_.clear();
    for (const BodyId id : bodies_) {
        const BodyKind kind = world.body_def(id).kind;
        if (kind != BodyKind::fixed && kind != BodyKind::kinematic) moving_.push_back(id);
    }
    driven_.assign(number(world.interaction_count()), false);
    inputs_.assign(world.inputs().begin(), world.inputs().end());
    for (const InputId id : inputs_)
        if (const InteractionId of = world.input_def(id).interaction; of.valid())
            driven_[number(of.index)] = true;
    role_.assign(number(world.interaction_count()), Role::source);
    for (const InteractionId id : interactions_) role_[number(id.index)] = energy_role(world, id);
    const std::size_t bodies = number(world.body_count());
    for (std::vector<Pose>* v : {&pose_, &pose_before_, &arrived_}) v->resize(bodies);
    twist_.resize(bodies);
    for (std::vector<Vec3>* v :
         {&force_, &torque_, &force_before_, &torque_before_, &other_force_, &other_torque_,
          &other_force_before_, &other_torque_before_, &impulse_, &turn_impulse_})
        v->resize(bodies, Vec3::Zero());
}

void StateVerifier::add_stiffness(InteractionId id, BodyId body, const Wrench& impulse) {
    if (role_[number(id.index)] != Role::joint) add_impulse(body, impulse);
}

void StateVerifier::add_impulse(BodyId body, const Wrench& impulse) {
    impulse_[number(body.index)] += impulse.force;
    turn_impulse_[number(body.index)] += impulse.torque;
}

StateVerifier::Role StateVerifier::energy_role(const World& world, InteractionId id) const {
    using enum InteractionKind;
    const InteractionDef& def = world.interaction_def(id);
    for (int b = 0; b < kind_info(def.kind).bodies; ++b)
        if (world.body_def(def.body[number(b)]).kind == BodyKind::kinematic) return Role::source;
    if (driven_[number(id.index)] || def.kind == WinchStretch) return Role::source;
    if (is_elastic_line(def.kind)) return Role::spring;
    const auto rows = number(kind_info(def.kind).rows);
    constexpr double kRigid = 1e-11;  // [m/N]; an elastic row is softer
    const auto soft = [](double compliance) { return compliance > kRigid; };
    const bool elastic = std::all_of(def.compliance.begin(), def.compliance.begin() + rows, soft);
    const bool rigid = std::none_of(def.compliance.begin(), def.compliance.begin() + rows, soft);
    switch (def.kind) {
        case Ball:
        case Hinge:
        case Prismatic:
        case Cylindrical:
        case Universal:
        case Lock:
        case Distance:
            return elastic ? Role::spring : rigid ? Role::joint : Role::source;
        case Bend:
        case Twist:
        case Hydrostatic:
            return elastic ? Role::spring : Role::source;
        default:
            return Role::source;
    }
}

void StateVerifier::before_step(const World& world) {
    if (steps_ > 0)
        count_edit_energy(world);
    else
        update_tables(world);  // edits before the first step do not change a state
    pose_before_ = pose_;
    for (const BodyId id : world.bodies()) {
        pose_[number(id.index)] = world.pose(id);
        twist_[number(id.index)] = world.velocity(id);
    }
    for (std::vector<Vec3>* v : {&impulse_, &turn_impulse_})
        std::fill(v->begin(), v->end(), Vec3::Zero());
    gravity_ = gravity(world);
    potential_ = gravity_ + elastic(world);
    const double kinetic_now = kinetic(world);
    if (steps_ > 0) {
        const double energy_rise = (kinetic_now - kinetic_) + (potential_ - potential_after_);
        work_ += energy_rise;
        energy_ += energy_rise;
        const double moving = (kinetic_now - kinetic_) + (gravity_ - gravity_after_);
        other_work_ += moving - energy_rise;
        moving_energy_ += moving;
    }
    impacts_ = world.stats().impacts;
    kinetic_ = kinetic_now;
    edited_stretch_.before_step(world);
}

/// Add the initial opening of new joints to their allowance, as at the start of a run.
void StateVerifier::allow_initial_gaps(const World& world,
                                       const std::vector<InteractionId>& known) {
    std::vector<Pose> now = pose_;
    for (const BodyId id : bodies_) now[number(id.index)] = world.pose(id);
    for (const InteractionId id : interactions_)
        if (!std::binary_search(known.begin(), known.end(), id))
            gap_allowance_ =
                std::max(gap_allowance_, joint_opening(world, id, now).part * limit::kOpen.wrong /
                                             limit::kOpen.doubtful);
}

std::string StateVerifier::restart(const World& world) {
    update_tables(world);
    std::string fault = check_edits(world);
    for (std::vector<Vec3>* v : {&force_, &torque_, &other_force_, &other_torque_})
        std::fill(v->begin(), v->end(), Vec3::Zero());
    previous_deviations_ = {};
    steps_ = 0;
    return fault;
}

std::string StateVerifier::check_joints(const World& world) {
    double worst = 0.0;
    JointGap gap_of_worst;
    InteractionId where{};
    const auto sample = [&](const std::vector<Pose>& pose) {
        worst = 0.0;
        for (const InteractionId id : interactions_) {
            if (role_[number(id.index)] != Role::joint) continue;
            const Opening open = joint_opening(world, id, pose);
            if (open.part <= worst) continue;
            worst = open.part;
            where = id;
            gap_of_worst = open.gap;
        }
    };
    if (steps_ == 0) {
        sample(pose_);
        gap_allowance_ = worst * limit::kOpen.wrong / limit::kOpen.doubtful;
    }
    sample(now_);
    gap_allowance_ *= std::exp(-1.0 / limit::kSettled);
    worst = std::max(0.0, worst - gap_allowance_ * limit::kOpen.doubtful / limit::kOpen.wrong);
    result_.open = std::max(result_.open, worst);
    if (worst <= 1.0) return {};
    return fmt::format("joint '{}'{} stands open by {} and {:.3g} rad (step of {:.4g} s)",
                       record::interaction_label(world, where),
                       record::origin(world, record::interaction_label(world, where)),
                       record::with_unit(gap_of_worst.separation, "m"), gap_of_worst.turned,
                       world.settings().step);
}

/// Return the deviation of a taut element from its law, relative to its length. The change of
/// length in the step and the contribution of the damper at this speed are subtracted. If the
/// element was slack at the start of the step, its rest length is used instead of its length.
double StateVerifier::law_deviation(const World& world, InteractionId id) const {
    const InteractionDef& def = world.interaction_def(id);
    const double tension = -world.force(id)[0];
    if (!(tension > 0.0)) return 0.0;
    const Attached at(world, id, pose_), then(world, id, now_);
    const double rest = parameter(world, id, "length"), h = world.settings().step;
    const double length = (at.point(1) - at.point(0)).norm(),
                 way = std::abs((then.point(1) - then.point(0)).norm() - length);
    const double late = std::isfinite(def.damping_time[0]) ? def.damping_time[0] / h : 0.0;
    const double off = std::abs(std::max(length, rest) - rest * (1.0 + tension / def.get("EA")));
    return std::max(0.0, off - (1.0 + late) * way) / rest;
}

/// Check the elements of lines against their law. Deviations of an element that becomes taut are
/// short; those of a vibrating element occur in every step.
std::string StateVerifier::check_lines(const World& world) {
    double worst = 0.0;
    InteractionId where{};
    for (const InteractionId id : interactions_) {
        if (world.interaction_def(id).kind != InteractionKind::Stretch || !world.intact(id))
            continue;
        const double off = law_deviation(world, id);
        if (off <= worst) continue;
        worst = off;
        where = id;
    }
    const double lasting_deviation =
        std::min({worst, previous_deviations_[0], previous_deviations_[1]});
    previous_deviations_ = {worst, previous_deviations_[0]};
    result_.cable = std::max(result_.cable, lasting_deviation / limit::kCable.wrong);
    if (lasting_deviation <= limit::kCable.wrong) return {};
    const Attached at(world, where, pose_);
    const double rest = parameter(world, where, "length"), tension = -world.force(where)[0];
    return fmt::format(
        "element '{}' is {} long, by its tension {}", record::interaction_label(world, where),
        record::with_unit((at.point(1) - at.point(0)).norm(), "m"),
        record::with_unit(rest * (1.0 + tension / world.interaction_def(where).get("EA")), "m"));
}

std::string StateVerifier::check_turns(const World& world) {
    for (const BodyId id : moving_) {
        if (world.body_def(id).kind != BodyKind::rigid) continue;
        const double turn = world.settings().step * world.velocity(id).angular.norm();
        result_.turn = std::max(result_.turn, turn / limit::kTurn.wrong);
        if (!(turn <= limit::kTurn.wrong))
            return fmt::format("body '{}'{} turned by {:.3g} rad in the step",
                               record::body_label(world, id),
                               record::origin(world, record::body_label(world, id)), turn);
    }
    return {};
}

std::string StateVerifier::after_step(const World& world) {
    now_.resize(pose_.size());
    for (const BodyId id : bodies_) now_[number(id.index)] = world.pose(id);
    std::string fault = check_joints(world);
    std::string other = check_energy(world);
    if (fault.empty()) fault = std::move(other);
    if (fault.empty()) fault = check_lines(world);
    if (fault.empty()) fault = check_turns(world);
    other = lasting_faults_.after_step(world, now_);
    if (fault.empty()) fault = std::move(other);
    arrived_ = now_;
    gravity_after_ = gravity(world);
    potential_after_ = gravity_after_ + elastic(world);
    ++steps_;
    return fault;
}

}  // namespace hawser::verify
