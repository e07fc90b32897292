// SPDX-License-Identifier: Apache-2.0
/// Check the momentum of the bodies over a step.
#include "base/dense.h"
#include "verify/certificate.h"
#include "verify/load_impulses.h"
#include "verify/step_velocity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hawser::verify {

namespace {

std::size_t index_of(std::int32_t i) { return static_cast<std::size_t>(i); }

double square_over(const Mat3& inverse, const Vec3& v) { return v.dot(inverse * v); }

// Return b(y) of the rotation of a step (docs/theory/rotation.md), from tangent and series.
double bend_of_turn(double y) {
    const double a = std::sqrt(y);
    if (y < 1e-2)
        return 1.0 / 3.0 +
               y * (1.0 / 45.0 + y * (2.0 / 945.0 + y * (1.0 / 4725.0 + y * (2.0 / 93555.0))));
    if (y <= 1.0) return (1.0 - a / std::tan(a)) / y;
    const double value = 1.0 / std::tan(1.0), sine = std::sin(1.0);
    const double slope = 0.5 * (value - 1.0 / (sine * sine));
    return (1.0 - value - slope * (1.0 - 1.0 / y)) / y;
}

// Return the angular momentum of half a step after the velocity w (h > 0), or before it (h < 0).
Vec3 spun(const Mat3& inertia, const Vec3& w, double h) {
    const Vec3 l = inertia * w, across = w.cross(l);
    const double square = 0.25 * h * h;
    return l + 0.5 * h * across + square * bend_of_turn(square * w.squaredNorm()) * w.cross(across);
}

// Return the angular velocity after h without torque (docs/theory/rotation.md), by Newton's method.
// Fixed-point iterations do not converge for slender bodies.
Vec3 free_spin(const Mat3& inertia, const Vec3& w, double h) {
    const Vec3 target = spun(inertia, w, -h);
    Vec3 u = w;
    for (int i = 0; i < 30; ++i) {
        const Vec3 l = inertia * u;
        const double square = 0.25 * h * h, bend = bend_of_turn(square * u.squaredNorm());
        // Without the slope of the bend, which is small: convergence is then linear and fast.
        const Mat3 slope = inertia + 0.5 * h * (cross_matrix(u) * inertia - cross_matrix(l)) +
                           square * bend *
                               (u.dot(l) * Mat3::Identity() + 2.0 * u * l.transpose() -
                                u.squaredNorm() * inertia - 2.0 * l * u.transpose());
        const Vec3 change = base::solve_lu(slope, target - spun(inertia, u, h));
        u += change;
        if (change.norm() <= 1e-16 * u.norm()) break;
    }
    return u;
}

// Return the weight θ of the velocity after the step in the drag (docs/theory/step.md). A body with
// drag only then slows down by exp(-z).
double late_fraction(double z) {
    if (z < 1e-2) return 0.5 + z / 12.0 - z * z * z / 720.0;
    return -1.0 / std::expm1(-z) - 1.0 / z;
}

// Return the inputs that are forces on bodies.
std::vector<InputId> forces_on_bodies(const World& world) {
    std::vector<InputId> out;
    for (const InputId id : world.inputs())
        if (world.input_def(id).body.valid()) out.push_back(id);
    return out;
}

// Return the applied force and torque, including inputs. @param turn  Orientation of the body at
// the start of the step; forces in its own frame rotate with it. @param inputs  forces_on_bodies().
Twist applied_wrench(const World& world, BodyId body, const Quat& turn,
                     const std::vector<InputId>& inputs) {
    const BodyDef& def = world.body_def(body);
    Twist f;
    f.linear = def.force;
    f.angular = def.torque;
    for (const InputId id : inputs) {
        const InputDef& input = world.input_def(id);
        if (input.body != body) continue;
        const Vec3 axis = Vec3::Unit(input.component % 3);
        (input.component < 3 ? f.linear : f.angular) +=
            world.input(id) * (input.local ? Vec3(turn * axis) : axis);
    }
    return f;
}

bool has_force(const World& world, InteractionId id) {
    const auto force = world.force(id);
    return std::any_of(force.begin(), force.end(), [](double f) { return f != 0.0; });
}

/// Sum of the squares of all bodies, and the body with the largest.
struct ResidualParts {
    double sum = 0.0, largest_part = 0.0;
    BodyId worst{};
    void add(BodyId body, double square) {
        sum += square;
        if (square > largest_part) {
            largest_part = square;
            worst = body;
        }
    }
};

}  // namespace

bool Verifier::sleeps(const World& world, BodyId body) const {
    return slept_[index_of(body.index)] && world.asleep(body);
}

void Verifier::add_interactions(const World& world) {
    for (const InteractionId id : world.interactions()) {
        const std::size_t i = index_of(id.index);
        const InteractionDef& def = world.interaction_def(id);
        const Wrenches rows = row_wrenches(world, id, pose_, world.force(id));
        // If the step was solved twice, the second solve used the stiffness of the forces from the
        // first one.
        if (world.stats().restiffened > 0) {
            const auto with = world.solver().stiffness_force(id);
            std::copy_n(with.begin(), last_[i].size(), last_[i].begin());
        }
        // A system may break it at the beginning of the step; an element breaks by its load at the
        // end.
        const bool held = intact_[i] && (world.intact(id) || has_force(world, id));
        // For an interaction from an edit, the wire's alert is known only after the step.
        const int damped_steps_before = std::max(damped_before_[i], world.wires().damped_steps(id));
        const Wrenches other = held ? stiffness_wrenches(world, id, pose_, twist_, earlier_,
                                                         last_[i], damped_steps_before)
                                    : Wrenches{};
        for (int k = 0; k < kind_info(def.kind).bodies; ++k) {
            const BodyId on = def.body[index_of(k)];
            const std::size_t b = index_of(on.index);
            if (sleeps(world, on)) continue;
            const Wrench &f = rows.on[index_of(k)], &g = other.on[index_of(k)];
            const Vec3 linear = step_ * f.force + g.force, turn = step_ * f.torque + g.torque;
            linear_[b] += linear;
            angular_[b] += turn;
            if (checks_.states) state_verifier_.add_stiffness(id, on, g);
            if (world.solver().completed(id)) turning_[b] = true;
            if (!rows.is_known || !other.is_known) unsure_[b] = true;
            const BodyDef& body = world.body_def(on);
            if (body.kind == BodyKind::fixed || body.kind == BodyKind::kinematic) continue;
            impulse_ += linear.squaredNorm() / body.mass +
                        square_over(mobility_[b], pose_[b].orientation.conjugate() * turn);
        }
    }
}

void Verifier::add_loads(const World& world) {
    for (const LoadImpulse& load : load_impulses(world, pose_, twist_)) {
        const std::size_t b = index_of(load.body.index);
        linear_[b] += load.linear;
        angular_[b] += load.angular;
        // A step solves for the change from a predicted velocity. A stop may cancel nearly all of
        // that velocity; the rounding of the prediction remains.
        constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
        rounded_[b] += kRounding * load.resistance *
                       (2.0 * twist_[b].linear.norm() + earlier_[b].linear.norm());
        impulse_ += load.linear.squaredNorm() / world.body_def(load.body).mass +
                    square_over(mobility_[b], pose_[b].orientation.conjugate() * load.angular);
    }
}

// Return the angular impulse I δ of a body, without its gyroscopic part. δ is the difference
// between its present angular velocity and that of a free rotation.
Vec3 Verifier::spin_impulse(std::size_t body, const Mat3& inertia, const Twist& now) {
    const Quat& turn = pose_[body].orientation;
    const Vec3 w = turn.conjugate() * twist_[body].angular;
    const Vec3 delta = turn.conjugate() * now.angular - free_spin(inertia, w, step_);
    Vec3& last = change_[body];
    const double limit = 0.5 * step_ / (1.0 + 0.25 * step_ * step_ * w.squaredNorm());
    const Vec3 gyro = -limit * (last.cross(inertia * w) + w.cross(inertia * last));
    last = delta;
    if (turning_[body]) {  // the whole equation, docs/theory/rotation.md
        const Vec3 u = turn.conjugate() * now.angular;
        return turn * (spun(inertia, u, step_) - spun(inertia, w, -step_));
    }
    return turn * (inertia * delta - gyro);
}

double Verifier::momentum_residual(const World& world) {
    const double h = step_;
    ResidualParts residual;
    double impulse = impulse_;
    double momentum = 0.0;
    std::int32_t covered = 0;
    const std::vector<InputId> inputs = forces_on_bodies(world);
    for (const BodyId id : moving_) {
        const std::size_t b = index_of(id.index);
        if (sleeps(world, id)) {
            ++covered;  // no motion to check
            continue;
        }
        const BodyDef& def = world.body_def(id);
        const bool turns = def.kind == BodyKind::rigid, scalar = def.kind == BodyKind::scalar;
        const Quat turn = turns ? pose_[b].orientation : Quat::Identity();
        const Twist now = step_velocity(world, id, pose_[b]),
                    force = applied_wrench(world, id, turn, inputs);
        // Impulse of drag d on velocities before and after the step; each axis of the body has its
        // own mobility.
        const auto drag = [&](const Vec3& d, const Vec3& mobility, const Vec3& old,
                              const Vec3& v) -> Vec3 {
            const Vec3 w = turn.conjugate() * old, u = turn.conjugate() * v;
            Vec3 sum;
            for (int k = 0; k < 3; ++k) {
                const double late = late_fraction(h * d[k] * mobility[k]);
                sum[k] = d[k] * (late * u[k] + (1.0 - late) * w[k]);
            }
            return -h * (turn * sum);
        };
        const Vec3 inverse_mass = Vec3::Constant(1.0 / def.mass);
        const Twist& old = twist_[b];
        const Vec3 weight =
            def.gravity && !scalar ? Vec3(def.mass * world.settings().gravity) : Vec3::Zero();
        const Vec3 load_impulse = h * (force.linear + weight);
        Vec3 p = def.mass * (now.linear - twist_[b].linear) - load_impulse -
                 drag(def.linear_damping, inverse_mass, old.linear, now.linear) - linear_[b];
        if (scalar) p = Vec3(p.x(), 0.0, 0.0);
        if (const double size = p.norm(); size > 0.0) p *= std::max(0.0, 1.0 - rounded_[b] / size);
        // Compute it also for omitted bodies, because it stores the change of angular velocity.
        const Vec3 spin = turns ? spin_impulse(b, def.inertia, now) : Vec3::Zero();
        if (unsure_[b]) {
            // Forces that this code does not compute: the account of lost energy counts them as
            // acting.
            if (checks_.states)
                state_verifier_.add_impulse(id, {p, spin - h * force.angular - angular_[b]});
            continue;
        }
        ++covered;
        residual.add(id, p.squaredNorm() / def.mass);
        momentum += def.mass * now.linear.squaredNorm();
        impulse += load_impulse.squaredNorm() / def.mass;
        if (!turns) continue;
        const Vec3 l = turn.conjugate() * (spin - h * force.angular -
                                           drag(def.angular_damping, mobility_[b].diagonal(),
                                                old.angular, now.angular) -
                                           angular_[b]);
        // Another iteration of the end-of-step constraints would have changed velocities by up to
        // this.
        const double left = 1.01 * world.stats().completion_change + 1e-15;
        if (!turning_[b] || (mobility_[b] * l).norm() > left)
            residual.add(id, square_over(mobility_[b], l));
        const Vec3 w = turn.conjugate() * now.angular;
        momentum += w.dot(def.inertia * w);
    }
    // An impact stage changes velocities within the step: restart.
    if (world.stats().impacts != impacts_) checked_steps_ = 0;
    impacts_ = world.stats().impacts;
    // Velocities before a world's first step belong to another time. The change of angular velocity
    // is therefore known from the second step on and used in the third.
    if (++checked_steps_ <= 2) return 0.0;
    if (world.stats().wire_repeats > 0)
        ++result_.rejected_steps;
    else
        omitted_bodies_ = std::max(omitted_bodies_, result_.moving_bodies - covered);
    result_.covered_bodies = std::max(0, result_.moving_bodies - omitted_bodies_);
    // A body without load has a small impulse, below the rounding of its momentum. Count 1e-4 of
    // the momentum as impulse, so that kRoundOff is 1e-13 of it.
    worst_momentum_body_ = residual.worst;
    return std::sqrt(residual.sum) /
           std::max({std::sqrt(impulse), momentum_floor_, 1e-4 * std::sqrt(momentum)});
}

}  // namespace hawser::verify
