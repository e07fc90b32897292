// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/gmres.h"

#include "base/index.h"
#include "nonsmooth/dot.h"

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {
void Gmres::reserve(std::size_t n, int iterations) {
    limit_ = iterations;
    if (basis_.size() < n * at(iterations + 1)) basis_.resize(n * at(iterations + 1));
    h_.resize(at((iterations + 1) * iterations));
    cosine_.resize(at(iterations));
    sine_.resize(at(iterations));
    g_.resize(at(iterations + 1));
}

void Gmres::start(std::size_t n, const double* b) noexcept {
    n_ = n;
    count_ = 0;
    norm_ = std::sqrt(dot(b, b, n));
    const double inverse = norm_ > 0.0 ? 1.0 / norm_ : 0.0;
    double* v = basis(0);
    for (std::size_t i = 0; i < n; ++i) v[i] = inverse * b[i];
    g_[0] = norm_;
}

double Gmres::take() noexcept {
    const int k = count_;
    double* w = basis(k + 1);
    for (int j = 0; j <= k; ++j) {
        const double* v = basis(j);
        const double c = dot(w, v, n_);
        h(j, k) = c;
        for (std::size_t i = 0; i < n_; ++i) w[i] -= c * v[i];
    }
    const double length = std::sqrt(dot(w, w, n_));
    if (length > 0.0)
        for (std::size_t i = 0; i < n_; ++i) w[i] /= length;
    for (int j = 0; j < k; ++j) {
        const double p = h(j, k), q = h(j + 1, k);
        h(j, k) = cosine_[at(j)] * p + sine_[at(j)] * q;
        h(j + 1, k) = cosine_[at(j)] * q - sine_[at(j)] * p;
    }
    const double radius = std::hypot(h(k, k), length);
    cosine_[at(k)] = radius > 0.0 ? h(k, k) / radius : 1.0;
    sine_[at(k)] = radius > 0.0 ? length / radius : 0.0;
    h(k, k) = radius;
    g_[at(k + 1)] = -sine_[at(k)] * g_[at(k)];
    g_[at(k)] *= cosine_[at(k)];
    ++count_;
    return norm_ > 0.0 ? std::fabs(g_[at(k + 1)]) / norm_ : 0.0;
}

void Gmres::solution(double* x) noexcept {
    std::fill_n(x, n_, 0.0);
    // Back substitution in place: g becomes the coefficients.
    for (int k = count_; k-- > 0;) {
        for (int j = k + 1; j < count_; ++j) g_[at(k)] -= h(k, j) * g_[at(j)];
        g_[at(k)] = h(k, k) != 0.0 ? g_[at(k)] / h(k, k) : 0.0;
    }
    for (int k = 0; k < count_; ++k) {
        const double* v = basis(k);
        for (std::size_t i = 0; i < n_; ++i) x[i] += g_[at(k)] * v[i];
    }
}

}  // namespace hawser::nonsmooth
