// SPDX-License-Identifier: Apache-2.0
#include "wire/lifted.h"

#include "wire/root.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {

Lifted::Sums Lifted::sum_elements(double h, double v) const {
    Sums out;
    for (std::size_t e = 0; e < chain_.elements(); ++e) {
        const double up = v + pull_change_[e];
        if (!(up > 0.0)) break;
        const Pulled p = stretched_element(chain_.length[e], chain_.compliance[e], h, up);
        out.z += p.z;
        out.x += p.x;
        out.x_h += p.x_h;
        out.x_v += p.x_v;
        out.z_v += p.z_v;
        ++out.count;
    }
    return out;
}

double Lifted::match_height(double h) {
    if (!(height_ > 0.0)) return v_ = -base_;
    double low = -base_, high = std::max(v_, drop_.v - base_);
    for (double step = 1e-3 * (base_ + h); sum_elements(h, high).z < height_; step *= 4.0) {
        low = high;
        high += step;
    }
    v_ = growing_root(
        [&](double v) {
            const Sums s = sum_elements(h, v);
            return Growing{s.z - height_, s.z_v};
        },
        low, high, std::clamp(v_, low, high), rounding_, false);
    return v_;
}

void Lifted::write_dropped(double lean, std::vector<Vec3>& chord,
                           std::vector<double>& tension) const {
    double v = drop_.v;
    for (std::size_t e = 0; e < drop_.hanging; ++e) {
        v -= chain_.weight[e];
        const double pull = std::max(0.0, v);
        chord.emplace_back(0.0, 0.0, -chain_.length[e] - chain_.compliance[e] * pull);
        tension.push_back(pull);
    }
    for (std::size_t e = drop_.hanging; e < elements_off_bottom(); ++e) {
        chord.emplace_back(chain_.length[e] / drop_.slack * Vec3(lean, 0.0, -drop_.rise));
        tension.push_back(0.0);
    }
}

void Lifted::write(double h, double v, std::vector<Vec3>& chord,
                   std::vector<double>& tension) const {
    for (std::size_t e = 0; e < chain_.elements(); ++e) {
        const double up = v + pull_change_[e];
        if (!(up > 0.0)) break;
        const Pulled p = stretched_element(chain_.length[e], chain_.compliance[e], h, up);
        chord.emplace_back(p.x, 0.0, -p.z);
        tension.push_back(p.tension);
    }
}

void Lifted::drop() {
    double hanging = 0.0;     // stretched length of the hanging elements
    double compliance = 0.0;  // their compliance
    if (!(height_ > 0.0)) return;
    std::size_t m = 0;
    while (m < max_lifted_) {
        // With v = Σ weights down to node m, the elements from there to the next weight have no
        // pull, and those above hang.
        double slack = 0.0, soft = 0.0;
        std::size_t next = m;
        do {
            slack += chain_.length[next];
            soft += chain_.compliance[next++];
        } while (next < max_lifted_ && !(chain_.weight[next] > 0.0));
        if (height_ <= hanging + slack) {
            drop_.rise = height_ - hanging;
            drop_.leaning = next - m;
            drop_.slack = slack;
            drop_.lean = std::sqrt(std::max(0.0, (slack - drop_.rise) * (slack + drop_.rise)));
            break;
        }
        // They hang as well, with all or part of that weight.
        hanging += slack;
        compliance += soft;
        m = next;
        const double stretched = hanging + chain_.weight[m] * compliance;
        if (height_ <= stretched || m == max_lifted_) {
            drop_.v += (height_ - hanging) / compliance;
            break;
        }
        hanging = stretched;
        drop_.v += chain_.weight[m];
    }
    drop_.hanging = m;
}

void Lifted::count_from_below() {
    double sum = 0.0;
    for (std::size_t e = 0; e < chain_.elements(); ++e) {
        pull_change_.push_back(sum -= chain_.weight[e]);
        if (e == drop_.hanging && height_ > 0.0) base_ = -sum;
    }
    for (double& f : pull_change_) f += base_;
    v_ = drop_.v - base_;
}

}  // namespace hawser::wire
