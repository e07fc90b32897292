// SPDX-License-Identifier: Apache-2.0
#include "wire/hang.h"

#include "wire/root.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::wire {
namespace {

struct Sums {
    double x = 0.0, z = 0.0, x_h = 0.0, x_v = 0.0, z_v = 0.0;
};

/// Solves for the position of the last end of one chain.
class Hanging {
  public:
    Hanging(const Chain& chain, double x, double z)
        : chain_(chain),
          x_(x),
          z_(z),
          rounding_(rounding(chain, std::hypot(x, z))),
          compliance_(std::accumulate(chain.compliance.begin(), chain.compliance.end(), 0.0)) {
        double v = 0.0;
        for (std::size_t e = 0; e < chain.elements(); ++e) {
            rise_.push_back(v += chain.weight[e]);
            lower_bound_ = std::min(lower_bound_, v);
            upper_bound_ = std::max(upper_bound_, v);
        }
        const double stretch = std::hypot(x, z) - chain.total_length();
        force_ = upper_bound_ - lower_bound_ + std::max(stretch, 0.0) / compliance_;
        if (!(force_ > 0.0)) force_ = 1e-9 * chain.total_length() / compliance_;
    }

    Plane solve() {
        vertical_pull_ = -0.5 * (upper_bound_ + lower_bound_);
        match_rise(0.0);
        measure_from_fold();
        const Plane still = without_pull();
        if (done_) return still;
        return with_pull();
    }

  private:
    Sums sum_elements(double h, double v) const {
        Sums out;
        for (std::size_t e = 0; e < chain_.elements(); ++e) {
            const Pulled p =
                stretched_element(chain_.length[e], chain_.compliance[e], h, v + rise_[e]);
            out.x += p.x;
            out.z += p.z;
            out.x_h += p.x_h;
            out.x_v += p.x_v;
            out.z_v += p.z_v;
        }
        return out;
    }

    /// Measure vertical pulls from the element nearest to a fold of the chain. Near a fold the last
    /// digits of the pull are decisive. They would be lost if pulls were measured from the first
    /// element.
    void measure_from_fold() {
        const auto nearest = std::min_element(rise_.begin(), rise_.end(), [&](double a, double b) {
            return std::abs(vertical_pull_ + a) < std::abs(vertical_pull_ + b);
        });
        const double base = *nearest;
        for (double& r : rise_) r -= base;
        vertical_pull_ += base;
    }

    /// Find the vertical pull, measured as measure_from_fold() defines it, that gives the required
    /// rise. The rise increases with the pull.
    double match_rise(double h) {
        double step = force_;
        double low = vertical_pull_ - step, high = vertical_pull_ + step;
        for (; sum_elements(h, low).z > z_; step *= 4.0) low -= step;
        for (step = force_; sum_elements(h, high).z < z_; step *= 4.0) high += step;
        vertical_pull_ = growing_root(
            [&](double v) {
                const Sums s = sum_elements(h, v);
                return Growing{s.z - z_, s.z_v};
            },
            low, high, vertical_pull_, rounding_, false);
        return vertical_pull_;
    }

    /// Return the shape without horizontal pull. All elements are vertical; slack elements incline
    /// as far as needed to reach the last end. Valid if the end is within this reach.
    Plane without_pull() {
        Plane out;
        const double v0 = match_rise(0.0);
        const double none = 1e-13 * force_;
        double slack = 0.0, rise = z_;
        for (std::size_t e = 0; e < chain_.elements(); ++e) {
            const double v = v0 + rise_[e];
            Pulled p = stretched_element(chain_.length[e], chain_.compliance[e], 0.0, v);
            if (std::abs(v) <= none) {
                p = {};
                slack += chain_.length[e];
            }
            out.chord.emplace_back(0.0, 0.0, p.z);
            out.tension.push_back(p.tension);
            rise -= p.z;
        }
        done_ = x_ <= 0.0 || x_ * x_ + rise * rise <= slack * slack;
        if (!done_ || !(slack > 0.0)) return out;
        out.slack = true;
        for (std::size_t e = 0; e < chain_.elements(); ++e)
            if (out.tension[e] == 0.0)
                out.chord[e] = chain_.length[e] / slack * Vec3(x_, 0.0, rise);
        return out;
    }

    Plane with_pull() {
        const auto miss = [&](double h) {
            const Sums s = sum_elements(h, match_rise(h));
            return Growing{s.x - x_, s.x_h - s.x_v * s.x_v / s.z_v};
        };
        double low = 0.0, high = force_;
        for (; miss(high).value < 0.0; high *= 4.0) low = high;
        const double h = growing_root(miss, low, high, high, 4.0 * rounding_, true);
        const double v = match_rise(h);
        Plane out;
        for (std::size_t e = 0; e < chain_.elements(); ++e) {
            const Pulled p =
                stretched_element(chain_.length[e], chain_.compliance[e], h, v + rise_[e]);
            out.chord.emplace_back(p.x, 0.0, p.z);
            out.tension.push_back(p.tension);
        }
        return out;
    }

    const Chain& chain_;
    double x_, z_, rounding_, compliance_;
    std::vector<double> rise_;  ///< Σ w up to each element, from a base element [N].
    double lower_bound_ = 0.0,
           upper_bound_ = 0.0;    ///< Bounds of the sum from the first element [N].
    double force_ = 0.0;          ///< Scale of its pulls [N].
    double vertical_pull_ = 0.0;  ///< Last vertical pull found, the start of the next search.
    bool done_ = false;
};

}  // namespace

Plane hang_between(const Chain& chain, double x, double z) { return Hanging(chain, x, z).solve(); }

Plane hang_down(const Chain& chain) {
    Plane out;
    const std::size_t n = chain.elements();
    out.chord.resize(n);
    out.tension.resize(n);
    double v = -chain.half_last;
    for (std::size_t e = n; e-- > 0;) {
        const Pulled p = stretched_element(chain.length[e], chain.compliance[e], 0.0, v);
        out.slack = out.slack || !(p.tension > 0.0);
        out.chord[e] = p.tension > 0.0 ? Vec3(0.0, 0.0, p.z) : Vec3(0.0, 0.0, -chain.length[e]);
        out.tension[e] = p.tension;
        v -= chain.weight[e];
    }
    return out;
}

}  // namespace hawser::wire
