// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/anderson.h"

#include "nonsmooth/dot.h"

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {
namespace {

/// A difference with a smaller independent part is redundant up to rounding.
constexpr double kMinIndependentPart = 1e-10;
/// Growth of the residual that clears the history.
constexpr double kMaxResidualGrowth = 100;

}  // namespace

void Anderson::reserve(std::size_t n) {
    n_ = n;
    for (std::vector<double>* a : {&x_, &image_, &f_, &last_f_, &last_image_, &weight_})
        a->resize(n);
    for (std::vector<double>* a : {&df_, &dg_, &q_}) a->resize(n * kHistoryDepth);
    restart();
}

const double* Anderson::next(double floor) noexcept {
    for (std::size_t i = 0; i < n_; ++i) {
        f_[i] = image_[i] - x_[i];
        // Use the weights of the first iteration, so that norms can be compared.
        if (count_ < 0) weight_[i] = 1.0 / (std::fabs(image_[i]) + floor);
        f_[i] *= weight_[i];
    }
    const double norm = std::sqrt(dot(f_.data(), f_.data(), n_));
    if (count_ >= 0 && norm > kMaxResidualGrowth * norm_) count_ = -1;
    if (count_ >= 0) {
        // Drop the oldest difference.
        std::rotate(df_.begin(), df_.end() - static_cast<std::ptrdiff_t>(n_), df_.end());
        std::rotate(dg_.begin(), dg_.end() - static_cast<std::ptrdiff_t>(n_), dg_.end());
        for (std::size_t i = 0; i < n_; ++i) {
            df(0)[i] = f_[i] - last_f_[i];
            dg(0)[i] = image_[i] - last_image_[i];
        }
    }
    count_ = std::min(count_ + 1, kHistoryDepth);
    norm_ = norm;
    last_f_ = f_;
    last_image_ = image_;
    // Modified Gram-Schmidt from the latest difference on; dependent ones are skipped.
    double r[kHistoryDepth][kHistoryDepth] = {}, rhs[kHistoryDepth] = {};
    int used = 0, index[kHistoryDepth];
    for (int j = 0; j < count_; ++j) {
        double* v = q(used);
        std::copy_n(df(j), n_, v);
        const double whole = std::sqrt(dot(v, v, n_));
        for (int k = 0; k < used; ++k) {
            r[k][used] = dot(q(k), v, n_);
            for (std::size_t i = 0; i < n_; ++i) v[i] -= r[k][used] * q(k)[i];
        }
        const double left = std::sqrt(dot(v, v, n_));
        if (!(left > kMinIndependentPart * whole)) continue;
        for (std::size_t i = 0; i < n_; ++i) v[i] /= left;
        r[used][used] = left;
        rhs[used] = dot(v, f_.data(), n_);
        index[used++] = j;
    }
    std::copy(image_.begin(), image_.end(), x_.begin());
    for (int k = used - 1; k >= 0; --k) {
        double gamma = rhs[k];
        for (int l = k + 1; l < used; ++l) gamma -= r[k][l] * rhs[l];
        gamma /= r[k][k];
        rhs[k] = gamma;
        for (std::size_t i = 0; i < n_; ++i) x_[i] -= gamma * dg(index[k])[i];
    }
    return x_.data();
}

}  // namespace hawser::nonsmooth
