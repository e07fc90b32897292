#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Implement the time stepper for a pendulum independently, in thirty lines.

The pendulum of 1 m, 1 kg is released from the horizontal. Prints its energy loss after 10 s
(scale 9.81 J) and its largest length error, for steps h and damping times n h. The rod is a
spring with a damper that no step resolves. Its row is satisfied at the end of the step
(docs/theory/joints.md). Geometric stiffness off. Standard library only.
"""

import math

G = 9.81


def pendulum(rate, n, compliance=1e-12, duration=10.0):
    h = 1.0 / rate
    upsilon = 1.0 / (1.0 + 4.0 * n)
    sigma = 4.0 * compliance * upsilon / (h * h)
    x, z, vx, vz = -1.0, 0.0, 0.0, 0.5 * h * G  # velocity at -h/2
    worst, lost = 0.0, 0.0
    for k in range(round(duration * rate)):
        length = math.hypot(x, z)
        ux, uz, g = x / length, z / length, length - 1.0
        ax, az = vx, vz - h * G
        before = length - math.hypot(x - h * vx, z - h * vz)  # d- times h
        nx, nz = vx, vz
        for _ in range(100):
            after = math.hypot(x + h * nx, z + h * nz) - length  # d+ times h
            rhs = (ux * nx + uz * nz) - after / h - 4.0 / h * upsilon * g + upsilon * before / h
            impulse = (rhs - (ux * ax + uz * az)) / (1.0 + sigma)
            last = (nx, nz)
            nx, nz = ax + ux * impulse, az + uz * impulse
            if abs(nx - last[0]) + abs(nz - last[1]) < 1e-14:
                break
        px, pz = x, z
        x, z, vx, vz = x + h * nx, z + h * nz, nx, nz
        worst = max(worst, abs(math.hypot(x, z) - 1.0))
        lost = -(0.5 * (vx * vx + vz * vz) + G * (z + pz) / 2)
    return lost, worst


if __name__ == "__main__":
    print("/// Damping time over step, energy lost after 10 s at 60 Hz and 240 Hz [J].")
    print("/// scripts/reference_spook.py.")
    print("inline constexpr std::array<std::array<double, 3>, 3> kPendulumLoss{{")
    for n in (2, 0.5, 0.0625):
        values = ", ".join(f"{pendulum(rate, n)[0]:.12g}" for rate in (60, 240))
        print(f"    {{{n}, {values}}},")
    print("}};\n")
