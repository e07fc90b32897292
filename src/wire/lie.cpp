// SPDX-License-Identifier: Apache-2.0
#include "wire/lie.h"

#include "wire/lifted.h"
#include "wire/root.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::wire {
namespace {

/// An element that rises by `rise_to_bottom` and pulls by h along the bottom: its horizontal reach
/// and its tension.
struct RisingElement {
    double x = 0.0, tension = 0.0;
    RisingElement(double length, double compliance, double h, double sunk) : tension(h) {
        double last = -1.0;
        for (int i = 0; i < 50 && tension != last; ++i) {
            last = tension;
            const double stretched = length + compliance * tension;
            x = std::sqrt(std::max(0.0, (stretched - sunk) * (stretched + sunk)));
            tension = x > 0.0 ? h * (stretched / x) : h;
        }
    }
};

/// Two lifted parts and the part on the bottom between them.
class LyingChain {
  public:
    LyingChain(const Chain& chain, double x, double first, double last, double friction)
        : chain_(chain),
          mirrored_(reversed(chain)),
          n_(chain.elements()),
          x_(x),
          friction_(friction),
          lifted_first_(first > 0.0),
          lifted_last_(last > 0.0),
          first_end_depth_(std::max(0.0, -first)),
          last_end_depth_(std::max(0.0, -last)),
          first_lifted_(chain_, std::max(0.0, first), last < 0.0 ? 1 : 0),
          last_lifted_(mirrored_, std::max(0.0, last), first < 0.0 ? 1 : 0),
          weight_(chain.total_weight()),
          rounding_(4.0 * rounding(chain, x)) {}

    std::optional<Plane> solve() {
        if (first_lifted_.dropped().v + last_lifted_.dropped().v > weight_ ||
            first_lifted_.elements_off_bottom() + last_lifted_.elements_off_bottom() > n_)
            return {};
        double reach = first_lifted_.dropped().lean + last_lifted_.dropped().lean;
        for (std::size_t e = first_lifted_.elements_off_bottom();
             e < n_ - last_lifted_.elements_off_bottom(); ++e)
            reach += lying_element(e, 0.0).x;
        return x_ <= reach ? shape_without_pull() : shape_with_pull();
    }

  private:
    /// Return the height by which an element rises to the bottom or descends from it [m].
    [[nodiscard]] double rise_to_bottom(std::size_t e) const {
        return e == 0 ? first_end_depth_ : e + 1 == n_ ? last_end_depth_ : 0.0;
    }
    /// Return element e on the bottom, under the horizontal force h.
    [[nodiscard]] RisingElement lying_element(std::size_t e, double h) const {
        return {chain_.length[e], chain_.compliance[e], h, rise_to_bottom(e)};
    }
    /// Append the chord and tension of an element that lies on the ground to the shape.
    void append_lying_element(Plane& out, std::size_t e, const Vec3& chord, double tension) const {
        const double up = e == 0 ? first_end_depth_ : e + 1 == n_ ? -last_end_depth_ : 0.0;
        out.chord.emplace_back(chord + up * Vec3::UnitZ());
        out.tension.push_back(tension);
    }
    void record_lying_part(Plane& out, std::size_t first, std::size_t last) const {
        // An end within rounding of the bottom is on it.
        const double digits = 1e-9 * chain_.total_length();
        out.laid_first = first == 0 && first_end_depth_ > digits ? 1 : first;
        out.laid_last = last == n_ && last_end_depth_ > digits ? n_ - 1 : last;
    }

    /// Return the shape without pull: both ends drop straight down, the part on the bottom has no
    /// tension, and an arc takes up excess length.
    Plane shape_without_pull() const {
        Plane out;
        out.slack = true;
        double lean_a = first_lifted_.dropped().lean, lean_b = last_lifted_.dropped().lean;
        const std::size_t first = first_lifted_.elements_off_bottom(),
                          end = n_ - last_lifted_.elements_off_bottom();
        const double most = first == end ? x_ : std::min(x_, lean_a + lean_b);
        if (lean_a + lean_b > 0.0) {
            const double scale = most / (lean_a + lean_b);
            lean_a *= scale;
            lean_b *= scale;
        }
        first_lifted_.write_dropped(lean_a, out.chord, out.tension);
        std::vector<double> reach;
        for (std::size_t e = first; e < end; ++e) reach.push_back(lying_element(e, 0.0).x);
        const auto lies = arc(reach, std::max(0.0, x_ - lean_a - lean_b));
        for (std::size_t e = first; e < end; ++e)
            append_lying_element(out, e, lies[e - first], 0.0);
        std::vector<Vec3> chord;
        std::vector<double> tension;
        last_lifted_.write_dropped(lean_b, chord, tension);
        append_mirrored(out, chord, tension);
        record_lying_part(out, first, end);
        return out;
    }

    static void append_mirrored(Plane& out, const std::vector<Vec3>& chord,
                                const std::vector<double>& tension) {
        for (std::size_t e = chord.size(); e-- > 0;) {
            out.chord.emplace_back(chord[e].x(), 0.0, -chord[e].z());
            out.tension.push_back(tension[e]);
        }
    }

    /// Compute the tension of elements a to n − b on the bottom, under the pull h of the lifted
    /// parts.
    std::vector<double> bottom_tensions(double h, std::size_t a, std::size_t b, double va,
                                        double vb) const {
        const std::size_t count = n_ - a - b;
        std::vector<double> out(count, h);
        if (!(friction_ > 0.0) || (!lifted_first_ && !lifted_last_)) return out;
        // Load on the bottom: the two nodes at its ends are partly lifted.
        const auto carried = [&](std::size_t node) {
            double w = chain_.weight[node];
            if (node == a && a > 0) w -= first_lifted_.pull_at(a - 1, va);
            if (node == n_ - b && b > 0) w -= last_lifted_.pull_at(b - 1, vb);
            return std::max(0.0, w);
        };
        std::vector<double> from_first(count, 0.0), from_last(count, 0.0);
        double sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) from_first[i] = sum += carried(a + i);
        sum = 0.0;
        for (std::size_t i = count; i-- > 0;) from_last[i] = sum += carried(a + i + 1);
        for (std::size_t i = 0; i < count; ++i) {
            const double bearing_load = !lifted_first_  ? from_last[i]
                                        : !lifted_last_ ? from_first[i]
                                                        : std::min(from_first[i], from_last[i]);
            out[i] = std::max(0.0, h - friction_ * bearing_load);
        }
        return out;
    }

    /// True if the lifted parts at both ends would carry more than the total weight, that is, if
    /// they overlap.
    [[nodiscard]] bool overlap(double va, double vb) const {
        return va + first_lifted_.base() + vb + last_lifted_.base() > weight_;
    }

    Growing horizontal_mismatch(double h) {
        const double va = first_lifted_.match_height(h), vb = last_lifted_.match_height(h);
        if (overlap(va, vb)) return {0.0, 0.0, true};
        const Lifted::Sums a = first_lifted_.sum_elements(h, va),
                           b = last_lifted_.sum_elements(h, vb);
        if (a.count + b.count > n_) return {0.0, 0.0, true};
        double x = a.x + b.x, slope = 0.0;
        for (const auto& s : {a, b})
            if (s.z_v > 0.0) slope += s.x_h - s.x_v * s.x_v / s.z_v;
        const auto tension = bottom_tensions(h, a.count, b.count, va, vb);
        for (std::size_t i = 0; i < tension.size(); ++i) {
            x += lying_element(a.count + i, tension[i]).x;
            if (tension[i] > 0.0) slope += chain_.compliance[a.count + i];
        }
        return {x - x_, slope, false};
    }

    std::optional<Plane> shape_with_pull() {
        const double c = std::accumulate(chain_.compliance.begin(), chain_.compliance.end(), 0.0);
        double low = 0.0;
        double high = std::max(weight_, std::max(0.0, x_ - chain_.total_length()) / c);
        if (!(high > 0.0)) high = 1e-9 * chain_.total_length() / c;
        for (int i = 0; i < 600; ++i, high *= 2.0) {
            const Growing g = horizontal_mismatch(high);
            if (g.above || g.value >= 0.0) break;
            low = high;
        }
        const double h = growing_root([&](double at) { return horizontal_mismatch(at); }, low, high,
                                      high, rounding_, true);
        // If it lifts before it spans the distance there is no root.
        if (const Growing g = horizontal_mismatch(h);
            g.above || std::abs(g.value) > 1e-9 * (x_ + chain_.s.back()))
            return {};
        const double va = first_lifted_.match_height(h), vb = last_lifted_.match_height(h);
        Plane out;
        std::vector<Vec3> chord;
        std::vector<double> tension;
        first_lifted_.write(h, va, out.chord, out.tension);
        last_lifted_.write(h, vb, chord, tension);
        const std::size_t first = out.chord.size(), end = n_ - chord.size();
        record_lying_part(out, first, end);
        const auto lies = bottom_tensions(h, first, chord.size(), va, vb);
        for (std::size_t e = first; e < end; ++e) {
            const RisingElement r = lying_element(e, lies[e - first]);
            append_lying_element(out, e, Vec3(r.x, 0.0, 0.0), r.tension);
        }
        append_mirrored(out, chord, tension);
        return out;
    }

    const Chain& chain_;
    Chain mirrored_;
    std::size_t n_;
    double x_, friction_;
    bool lifted_first_, lifted_last_;
    double first_end_depth_, last_end_depth_;  ///< Depth of the ends under the bottom [m].
    Lifted first_lifted_, last_lifted_;
    double weight_, rounding_;
};

bool floats(const Chain& chain) {
    return std::any_of(chain.weight.begin(), chain.weight.end(), [](double w) { return w < 0.0; });
}

}  // namespace

std::optional<Plane> rest_between(const Chain& chain, double x, double first, double last,
                                  double friction) {
    if (floats(chain)) return {};
    return LyingChain(chain, x, first, last, friction).solve();
}

std::optional<Plane> rest_with_free_end(const Chain& chain, double first) {
    if (floats(chain) || chain.half_last < 0.0) return {};
    Chain whole = chain;  // the free node lies like any other
    whole.weight.back() = chain.half_last;
    const Lifted side(whole, first, 0);
    if (side.elements_off_bottom() > chain.elements() || side.dropped().v > whole.total_weight())
        return {};
    Plane out;
    out.slack = true;
    side.write_dropped(side.dropped().lean, out.chord, out.tension);
    for (std::size_t e = out.chord.size(); e < chain.elements(); ++e) {
        out.chord.emplace_back(chain.length[e], 0.0, 0.0);
        out.tension.push_back(0.0);
    }
    out.laid_first = side.elements_off_bottom();
    out.laid_last = chain.elements();
    return out;
}

}  // namespace hawser::wire
