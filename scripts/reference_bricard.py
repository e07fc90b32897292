#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Corner (1, -1, 1) of Bricard's mechanism (IFToMM A04): reference positions.

Rigid bodies with rotation matrices, accelerations from the constraint equations by least
squares (one row is redundant), integrated by extrapolation at two macro steps. Needs numpy.
"""

import numpy as np

POINTS = np.array([(0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1)], float)
AXES = np.array([(0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0)], float)
CENTRES = (POINTS[:-1] + POINTS[1:]) / 2
ALONG, ACROSS = 0.01 / 6, 1.01 / 12
INERTIA = [np.diag([ALONG if abs(d) > 0.5 else ACROSS for d in b - a])
           for a, b in zip(POINTS[:-1], POINTS[1:])]
GRAVITY = np.array([0, -9.81, 0])
TIMES = (0.5, 1.0, 2.0)


def skew(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def acceleration(p, R, v, w):
    """Return accelerations of five bodies that satisfy six hinges, multipliers of least norm."""
    rows, bias = np.zeros((30, 30)), np.zeros(30)
    for j in range(6):
        axis = AXES[j]
        tangents = [np.roll(axis, 1), np.roll(axis, 2)]
        sides = []
        for body, sign in ((j - 1, -1.0), (j, 1.0)):
            if 0 <= body < 5:
                arm = R[body] @ (POINTS[j] - CENTRES[body])
                rows[5 * j:5 * j + 3, 6 * body:6 * body + 3] = sign * np.eye(3)
                rows[5 * j:5 * j + 3, 6 * body + 3:6 * body + 6] = -sign * skew(arm)
                bias[5 * j:5 * j + 3] += sign * np.cross(w[body], np.cross(w[body], arm))
                sides.append((body, R[body], w[body]))
            else:
                sides.append((None, np.eye(3), np.zeros(3)))
        (i0, r0, w0), (i1, r1, w1) = sides
        a, da = r1 @ axis, np.cross(w1, r1 @ axis)
        for k, tangent in enumerate(tangents):
            b, db, row = r0 @ tangent, np.cross(w0, r0 @ tangent), 5 * j + 3 + k
            if i0 is not None:
                rows[row, 6 * i0 + 3:6 * i0 + 6] = np.cross(b, a)
            if i1 is not None:
                rows[row, 6 * i1 + 3:6 * i1 + 6] = np.cross(a, b)
            bias[row] = np.cross(w0, db) @ a + 2 * db @ da + b @ np.cross(w1, da)
    force, inverse = np.zeros(30), np.zeros((30, 30))
    for i in range(5):
        inertia = R[i] @ INERTIA[i] @ R[i].T
        force[6 * i:6 * i + 3] = GRAVITY
        force[6 * i + 3:6 * i + 6] = -np.cross(w[i], inertia @ w[i])
        inverse[6 * i:6 * i + 3, 6 * i:6 * i + 3] = np.eye(3)
        inverse[6 * i + 3:6 * i + 6, 6 * i + 3:6 * i + 6] = np.linalg.inv(inertia)
    free = inverse @ force
    system = rows @ inverse @ rows.T
    multipliers = np.linalg.lstsq(system, -bias - rows @ free, rcond=1e-11)[0]
    return (free + inverse @ rows.T @ multipliers).reshape(5, 6)


def slope(y):
    p, R, v, w = unpack(y)
    a = acceleration(p, R, v, w)
    turn = np.array([skew(w[i]) @ R[i] for i in range(5)])
    return np.concatenate([v.ravel(), turn.ravel(), a[:, :3].ravel(), a[:, 3:].ravel()])


def unpack(y):
    return (y[:15].reshape(5, 3), y[15:60].reshape(5, 3, 3), y[60:75].reshape(5, 3),
            y[75:90].reshape(5, 3))


def gbs_step(y, step, columns=7):
    table = []
    for k in range(columns):
        n = 2 * (k + 1)
        h = step / n
        previous, current = y, y + h * slope(y)
        for _ in range(1, n):
            previous, current = current, previous + 2 * h * slope(current)
        row = [(previous + current + h * slope(current)) / 2]
        for j in range(k):
            row.append(row[j] + (row[j] - table[-1][j]) / ((n / (2 * (k - j))) ** 2 - 1))
        table.append(row)
    return table[-1][-1]


def corner(macro):
    y = np.concatenate([CENTRES.ravel(), np.tile(np.eye(3).ravel(), 5), np.zeros(30)])
    t, out = 0.0, []
    for target in TIMES:
        for _ in range(round((target - t) / macro)):
            y = gbs_step(y, macro)
        t = target
        p, R, _, _ = unpack(y)
        out.extend(p[2] + R[2] @ (POINTS[3] - CENTRES[2]))
    return np.array(out)


if __name__ == "__main__":
    a, b = corner(0.0125), corner(0.00625)
    print(f"// Times {TIMES} s; scripts/reference_bricard.py: two macro steps agree to "
          f"{np.max(np.abs(a - b)):.0e}.")
    print(f"inline constexpr std::array<double, {len(b)}> kBricardCorner{{"
          + ", ".join(f"{x:.14g}" for x in b) + "};\n")
