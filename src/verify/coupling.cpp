// SPDX-License-Identifier: Apache-2.0
#include "verify/coupling.h"

#include <hawser/experimental/splits.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

bool moves(const World& world, BodyId body) {
    const BodyKind kind = world.body_def(body).kind;
    return kind == BodyKind::rigid || kind == BodyKind::lump;
}

void read_velocities(const World& world, std::vector<Vec3>& out) {
    out.assign(static_cast<std::size_t>(world.body_count()), Vec3::Zero());
    for (const BodyId id : world.bodies())
        if (moves(world, id)) out[static_cast<std::size_t>(id.index)] = world.velocity(id).linear;
}

/// Displacement, rotation, velocity and angular velocity of a body, between two states.
struct Deviation {
    Vec3 x, turn, v, w;
};

Deviation operator*(double s, const Deviation& d) {
    return {s * d.x, s * d.turn, s * d.v, s * d.w};
}

/// Moving bodies, their states, and the scales of their norms.
class Linearised {
  public:
    explicit Linearised(const World& world)
        : world_(world),
          unperturbed_(world.twin()),
          perturbed_(world.twin()),
          h_(world.settings().step) {
        for (const BodyId id : world.bodies())
            if (moves(world, id)) bodies_.push_back(id);
        // Linearise one step with the present groups.
        for (World* w : {&unperturbed_, &perturbed_})
            w->splits().follow_groups(world.settings().parts, 0);
        is_ok_ = unperturbed_.step() == Status::ok;
    }

    [[nodiscard]] std::size_t size() const { return bodies_.size(); }

    /// Replace the deviations d by those after a step, linearised by finite differences. @return
    /// the mass-weighted norm of the change of velocities; −1: the step failed.
    double apply(std::vector<Deviation>& d) {
        perturbed_.state().copy_from(world_);
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            apply_deviation(bodies_[i], kDeviationScale * d[i]);
        if (!is_ok_ || perturbed_.step() != Status::ok) return -1.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Deviation next = (1.0 / kDeviationScale) * difference(bodies_[i]);
            sum += weight(bodies_[i]) * (next.v - d[i].v).squaredNorm();
            d[i] = next;
        }
        return std::sqrt(sum);
    }

    /// Return the mass-weighted norm of deviations. A displacement counts as a velocity over one
    /// step.
    [[nodiscard]] double norm(const std::vector<Deviation>& d) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < d.size(); ++i)
            sum += weight(bodies_[i]) * (d[i].v.squaredNorm() + d[i].x.squaredNorm() / (h_ * h_));
        return std::sqrt(sum);
    }

    /// Return the weight of a body in the norm: its mass.
    [[nodiscard]] double weight(BodyId body) const { return world_.body_def(body).mass; }

  private:
    static constexpr double kDeviationScale =
        1e-5;  ///< Scale of the differences [m/s]: far above rounding, far below motions.

    void apply_deviation(BodyId body, const Deviation& d) {
        Pose pose = perturbed_.pose(body);
        pose.position += d.x;
        if (perturbed_.body_def(body).kind == BodyKind::rigid && d.turn.norm() > 0.0)
            pose.orientation =
                Quat(Eigen::AngleAxisd(d.turn.norm(), d.turn.normalized())) * pose.orientation;
        perturbed_.set_pose(body, pose);
        Twist twist = perturbed_.velocity(body);
        twist.linear += d.v;
        twist.angular += d.w;
        perturbed_.set_velocity(body, twist);
    }

    [[nodiscard]] Deviation difference(BodyId body) const {
        const Pose a = unperturbed_.pose(body), b = perturbed_.pose(body);
        const Twist va = unperturbed_.velocity(body), vb = perturbed_.velocity(body);
        Quat turn = b.orientation * a.orientation.conjugate();
        if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
        return {b.position - a.position, 2.0 * turn.vec(), vb.linear - va.linear,
                vb.angular - va.angular};
    }

    const World& world_;
    World unperturbed_, perturbed_;
    double h_;
    bool is_ok_ = false;
    std::vector<BodyId> bodies_;
};

}  // namespace

const char* to_string(Coupling coupling) noexcept {
    return coupling == Coupling::kinematic   ? "kinematic"
           : coupling == Coupling::compliant ? "compliant"
           : coupling == Coupling::deadline  ? "deadline"
                                             : "exact";
}

const char* to_string(Predictor predictor) noexcept {
    return predictor == Predictor::forces   ? "forces"
           : predictor == Predictor::clique ? "clique"
                                            : "hold";
}

CouplingObserver::CouplingObserver(const World& world) : exact_world_(world.twin(Coupling::exact)) {
    figures_.coupling = world.settings().coupling;
    figures_.predictor = world.settings().predictor;
    read_velocities(world, now_);
}

void CouplingObserver::before_step(const World& world) {
    const auto same = [](const auto& a, const auto& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    };
    if (same(world.bodies(), exact_world_.bodies()) &&
        same(world.interactions(), exact_world_.interactions()) &&
        same(world.shapes(), exact_world_.shapes()) &&
        same(world.inputs(), exact_world_.inputs())) {
        exact_world_.state().copy_from(world);
    } else {
        exact_world_ = world.twin(Coupling::exact);
        figures_.steps = 0;  // new objects have no previous velocity
    }
    before_.swap(now_);
    read_velocities(world, now_);
}

void CouplingObserver::after_step(const World& world) {
    const StepStats& stats = world.stats();
    ++figures_.steps;
    figures_.cuts = stats.cuts;
    figures_.residual_max = std::max(figures_.residual_max, stats.cut_residual);
    figures_.defect_max = std::max(figures_.defect_max, stats.momentum_defect);
    defect_squares_ += stats.momentum_defect * stats.momentum_defect;
    if (exact_world_.step() != Status::ok) return;
    const double per_h2 = 1.0 / (world.settings().step * world.settings().step);
    // The first step has no previous velocity.
    for (const BodyId id : world.bodies()) {
        if (figures_.steps == 1 || !moves(world, id)) continue;
        const auto i = static_cast<std::size_t>(id.index);
        const Vec3 v = world.velocity(id).linear, e = exact_world_.velocity(id).linear;
        const Vec3 last = 2.0 * now_[i] - before_[i];
        figures_.jerk_max = std::max(figures_.jerk_max, per_h2 * (v - last).norm());
        figures_.jerk_exact_max = std::max(figures_.jerk_exact_max, per_h2 * (e - last).norm());
        figures_.jerk_difference_max =
            std::max(figures_.jerk_difference_max, per_h2 * (v - e).norm());
    }
    for (const CutView& cut : world.splits().cuts()) {
        const char* units = kind_info(world.interaction_def(cut.interaction).kind).row_units;
        const auto f = world.force(cut.interaction), e = exact_world_.force(cut.interaction);
        for (std::size_t r = 0; r < f.size() && units[r] == 'm'; ++r) {
            const double error = std::fabs(f[r] - e[r]);
            error_squares_ += error * error;
            force_squares_ += e[r] * e[r];
            error_max_ = std::max(error_max_, error);
            ++forces_;
        }
    }
}

CouplingFigures CouplingObserver::result(const World& world, bool radius) const {
    CouplingFigures out = figures_;
    const auto steps = static_cast<double>(std::max<std::int64_t>(1, out.steps));
    out.defect_rms = std::sqrt(defect_squares_ / steps);
    if (force_squares_ > 0.0) {
        out.tension_error_rms = std::sqrt(error_squares_ / force_squares_);
        out.tension_error_max =
            error_max_ / std::sqrt(force_squares_ / static_cast<double>(forces_));
    }
    if (radius) out.spectral_radius = spectral_radius(world);
    return out;
}

double spectral_radius(const World& world) {
    constexpr int kIterations = 160, kHalfIterations = kIterations / 2;
    Linearised step(world);
    std::vector<Deviation> d(step.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
    for (std::size_t i = 0; i < d.size(); ++i) {  // no symmetry, equal in each run
        const auto s = static_cast<double>(i);
        d[i].v = {std::sin(1.0 + 2.3 * s), std::sin(2.0 + 3.1 * s), std::sin(3.0 + 4.7 * s)};
    }
    double scale = 0.0, middle = 0.0, last = 0.0;  // logarithms
    for (int k = 1; k <= kIterations; ++k) {
        const double size = step.norm(d);
        if (!(size > 0.0)) return 0.0;
        // Normalise to the order of 1 m/s for each body.
        double mass = 0.0;
        for (std::size_t i = 0; i < d.size(); ++i)
            mass = std::max(mass, d[i].v.norm() + d[i].x.norm());
        for (Deviation& each : d) each = (1.0 / mass) * each;
        scale += std::log(mass);
        const double change = step.apply(d);
        if (change < 0.0) return HUGE_VAL;
        last = scale + std::log(change + 1e-300);
        if (k == kHalfIterations) middle = last;
    }
    return std::exp((last - middle) / kHalfIterations);
}

}  // namespace hawser::verify
