// SPDX-License-Identifier: Apache-2.0
#include "verify/certificate_state.h"

#include "record/scene_info.h"
#include "record/units.h"
#include "verify/interaction_forces.h"
#include "verify/joint_gap.h"
#include "verify/load_impulses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

std::size_t number(std::int32_t i) { return static_cast<std::size_t>(i); }

bool is_elastic_line(InteractionKind kind) {
    return kind == InteractionKind::Stretch || kind == InteractionKind::WinchStretch;
}

// ½ g²/ε of the rows at the poses at hand; a line that only pulls holds nothing where it is short.
double energy_of_spring(const World& world, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    if (!world.intact(id)) return 0.0;
    const auto g = world.violation(id);
    double sum = 0.0;
    for (std::size_t r = 0; r < number(kind_info(def.kind).rows); ++r) {
        if (is_elastic_line(def.kind) && g[r] < 0.0 && def.get("tension_only") != 0.0) continue;
        const double compliance = is_elastic_line(def.kind)
                                      ? parameter(world, id, "length") / def.get("EA")
                                      : def.compliance[r];
        sum += 0.5 * g[r] * g[r] / compliance;
    }
    return sum;
}

}  // namespace

StateVerifier::StateVerifier(const World& world) {
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        const BodyKind kind = world.body_def({b}).kind;
        if (kind != BodyKind::fixed && kind != BodyKind::kinematic) moving_.push_back({b});
    }
    driven_.resize(number(world.interaction_count()));
    for (std::int32_t i = 0; i < world.input_count(); ++i)
        if (const InteractionId of = world.input_def({i}).interaction; of.valid())
            driven_[number(of.index)] = true;
    for (std::int32_t i = 0; i < world.interaction_count(); ++i)
        role_.push_back(role_of(world, {i}));
    const std::size_t bodies = number(world.body_count());
    pose_.resize(bodies);
    twist_.resize(bodies);
    for (std::vector<Vec3>* v : {&force_, &torque_, &force_before_, &torque_before_})
        v->assign(bodies, Vec3::Zero());
}

StateVerifier::Role StateVerifier::role_of(const World& world, InteractionId id) const {
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
    return sum;
}

double StateVerifier::potential(const World& world) const {
    double sum = 0.0;
    for (const BodyId id : moving_) {
        const BodyDef& def = world.body_def(id);
        if (def.gravity && def.kind != BodyKind::scalar)
            sum -= def.mass * world.settings().gravity.dot(world.pose(id).position);
    }
    for (std::int32_t i = 0; i < world.interaction_count(); ++i)
        if (role_[number(i)] == Role::spring) sum += energy_of_spring(world, {i});
    return sum;
}

void StateVerifier::before_step(const World& world) {
    pose_before_ = pose_;
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        pose_[number(b)] = world.pose({b});
        twist_[number(b)] = world.velocity({b});
    }
    potential_ = potential(world);
    if (steps_ == 0) kinetic_ = kinetic(world);
}

void StateVerifier::add_sources(const World& world) {
    force_before_ = force_;
    torque_before_ = torque_;
    for (const BodyId id : moving_) {
        force_[number(id.index)] = world.body_def(id).force;
        torque_[number(id.index)] = world.body_def(id).torque;
    }
    for (std::int32_t i = 0; i < world.input_count(); ++i) {
        const InputDef& input = world.input_def({i});
        if (!input.body.valid() || input.local) continue;
        const std::size_t b = number(input.body.index);
        (input.component < 3 ? force_[b][input.component] : torque_[b][input.component - 3]) =
            world.input({i});
    }
    for (std::int32_t i = 0; i < world.input_count(); ++i) {
        const InputDef& input = world.input_def({i});
        if (!input.local) continue;
        const std::size_t b = number(input.body.index);
        (input.component < 3 ? force_ : torque_)[b] +=
            pose_[b].orientation * (world.input({i}) * Vec3::Unit(input.component % 3));
    }
    for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
        if (role_[number(i)] != Role::source) continue;
        const InteractionDef& def = world.interaction_def({i});
        const Wrenches w = row_wrenches(world, {i}, pose_, world.force({i}));
        for (int k = 0; k < kind_info(def.kind).bodies; ++k) {
            force_[number(def.body[number(k)].index)] += w.on[number(k)].force;
            torque_[number(def.body[number(k)].index)] += w.on[number(k)].torque;
        }
    }
    for (const LoadImpulse& load : load_impulses(world, pose_, twist_)) {
        force_[number(load.body.index)] += load.linear / world.settings().step;
        torque_[number(load.body.index)] += load.angular / world.settings().step;
    }
    for (const ContactView& c : world.contacts())
        for (int k = 0; k < 2; ++k) {
            const ShapeDef& shape = world.shape_def(c.shape[k]);
            const double sign = k == 0 ? -1.0 : 1.0;
            // A segment hangs between two lumps: by how near each is.
            const std::size_t a = number(shape.body.index);
            double other = 0.0;
            if (shape.body_b.valid()) {
                const std::size_t b = number(shape.body_b.index);
                const Vec3 along = pose_[b].position - pose_[a].position;
                other = std::clamp((c.point - pose_[a].position).dot(along) / along.squaredNorm(),
                                   0.0, 1.0);
                force_[b] += sign * other * c.force;
            }
            force_[a] += sign * (1.0 - other) * c.force;
            torque_[a] += sign * ((c.point - pose_[a].position).cross(c.force) + c.moment);
        }
}

std::string StateVerifier::check_energy(const World& world) {
    const double now = kinetic(world), energy = 0.5 * (kinetic_ + now) + potential_;
    const double h = world.settings().step;
    add_sources(world);
    if (steps_ > 0) {
        for (const BodyId id : moving_) {
            const std::size_t b = number(id.index);
            const Vec3 moved = pose_[b].position - pose_before_[b].position;
            const Eigen::AngleAxisd turn(pose_[b].orientation *
                                         pose_before_[b].orientation.conjugate());
            work_ += 0.5 * (force_[b] + force_before_[b]).dot(moved);
            if (world.body_def(id).kind == BodyKind::rigid)
                work_ += 0.5 * (torque_[b] + torque_before_[b]).dot(turn.angle() * turn.axis());
        }
    }
    const double left = energy - work_, forgotten = std::min(1.0, h / limit::kMemory);
    exchanged_ +=
        (steps_ > 0 ? 0.5 * (std::abs(energy - energy_) + std::abs(now - kinetic_)) : 0.0) -
        forgotten * exchanged_;
    // The mean of the kinetic energies before and after the start is higher than that at it.
    mean_ = steps_ == 0 ? left : mean_ + (1.0 - std::exp(-h / limit::kMean)) * (left - mean_);
    least_ = steps_ == 0 || excused_ > 1.0 ? mean_
                                           : std::min(mean_, least_ + forgotten * (mean_ - least_));
    energy_ = energy;
    kinetic_ = now;
    const double rise = mean_ - least_, scale = now + exchanged_;
    if (rise <= limit::kNothing * (now + std::abs(potential_))) return {};
    result_.created = std::max(result_.created, rise / scale / limit::kCreated.wrong);
    if (rise <= limit::kCreated.wrong * scale) return {};
    return fmt::format("{} of mechanical energy came out of nothing, where {} were exchanged",
                       record::with_unit(rise, "J"), record::with_unit(scale, "J"));
}

std::string StateVerifier::check_joints(const World& world) {
    const double h = world.settings().step;
    std::vector<Pose> now;
    now.reserve(pose_.size());
    for (std::int32_t b = 0; b < world.body_count(); ++b) now.push_back(world.pose({b}));
    double worst = 0.0;
    JointGap gap_of_worst;
    InteractionId where{};
    const auto look = [&](const std::vector<Pose>& pose) {
        worst = 0.0;
        for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
            if (role_[number(i)] != Role::joint) continue;
            const JointGap gap = joint_gap(world, {i}, pose);
            if (!gap.rigid) continue;
            const double size = joint_size(world, {i});
            const double open = std::max(gap.apart, 0.5 * size * gap.turned) /
                                (limit::kOpen.wrong * std::max(1.0, size));
            if (open <= worst) continue;
            worst = open;
            where = {i};
            gap_of_worst = gap;
        }
    };
    if (steps_ == 0) {
        look(pose_);
        excused_ = worst * limit::kOpen.wrong / limit::kOpen.doubtful;
    }
    look(now);
    excused_ *= std::exp(-1.0 / limit::kSettled);
    worst = std::max(0.0, worst - excused_ * limit::kOpen.doubtful / limit::kOpen.wrong);
    result_.open = std::max(result_.open, worst);
    if (worst <= 1.0) return {};
    return fmt::format("joint '{}' stands open by {} and {:.3g} rad (step of {:.4g} s)",
                       record::interaction_label(world, where),
                       record::with_unit(gap_of_worst.apart, "m"), gap_of_worst.turned, h);
}

std::string StateVerifier::check_lines(const World& world) {
    for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
        const InteractionDef& def = world.interaction_def({i});
        if (def.kind != InteractionKind::Stretch || !world.intact({i})) continue;
        const double tension = -world.force({i})[0];
        if (!(tension > 0.0)) continue;
        const Attached at(world, {i}, pose_);
        const double rest = parameter(world, {i}, "length");
        const double length = (at.point(1) - at.point(0)).norm();
        const double off = std::abs(length - rest * (1.0 + tension / def.get("EA"))) / rest;
        result_.cable = std::max(result_.cable, off / limit::kCable.wrong);
        if (off > limit::kCable.wrong)
            return fmt::format("element '{}' is {} long, by its tension {}",
                               record::interaction_label(world, {i}),
                               record::with_unit(length, "m"),
                               record::with_unit(rest * (1.0 + tension / def.get("EA")), "m"));
    }
    return {};
}

std::string StateVerifier::check_turns(const World& world) {
    for (const BodyId id : moving_) {
        if (world.body_def(id).kind != BodyKind::rigid) continue;
        const double turn = world.settings().step * world.velocity(id).angular.norm();
        result_.turn = std::max(result_.turn, turn / limit::kTurn.wrong);
        if (!(turn <= limit::kTurn.wrong))
            return fmt::format("body '{}' turned by {:.3g} rad in the step",
                               record::body_label(world, id), turn);
    }
    return {};
}

std::string StateVerifier::after_step(const World& world) {
    std::string wrong = check_joints(world);
    std::string other = check_energy(world);
    if (wrong.empty()) wrong = std::move(other);
    if (wrong.empty()) wrong = check_lines(world);
    if (wrong.empty()) wrong = check_turns(world);
    ++steps_;
    return wrong;
}

}  // namespace hawser::verify
