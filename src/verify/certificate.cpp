// SPDX-License-Identifier: Apache-2.0
#include "verify/certificate.h"

#include "verify/anchor_soil.h"
#include "verify/contact_side.h"
#include "verify/step_velocity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hawser::verify {

namespace {

// Sums of a dozen terms of size 1 differ by 1e-15; a light point among fast bodies loses a factor
// of 1e6 (its impulse against the floor).
constexpr double kRoundOff = 1e-9;
constexpr double kNotStrict = 1e-5;  // Closed loops at singular poses reach 3e-6.

std::size_t slot(std::int32_t i) { return static_cast<std::size_t>(i); }

bool is_free(BodyKind kind) { return kind == BodyKind::rigid || kind == BodyKind::lump; }

// Return the nearest point of the cone ‖x_t‖ ≤ μ x_n.
Vec3 onto_cone(const Vec3& x, const Vec3& n, double mu) {
    const double normal = x.dot(n);
    const Vec3 tangent = x - normal * n;
    const double length = tangent.norm();
    // Without friction the cone is a half line: the tangent is 0 up to rounding or a pull has none.
    if (mu * length <= -normal) return Vec3::Zero();
    if (length <= mu * normal) return x;
    const double on_rim = (normal + mu * length) / (1.0 + mu * mu);
    return on_rim * n + (mu * on_rim / length) * tangent;
}

}  // namespace

Mat3 cross_matrix(const Vec3& a) {
    Mat3 m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

Verifier::Verifier(const World& world, Checks checks)
    : step_(world.settings().step), checks_(checks), state_verifier_(world), sea_(world) {
    // Worlds without groups or with an unused budget may split later.
    if (world.settings().coupling != Coupling::exact)
        throw DefError(
            "--verify checks momentum, which a split does not keep; use --coupling exact");
    update_tables(world);
    result_.covered_bodies = result_.moving_bodies;
}

void Verifier::begin_at(const World& world) {
    SeaVerifier sea = std::move(sea_);
    const Verification before = result_;
    *this = Verifier(world, checks_);
    sea_ = std::move(sea);
    sea_.restart();
    if (before.steps > 0) result_ = before;
}

bool Verifier::covers(const World& world) const {
    const auto same = [](const auto& a, const auto& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    };
    return same(bodies_, world.bodies()) && same(interactions_, world.interactions());
}

void Verifier::update_tables(const World& world) {
    const std::vector<BodyId> before = bodies_;
    bodies_.assign(world.bodies().begin(), world.bodies().end());
    interactions_.assign(world.interactions().begin(), world.interactions().end());
    const auto bodies = slot(world.body_count());
    mobility_.assign(bodies, Mat3::Zero());
    for (std::vector<Vec3>* v : {&change_, &linear_, &angular_}) v->resize(bodies, Vec3::Zero());
    rounded_.resize(bodies, 0.0);
    pose_.resize(bodies);
    twist_.resize(bodies);
    earlier_.resize(bodies);
    velocity_after_.resize(bodies);
    unsure_.resize(bodies);
    slept_.resize(bodies);
    moving_.clear();
    // Least mass of bodies that are not scalar, of all, and of a world without any.
    constexpr double kNone = 1e300;
    double least = kNone, least_of_all = kNone, mass = 0.0;
    for (const BodyId id : bodies_) {
        // Added bodies had no torque before. Their velocity is constant until then.
        if (!std::binary_search(before.begin(), before.end(), id)) {
            change_[slot(id.index)].setZero();
            twist_[slot(id.index)] = world.velocity(id);
            velocity_after_[slot(id.index)].linear.setConstant(
                std::numeric_limits<double>::quiet_NaN());
        }
        const BodyDef& def = world.body_def(id);
        if (def.kind == BodyKind::fixed || def.kind == BodyKind::kinematic) continue;
        least_of_all = std::min(least_of_all, def.mass);
        if (def.kind != BodyKind::scalar) least = std::min(least, def.mass);
        mass += def.mass;
        moving_.push_back(id);
        if (def.kind == BodyKind::rigid) mobility_[slot(id.index)] = def.inertia.inverse();
    }
    loads_ = false;
    for (const InteractionId id : interactions_) {
        const InteractionDef& def = world.interaction_def(id);
        for (const FrictionLoad& load : def.load) loads_ = loads_ || load.interaction.valid();
        loads_ = loads_ || (kind_info(def.kind).is(kMotorKind) && def.get("power") < 1e30);
    }
    rounding_floor_ = 1e-6 * step_ * 9.81 * (least < kNone ? least : least_of_all);
    scalar_floor_ = 1e-6 * step_ * 9.81 * least_of_all;
    momentum_floor_ = 1e-6 * step_ * 9.81 * std::sqrt(mass);
    last_.resize(slot(world.interaction_count()));
    intact_.resize(last_.size());
    damped_before_.resize(last_.size());
    result_.moving_bodies = static_cast<std::int32_t>(moving_.size());
}

void Verifier::before_step(const World& world) {
    if (!covers(world)) update_tables(world);
    earlier_ = twist_;
    for (const BodyId id : bodies_) {
        const std::size_t b = slot(id.index);
        pose_[b] = world.pose(id);
        twist_[b] = world.velocity(id);
        // The extrapolation is not 2 v − v₋ after an edit of the velocity, or for a new body.
        const Twist &now = twist_[b], &left = velocity_after_[b];
        if (now.linear != left.linear || now.angular != left.angular) {
            const Twist ahead = world.predicted_velocity(id);
            earlier_[b] = {2.0 * now.linear - ahead.linear, 2.0 * now.angular - ahead.angular};
        }
        linear_[b].setZero();
        rounded_[b] = 0.0;
        angular_[b].setZero();
        slept_[b] = world.asleep(id);
    }
    for (const InteractionId id : interactions_) {
        const auto force = world.force(id);
        last_[slot(id.index)].assign(force.begin(), force.end());
        intact_[slot(id.index)] = world.intact(id);
        damped_before_[slot(id.index)] = world.wires().damped_steps(id);
    }
    unsure_.assign(unsure_.size(), false);
    turning_.assign(unsure_.size(), false);
    impulse_ = 0.0;
    law_error_.clear();
    if (checks_.states) state_verifier_.before_step(world);
    if (checks_.sea) sea_.before_step(world);
}

std::string Verifier::after_step(const World& world) {
    if (!covers(world)) {
        update_tables(world);
        std::string edits = checks_.states ? state_verifier_.restart(world) : std::string{};
        result_.states = state_verifier_.result();
        checked_steps_ = 1;  // the change of spin is known from the next step on
        impacts_ = world.stats().impacts;
        return world.settings().on_diverged == OnDiverged::stop ? edits : std::string{};
    }
    const StepStats& stats = world.stats();
    const double map = step_map(world);
    // The step counts friction with loads and motors with a power limit by the motion of their
    // bounds after the last solve. Contacts may then be better than that, not worse.
    const double better = loads_ ? stats.natural_map : 0.0;
    // Values within rounding may differ there.
    const double difference = std::max(
        map - stats.natural_map, stats.natural_map - std::max(map, within_rounding_) - better);
    const double excess = bound_excess(world);
    add_interactions(world);
    add_loads(world);
    const double momentum = momentum_residual(world);
    for (const BodyId id : bodies_) velocity_after_[slot(id.index)] = world.velocity(id);
    const double sea = checks_.sea ? sea_.after_step(world, pose_, twist_) : 0.0;
    std::string state = checks_.states ? state_verifier_.after_step(world) : std::string{};
    result_.states = state_verifier_.result();
    ++result_.steps;
    result_.difference = std::max(result_.difference, difference);
    result_.momentum = std::max(result_.momentum, momentum);
    result_.bounds = std::max(result_.bounds, excess);
    result_.sea = std::max(result_.sea, sea);
    if (!stats.cut) result_.natural_map = std::max(result_.natural_map, map);
    const double rounding = checks_.strict ? kRoundOff : kNotStrict;
    const bool unsolved = stats.natural_map > world.settings().contact_tolerance ||
                          stats.flips_left > 0 || stats.momentum_residual > kNotStrict;
    if (!checks_.strict && (unsolved || stats.cut)) return {};
    if (!law_error_.empty()) return law_error_;
    if (std::string fault = anchor_fault(world); !fault.empty()) return fault;
    // Comparisons are written so that NaN fails.
    if (!(difference <= rounding + 1e-6 * stats.natural_map))
        return fmt::format("the natural map is {:.3e}, the step says {:.3e}", map,
                           stats.natural_map);
    // A single step that reports itself as unsolved is accepted; a sequence of them fails.
    const double most = world.settings().contact_tolerance;
    unsolved_ = !stats.cut && !(map <= most + rounding) ? unsolved_ + step_ : 0.0;
    if (unsolved_ > 0.0 && !(map <= limit::kCertificate.wrong && unsolved_ < limit::kSustained))
        return fmt::format("the natural map is {:.3e}, more than {:.3e}", map, most);
    // Bounds of friction are followed until their part of the natural map is small enough; rows
    // that still switch are reported as such.
    if (!stats.cut && stats.flips_left == 0 && !(excess <= stats.natural_map + rounding))
        return fmt::format("{} by {:.3e}, relative", describe_worst_bound(world), excess);
    if (!(momentum <= rounding))
        return fmt::format("momentum is off by {:.3e}, relative, most of it that of {}", momentum,
                           object_label("body", world.body_def(worst_momentum_body_).name,
                                        worst_momentum_body_.index));
    if (!(sea <= sea_.limit()))
        return fmt::format("loads of the sea are off by {:.3e}, relative", sea);
    if (world.settings().on_diverged == OnDiverged::stop) return state;
    return {};
}

double Verifier::step_map(const World& world) {
    double map = 0.0;
    within_rounding_ = 0.0;
    for (const ContactView& contact : world.contacts())
        if (!contact.asleep)
            map =
                std::max({map, natural_map(world, contact), rotation_natural_map(world, contact)});
    return map;
}

double Verifier::natural_map(const World& world, const ContactView& contact) {
    const Vec3 &n = contact.normal, lambda = step_ * contact.force;
    Vec3 u = Vec3::Zero();
    double mobility = 0.0, speed = 0.0, speeds = 0.0, terms = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double sign = k == 0 ? -1.0 : 1.0;
        const double to_axis = 0.5 * contact.gap + world.shape_def(contact.shape[k]).radius;
        const ContactSide side = contact_side(
            world, contact.shape[k], contact.point + sign * to_axis * n, contact.point, pose_);
        for (int i = 0; i < side.count; ++i) {
            const BodyId id = side.body[i];
            const std::size_t b = slot(id.index);
            const BodyDef& def = world.body_def(id);
            const double w = side.fraction[i];
            const Twist now = step_velocity(world, id, pose_[b]), before = twist_[b];
            const bool turns = def.kind != BodyKind::lump;
            const Vec3& arm = side.arm[i];
            const Vec3 at_point = now.linear + now.angular.cross(arm);
            u += sign * w * at_point;
            // The rounding of a coordinate enters velocities by arms, and by the length of a
            // segment.
            terms += at_point.norm() * (1.0 + contact.point.norm() / side.length) +
                     now.angular.norm() * contact.point.norm();
            const double along = n.dot(before.linear + before.angular.cross(arm));
            speed += sign * w * along;
            speeds += std::abs(along);
            linear_[b] += sign * w * lambda;
            angular_[b] += sign * w * arm.cross(lambda);
            if (!is_free(def.kind)) continue;
            double own = 1.0 / def.mass;
            if (turns) {
                const Vec3 local = pose_[b].orientation.conjugate() * arm;
                const Mat3 cross = cross_matrix(local);
                own += (cross.transpose() * def.inertia.inverse() * cross).trace() / 3.0;
            }
            mobility += w * w * own;
        }
    }
    check_law(world, contact, mobility, speed, speeds);
    // ‖λ − P_K(λ − ρ ũ)‖ over the larger of ‖λ‖ and ρ‖q‖.
    const double sn = contact.softness[0], st = contact.softness[1];
    const Vec3 lambda_n = lambda.dot(n) * n;
    const Vec3 r = u + sn * lambda_n + st * (lambda - lambda_n) - contact.target;
    const double shift = contact.friction * (r - r.dot(n) * n).norm();
    const double rho = 1.0 / (mobility + std::max(sn, st));
    const Vec3 error = lambda - onto_cone(lambda - rho * (r + shift * n), n, contact.friction);
    const Vec3 q = rho * (u - contact.target - mobility * lambda);
    // The remainder of cancelling velocities is their rounding, which differs from that in the
    // step.
    constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
    const double rounding = kRounding * rho * (terms + contact.target.norm()),
                 over = std::max({lambda.norm(), q.norm(), rounding_floor_});
    if (error.norm() > rounding) return error.norm() / over;
    within_rounding_ = std::max(within_rounding_, rounding / over);
    return 0.0;
}

double Verifier::rotation_natural_map(const World& world, const ContactView& contact) {
    if (contact.rolling == 0.0 && contact.torsional == 0.0) return 0.0;
    const Vec3 &n = contact.normal, lambda = step_ * contact.moment;
    Vec3 u = Vec3::Zero();
    double mobility = 0.0;
    for (int k = 0; k < 2; ++k) {
        const BodyId id = world.shape_def(contact.shape[k]).body;
        const std::size_t b = slot(id.index);
        const BodyDef& def = world.body_def(id);
        const double sign = k == 0 ? -1.0 : 1.0;
        u += sign * step_velocity(world, id, pose_[b]).angular;
        angular_[b] += sign * lambda;
        if (is_free(def.kind)) mobility += def.inertia.inverse().trace() / 3.0;
    }
    // Free components have no row.
    const auto rows = [&](const Vec3& x) -> Vec3 {
        const Vec3 about = x.dot(n) * n;
        return (contact.torsional > 0.0 ? about : Vec3(Vec3::Zero())) +
               (contact.rolling > 0.0 ? Vec3(x - about) : Vec3(Vec3::Zero()));
    };
    const double rho = 1.0 / (mobility + contact.turn_softness);
    const Vec3 r = u + contact.turn_softness * lambda - contact.turn_target;
    const Vec3 y = rows(lambda - rho * r);
    const double normal = std::max(0.0, step_ * contact.force.dot(n));
    const double spin = y.dot(n), most = contact.torsional * normal;
    const Vec3 roll = y - spin * n;
    const double length = roll.norm(), radius = contact.rolling * normal;
    const Vec3 nearest =
        std::clamp(spin, -most, most) * n + (length > radius ? radius / length : 1.0) * roll;
    const double error = (rows(lambda) - nearest).norm();
    if (error == 0.0) return 0.0;
    const Vec3 q = rho * rows(u - contact.turn_target - mobility * lambda);
    return error / std::max({rows(lambda).norm(), q.norm(),
                             rounding_floor_ * std::max(contact.rolling, contact.torsional)});
}

}  // namespace hawser::verify
