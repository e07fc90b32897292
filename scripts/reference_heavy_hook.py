#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Independent reference trajectory of the heavy hook (S1): CSV with columns t,x,y,z of the block.

The motion is planar, so the chain has one angle per body, measured from the downward vertical:
100 links (1 m, 10 kg, solid cylinders of radius 5 cm) and a 50 t cube of 2 m joined at the middle
of a face. With a[k][i] the arm of angle i on the mass centre of body k,

    x_k = sum_i a_ki u(theta_i),   A = a' diag(m) a,
    (A*cos(theta_i - theta_j) + diag(I)) theta'' + (A*sin(theta_i - theta_j)) theta'^2
        + g (a' m) sin(theta) = 0.

No joint can open: it shares neither method nor code with the compared engines.
Integrated with the Dormand-Prince 5(4) pair, error-controlled per step (tolerance 1e-10 on every
angle [rad] and angular velocity scaled by 1 s). The script prints the energy error; run it with
two tolerances to measure the convergence of the trajectory.
"""
import argparse
import sys

import numpy as np

GRAVITY = 9.81  # [m/s2]

# Dormand and Prince 1980, "A family of embedded Runge-Kutta formulae".
STAGES = [
    [1 / 5],
    [3 / 40, 9 / 40],
    [44 / 45, -56 / 15, 32 / 9],
    [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
    [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
    [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
]
ERROR = np.array([71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])


class Chain:
    """Planar chain of rigid bodies hanging from a fixed point."""

    def __init__(self, links=100):
        n = links + 1
        length = np.ones(n)
        arm = np.full(n, 0.5)
        arm[-1] = 1.0
        self.mass = np.full(n, 10.0)
        self.mass[-1] = 50e3
        inertia = np.full(n, 10.0 * (3 * 0.05**2 + 1.0) / 12)
        inertia[-1] = 50e3 * (2.0**2 + 2.0**2) / 12
        self.a = np.tril(np.tile(length, (n, 1)), -1) + np.diag(arm)
        self.A = self.a.T @ (self.mass[:, None] * self.a)
        self.inertia = inertia
        self.weight = GRAVITY * (self.a.T @ self.mass)

    def rate(self, y):
        n = len(self.mass)
        q, w = y[:n], y[n:]
        d = q[:, None] - q[None, :]
        m = self.A * np.cos(d) + np.diag(self.inertia)
        f = -(self.A * np.sin(d)) @ (w * w) - self.weight * np.sin(q)
        return np.concatenate([w, np.linalg.solve(m, f)])

    def energy(self, y):
        n = len(self.mass)
        q, w = y[:n], y[n:]
        d = q[:, None] - q[None, :]
        m = self.A * np.cos(d) + np.diag(self.inertia)
        return 0.5 * w @ m @ w - self.weight @ np.cos(q)

    def block(self, y):
        q = y[: len(self.mass)]
        return self.a[-1] @ np.sin(q), -self.a[-1] @ np.cos(q)


def integrate(chain, y, duration, tolerance, frame, emit):
    """Advance to `duration`, landing exactly on every multiple of `frame`."""
    k1 = chain.rate(y)
    h = 1e-4
    steps = rejected = 0
    for i in range(1, round(duration / frame) + 1):
        t, end = (i - 1) * frame, i * frame
        while t < end - 1e-12:
            step = min(h, end - t)
            k = [k1]
            for row in STAGES:
                z = y + step * sum(c * kk for c, kk in zip(row, k) if c)
                k.append(chain.rate(z))
            error = np.max(np.abs(step * (ERROR @ np.array(k)))) / tolerance
            if error <= 1:
                t, y, k1 = t + step, z, k[-1]
                steps += 1
            else:
                rejected += 1
            if error > 1 or step == h:
                h = step * min(4.0, max(0.2, 0.9 * (error + 1e-12) ** -0.2))
        emit(end, y)
    return steps, rejected


def main():
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("--duration", type=float, default=10.0, help="[s]")
    p.add_argument("--tolerance", type=float, default=1e-10)
    p.add_argument("--out", default="-", help="CSV file, - for the standard output")
    args = p.parse_args()
    chain = Chain()
    n = len(chain.mass)
    y = np.concatenate([np.full(n, np.radians(20.0)), np.zeros(n)])
    e0 = chain.energy(y)
    scale = chain.weight.sum() * (1 - np.cos(np.radians(20.0)))
    worst = [0.0]
    rows = ["t,x,y,z"]

    def emit(t, state):
        x, z = chain.block(state)
        rows.append(f"{t:.9f},{x:.10f},0,{z:.10f}")
        worst[0] = max(worst[0], abs(chain.energy(state) - e0) / scale)

    emit(0.0, y)
    steps, rejected = integrate(chain, y, args.duration, args.tolerance, 1 / 60, emit)
    text = "\n".join(rows) + "\n"
    if args.out == "-":
        sys.stdout.write(text)
    else:
        with open(args.out, "w", encoding="ascii") as f:
            f.write(text)
    print(f"steps {steps}, rejected {rejected}, energy error {worst[0]:.2e}", file=sys.stderr)


if __name__ == "__main__":
    main()
