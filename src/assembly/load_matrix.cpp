// SPDX-License-Identifier: Apache-2.0
#include "assembly/load_matrix.h"

#include <hawser/system.h>

#include "base/index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::assembly {

/// Most bodies with loads are point masses. Therefore each function is compiled for three rows and
/// for any number, with the same operations in the same order.
#define HAWSER_ROWS [[gnu::always_inline]] inline

namespace {

HAWSER_ROWS double product_of(const double* s, int n, const double* u, const double* v) noexcept {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i; ++j, ++s) sum += *s * (u[i] * v[j] + u[j] * v[i]);
        sum += *s++ * u[i] * v[i];
    }
    return sum;
}

HAWSER_ROWS void add_product_of(const double* s, int n, double factor, const double* v,
                                double* out) noexcept {
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i; ++j, ++s) {
            out[i] += factor * *s * v[j];
            out[j] += factor * *s * v[i];
        }
        out[i] += factor * *s++ * v[i];
    }
}

constexpr double kMaxEntry = 1e300, kRounding = 1e-14,
                 kMaxOffDiagonal = 2e-7;    // kMaxOffDiagonal ≥ √kRounding
constexpr double kUnderflowFloor = 1e-290;  // ≫ smallest normal number/kRounding

HAWSER_ROWS bool semidefinite_of(const double* m, int n) noexcept {
    if (std::all_of(m, m + entries_of(n), [](double x) { return x == 0.0; })) return true;
    double scale[6], d[6], low[21];
    for (int i = 0; i < n; ++i) {
        const double own = m[triangle(i, i)];
        if (!(own >= 0.0 && own <= kMaxEntry)) return false;
        scale[i] = own > 0.0 ? 1.0 / std::sqrt(own) : 0.0;
    }
    for (int j = 0; j < n; ++j) {
        double pivot = scale[j] > 0.0 ? 1.0 : 0.0;
        for (int k = 0; k < j; ++k) pivot -= low[triangle(j, k)] * low[triangle(j, k)] * d[k];
        if (!(pivot >= -kRounding)) return false;
        d[j] = pivot > kRounding ? pivot : 0.0;
        for (int i = j + 1; i < n; ++i) {
            const double entry = m[triangle(i, j)];
            if ((scale[i] == 0.0 || scale[j] == 0.0) && !(entry == 0.0)) return false;
            double c = entry * scale[i] * scale[j];
            for (int k = 0; k < j; ++k) c -= low[triangle(i, k)] * low[triangle(j, k)] * d[k];
            if (d[j] == 0.0 && !(std::fabs(c) <= kMaxOffDiagonal)) return false;
            low[triangle(i, j)] = d[j] > 0.0 ? c / d[j] : 0.0;
        }
    }
    return true;
}

/// Factorise with the largest pivot first, which limits the growth of rounding errors to a small
/// factor. In the order of the rows, a small pivot d would cause errors of 1e-16/d in later pivots.
/// Example: E − t tᵀ, the added mass of a straight piece of wire. Its last pivot is 0. For a wire
/// nearly in a plane of two axes it would be −1e-12.
///
/// Squares below the smallest normal number lose digits. For t = (1, 1e-160, 0) the diagonal entry
/// 1e-320 has four digits, and its off-diagonal neighbour all of them. Therefore `floor` is added
/// to the diagonal. It is too small to change a sum with any mass.
bool semidefinite_by_pivots(const double* m, int n) noexcept {
    double a[6][6], scale[6], largest = 1.0;
    for (int i = 0; i < n; ++i) largest = std::max(largest, m[triangle(i, i)]);
    const double floor = kUnderflowFloor * largest;
    for (int i = 0; i < n; ++i) scale[i] = 1.0 / std::sqrt(m[triangle(i, i)] + floor);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j)
            a[i][j] = a[j][i] = i == j ? 1.0 : m[triangle(i, j)] * scale[i] * scale[j];
    for (int k = 0; k < n; ++k) {
        int most = k;
        for (int i = k + 1; i < n; ++i)
            if (a[i][i] > a[most][most]) most = i;
        for (int i = 0; i < n; ++i) std::swap(a[k][i], a[most][i]);
        for (int i = 0; i < n; ++i) std::swap(a[i][k], a[i][most]);
        const double pivot = a[k][k];
        for (int i = k; i < n && pivot <= kRounding; ++i)
            for (int j = k; j < n; ++j)
                if (i == j ? !(a[i][i] >= -kRounding) : !(std::fabs(a[i][j]) <= kMaxOffDiagonal))
                    return false;
        if (pivot <= kRounding) return true;
        for (int i = k + 1; i < n; ++i)
            for (int j = k + 1; j < n; ++j) a[i][j] -= a[i][k] / pivot * a[k][j];
    }
    return true;
}

HAWSER_ROWS void factor_of(double* m, int n) noexcept {
    for (int j = 0; j < n; ++j) {
        double pivot = m[triangle(j, j)];
        for (int k = 0; k < j; ++k) pivot -= m[triangle(j, k)] * m[triangle(j, k)];
        m[triangle(j, j)] = std::sqrt(pivot);
        for (int i = j + 1; i < n; ++i) {
            double c = m[triangle(i, j)];
            for (int k = 0; k < j; ++k) c -= m[triangle(i, k)] * m[triangle(j, k)];
            m[triangle(i, j)] = c / m[triangle(j, j)];
        }
    }
}

HAWSER_ROWS void solve_of(const double* low, int n, double* x) noexcept {
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < i; ++k) x[i] -= low[triangle(i, k)] * x[k];
        x[i] /= low[triangle(i, i)];
    }
    for (int i = n - 1; i >= 0; --i) {
        for (int k = i + 1; k < n; ++k) x[i] -= low[triangle(k, i)] * x[k];
        x[i] /= low[triangle(i, i)];
    }
}

HAWSER_ROWS double trace_of(double* m, const double* s, int n) noexcept {
    factor_of(m, n);
    double sum = 0.0;
    for (int c = 0; c < n; ++c) {
        double x[6] = {};
        x[c] = 1.0;
        solve_of(m, n, x);
        for (int i = 0; i < n; ++i) sum += x[i] * s[i >= c ? triangle(i, c) : triangle(c, i)];
    }
    return sum;
}

/// Return tr M⁻¹ S of three rows: with M = L D Lᵀ and the rows r of L⁻¹, the sum of rᵀ S r over the
/// pivots. It has three divisions, and no negative terms if S is positive semi-definite.
double trace_of_three(double* m, const double* s) noexcept {
    const double a = 1.0 / m[0], l10 = m[1] * a, l20 = m[3] * a;
    const double b = 1.0 / (m[2] - l10 * m[1]), under = m[4] - l20 * m[1], l21 = under * b;
    const double c = 1.0 / (m[5] - l20 * m[3] - l21 * under);
    const double x = l10 * l21 - l20;
    const double second = s[2] - l10 * (2.0 * s[1] - l10 * s[0]);
    const double third =
        s[5] + x * (2.0 * s[3] + x * s[0]) + l21 * (l21 * s[2] - 2.0 * s[4] - 2.0 * x * s[1]);
    return a * s[0] + b * second + c * third;
}

/// True if the leading minors of three rows show that a matrix is positive definite, with pivots
/// above kRounding of the diagonal. The test needs no division. If the result is false, the matrix
/// may still be positive definite.
bool plainly_definite(const double* m) noexcept {
    constexpr double kSmallestMinor = 1e-90,
                     kLargestMinor = 1e90;  // products of three entries stay normal numbers
    const double a = m[0], b = m[1], c = m[2], d = m[3], e = m[4], f = m[5];
    for (const double own : {a, c, f})
        if (!(own >= kSmallestMinor && own <= kLargestMinor)) return false;
    const double ac = a * c, two = ac - b * b;
    if (!(two >= 1e-6 * ac && d * d <= a * f && e * e <= c * f)) return false;
    return two * f + d * (2.0 * b * e - c * d) - a * e * e >= 1e-9 * ac * f;
}

}  // namespace

#undef HAWSER_ROWS

double product(const double* s, int n, const double* u, const double* v) noexcept {
    return n == 3 ? product_of(s, 3, u, v) : product_of(s, n, u, v);
}
void add_product(const double* s, int n, double factor, const double* v, double* out) noexcept {
    if (n == 3) return add_product_of(s, 3, factor, v, out);
    add_product_of(s, n, factor, v, out);
}
bool semidefinite(const double* m, int n) noexcept {
    if (n == 3 && plainly_definite(m)) return true;
    const bool plainly = n == 3 ? semidefinite_of(m, 3) : semidefinite_of(m, n);
    if (plainly || !std::all_of(m, m + entries_of(n), [](double x) { return std::isfinite(x); }))
        return plainly;
    for (int i = 0; i < n; ++i)
        if (!(m[triangle(i, i)] >= 0.0 && m[triangle(i, i)] <= kMaxEntry)) return false;
    return semidefinite_by_pivots(m, n);
}
void factor_triangle(double* m, int n) noexcept {
    if (n == 3) return factor_of(m, 3);
    factor_of(m, n);
}
void solve_triangle(const double* low, int n, double* x) noexcept {
    if (n == 3) return solve_of(low, 3, x);
    solve_of(low, n, x);
}
double trace_over(double* m, const double* s, int n) noexcept {
    return n == 3 ? trace_of_three(m, s) : trace_of(m, s, n);
}

void mass_matrix(const model::Bodies& b, std::int32_t body, int n, double* out) noexcept {
    std::fill_n(out, entries_of(n), 0.0);
    for (int i = 0; i < std::min(n, 3); ++i) out[triangle(i, i)] = b.mass[at(body)];
    if (n < 6) return;
    const double *r = &b.r[9 * at(body)], *inertia = &b.inertia[9 * at(body)];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) sum += r[3 * i + k] * inertia[3 * k + l] * r[3 * j + l];
            out[triangle(3 + i, 3 + j)] = sum;
        }
}

}  // namespace hawser::assembly
