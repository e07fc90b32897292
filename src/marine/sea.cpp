// SPDX-License-Identifier: Apache-2.0
#include <hawser/sea.h>

#include "marine/checks.h"
#include "marine/field.h"
#include "marine/spectra.h"
#include "marine/wave_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hawser {

namespace marine {

base::Array<double> wave_table(std::span<const WaveComponent> waves, double depth) {
    const std::size_t padded = 8 * ((waves.size() + 7) / 8);
    base::Array<double> table(static_cast<std::size_t>(kWaveRows) * padded, 0.0);
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const WaveComponent& w = waves[i];
        const auto set = [&](WaveRow row, double value) {
            table[static_cast<std::size_t>(row) * padded + i] = value;
        };
        const double dx = std::cos(w.direction), dy = std::sin(w.direction);
        const double below = -2.0 * w.wave_number * depth;
        const double speed = -w.amplitude * w.frequency / std::expm1(below);
        set(kTurnsX, w.wave_number * dx / kTwoPi);
        set(kTurnsY, w.wave_number * dy / kTwoPi);
        set(kAmplitude, w.amplitude);
        set(kDecay, w.wave_number * std::numbers::log2e);
        set(kBottom, std::exp(below));
        set(kSpeedX, speed * dx);
        set(kSpeedY, speed * dy);
        set(kSpeedZ, speed);
        set(kRate, w.frequency);
        set(kPressure, speed * w.frequency / w.wave_number);
    }
    for (std::size_t g = 0; g < padded; g += 8) {
        double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
        for (std::size_t i = g; i < std::min(g + 8, waves.size()); ++i) {
            slowest = std::min(slowest, table[kDecay * padded + i]);
            fastest = std::max(fastest, table[kDecay * padded + i]);
        }
        table[kNothingBelow * padded + g] = -44.0 / slowest;
        table[kDeepAbove * padded + g] = std::max(27.0 / slowest - depth, -1000.0 / fastest);
    }
    return table;
}

}  // namespace marine

using marine::kTwoPi;

Sea::Sea(const SeaDef& def, double gravity)
    : depth_(def.depth),
      density_(def.density),
      gravity_(gravity),
      level_(def.level),
      current_(def.current),
      wind_(def.wind) {
    marine::check_sea(def, gravity);
    for (const WaveDef& wave : def.waves) marine::add_components(wave, depth_, gravity_, waves_);
    gusts_ = marine::gust_components(def.wind);
    make_table();
}

void Sea::make_table() {
    const auto table = marine::wave_table(waves_, depth_);
    table_.assign(table.begin(), table.end());
    padded_ = static_cast<int>(table_.size()) / marine::kWaveRows;
}

SeaInputs Sea::inputs() const noexcept {
    return {.wind = wind_.speed, .wind_direction = wind_.direction};
}

SeaMoment Sea::at(double time) const { return at(time, inputs()); }

SeaMoment Sea::at(double time, const SeaInputs& inputs) const {
    SeaMoment out;
    at(time, inputs, out);
    return out;
}

void Sea::at(double time, const SeaInputs& inputs, SeaMoment& out) const {
    out.time = time;
    out.level = tide(time) + inputs.level;
    out.waves = inputs.waves;
    out.current = inputs.current;
    out.phase.resize(static_cast<std::size_t>(padded_), 0.0);
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const double turns =
            (waves_[i].phase - std::fmod(waves_[i].frequency * time, kTwoPi)) / kTwoPi;
        out.phase[i] = turns - std::nearbyint(turns);
    }
    out.gust.resize(gusts_.size());
    if (out.gust_of != inputs.wind) {
        for (std::size_t i = 0; i < gusts_.size(); ++i)
            out.gust[i] =
                std::sqrt(2.0 * gusts_[i].width * gust_spectrum(inputs.wind, gusts_[i].frequency));
        out.gust_of = inputs.wind;
    }
    double gust = 0.0;
    for (std::size_t i = 0; i < gusts_.size(); ++i)
        gust += out.gust[i] * std::cos(kTwoPi * gusts_[i].frequency * time + gusts_[i].phase);
    out.mean_wind = inputs.wind;
    out.wind = inputs.wind + gust;
    out.wind_x = std::cos(inputs.wind_direction);
    out.wind_y = std::sin(inputs.wind_direction);
}

double Sea::tide(double time) const noexcept {
    if (level_.empty()) return 0.0;
    const auto after = std::upper_bound(level_.begin(), level_.end(), time,
                                        [](double t, const SeaLevel& l) { return t < l.time; });
    if (after == level_.begin()) return level_.front().level;
    if (after == level_.end()) return level_.back().level;
    const SeaLevel &a = *(after - 1), &b = *after;
    return a.level + (b.level - a.level) * (time - a.time) / (b.time - a.time);
}

Vec3 Sea::current(const SeaMoment& now, double z) const noexcept {
    return marine::profile_at(current_, now.level - z, [&](std::size_t i) {
        return marine::flow_of(current_[i], now.current);
    });
}

Vec3 Sea::wind(const SeaMoment& now, double z) const noexcept {
    const double height = std::max(z - now.level, 1.0);
    if (z <= now.level) return Vec3::Zero();
    const double c = 0.0573 * std::sqrt(1.0 + 0.15 * now.mean_wind);
    const double speed =
        now.mean_wind * (1.0 + c * std::log(0.1 * height)) + (now.wind - now.mean_wind);
    return {speed * now.wind_x, speed * now.wind_y, 0.0};
}

double Sea::stretched(double z, double elevation) const noexcept {
    return marine::stretched(depth_, z, elevation);
}

double Sea::elevation(const SeaMoment& now, double x, double y) const noexcept {
    if (waves_.empty() || now.waves == 0.0) return now.level;
    alignas(64) double circle[2 * kMaxWaveComponents];
    double sum = 0.0;
    marine::wave_kernels().one.surface(table_.data(), padded_, now.phase.data(), &x, &y, circle,
                                       &sum);
    return now.level + now.waves * sum;
}

WaterPoint Sea::water(const SeaMoment& now, const Vec3& point) const noexcept {
    WaterPoint out;
    out.elevation = now.level;
    const double z = point.z();
    if (!waves_.empty() && now.waves != 0.0) {
        alignas(64) double circle[2 * kMaxWaveComponents];
        double sum = 0.0;
        const marine::WaveKernel& by = marine::wave_kernels().one;
        by.surface(table_.data(), padded_, now.phase.data(), &point.x(), &point.y(), circle, &sum);
        out.elevation += now.waves * sum;
        const double still = stretched(z, out.elevation);
        marine::WaveSums s;
        by.sums(table_.data(), padded_, circle, &still, &s);
        marine::add_waves(s, now, density_, out);
    }
    out.velocity += current(now, std::min(z, now.level));
    if (z < out.elevation)
        out.pressure = density_ * gravity_ * (now.level - z) + out.dynamic_pressure;
    return out;
}

Vec3 Sea::convection(const SeaMoment& now, const Vec3& point) const noexcept {
    // Sum by components: ∂u/∂x, ∂u/∂y, ∂u/∂z of the stretched column. Too rare to need a kernel.
    Vec3 u = Vec3::Zero();
    Mat3 gradient = Mat3::Zero();
    const double z = stretched(point.z(), elevation(now, point.x(), point.y()));
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const WaveComponent& w = waves_[i];
        const double k = w.wave_number, dx = std::cos(w.direction), dy = std::sin(w.direction);
        const double theta = k * (dx * point.x() + dy * point.y()) + kTwoPi * now.phase[i];
        const double up = std::exp(k * z), down = std::exp(-k * (z + 2.0 * depth_));
        const double part = -now.waves * w.amplitude * w.frequency / std::expm1(-2.0 * k * depth_);
        const double c = part * (up + down), s = part * (up - down);
        const double along = c * std::cos(theta), steep = s * std::sin(theta);
        u += Vec3(dx * along, dy * along, steep);
        // ∂/∂x of cos θ is −k_x sin θ, ∂/∂z of C is k S.
        const double level = -k * c * std::sin(theta), slope = k * s * std::cos(theta);
        gradient(0, 0) += dx * dx * level;
        gradient(0, 1) += dx * dy * level;
        gradient(1, 1) += dy * dy * level;
        gradient(0, 2) += dx * slope;
        gradient(1, 2) += dy * slope;
        gradient(2, 2) -= level;
    }
    gradient(1, 0) = gradient(0, 1);
    gradient(2, 0) = gradient(0, 2);
    gradient(2, 1) = gradient(1, 2);
    return gradient * u;
}

double Sea::shortest_period() const noexcept {
    double highest = 0.0;
    for (const WaveComponent& w : waves_) highest = std::max(highest, w.frequency);
    return highest > 0.0 ? kTwoPi / highest : std::numeric_limits<double>::infinity();
}

}  // namespace hawser
