// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/tridiagonal.h"

namespace hawser::nonsmooth {
namespace {

/// Return the entry of M between rows k and k + 1 of n; 0 after the last one.
double off_diagonal(std::size_t n, const ChainRow* rows, std::size_t k) noexcept {
    return k + 1 < n ? rows[k].next : 0.0;
}

/// Return component k of M z₀: tridiagonal matrix M, start vector z₀.
double start_product(std::size_t n, const ChainRow* rows, std::size_t k) noexcept {
    double sum = rows[k].diagonal * rows[k].start;
    if (k > 0) sum += rows[k - 1].next * rows[k - 1].start;
    if (k + 1 < n) sum += rows[k].next * rows[k + 1].start;
    return sum;
}

/// Solve w = 0 for the multipliers z of active rows, with z = 0 in all others.
void solve_active(std::size_t n, ChainRow* rows) noexcept {
    for (std::size_t k = 0; k < n; ++k) {
        ChainRow& row = rows[k];
        row.z = 0.0;
        if (!row.active) continue;
        row.pivot = row.diagonal;
        row.reduced = start_product(n, rows, k) - row.residual;
        if (k == 0 || !rows[k - 1].active) continue;
        const ChainRow& before = rows[k - 1];
        const double factor = before.next / before.pivot;
        row.pivot -= factor * before.next;
        row.reduced -= factor * before.reduced;
    }
    for (std::size_t k = n; k-- > 0;) {
        ChainRow& row = rows[k];
        if (!row.active) continue;
        const double behind = k + 1 < n ? rows[k + 1].z : 0.0;
        row.z = (row.reduced - off_diagonal(n, rows, k) * behind) / row.pivot;
    }
}

/// True if the row is in the wrong set: its multiplier or speed has the wrong sign.
bool row_in_wrong_set(std::size_t n, const ChainRow* rows, std::size_t k) noexcept {
    const ChainRow& row = rows[k];
    if (row.fixed) return false;
    if (row.active) return !(row.z > 0.0);
    double w = row.residual - start_product(n, rows, k);
    if (k > 0) w += rows[k - 1].next * rows[k - 1].z;
    if (k + 1 < n) w += row.next * rows[k + 1].z;
    return w < 0.0;
}

}  // namespace

bool solve_chain(std::size_t n, ChainRow* rows) noexcept {
    for (std::size_t k = 0; k < n; ++k) rows[k].active = rows[k].active && !rows[k].fixed;
    for (std::size_t sweep = 0; sweep < 4 * n + 8; ++sweep) {
        solve_active(n, rows);
        bool any_switched = false;
        for (std::size_t k = 0; k < n; ++k) {
            if (!row_in_wrong_set(n, rows, k)) continue;
            any_switched = true;
            rows[k].active = !rows[k].active;
            if (sweep >= 2 * n) break;
        }
        if (!any_switched) return true;
    }
    return false;
}

}  // namespace hawser::nonsmooth
