// SPDX-License-Identifier: Apache-2.0
#include "wire/rest.h"

#include "wire/band.h"
#include "wire/wet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hawser::wire {
namespace {

/// Energy, forces and Newton's method of one wire.
class Balance {
  public:
    Balance(const Chain& chain, const Plane& start, const Surroundings& around)
        : chain_(chain),
          surroundings_(around),
          n_(chain.elements()),
          moving_(around.free ? n_ : n_ - 1),
          half_elements_(2 * (n_ + 1)),
          friction_(n_ + 1, 0.0),
          band_(2 * moving_) {
        x_.resize(2 * (n_ + 1), 0.0);
        for (std::size_t e = 0; e < n_; ++e) {
            x_[2 * e + 2] = x_[2 * e] + start.chord[e].x();
            x_[2 * e + 3] = x_[2 * e + 1] + start.chord[e].z();
        }
        for (std::size_t i = 1; i <= moving_; ++i) {
            double& z = x_[2 * i + 1];
            if (surroundings_.bottom) z = std::max(z, *surroundings_.bottom);
        }
        if (start.laid_first <= start.laid_last && around.friction > 0.0)
            for (std::size_t i = std::max<std::size_t>(start.laid_first, 1);
                 i <= start.laid_last && i < n_; ++i)
                friction_[i] = start.tension[i - 1] - start.tension[i];
        friction_demand_ = friction_;
        soften_ = 1.0;
    }

    /// Find the equilibrium of the nodes.
    /// @return true if it is found to `tolerance`.
    bool solve(double tolerance) {
        // Start with soft elements, which a Newton step rotates without much stretch.
        double strain = 0.0;
        for (std::size_t e = 0; e < n_; ++e)
            strain = std::max(strain, weight() * chain_.compliance[e] / chain_.length[e]);
        for (soften_ = std::max(1.0, kInitialStrain / std::max(strain, 1e-300)); soften_ > 1.0;
             soften_ = std::max(1.0, soften_ / 30.0)) {
            update_half_forms();
            (void)minimise(1e-3 * weight());
        }
        soften_ = 1.0;
        for (int outer = 0; outer < kMaxSofteningSteps; ++outer) {
            const double change = update_half_forms() + update_bottom_friction();
            if (!minimise(tolerance)) return false;
            if (outer > 0 && change <= tolerance) return true;
        }
        return false;
    }

    [[nodiscard]] Plane shape() const {
        Plane out;
        const double none = std::numeric_limits<double>::epsilon() * chain_.total_length();
        for (std::size_t e = 0; e < n_; ++e) {
            const double dx = x_[2 * e + 2] - x_[2 * e], dz = x_[2 * e + 3] - x_[2 * e + 1];
            out.chord.emplace_back(dx, 0.0, dz);
            out.tension.push_back(
                std::max(0.0, (std::hypot(dx, dz) - chain_.length[e]) / chain_.compliance[e]));
        }
        // Report the longest contiguous part on the bottom.
        std::size_t begin = 1, most = 0;
        for (std::size_t i = 1; surroundings_.bottom && i <= moving_ + 1; ++i) {
            if (i <= moving_ && x_[2 * i + 1] <= *surroundings_.bottom + none) continue;
            if (i - begin > most) {
                most = i - begin;
                out.laid_first = begin;
                out.laid_last = i - 1;
            }
            begin = i + 1;
        }
        if (most == 0) return out;
        const double digits = 1e-9 * chain_.total_length();
        if (out.laid_first == 1 && std::abs(*surroundings_.bottom) <= digits) out.laid_first = 0;
        if (out.laid_last + 1 == n_ && !surroundings_.free &&
            std::abs(x_[2 * n_ + 1] - *surroundings_.bottom) <= digits)
            out.laid_last = n_;
        return out;
    }

  private:
    static constexpr double kInitialStrain = 1e-2;  ///< Initial strain under the whole weight.
    static constexpr int kMaxSofteningSteps = 40, kMaxNewtonSteps = 400;

    [[nodiscard]] double weight() const {
        double sum = 0.0;
        for (const double w : chain_.heavy) sum += std::abs(w);
        for (const double b : chain_.buoyancy) sum += b;
        for (std::size_t i = 1; i < n_; ++i) sum = std::max(sum, chain_.bend[i] / chain_.s.back());
        return sum;
    }
    [[nodiscard]] double air_weight(std::size_t i) const {
        return 0.5 * ((i > 0 ? chain_.heavy[i - 1] : 0.0) + (i < n_ ? chain_.heavy[i] : 0.0));
    }

    /// Update the slopes of half elements.
    /// @return the largest resulting change of a buoyancy [N].
    double update_half_forms() {
        if (!surroundings_.water) return 0.0;
        double change = 0.0;
        for (std::size_t i = 1; i <= moving_; ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                if (k == 1 && i == n_) continue;
                const std::size_t e = i - 1 + k, other = k == 0 ? i - 1 : i + 1;
                const double z = x_[2 * i + 1];
                HalfForm form =
                    half_element_form(z, 0.5 * (z + x_[2 * other + 1]), chain_.diameter[e]);
                form.lift = 0.5 * chain_.buoyancy[e];
                HalfForm& now = half_elements_[2 * i + k];
                const double depth = *surroundings_.water - z;
                change = std::max(
                    change, std::abs(form.lift * wet_fraction(depth + form.below, form.spread) -
                                     now.lift * wet_fraction(depth + now.below, now.spread)));
                now = form;
            }
        return change;
    }

    /// Update the friction of nodes on the bottom, at most the coefficient times their load on it.
    double update_bottom_friction() {
        if (!(surroundings_.friction > 0.0) || !surroundings_.bottom) return 0.0;
        std::vector<double> g(2 * (n_ + 1), 0.0);
        gradient(g);
        double change = 0.0;
        for (std::size_t i = 1; i <= moving_; ++i) {
            const bool lies = x_[2 * i + 1] <= *surroundings_.bottom;
            const double max_friction =
                lies ? surroundings_.friction * std::max(0.0, g[2 * i + 1]) : 0.0;
            const double f = std::clamp(friction_demand_[i], -max_friction, max_friction);
            change = std::max(change, std::abs(f - friction_[i]));
            friction_[i] = f;
        }
        return change;
    }

    double energy(const std::vector<double>& x) const {
        double sum = 0.0;
        for (std::size_t e = 0; e < n_; ++e) {
            const double dx = x[2 * e + 2] - x[2 * e], dz = x[2 * e + 3] - x[2 * e + 1];
            const double more = std::hypot(dx, dz) - chain_.length[e];
            if (more > 0.0) sum += 0.5 * more * more / (soften_ * chain_.compliance[e]);
        }
        for (std::size_t i = 1; i <= moving_; ++i) {
            if (i < n_ && chain_.bend[i] > 0.0)
                sum += chain_.bend[i] * (1.0 - std::cos(turning_angle(x, i)));
            const double z = x[2 * i + 1];
            sum += air_weight(i) * z - friction_[i] * x[2 * i];
            for (std::size_t k = 0; surroundings_.water && k < 2; ++k) {
                const HalfForm& h = half_elements_[2 * i + k];
                const double t = (*surroundings_.water - z + h.below) / h.spread;
                sum += h.lift * h.spread * (t <= 0.0 ? 0.0 : t >= 1.0 ? t - 0.5 : 0.5 * t * t);
            }
        }
        return sum;
    }

    static double turning_angle(const std::vector<double>& x, std::size_t i) {
        const double ax = x[2 * i] - x[2 * i - 2], az = x[2 * i + 1] - x[2 * i - 1];
        const double bx = x[2 * i + 2] - x[2 * i], bz = x[2 * i + 3] - x[2 * i + 1];
        return std::atan2(ax * bz - az * bx, ax * bx + az * bz);
    }

    /// Compute the unbalanced force with negative sign at each coordinate of all nodes.
    void gradient(std::vector<double>& g) {
        std::fill(g.begin(), g.end(), 0.0);
        for (std::size_t e = 0; e < n_; ++e) {
            const double dx = x_[2 * e + 2] - x_[2 * e], dz = x_[2 * e + 3] - x_[2 * e + 1];
            const double length = std::hypot(dx, dz), more = length - chain_.length[e];
            if (!(more > 0.0)) continue;
            const double pull = more / (soften_ * chain_.compliance[e]) / length;
            g[2 * e] -= pull * dx;
            g[2 * e + 1] -= pull * dz;
            g[2 * e + 2] += pull * dx;
            g[2 * e + 3] += pull * dz;
        }
        for (std::size_t i = 1; i <= moving_; ++i) {
            const double z = x_[2 * i + 1];
            g[2 * i] -= friction_[i];
            g[2 * i + 1] += air_weight(i);
            for (std::size_t k = 0; surroundings_.water && k < 2; ++k) {
                const HalfForm& h = half_elements_[2 * i + k];
                g[2 * i + 1] -= h.lift * wet_fraction(*surroundings_.water - z + h.below, h.spread);
            }
            if (i == n_ || !(chain_.bend[i] > 0.0)) continue;
            const BendingTerm b = bending_at(i);
            for (std::size_t k = 0; k < 6; ++k)
                g[2 * i - 2 + k] += chain_.bend[i] * b.sine * b.slope[k];
        }
    }

    /// Bend angle of a node, with gradient and second derivatives by the six coordinates.
    struct BendingTerm {
        double sine, cosine;
        std::array<double, 6> slope;
        std::array<double, 3> first, last;  ///< ∇²θ of both elements: xx, xz, zz.
    };
    [[nodiscard]] BendingTerm bending_at(std::size_t i) const {
        BendingTerm out{};
        const double ax = x_[2 * i] - x_[2 * i - 2], az = x_[2 * i + 1] - x_[2 * i - 1];
        const double bx = x_[2 * i + 2] - x_[2 * i], bz = x_[2 * i + 3] - x_[2 * i + 1];
        const double a = ax * ax + az * az, b = bx * bx + bz * bz, size = std::sqrt(a * b);
        out.sine = (ax * bz - az * bx) / size;
        out.cosine = (ax * bx + az * bz) / size;
        // θ = atan2(z, x): ∇θ = (−z, x)/d².
        out.slope = {-az / a, ax / a, az / a + bz / b, -ax / a - bx / b, -bz / b, bx / b};
        out.first = {2.0 * ax * az / (a * a), (az * az - ax * ax) / (a * a),
                     -2.0 * ax * az / (a * a)};
        out.last = {2.0 * bx * bz / (b * b), (bz * bz - bx * bx) / (b * b),
                    -2.0 * bx * bz / (b * b)};
        return out;
    }

    /// Add a block of second derivatives for the chord of two nodes.
    void add_chord(std::size_t node, double xx, double xz, double zz) {
        const double block[2][2] = {{xx, xz}, {xz, zz}};
        for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t q = 0; q < 2; ++q)
                for (std::size_t r = 0; r < 2; ++r)
                    for (std::size_t s = 0; s < 2; ++s)
                        add(2 * (node + p) + r, 2 * (node + q) + s,
                            (p == q ? 1.0 : -1.0) * block[r][s]);
    }
    /// Add to the lower triangle; skip coordinates of fixed ends.
    void add(std::size_t row, std::size_t column, double value) {
        if (row < column || column < 2 || row >= 2 * moving_ + 2) return;
        band_.at(row - 2, column - 2) += value;
    }

    void second_derivatives(double shift) {
        band_.clear();
        for (std::size_t e = 0; e < n_; ++e) {
            const double dx = x_[2 * e + 2] - x_[2 * e], dz = x_[2 * e + 3] - x_[2 * e + 1];
            const double length = std::hypot(dx, dz), more = length - chain_.length[e];
            if (!(more > 0.0)) continue;
            const double k = 1.0 / (soften_ * chain_.compliance[e]), t = k * more / length;
            const double c = dx / length, s = dz / length;
            add_chord(e, k * c * c + t * s * s, (k - t) * c * s, k * s * s + t * c * c);
        }
        for (std::size_t i = 1; i <= moving_; ++i) {
            const double z = x_[2 * i + 1];
            double stiff = shift;
            for (std::size_t k = 0; surroundings_.water && k < 2; ++k) {
                const HalfForm& h = half_elements_[2 * i + k];
                const double t = (*surroundings_.water - z + h.below) / h.spread;
                if (t > 0.0 && t < 1.0) stiff += h.lift / h.spread;
            }
            add(2 * i, 2 * i, shift);
            add(2 * i + 1, 2 * i + 1, stiff);
            if (i == n_ || !(chain_.bend[i] > 0.0)) continue;
            const BendingTerm b = bending_at(i);
            const double k = chain_.bend[i];
            for (std::size_t p = 0; p < 6; ++p)
                for (std::size_t q = 0; q <= p; ++q)
                    add(2 * i - 2 + p, 2 * i - 2 + q, k * b.cosine * b.slope[p] * b.slope[q]);
            add_chord(i - 1, -k * b.sine * b.first[0], -k * b.sine * b.first[1],
                      -k * b.sine * b.first[2]);
            add_chord(i, k * b.sine * b.last[0], k * b.sine * b.last[1], k * b.sine * b.last[2]);
        }
    }

    [[nodiscard]] bool lies_on_bottom(std::size_t coordinate, const std::vector<double>& g) const {
        return surroundings_.bottom && coordinate % 2 == 1 &&
               x_[coordinate] <= *surroundings_.bottom && g[coordinate] > 0.0;
    }
    [[nodiscard]] double largest_residual(const std::vector<double>& g) const {
        double most = 0.0;
        for (std::size_t c = 2; c < 2 * moving_ + 2; ++c)
            if (!lies_on_bottom(c, g)) most = std::max(most, std::abs(g[c]));
        return most;
    }

    /// Run Newton's method until the force at each coordinate is at most `tolerance`.
    bool minimise(double tolerance) {
        std::vector<double> g(2 * (n_ + 1), 0.0), step(2 * moving_), next;
        gradient(g);
        double now = energy(x_), force = largest_residual(g), shift = 0.0;
        double stiffest = 0.0;
        for (const double c : chain_.compliance) stiffest = std::max(stiffest, 1.0 / (soften_ * c));
        for (int k = 0; k < kMaxNewtonSteps && force > tolerance; ++k) {
            for (;;) {
                second_derivatives(shift);
                for (std::size_t c = 2; c < 2 * moving_ + 2; ++c) {
                    step[c - 2] = -g[c];
                    if (!lies_on_bottom(c, g)) continue;
                    step[c - 2] = 0.0;
                    for (std::size_t j = c >= 7 ? c - 5 : 2; j < c; ++j) band_.at(c - 2, j - 2) = 0;
                    for (std::size_t j = c + 1; j < std::min(c + 6, 2 * moving_ + 2); ++j)
                        band_.at(j - 2, c - 2) = 0;
                    band_.at(c - 2, c - 2) = 1.0;
                }
                if (band_.factor()) break;
                shift = shift > 0.0 ? 10.0 * shift : 1e-9 * stiffest;
                if (!(shift < 1e6 * stiffest)) return false;
            }
            band_.solve(step);
            double along = 0.0;
            for (std::size_t c = 0; c < step.size(); ++c) along += step[c] * g[c + 2];
            bool better = false;
            for (double part = 1.0; part > 1e-10 && !better; part *= 0.5) {
                next = x_;
                for (std::size_t c = 0; c < step.size(); ++c) {
                    next[c + 2] += part * step[c];
                    if (surroundings_.bottom && c % 2 == 1)
                        next[c + 2] = std::max(next[c + 2], *surroundings_.bottom);
                }
                const double then = energy(next);
                const double digits = 1e-14 * (std::abs(now) + weight() * chain_.s.back());
                if (then > now + 1e-4 * part * along + digits) continue;
                std::swap(x_, next);
                gradient(g);
                const double after = largest_residual(g);
                // Below the rounding of the energy the forces decide.
                if (now - then <= digits && !(after < force)) {
                    std::swap(x_, next);
                    gradient(g);
                    continue;
                }
                better = true;
                now = then;
                force = after;
                shift = part == 1.0 ? (shift > 1e-12 * stiffest ? 0.1 * shift : 0.0) : shift;
            }
            if (better) continue;
            shift = shift > 0.0 ? 10.0 * shift : 1e-9 * stiffest;
            if (!(shift < 1e6 * stiffest)) break;
        }
        return force <= tolerance;
    }

    const Chain& chain_;
    Surroundings surroundings_;
    std::size_t n_, moving_;
    std::vector<double> x_;  ///< x, z of all nodes [m].
    std::vector<HalfForm>
        half_elements_;  ///< Two per node: towards the first end, and towards the last.
    std::vector<double> friction_, friction_demand_;  ///< Along x at the nodes [N].
    double soften_ = 1.0;                             ///< Factor of compliances.
    Band band_;
};

}  // namespace

std::optional<Plane> equilibrium_near(Chain& chain, const Plane& start, const Surroundings& around,
                                      double tolerance) {
    if (chain.elements() < (around.free ? 1 : 2)) return {};
    Balance balance(chain, start, around);
    const bool found = balance.solve(tolerance);
    Plane out = balance.shape();
    if (around.water) (void)weigh_nodes(chain, wet_halves(chain, out, *around.water));
    if (!found) return {};
    return out;
}

}  // namespace hawser::wire
