// SPDX-License-Identifier: Apache-2.0
#include "marine/wave_force.h"

#include "marine/checks.h"
#include "marine/spectra.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace hawser::marine {
namespace {

/// Tolerance of directions beyond the ends of a table; they use the end's values [rad].
constexpr double kHeadingTolerance = 5.0 * std::numbers::pi / 180.0;

double wrapped(double angle) noexcept { return angle - kTwoPi * std::nearbyint(angle / kTwoPi); }

/// Interpolate a column of a table linearly at the frequency ω. Below the first frequency the first
/// value applies, above the last one the last value times `above`.
template <class T>
std::array<T, 6> column_at(const WaveCoefficients& c, const std::vector<T>& table, std::size_t head,
                           double omega, double above) {
    std::array<T, 6> out{};
    const auto& w = c.frequency;
    const auto after = std::upper_bound(w.begin(), w.end(), omega);
    const bool low = after == w.begin(), high = after == w.end();
    const std::size_t i = low ? 0 : static_cast<std::size_t>(after - w.begin()) - 1;
    const std::size_t j = low || high ? i : i + 1;
    const double fraction = i == j ? 0.0 : (omega - w[i]) / (w[j] - w[i]);
    const double scale = high && omega > w.back() * (1.0 + 1e-9) ? above : 1.0;
    for (int k = 0; k < 6; ++k)
        out[static_cast<std::size_t>(k)] = scale * ((1.0 - fraction) * table[c.index(head, i, k)] +
                                                    fraction * table[c.index(head, j, k)]);
    return out;
}

/// True if coefficients are those of a body symmetric to its centre plane: sway, roll and yaw
/// vanish in waves from ahead and astern.
bool is_symmetric_body(const WaveCoefficients& c, const std::vector<std::complex<double>>& table) {
    if (c.heading.size() < 2 || std::abs(c.heading.front()) > 1e-3 ||
        std::abs(c.heading.back() - std::numbers::pi) > 1e-3)
        return false;
    std::array<double, 6> all{}, ends{};
    for (std::size_t h = 0; h < c.heading.size(); ++h)
        for (std::size_t f = 0; f < c.frequency.size(); ++f)
            for (int k = 0; k < 6; ++k) {
                const auto n = static_cast<std::size_t>(k);
                const double size = std::abs(table[c.index(h, f, k)]);
                all[n] = std::max(all[n], size);
                if (h == 0 || h + 1 == c.heading.size()) ends[n] = std::max(ends[n], size);
            }
    return ends[1] <= 1e-3 * all[1] && ends[3] <= 1e-3 * all[3] && ends[5] <= 1e-3 * all[5];
}

}  // namespace

WaveForce::WaveForce(const WaterHull& def, const Sea& sea, double step, double heading) {
    force_ = def.coefficients && def.excitation != ExcitationKind::none;
    drift_ = def.coefficients && def.drift;
    follow_ = def.slow_time > 0.0 ? -std::expm1(-step / def.slow_time) : 1.0;
    if (!any()) return;
    fill(def, sea);
    for (const WaveComponent& w : sea.components())
        if (!find(w.direction - heading).known)
            throw DefError(
                "waves towards " +
                number(wrapped(w.direction - heading) * 180.0 / std::numbers::pi) +
                " degrees from ahead are not among the directions of the coefficients, " +
                number(heading_.front() * 180.0 / std::numbers::pi) + " to " +
                number(heading_.back() * 180.0 / std::numbers::pi));
}

void WaveForce::fill(const WaterHull& def, const Sea& sea) {
    const WaveCoefficients& c = *def.coefficients;
    const auto& force = def.excitation == ExcitationKind::scattering ? c.scattering : c.excitation;
    struct Column {
        double heading;
        std::size_t of;
        bool mirrored;
    };
    std::vector<Column> columns;
    const bool both = is_symmetric_body(c, force_                 ? force
                                           : c.excitation.empty() ? force
                                                                  : c.excitation);
    if (both)
        for (std::size_t h = c.heading.size(); h-- > 1;)
            if (-c.heading[h] > -std::numbers::pi + 1e-3)
                columns.push_back({-c.heading[h], h, true});
    for (std::size_t h = 0; h < c.heading.size(); ++h) columns.push_back({c.heading[h], h, false});
    if (columns.size() > 2) {  // closes the circle where no more than a gap is left
        double gap = 0.0;
        for (std::size_t i = 1; i < columns.size(); ++i)
            gap = std::max(gap, columns[i].heading - columns[i - 1].heading);
        const double next = columns.front().heading + kTwoPi;
        if (next - columns.back().heading <= 1.01 * gap && next > columns.back().heading + 1e-9)
            columns.push_back({next, columns.front().of, columns.front().mirrored});
    }
    for (const Column& column : columns) heading_.push_back(column.heading);
    table_.reserve(columns.size() * sea.components().size());
    for (const WaveComponent& w : sea.components())
        for (const Column& column : columns) {
            Entry entry;
            const auto sign = [&](int k) { return column.mirrored && k % 2 == 1 ? -1.0 : 1.0; };
            if (force_) {
                const auto x = column_at(c, force, column.of, w.frequency, 0.0);
                for (int k = 0; k < 6; ++k) {
                    entry.re[static_cast<std::size_t>(k)] =
                        sign(k) * x[static_cast<std::size_t>(k)].real();
                    entry.im[static_cast<std::size_t>(k)] =
                        sign(k) * x[static_cast<std::size_t>(k)].imag();
                }
            }
            if (drift_) {
                const auto d = column_at(c, c.drift, column.of, w.frequency, 1.0);
                // Drift forces of long waves decrease to 0 below the first frequency.
                const double low = std::min(1.0, w.frequency / c.frequency.front());
                entry.drift = {low * d[0], low * sign(1) * d[1], low * sign(5) * d[5]};
            }
            table_.push_back(entry);
        }
}

WaveForce::Spot WaveForce::find(double direction) const noexcept {
    Spot out;
    if (heading_.empty()) return out;
    double d = wrapped(direction);
    if (d < heading_.front() - kHeadingTolerance) d += kTwoPi;
    if (d > heading_.back() + kHeadingTolerance) d -= kTwoPi;
    if (d < heading_.front() - kHeadingTolerance || d > heading_.back() + kHeadingTolerance)
        return out;
    out.known = true;
    const auto after = std::upper_bound(heading_.begin(), heading_.end(), d);
    if (after == heading_.begin()) return out;
    out.low = static_cast<std::size_t>(after - heading_.begin()) - 1;
    out.high = out.low;
    if (after == heading_.end()) return out;
    out.high = out.low + 1;
    out.fraction = (d - heading_[out.low]) / (heading_[out.high] - heading_[out.low]);
    return out;
}

void WaveForce::follow(double x, double y, double heading) noexcept {
    if (!any()) return;
    std::array<double, 3> to{x, y, heading};
    if (begun_ == 0) {
        lag_.fill(to);
        begun_ = 1;
        return;
    }
    to[2] = lag_[0][2] + wrapped(heading - lag_[0][2]);
    for (auto& lag : lag_) {
        for (std::size_t k = 0; k < 3; ++k) lag[k] += follow_ * (to[k] - lag[k]);
        to = lag;
    }
}

bool WaveForce::act(const Sea& sea, const SeaMoment& now, Vec6& out) const noexcept {
    out.setZero();
    if (now.waves == 0.0) return true;
    const double x = slow(0), y = slow(1), turned = slow(2);
    const std::size_t directions = heading_.size();
    double above[6] = {}, below[6] = {};  // surge, sway, yaw: cos and sin sums of one sign of D
    const auto waves = sea.components();
    Spot spot;
    double of = std::nan("");
    for (std::size_t n = 0; n < waves.size(); ++n) {
        const WaveComponent& w = waves[n];
        if (w.direction != of) {
            spot = find(w.direction - turned);
            of = w.direction;
            if (!spot.known) return false;
        }
        const double theta =
            w.wave_number * (x * std::cos(w.direction) + y * std::sin(w.direction)) +
            kTwoPi * now.phase[n];
        const double a = now.waves * w.amplitude;
        const double c = a * std::cos(theta), s = a * std::sin(theta);
        const Entry& p = table_[n * directions + spot.low];
        const Entry& q = table_[n * directions + spot.high];
        const auto mix = [&](double first, double second) {
            return first + spot.fraction * (second - first);
        };
        if (force_)
            for (std::size_t k = 0; k < 6; ++k)
                out[static_cast<Eigen::Index>(k)] +=
                    mix(p.re[k], q.re[k]) * c - mix(p.im[k], q.im[k]) * s;
        if (!drift_) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = mix(p.drift[k], q.drift[k]), root = std::sqrt(std::abs(d));
            double* const sum = d > 0.0 ? above : below;
            sum[2 * k] += root * c;
            sum[2 * k + 1] += root * s;
        }
    }
    constexpr int kDriftMotions[] = {0, 1, 5};
    if (drift_)
        for (int k = 0; k < 3; ++k)
            out[kDriftMotions[k]] +=
                above[2 * k] * above[2 * k] + above[2 * k + 1] * above[2 * k + 1] -
                below[2 * k] * below[2 * k] - below[2 * k + 1] * below[2 * k + 1];
    return true;
}

void WaveForce::visit_state(StateVisitor& v) {
    if (!any()) return;
    v.visit(begun_);
    for (auto& lag : lag_) v.visit(std::span<double>(lag));
}

void WaveForce::check_state(StateRules& rules) const {
    if (!any()) return;
    constexpr double kMaxCoordinate = 1e15, kMaxTurn = 1e9;  // [m], [rad]
    rules.require(begun_ == 0 || begun_ == 1, "whether a hull's lags have begun is no flag");
    for (const auto& lag : lag_) {
        rules.range(lag[0], -kMaxCoordinate, kMaxCoordinate,
                    "the filtered position of a hull is out of range");
        rules.range(lag[1], -kMaxCoordinate, kMaxCoordinate,
                    "the filtered position of a hull is out of range");
        rules.range(lag[2], -kMaxTurn, kMaxTurn, "the slow heading of a hull is out of range");
    }
}

void WaveForce::write_memory(HullMemory& out) const {
    for (std::size_t i = 0; i < 4; ++i) out.lag[i] = lag_[i];
}

}  // namespace hawser::marine
