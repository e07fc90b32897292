// SPDX-License-Identifier: Apache-2.0
#include "meter.h"

#include "index.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace hawser::bench {
namespace {

double rotational_energy(const Body& b, const BodyState& s) {
    const Vec3 w = s.q.conjugate() * s.w;
    return 0.5 * w.dot(b.inertia.cwiseProduct(w));
}

std::string number(const char* format, double value) {
    char text[96];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

Meter::Meter(const Scene& scene, const Reference& reference, bool staggered)
    : scene_(scene),
      reference_(reference),
      staggered_(staggered),
      loaded_(scene.bodies.size(), 0),
      impulse_(scene.towed.size(), Vec3::Zero()),
      substep_tension_(scene.towed.size()),
      tensions_(scene.towed.size()) {
    std::vector<BodyState> start;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        start.push_back(scene.bodies[i].start);
        loaded_[i] = scene.bodies[i].drag != 0.0;
    }
    for (const Thrust& t : scene.thrusts) loaded_[at(t.body)] = 1;
    for (const Floating& f : scene.floating) loaded_[at(f.body)] = 1;
    energy_start_ = energy(start);
    m_.gap = largest_gap(start);
}

double Meter::energy(const std::vector<BodyState>& s) const {
    double e = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Body& b = scene_.bodies[i];
        e += 0.5 * b.mass * s[i].v.squaredNorm() + rotational_energy(b, s[i]);
        if (!b.afloat) e += b.mass * scene_.gravity * s[i].x.z();
    }
    for (const Floating& f : scene_.floating) {
        const BodyState& b = s[at(f.body)];
        const double z = b.x.z() - scene_.bodies[at(f.body)].start.x.z();
        e += 0.5 * f.heave_k * z * z + f.tilt_k * (1.0 - (b.q * Vec3::UnitZ()).z());
    }
    return e;
}

double Meter::largest_gap(const std::vector<BodyState>& s) const {
    double worst = 0.0;
    for (const BallJoint& j : scene_.joints) {
        const auto end = [&](int body, const Vec3& arm) -> Vec3 {
            return body == kWorld ? arm : Vec3(s[at(body)].x + s[at(body)].q * arm);
        };
        const double d2 = (end(j.a, j.arm_a) - end(j.b, j.arm_b)).squaredNorm();
        if (std::isnan(d2)) return d2;
        worst = std::max(worst, d2);
    }
    return std::sqrt(worst);
}

void Meter::substep(const std::vector<BodyState>& before, const std::vector<Load>& loads,
                    const std::vector<BodyState>& after, double h, const std::vector<Vec3>* tow) {
    last_work_ = 0.0;
    // Velocity that moved the bodies over this substep.
    const auto mean = [&](const Vec3& a, const Vec3& b) -> Vec3 {
        return staggered_ ? b : Vec3(0.5 * (a + b));
    };
    for (std::size_t i = 0; i < loaded_.size(); ++i)
        if (loaded_[i])
            last_work_ -=
                scene_.bodies[i].drag * mean(before[i].v, after[i].v).dot(after[i].x - before[i].x);
    for (const Thrust& t : scene_.thrusts)
        last_work_ += t.force.dot(after[at(t.body)].x - before[at(t.body)].x);
    for (const Floating& f : scene_.floating) {
        const BodyState &a = before[at(f.body)], &b = after[at(f.body)];
        last_work_ -= f.heave_c * mean(a.v, b.v).z() * (b.x.z() - a.x.z());
        const Vec3 w = mean(a.w, b.w);
        last_work_ -= f.tilt_c * h * (w.x() * w.x() + w.y() * w.y());
    }
    work_ += last_work_;

    frame_time_ += h;
    substep_time_ = h;
    for (std::size_t k = 0; k < scene_.towed.size(); ++k) {
        const std::size_t i = at(scene_.towed[k]);
        const Vec3 force =
            tow ? (*tow)[k]
                : Vec3(scene_.bodies[i].mass / h * (after[i].v - before[i].v) - loads[i].force);
        impulse_[k] += h * force;
        substep_tension_[k].push_back(force.norm());
    }
}

std::optional<double> Meter::reference_tension(std::size_t ship, double t) const {
    if (scene_.tension) return scene_.tension;
    if (ship < reference_.tension.size() && reference_.covers(t))
        return reference_.tension_at(ship, t);
    return std::nullopt;
}

void Meter::measure_tension(double t) {
    // A mean force belongs to the middle of its frame. With staggered velocities the frame reaches
    // from half a substep before its start to half a substep before its end: half a substep
    // earlier.
    const double middle = t - 0.5 * frame_time_ - (staggered_ ? 0.5 * substep_time_ : 0.0);
    if (!scene_.towed.empty()) times_.push_back(middle);
    for (std::size_t k = 0; k < scene_.towed.size(); ++k) {
        const auto ref = reference_tension(k, middle);
        const double force = impulse_[k].norm() / frame_time_;
        tensions_[k].push_back(force);
        if (ref && t - frame_time_ >= kSettle - 1e-9) {
            const double e = (force - *ref) / *ref;
            sum_e2_ += e * e;
            sum_t_ += force;
            sum_t2_ += force * force;
            sum_ref_ += *ref;
            ++count_;
            if (!(std::abs(e) <= m_.tension_worst.value_or(0.0))) m_.tension_worst = std::abs(e);
            for (const double f : substep_tension_[k]) {
                const double es = (f - *ref) / *ref;
                sum_sub2_ += es * es;
                ++count_sub_;
            }
        }
        impulse_[k].setZero();
        substep_tension_[k].clear();
    }
    frame_time_ = 0.0;
    if (count_ == 0) return;
    const double mean = sum_t_ / count_, ref = sum_ref_ / count_;
    m_.tension_error = std::sqrt(sum_e2_ / count_);
    m_.substep_ripple = std::sqrt(sum_sub2_ / count_sub_);
    m_.tension_mean = (mean - ref) / ref;
    m_.tension_ripple = std::sqrt(std::max(0.0, sum_t2_ / count_ - mean * mean)) / ref;
}

/// Measure the amplitude of the first sine mode of the cable: sqrt(q^2 + (q'/omega)^2) of its
/// displacement and velocity. It is constant if the mode is undamped.
void Meter::measure_mode(const std::vector<BodyState>& s, double t) {
    if (scene_.cable_first < 0 || t < scene_.duration - 1.0) return;
    const int n = scene_.cable_links;
    double q = 0.0, rate = 0.0;
    for (int i = 0; i < n; ++i) {
        const double shape = std::sin(std::numbers::pi * (i + 0.5) / n);
        q += 2.0 / n * shape * s[at(scene_.cable_first + i)].x.y();
        rate += 2.0 / n * shape * s[at(scene_.cable_first + i)].v.y();
    }
    mode_sum_ += std::hypot(q, rate / scene_.sine_omega) / scene_.sine;
    m_.mode_amplitude = mode_sum_ / ++mode_count_;
}

void Meter::measure_contact(const std::vector<BodyState>& s) {
    const auto worsen = [](std::optional<double>& worst, double value) {
        if (!(value <= worst.value_or(-1.0))) worst = value;
    };
    if (scene_.top >= 0) {
        const Vec3 moved = s[at(scene_.top)].x - scene_.bodies[at(scene_.top)].start.x;
        worsen(m_.drop, std::abs(moved.z()));
        worsen(m_.sideways, moved.head<2>().norm());
    }
    if (!scene_.touching) return;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const BodyShape& shape = scene_.bodies[i].shape;
        if (shape.kind != BodyShape::Kind::capsule) continue;
        const double end = shape.half_length * std::abs((s[i].q * Vec3::UnitX()).z());
        worsen(m_.sink, std::max(0.0, scene_.touching->floor - (s[i].x.z() - end - shape.radius)));
    }
}

void Meter::measure_energy(const std::vector<BodyState>& before,
                           const std::vector<BodyState>& now) {
    double work = work_;
    double e = 0.0;
    if (staggered_) {
        std::vector<BodyState> half = now;
        for (std::size_t i = 0; i < half.size(); ++i) {
            half[i].x = 0.5 * (before[i].x + now[i].x);
            half[i].q = before[i].q.slerp(0.5, now[i].q);
        }
        e = energy(half);
        work -= 0.5 * last_work_;
    } else {
        e = energy(now);
    }
    m_.finite = std::isfinite(e);
    if (scene_.touching) return;
    m_.energy_end = (e - energy_start_ - work) / scene_.energy_scale;
    if (!(std::abs(m_.energy_end) <= std::abs(m_.energy_drift))) m_.energy_drift = m_.energy_end;
}

void Meter::frame(const std::vector<BodyState>& before, const std::vector<BodyState>& now,
                  double t) {
    const double gap = largest_gap(now);
    if (!(gap <= m_.gap)) m_.gap = gap;
    measure_energy(before, now);
    measure_contact(now);

    if (scene_.block >= 0 && !reference_.block.empty() && reference_.covers(t)) {
        const double d = (now[at(scene_.block)].x - reference_.block_at(t)).norm();
        if (!(d <= m_.block_error.value_or(0.0)) || !m_.block_error) m_.block_error = d;
    }
    measure_tension(t);
    measure_mode(now, t);
    m_.finite = m_.finite && std::isfinite(gap);
}

std::string Meter::reason_unusable(int frames) const {
    if (!m_.finite) return "not finite";
    if (!(m_.gap <= kGapLimit)) return number("gap %.2g m", m_.gap);
    if (!(std::abs(m_.energy_drift) <= kEnergyLimit))
        return number("energy drift %.2g %%", 100.0 * m_.energy_drift);
    if (m_.block_error && !(*m_.block_error <= kBlockLimit))
        return number("block error %.2g m", *m_.block_error);
    if (m_.drop && !(*m_.drop <= kMovedLimit)) return number("dropped %.2g m", *m_.drop);
    if (m_.sideways && !(*m_.sideways <= kMovedLimit))
        return number("moved %.2g m sideways", *m_.sideways);
    if (count_ > 0) {
        // Divided by the samples of the whole run: the rest could at best be exact.
        const double all = (frames - kSettle / kFrame) * static_cast<double>(scene_.towed.size());
        const double rms = std::sqrt(sum_e2_ / std::max(all, static_cast<double>(count_)));
        if (!(rms <= kTensionLimit))
            return number(
                count_ < all ? "tension error of the run >= %.2g %%" : "tension error %.2g %%",
                100.0 * rms);
    }
    return {};
}

}  // namespace hawser::bench
