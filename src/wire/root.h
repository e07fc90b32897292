// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file root.h
/// Root of an increasing function.

#include <cmath>

namespace hawser::wire {

/// Value and slope of a growing function. `above` is true if the argument is too large for a value.
struct Growing {
    double value = 0.0, slope = 0.0;
    bool above = false;
};

/// Find the root of an increasing function f by Newton's method within a bracket. Each step narrows
/// the bracket. If Newton's step ends outside the bracket, the bracket is halved. The search stops
/// if |f| ≤ small, or if no floating-point number lies between the ends.
/// @param low,high  Ends of the bracket: f(low) ≤ 0 ≤ f(high).
/// @param guess     First argument, between low and high.
/// @param positive  True if arguments are ≥ 0 and may have very different magnitudes.
template <class F>
double growing_root(F&& f, double low, double high, double guess, double small, bool positive) {
    double at = guess;
    double last = high - low;  // width two steps ago: bisect if Newton does not halve it
    for (int i = 0; i < 300; ++i) {
        const Growing g = f(at);
        if (!g.above && std::abs(g.value) <= small) return at;
        (g.above || g.value > 0.0 ? high : low) = at;
        double next = g.above ? high : at - g.value / g.slope;
        const bool bracket_halves_slowly = i % 4 == 3 && high - low > 0.5 * last;
        if (i % 4 == 3) last = high - low;
        if (!(next > low && next < high) || bracket_halves_slowly) {
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
