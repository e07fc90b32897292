// SPDX-License-Identifier: Apache-2.0
#include "observe/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::observe {

namespace {

// Sums of a dozen terms of size 1 differ by 1e-15; a light point among fast bodies loses a factor
// of 1e6 (its impulse against the floor).
constexpr double kRoundOff = 1e-9;

std::size_t slot(std::int32_t i) { return static_cast<std::size_t>(i); }

bool is_free(BodyKind kind) { return kind == BodyKind::rigid || kind == BodyKind::lump; }

// The nearest point of the cone ‖x_t‖ ≤ μ x_n.
Vec3 onto_cone(const Vec3& x, const Vec3& n, double mu) {
    const double normal = x.dot(n);
    const Vec3 tangent = x - normal * n;
    const double length = tangent.norm();
    if (length <= mu * normal) return x;
    if (mu * length <= -normal) return Vec3::Zero();
    const double on_rim = (normal + mu * length) / (1.0 + mu * mu);
    return on_rim * n + (mu * on_rim / length) * tangent;
}

Vec3 spun(const Mat3& inertia, const Vec3& w, double h) {
    const Vec3 l = inertia * w;
    return l + 0.5 * h * w.cross(l) + 0.25 * h * h * w.dot(l) * w;
}

Mat3 cross_matrix(const Vec3& a) {
    Mat3 m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

// Spin after h without torque (docs/methods.md, 3), by Newton's method: fixed points do not
// converge for slender bodies.
Vec3 free_spin(const Mat3& inertia, const Vec3& w, double h) {
    const Vec3 target = spun(inertia, w, -h);
    Vec3 u = w;
    for (int i = 0; i < 30; ++i) {
        const Vec3 l = inertia * u;
        const Mat3 slope = inertia + 0.5 * h * (cross_matrix(u) * inertia - cross_matrix(l)) +
                           0.25 * h * h * (u.dot(l) * Mat3::Identity() + 2.0 * u * l.transpose());
        const Vec3 change = slope.partialPivLu().solve(target - spun(inertia, u, h));
        u += change;
        if (change.norm() <= 1e-16 * u.norm()) break;
    }
    return u;
}

// Applied force and torque, inputs included.
Twist applied(const World& world, std::int32_t body) {
    const BodyDef& def = world.body_def({body});
    Twist f;
    f.linear = def.force;
    f.angular = def.torque;
    for (std::int32_t i = 0; i < world.input_count(); ++i) {
        const InputDef& input = world.input_def({i});
        if (input.interaction.valid() || input.body.index != body) continue;
        (input.component < 3 ? f.linear[input.component] : f.angular[input.component - 3]) =
            world.input({i});
    }
    return f;
}

}  // namespace

Verifier::Verifier(const World& world) : step_(world.settings().step) {
    const auto bodies = slot(world.body_count());
    std::vector<bool> held(bodies, false);
    for (std::int32_t i = 0; i < world.interaction_count(); ++i)
        for (const BodyId body : world.interaction_def({i}).body)
            if (body.valid()) held[slot(body.index)] = true;
    double least = 1e300, mass = 0.0;
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        const BodyDef& def = world.body_def({b});
        if (def.kind == BodyKind::fixed || def.kind == BodyKind::kinematic) continue;
        least = std::min(least, def.mass);
        mass += def.mass;
        if (is_free(def.kind) && !held[slot(b)]) free_.push_back(b);
    }
    floor_ = 1e-6 * step_ * 9.81 * least;
    momentum_floor_ = 1e-6 * step_ * 9.81 * std::sqrt(mass);
    pose_.resize(bodies);
    twist_.resize(bodies);
    change_.assign(bodies, Vec3::Zero());
    linear_.resize(bodies);
    angular_.resize(bodies);
    result_.free_bodies = static_cast<std::int32_t>(free_.size());
}

void Verifier::before_step(const World& world) {
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        pose_[slot(b)] = world.pose({b});
        twist_[slot(b)] = world.velocity({b});
        linear_[slot(b)].setZero();
        angular_[slot(b)].setZero();
    }
}

std::string Verifier::after_step(const World& world) {
    double map = 0.0;
    for (const ContactView& contact : world.contacts())
        map = std::max({map, natural_map(world, contact), turn_map(world, contact)});
    const StepStats& stats = world.stats();
    const double difference = std::abs(map - stats.natural_map);
    const double momentum = momentum_residual(world);
    ++result_.steps;
    result_.difference = std::max(result_.difference, difference);
    result_.momentum = std::max(result_.momentum, momentum);
    if (!stats.cut) result_.natural_map = std::max(result_.natural_map, map);
    // Comparisons written so that what is not a number fails.
    if (!(difference <= kRoundOff + 1e-6 * stats.natural_map))
        return fmt::format("the natural map is {:.3e}, the step says {:.3e}", map,
                           stats.natural_map);
    if (const double most = world.settings().contact_tolerance;
        !stats.cut && !(map <= most + kRoundOff))
        return fmt::format("the natural map is {:.3e}, more than {:.3e}", map, most);
    if (!(momentum <= kRoundOff))
        return fmt::format("momentum of bodies between contacts is off by {:.3e}, relative",
                           momentum);
    return {};
}

Verifier::Side Verifier::side_of(const World& world, ShapeId shape, const Vec3& on_axis) const {
    const ShapeDef& def = world.shape_def(shape);
    Side side{.count = 1, .body = {def.body.index, def.body_b.index}};
    if (!def.body_b.valid()) return side;
    const Vec3 from = pose_[slot(side.body[0])].position;
    const Vec3 along = pose_[slot(side.body[1])].position - from;
    const double s = std::clamp((on_axis - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    side.count = 2;
    side.share[0] = 1.0 - s;
    side.share[1] = s;
    return side;
}

double Verifier::natural_map(const World& world, const ContactView& contact) {
    const Vec3 &n = contact.normal, lambda = step_ * contact.force;
    Vec3 u = Vec3::Zero();
    double mobility = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double sign = k == 0 ? -1.0 : 1.0;
        const double to_axis = 0.5 * contact.gap + world.shape_def(contact.shape[k]).radius;
        const Side side = side_of(world, contact.shape[k], contact.point + sign * to_axis * n);
        for (int i = 0; i < side.count; ++i) {
            const std::int32_t b = side.body[i];
            const BodyDef& def = world.body_def({b});
            const double w = side.share[i];
            const Twist now = world.velocity({b});
            const bool turns = def.kind != BodyKind::lump;
            const Vec3 arm = turns ? Vec3(contact.point - pose_[slot(b)].position) : Vec3::Zero();
            u += sign * w * (now.linear + now.angular.cross(arm));
            linear_[slot(b)] += sign * w * lambda;
            angular_[slot(b)] += sign * w * arm.cross(lambda);
            if (!is_free(def.kind)) continue;
            double own = 1.0 / def.mass;
            if (turns) {
                const Vec3 local = pose_[slot(b)].orientation.conjugate() * arm;
                const Mat3 cross = cross_matrix(local);
                own += (cross.transpose() * def.inertia.inverse() * cross).trace() / 3.0;
            }
            mobility += w * w * own;
        }
    }
    // ‖λ − P_K(λ − ρ ũ)‖ over the larger of ‖λ‖ and ρ‖q‖.
    const double sn = contact.softness[0], st = contact.softness[1];
    const Vec3 lambda_n = lambda.dot(n) * n;
    const Vec3 r = u + sn * lambda_n + st * (lambda - lambda_n) - contact.target;
    const double shift = contact.friction * (r - r.dot(n) * n).norm();
    const double rho = 1.0 / (mobility + std::max(sn, st));
    const Vec3 error = lambda - onto_cone(lambda - rho * (r + shift * n), n, contact.friction);
    const Vec3 q = rho * (u - contact.target - mobility * lambda);
    if (error.norm() == 0.0) return 0.0;
    return error.norm() / std::max({lambda.norm(), q.norm(), floor_});
}

double Verifier::turn_map(const World& world, const ContactView& contact) {
    if (contact.rolling == 0.0 && contact.torsional == 0.0) return 0.0;
    const Vec3 &n = contact.normal, lambda = step_ * contact.moment;
    Vec3 u = Vec3::Zero();
    double mobility = 0.0;
    for (int k = 0; k < 2; ++k) {
        const std::int32_t b = world.shape_def(contact.shape[k]).body.index;
        const BodyDef& def = world.body_def({b});
        const double sign = k == 0 ? -1.0 : 1.0;
        u += sign * world.velocity({b}).angular;
        angular_[slot(b)] += sign * lambda;
        if (is_free(def.kind)) mobility += def.inertia.inverse().trace() / 3.0;
    }
    // Parts that are free have no row.
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
                             floor_ * std::max(contact.rolling, contact.torsional)});
}

// Iδ of a body between its free spin and now, less what couples spin and its change.
Vec3 Verifier::spin_impulse(std::int32_t body, const Mat3& inertia, const Twist& now) {
    const Quat& turn = pose_[slot(body)].orientation;
    const Vec3 w = turn.conjugate() * twist_[slot(body)].angular;
    const Vec3 delta = turn.conjugate() * now.angular - free_spin(inertia, w, step_);
    Vec3& last = change_[slot(body)];
    const double limit = 0.5 * step_ / (1.0 + 0.25 * step_ * step_ * w.squaredNorm());
    const Vec3 gyro = -limit * (last.cross(inertia * w) + w.cross(inertia * last));
    last = delta;
    return turn * (inertia * delta - gyro);
}

double Verifier::momentum_residual(const World& world) {
    const double h = step_;
    double residual = 0.0, impulse = 0.0;
    for (const std::int32_t b : free_) {
        const BodyDef& def = world.body_def({b});
        const Twist now = world.velocity({b}), force = applied(world, b);
        const bool turns = def.kind == BodyKind::rigid;
        const Quat turn = turns ? pose_[slot(b)].orientation : Quat::Identity();
        const auto drag = [&](const Vec3& d, const Vec3& v) -> Vec3 {
            return -h * (turn * d.cwiseProduct(turn.conjugate() * v));
        };
        const Vec3 weight = def.gravity ? Vec3(def.mass * world.settings().gravity) : Vec3::Zero();
        const Vec3 given = h * (force.linear + weight);
        const Vec3 p = def.mass * (now.linear - twist_[slot(b)].linear) - given -
                       drag(def.linear_damping, now.linear) - linear_[slot(b)];
        residual += p.squaredNorm() / def.mass;
        impulse += given.squaredNorm() / def.mass;
        if (!turns) continue;
        const Vec3 l =
            turn.conjugate() * (spin_impulse(b, def.inertia, now) - h * force.angular -
                                drag(def.angular_damping, now.angular) - angular_[slot(b)]);
        residual += l.dot(def.inertia.llt().solve(l));
    }
    // An impact stage jumps velocities within the step: begin anew.
    if (world.stats().impacts != impacts_) seen_ = 0;
    impacts_ = world.stats().impacts;
    // Velocities before a world's first step belong to another time, so that the change of spin is
    // known from the second step on and used in the third.
    return ++seen_ > 2 ? std::sqrt(residual) / std::max(std::sqrt(impulse), momentum_floor_) : 0.0;
}

}  // namespace hawser::observe
