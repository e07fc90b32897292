// SPDX-License-Identifier: Apache-2.0
#include "report/samples.h"

#include <algorithm>
#include <cmath>

namespace hawser::report {

void Samples::add(double value) {
    max_ = count_ == 0 ? value : std::max(max_, value);
    if (count_ % sample_interval_ == 0) {
        if (samples_.size() == capacity_) {
            std::size_t n = 0;
            for (std::size_t i = 0; i < samples_.size(); i += 2) samples_[n++] = samples_[i];
            samples_.resize(n);
            sample_interval_ *= 2;
        }
        if (count_ % sample_interval_ == 0) samples_.push_back(value);
    }
    ++count_;
}

double Samples::quantile(double q) const {
    if (samples_.empty()) return 0.0;
    std::vector<double> sorted = samples_;
    const double at = std::clamp(q, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(at));
    const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(below);
    std::nth_element(sorted.begin(), nth, sorted.end());
    const double low = *nth;
    if (below + 1 >= sorted.size()) return low;
    const double high = *std::min_element(nth + 1, sorted.end());
    return low + (at - static_cast<double>(below)) * (high - low);
}

}  // namespace hawser::report
