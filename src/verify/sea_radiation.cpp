// SPDX-License-Identifier: Apache-2.0
/// Effects of coefficients on hulls. K(t) comes from Gauss points, the convolution from velocities
/// stored here, states from a series for e^{Ah}, waves from each component. At the start of
/// verification, the library's memory terms and its damping added for passivity are accepted.
#include "base/dense.h"
#include "verify/sea_loads.h"
#include "verify/sea_tools.h"

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

/// Return the damping B(ω) as in hydro.h: interpolated linearly between frequencies, and
/// extrapolated beyond the last one.
M6 damping_at(const WaveCoefficients& c, double omega) {
    const auto part = [&](double w0, const M6& b0, double w1, const M6& b1) -> M6 {
        return b0 + (omega - w0) / (w1 - w0) * (b1 - b0);
    };
    const double last = c.frequency.back();
    if (omega <= c.frequency.front())
        return part(0.0, M6::Zero(), c.frequency.front(), c.damping.front());
    for (std::size_t i = 1; i < c.frequency.size(); ++i)
        if (omega <= c.frequency[i])
            return part(c.frequency[i - 1], c.damping[i - 1], c.frequency[i], c.damping[i]);
    for (int i = 1; i <= 12; ++i) {
        const double w0 = last * std::pow(4.0, (i - 1) / 12.0), w1 = last * std::pow(4.0, i / 12.0);
        if (omega <= w1)
            return part(w0, c.damping.back() * std::pow(last / w0, 3), w1,
                        c.damping.back() * std::pow(last / w1, 3));
    }
    return part(4.0 * last, c.damping.back() / 64.0, 5.0 * last, M6::Zero());
}

/// Return the frequencies that bound the intervals in which B is linear.
std::vector<double> frequency_breaks(const WaveCoefficients& c) {
    std::vector<double> out{0.0};
    out.insert(out.end(), c.frequency.begin(), c.frequency.end());
    for (int i = 1; i <= 12; ++i) out.push_back(c.frequency.back() * std::pow(4.0, i / 12.0));
    out.push_back(5.0 * c.frequency.back());
    return out;
}

/// Return K at m h, m = 0 … count − 1, with about five Gauss points per radian.
std::vector<M6> retardation_kernel(const WaveCoefficients& c, double h, std::size_t count,
                                   double memory) {
    constexpr double kGaussPoints[] = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                       0.5384693101056831, 0.9061798459386640};
    constexpr double kGaussWeights[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                        0.4786286704993665, 0.2369268850561891};
    std::vector<M6> out(count, M6::Zero());
    const std::vector<double> ends = frequency_breaks(c);
    const double longest = h * static_cast<double>(count);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double wide = ends[i] - ends[i - 1];
        const int panels = 1 + static_cast<int>(0.7 * wide * longest);
        for (int p = 0; p < panels; ++p)
            for (int g = 0; g < 5; ++g) {
                const double omega =
                    ends[i - 1] + wide / panels * (p + 0.5 + 0.5 * kGaussPoints[g]);
                const M6 b = damping_at(c, omega);
                const M6 weight =
                    kGaussWeights[g] * wide / panels / kHalfTurn * 0.5 * (b + b.transpose());
                for (std::size_t m = 0; m < count; ++m)
                    out[m] += std::cos(omega * static_cast<double>(m) * h) * weight;
            }
    }
    for (std::size_t m = 0; m < count; ++m) {
        const double late = (static_cast<double>(m) * h - 0.8 * memory) / (0.2 * memory);
        if (late > 0.0) out[m] *= 0.5 * (1.0 + std::cos(kHalfTurn * std::min(late, 1.0)));
    }
    return out;
}

/// Return e^{A h} by the series of A h/1024, squared ten times.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& a, double h) {
    const Eigen::MatrixXd x = a * h / 1024.0;
    Eigen::MatrixXd term = Eigen::MatrixXd::Identity(a.rows(), a.cols()), sum = term;
    for (int n = 1; n < 12; ++n) {
        term = term * x / n;
        sum += term;
    }
    for (int n = 0; n < 10; ++n) sum = sum * sum;
    return sum;
}

}  // namespace

void SeaVerifier::start_history(const World& world, std::size_t hull) {
    Past& past = history_[hull];
    const WaterHull& def = def_->hulls[hull];
    const bool goes_on = past.until != 0.0 && std::abs(past.until - time_) < 1e-9;
    past.until = time_ + step_;
    if (goes_on) return;
    past.at_start = hull_memory(world, hull);
    const HullMemory& m = past.at_start;
    past.is_begun = m.begun;
    past.slow_begun = world.time() > 0.0;
    past.lag = {m.lag[0], m.lag[1], m.lag[2], m.lag[3]};
    past.last = Eigen::Map<const V6>(m.last.data());
    past.velocity.clear();
    for (const auto& v : m.past) past.velocity.emplace_back(Eigen::Map<const V6>(v.data()));
    if (m.kind == RadiationKind::convolution && past.kernel.size() != m.past.size() + 1)
        past.kernel = retardation_kernel(*def.coefficients, m.step, m.past.size() + 1, def.memory);
    if (m.kind != RadiationKind::state_space) return;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto n = static_cast<Eigen::Index>(m.states.size());
    past.states = Eigen::Map<const Eigen::VectorXd>(m.states.data(), n);
    past.step_on = matrix_exponential(Eigen::Map<const Rows>(m.a.data(), n, n), m.step);
    past.b = Eigen::Map<const Rows>(m.b.data(), n, 6);
    past.c = Eigen::Map<const Rows>(m.c.data(), 6, n);
}

void SeaVerifier::add_memory(const WaterHull& def, Past& past, const Mat3& axes, const Twist& twist,
                             Load& out) {
    const RadiationKind kind = past.at_start.kind;
    if (kind == RadiationKind::none && !def.coriolis) return;
    const M6 to_reference = motions_at(def.coefficients->reference);
    V6 v;
    v << axes.transpose() * twist.linear, axes.transpose() * twist.angular;
    v = to_reference * v;
    past.predicted = past.is_begun ? V6(v + 0.5 * (v - past.last)) : v;
    M6 first = M6::Zero();
    V6 force = V6::Zero();
    if (past.is_begun && kind != RadiationKind::none) {
        const V6 mean = 0.5 * (past.last + v);
        if (kind == RadiationKind::convolution) {
            past.velocity.insert(past.velocity.begin(), mean);
            past.velocity.pop_back();
        } else {
            past.states = past.step_on * (past.states + step_ * past.b * mean);
        }
    }
    past.last = v;
    past.is_begun = true;
    if (kind == RadiationKind::none) return;
    if (kind == RadiationKind::convolution) {
        first = past.kernel[0];
        for (std::size_t m = 0; m < past.velocity.size(); ++m)
            force -= step_ * past.kernel[m + 1] * past.velocity[m];
    } else {
        first = past.at_start.first;  // the fit's value without its negative part
        force = -past.c * past.states;
    }
    const M6 turn = block_diagonal(axes);
    const M6 damping = 0.5 * step_ * first + past.at_start.added;
    out.damping += turn * to_reference.transpose() * damping * to_reference * turn.transpose();
    out.force += turn * to_reference.transpose() * force;
}

/// Return the axes to which the coefficients refer. They are those of the body, or horizontal axes
/// at the slow heading, which this function updates.
Mat3 SeaVerifier::frame_of(const WaterHull& def, Past& past, const Pose& pose) const {
    Mat3 axes = pose.orientation.toRotationMatrix();
    if (def.excitation == ExcitationKind::none && !def.drift) return axes;
    const Vec3 arm = axes * def.coefficients->reference;
    std::array<double, 3> to{pose.position.x() + arm.x(), pose.position.y() + arm.y(),
                             heading_about_z(pose)};
    if (!past.slow_begun) past.lag.fill(to);
    to[2] = past.lag[0][2] + wrap_angle(to[2] - past.lag[0][2]);
    const double fraction = def.slow_time > 0.0 ? 1.0 - std::exp(-step_ / def.slow_time) : 1.0;
    for (auto& lag : past.lag) {
        for (std::size_t k = 0; k < 3; ++k) lag[k] = (1.0 - fraction) * lag[k] + fraction * to[k];
        to = lag;
    }
    past.slow_begun = true;
    const double heading = 4.0 * past.lag[2][2] - 3.0 * past.lag[3][2];
    return Eigen::AngleAxisd(heading, Vec3(0, 0, 1)).toRotationMatrix();
}

void SeaVerifier::add_coefficients(const WaterHull& def, Past& past, const Pose& pose,
                                   const Twist& twist) {
    Load& out = load_[static_cast<std::size_t>(def.body.index)];
    const WaveCoefficients& c = *def.coefficients;
    const Mat3 axes = frame_of(def, past, pose);
    if (def.linear.on) {
        const bool waves = def.excitation != ExcitationKind::none || def.drift;
        const Mat3 level =
            Eigen::AngleAxisd(heading_about_z(pose), Vec3(0, 0, 1)).toRotationMatrix();
        add_statics(def, pose, waves ? axes : level, out);
    }
    const M6 turn = block_diagonal(axes), t = motions_at(c.reference);
    M6 a = M6::Zero();
    if (def.radiation == RadiationKind::constant) {
        const double omega = 2.0 * kHalfTurn / def.constant_period;
        const auto at = [&](const std::vector<Matrix6>& m) -> M6 {
            if (omega <= c.frequency.front()) return m.front();
            for (std::size_t i = 1; i < m.size(); ++i)
                if (omega < c.frequency[i])
                    return m[i - 1] + (omega - c.frequency[i - 1]) /
                                          (c.frequency[i] - c.frequency[i - 1]) * (m[i] - m[i - 1]);
            return m.back();
        };
        a = at(c.added_mass);
        const M6 b = at(c.damping);
        out.damping += turn * t.transpose() * (0.5 * (b + b.transpose())) * t * turn.transpose();
    } else if (def.radiation != RadiationKind::none) {
        a = c.has_infinite ? c.infinite : infinite_added_mass(c);
    }
    const M6 mass = turn * t.transpose() * (0.5 * (a + a.transpose())) * t * turn.transpose();
    out.mass += mass;
    add_memory(def, past, axes, twist, out);
    const Vec3 arm = axes * c.reference;
    if (def.excitation != ExcitationKind::none || def.drift) {
        V6 f = waves_on(def, past);
        f = turn * f;
        f.tail<3>() += arm.cross(f.head<3>());
        out.force += f;
    }
    if (!def.coriolis) return;
    Vec3 flow = Vec3::Zero();
    flow = sea_->current(air_, std::min(pose.position.z(), level_));
    // Velocity at the centre of mass, along axes of the world.
    V6 v = turn * base::inverse(motions_at(c.reference)) * past.predicted;
    v.head<3>() -= flow;
    const Vec3 spin = v.tail<3>();
    const V6 p = mass * v;
    V6 swept = V6::Zero();
    swept.head<3>() = spin.cross(v.head<3>());
    out.force += mass * swept;
    out.force.head<3>() -= spin.cross(p.head<3>());
    out.force.tail<3>() -= spin.cross(p.tail<3>()) + v.head<3>().cross(p.head<3>());
}

}  // namespace hawser::verify
