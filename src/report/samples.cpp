// SPDX-License-Identifier: Apache-2.0
#include "report/samples.h"

#include <algorithm>
#include <cmath>

namespace hawser::report {

void Samples::add(double value) {
    max_ = count_ == 0 ? value : std::max(max_, value);
    if (count_ % every_ == 0) {
        if (kept_.size() == capacity_) {
            std::size_t n = 0;
            for (std::size_t i = 0; i < kept_.size(); i += 2) kept_[n++] = kept_[i];
            kept_.resize(n);
            every_ *= 2;
        }
        if (count_ % every_ == 0) kept_.push_back(value);
    }
    ++count_;
}

double Samples::quantile(double q) const {
    if (kept_.empty()) return 0.0;
    std::vector<double> sorted = kept_;
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
