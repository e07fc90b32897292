// SPDX-License-Identifier: Apache-2.0
#include "random_judge.h"

#include "index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::bench {
namespace {

constexpr double kMinViolation = 0.01;       ///< allowed for any size [m]
constexpr double kViolationFraction = 0.01;  ///< allowed fraction of the size of the smaller body

bool is_joint(InteractionKind kind) {
    using enum InteractionKind;
    return kind == Ball || kind == Hinge || kind == Prismatic || kind == Cylindrical ||
           kind == Universal || kind == Lock;
}

Vec3 point_of(const InteractionDef& d, const std::vector<Pose>& poses, std::size_t slot) {
    const Pose& p = poses[at(d.body[slot].index)];
    return p.position + p.orientation * d.point[slot];
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Violation of a joint.
struct Gap {
    double along = 0.0;   ///< [m].
    double turned = 0.0;  ///< [rad].
};

Gap joint_gap(const InteractionDef& d, const std::vector<Pose>& poses) {
    using enum InteractionKind;
    const Vec3 separation = point_of(d, poses, 1) - point_of(d, poses, 0);
    if (d.kind == Distance) return {std::abs(separation.norm() - d.get("length")), 0.0};
    const Quat p = poses[at(d.body[0].index)].orientation * d.frame[0];
    const Quat q = poses[at(d.body[1].index)].orientation * d.frame[1];
    const Vec3 pz = p * Vec3::UnitZ(), qz = q * Vec3::UnitZ();
    Gap gap{separation.norm(), 0.0};
    if (d.kind == Prismatic || d.kind == Cylindrical)
        gap.along = (separation - separation.dot(pz) * pz).norm();
    if (d.kind == Hinge || d.kind == Cylindrical) gap.turned = angle_between(pz, qz);
    if (d.kind == Prismatic || d.kind == Lock) gap.turned = p.angularDistance(q);
    if (d.kind == Universal) gap.turned = std::abs(std::asin(std::clamp(pz.dot(qz), -1.0, 1.0)));
    return gap;
}

std::vector<Pose> all_poses(const World& world) {
    std::vector<Pose> poses;
    for (std::int32_t i = 0; i < world.body_count(); ++i) poses.push_back(world.pose(BodyId{i}));
    return poses;
}

}  // namespace

double RandomMonitor::Swing::rise(double energy) {
    least = begun ? std::min(least, energy) : energy;
    begun = true;
    now = energy;
    return now - least;
}

RandomMonitor::RandomMonitor(const World& world) : before_(all_poses(world)) {
    double weight = 0.0;
    for (std::int32_t i = 0; i < world.body_count(); ++i) {
        const BodyDef& d = world.body_def(BodyId{i});
        if (d.kind != BodyKind::rigid && d.kind != BodyKind::lump) continue;
        moving_.push_back(BodyId{i});
        if (d.gravity) weight += d.mass * world.settings().gravity.norm();
    }
    floor_ = kMinViolation * weight;
    auto size_of = [&](BodyId id) {
        const BodyDef& d = world.body_def(id);
        const double size = 2.0 * d.half_size.maxCoeff();
        return size > 0.0 ? size : std::numeric_limits<double>::infinity();
    };
    for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
        const InteractionDef& d = world.interaction_def(InteractionId{i});
        const bool line = d.kind == InteractionKind::Stretch;
        const double compliance = line ? d.get("length") / d.get("EA") : d.compliance[0];
        // A larger compliance is a spring; others are meant to be rigid.
        constexpr double kRigid = 1e-10;
        const bool rod = d.kind == InteractionKind::Distance;
        // Any compliance stores energy, also that of a rod that is meant to be rigid.
        if (line || (rod && compliance > 0.0))
            springs_.push_back({InteractionId{i}, d.get("length"), compliance,
                                line && d.get("tension_only") != 0.0});
        if (is_joint(d.kind) || (rod && compliance <= kRigid)) {
            const double size = std::min(size_of(d.body[0]), size_of(d.body[1]));
            joints_.push_back(InteractionId{i});
            size_.push_back(std::isfinite(size) ? size : 0.0);
            allowed_.push_back(std::max(kMinViolation, kViolationFraction * size_.back()));
        }
    }
    start(world);
}

void RandomMonitor::start(const World& world) {
    kinetic_ = kinetic(world);
    gravity_ = gravity(world, before_);
    elastic_ = elastic(world, before_);
    const double energy = kinetic_ + gravity_ + elastic_;
    (void)at_midpoint_.rise(energy);
    (void)by_force_.rise(energy);
    // The mean of the kinetic energies half a step before and after exceeds that between them if
    // bodies fall: by m (g h)²/8.
    double fall = 0.0;
    const double gained = world.settings().gravity.norm() * world.settings().step;
    for (const BodyId id : moving_) fall += world.body_def(id).mass * gained * gained / 8.0;
    (void)at_poses_.rise(energy + fall);
}

double RandomMonitor::gravity(const World& world, const std::vector<Pose>& poses) const {
    double sum = 0.0;
    for (const BodyId id : moving_) {
        const BodyDef& d = world.body_def(id);
        if (d.gravity) sum -= d.mass * world.settings().gravity.dot(poses[at(id.index)].position);
    }
    return sum;
}

double RandomMonitor::elastic(const World& world, const std::vector<Pose>& poses) const {
    double sum = 0.0;
    for (const Spring& s : springs_) {
        const InteractionDef& d = world.interaction_def(s.id);
        const double g = (point_of(d, poses, 1) - point_of(d, poses, 0)).norm() - s.length;
        if (g > 0.0 || !s.one_sided) sum += 0.5 * g * g / s.compliance;
    }
    return sum;
}

double RandomMonitor::elastic_by_force(const World& world) const {
    double sum = 0.0;
    for (const Spring& s : springs_) {
        const double force = world.force(s.id)[0];
        sum += 0.5 * force * force * s.compliance;
    }
    return sum;
}

double RandomMonitor::kinetic(const World& world) const {
    double sum = 0.0;
    for (const BodyId id : moving_) {
        const BodyDef& d = world.body_def(id);
        const Twist v = world.velocity(id);
        const Vec3 w = world.pose(id).orientation.conjugate() * v.angular;
        sum += 0.5 * d.mass * v.linear.squaredNorm();
        if (d.kind == BodyKind::rigid) sum += 0.5 * w.dot(d.inertia * w);
    }
    return sum;
}

void RandomMonitor::check_joints(const World& world) {
    const std::vector<Pose> poses = all_poses(world);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Gap gap = joint_gap(world.interaction_def(joints_[i]), poses);
        const double violation = std::max(gap.along, 0.5 * size_[i] * gap.turned);
        if (!std::isfinite(violation)) out_.finite = false;
        out_.violation = std::max(out_.violation, violation);
        if (violation / allowed_[i] <= out_.violation_fraction) continue;
        out_.violation_fraction = violation / allowed_[i];
        out_.violation_at = world.time();
        out_.worst = joints_[i];
    }
}

void RandomMonitor::check_energy(const World& world) {
    const std::vector<Pose> poses = all_poses(world);
    std::vector<Pose> half = poses;
    for (std::size_t i = 0; i < poses.size(); ++i)
        half[i] = {0.5 * (poses[i].position + before_[i].position),
                   before_[i].orientation.slerp(0.5, poses[i].orientation)};
    // With the velocity midway between the poses.
    const double moved = kinetic(world);
    const double height = gravity(world, half), spring = elastic(world, half);
    out_.exchanged += 0.5 * (std::abs(moved - kinetic_) + std::abs(height - gravity_) +
                             std::abs(spring - elastic_));
    double rise = std::min(at_midpoint_.rise(moved + height + spring),
                           by_force_.rise(moved + height + elastic_by_force(world)));
    // At the pose before, between the velocity before and this one; there is none before the first
    // step.
    const double at_pose = begun_
                               ? at_poses_.rise(0.5 * (moved + kinetic_) + gravity(world, before_) +
                                                elastic(world, before_))
                               : rise;
    rise = std::min(rise, at_pose);
    if (!std::isfinite(moved + height + spring)) out_.finite = false;
    const double stays = std::min({rise, risen_[0], risen_[1]});
    risen_ = {rise, risen_[0]};
    out_.created = std::max(out_.created, stays);
    const double of = std::max(out_.exchanged + moved, floor_);
    out_.oscillation_fraction = std::max(out_.oscillation_fraction, rise / of);
    const double share = stays / of;
    if (share > out_.created_fraction) {
        out_.created_fraction = share;
        out_.created_at = world.time();
    }
    kinetic_ = moved;
    gravity_ = height;
    elastic_ = spring;
    before_ = poses;
    begun_ = true;
}

void RandomMonitor::sample(const World& world) {
    check_joints(world);
    check_energy(world);
}

}  // namespace hawser::bench
