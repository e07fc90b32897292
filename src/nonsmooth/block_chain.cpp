// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/block_chain.h"

#include <cmath>

namespace hawser::nonsmooth {
namespace {

/// Replace a 3 × 3 matrix by its inverse, by cofactors. @return false if it is singular.
bool invert_block(double a[9]) noexcept {
    const double c0 = a[4] * a[8] - a[5] * a[7], c1 = a[5] * a[6] - a[3] * a[8],
                 c2 = a[3] * a[7] - a[4] * a[6];
    const double determinant = a[0] * c0 + a[1] * c1 + a[2] * c2;
    if (determinant == 0.0 || !std::isfinite(determinant)) return false;
    const double f = 1.0 / determinant;
    const double b[9] = {f * c0, f * (a[2] * a[7] - a[1] * a[8]), f * (a[1] * a[5] - a[2] * a[4]),
                         f * c1, f * (a[0] * a[8] - a[2] * a[6]), f * (a[2] * a[3] - a[0] * a[5]),
                         f * c2, f * (a[1] * a[6] - a[0] * a[7]), f * (a[0] * a[4] - a[1] * a[3])};
    for (int i = 0; i < 9; ++i) a[i] = b[i];
    return true;
}

/// Subtract the product a b of 3×3 matrices from c.
void subtract_product(const double a[9], const double b[9], double c[9]) noexcept {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            c[3 * i + j] -= a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
}

/// Subtract the product a x of a 3×3 matrix and a vector from y.
void subtract_block_product(const double a[9], const double x[3], double y[3]) noexcept {
    for (int i = 0; i < 3; ++i) y[i] -= a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2];
}

void apply(const double a[9], double x[3]) noexcept {
    const double y[3] = {x[0], x[1], x[2]};
    for (int i = 0; i < 3; ++i) x[i] = a[3 * i] * y[0] + a[3 * i + 1] * y[1] + a[3 * i + 2] * y[2];
}

}  // namespace

bool solve_block_chain(std::size_t n, ChainBlock* rows) noexcept {
    // Rows end as x_k + U_k x_{k+1} = y_k, with U_k in `block_behind`.
    for (std::size_t k = 0; k < n; ++k) {
        ChainBlock& row = rows[k];
        if (k > 0) {
            subtract_product(row.block_before, rows[k - 1].block_behind, row.diagonal);
            subtract_block_product(row.block_before, rows[k - 1].x, row.x);
        }
        if (!invert_block(row.diagonal)) return false;
        apply(row.diagonal, row.x);
        if (k + 1 == n) break;
        double u[9] = {};
        subtract_product(row.diagonal, row.block_behind, u);
        for (int i = 0; i < 9; ++i) row.block_behind[i] = -u[i];
    }
    for (std::size_t k = n; k-- > 0;) {
        if (k + 1 < n) subtract_block_product(rows[k].block_behind, rows[k + 1].x, rows[k].x);
        for (const double x : rows[k].x)
            if (!std::isfinite(x)) return false;
    }
    return true;
}

}  // namespace hawser::nonsmooth
