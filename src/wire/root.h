// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file root.h
/// Root of a function that grows.

#include <cmath>

namespace hawser::wire {

/// A value of a growing function and how fast it grows; `above` alone where it has no value: the
/// argument is too large.
struct Growing {
    double value = 0.0, slope = 0.0;
    bool above = false;
};

/// Where f, which grows, is zero: Newton's method, within a bracket that each step narrows and
/// halves where Newton leaves it. Ends where |f| ≤ small or no number is left between the ends.
/// @param low,high  f(low) ≤ 0 ≤ f(high).
/// @param guess     Between them.
/// @param positive  They are 0 or more, and may span many powers of ten.
template <class F>
double growing_root(F&& f, double low, double high, double guess, double small, bool positive) {
    double at = guess;
    double last = high - low;  // width two steps ago: Newton that does not halve it gives way
    for (int i = 0; i < 300; ++i) {
        const Growing g = f(at);
        if (!g.above && std::abs(g.value) <= small) return at;
        (g.above || g.value > 0.0 ? high : low) = at;
        double next = g.above ? high : at - g.value / g.slope;
        const bool slow = i % 4 == 3 && high - low > 0.5 * last;
        if (i % 4 == 3) last = high - low;
        if (!(next > low && next < high) || slow) {
            next = !positive || (low > 0.0 && high < 4.0 * low) ? 0.5 * (low + high)
                   : low > 0.0                                  ? std::sqrt(low) * std::sqrt(high)
                                                                : 1e-3 * high;
        }
        if (!(next > low && next < high)) return at;
        at = next;
    }
    return at;
}

}  // namespace hawser::wire
