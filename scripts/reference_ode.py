#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compute reference values of the pendulum-like cases by extrapolated midpoint integration.

The integrator is the Gragg-Bulirsch-Stoer method at a fixed macro step (Hairer, Norsett,
Wanner, "Solving Ordinary Differential Equations I", II.9). Values are computed at two macro
steps and printed with their difference. Standard library only.
"""

import math


def gbs_step(f, t, y, step, columns=8):
    """Perform one macro step of the extrapolated modified midpoint rule of order 2 * columns."""
    table = []
    for k in range(columns):
        n = 2 * (k + 1)
        h = step / n
        previous, current = y, [a + h * b for a, b in zip(y, f(t, y))]
        for i in range(1, n):
            slope = f(t + i * h, current)
            previous, current = current, [a + 2 * h * b for a, b in zip(previous, slope)]
        slope = f(t + step, current)
        row = [[(a + b + h * c) / 2 for a, b, c in zip(previous, current, slope)]]
        for j in range(k):
            ratio = (n / (2 * (k - j))) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[j], table[-1][j])])
        table.append(row)
    return table[-1][-1]


def integrate(f, y, times, macro):
    """Return the states at the given ascending times, starting from time 0."""
    t, out = 0.0, []
    for target in times:
        count = max(1, math.ceil((target - t) / macro - 1e-9))
        step = (target - t) / count
        for _ in range(count):
            y = gbs_step(f, t, y, step)
            t += step
        out.append(list(y))
    return out


def a01(macro):
    """Return positions of the simple pendulum of IFToMM A01 at 1, 2, 5, 10 s."""
    states = integrate(lambda t, y: [y[1], -9.81 * math.sin(y[0])], [-math.pi / 2, 0.0],
                       (1, 2, 5, 10), macro)
    return [c for s in states for c in (math.sin(s[0]), -math.cos(s[0]))]


def a02(macro, n=2):
    """Return B0 of the N-four-bar mechanism at 1, 5, 10 s; angle from the upright pose."""
    rate = ((n + 1) / 2 + n) * 9.81 / ((n + 1) / 3 + n)
    states = integrate(lambda t, y: [y[1], rate * math.sin(y[0])], [0.0, 1.0], (1, 5, 10), macro)
    return [c for s in states for c in (math.sin(s[0]), math.cos(s[0]))]


def dzhanibekov(macro):
    """Return the body-frame angular velocity at 2 s and the first zero of its middle component."""
    def f(t, w):
        return [(2 - 3) / 1 * w[1] * w[2], (3 - 1) / 2 * w[2] * w[0], (1 - 2) / 3 * w[0] * w[1]]

    state = integrate(f, [.01, 5.0, .01], (2,), macro)[0]
    low, high = 2.5, 3.0
    start = integrate(f, [.01, 5.0, .01], (low,), macro)[0]
    base = low
    for _ in range(50):
        middle = (low + high) / 2
        if integrate(f, start, (middle - base,), macro)[0][1] > 0:
            low = middle
        else:
            high = middle
    return state + [(low + high) / 2]


def report(name, function, coarse=0.04, fine=0.02):
    a, b = function(coarse), function(fine)
    spread = max(abs(x - y) for x, y in zip(a, b))
    print(f"// scripts/reference_ode.py, {function.__name__}: two macro steps agree to "
          f"{spread:.0e}.")
    values = ", ".join(f"{x:.14g}" for x in b)
    print(f"inline constexpr std::array<double, {len(b)}> {name}{{{values}}};\n")


if __name__ == "__main__":
    report("kA01", a01)
    report("kA02", a02)
    report("kDzhanibekov", dzhanibekov)
