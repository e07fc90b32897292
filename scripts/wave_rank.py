#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Count the independent functions among the waves at neighbouring corners of a hull.

A field that is interpolated from r points has at most r independent functions. This script counts
the functions that elevation and pressure at consecutive corners need (docs/theory/waves.md, Limits).
It returns the smallest r with a small remainder at every corner: six standard deviations of it are
at most --tolerance of the significant amplitude. Phases are random. Pressure is taken at the height
of each corner at rest, raised and lowered by the elevation (--reach).

    scripts/wave_rank.py bench/scenes/frozen/parts/anchor_sea_ahts.obj
"""
import argparse

import numpy as np

GRAVITY = 9.81


def components(count, height, period, spreading, rng):
    """Return amplitudes [m], wave numbers [1/m] and directions [rad] of a JONSWAP sea, gamma 3.3."""
    peak = 2.0 * np.pi / period
    edges = np.linspace(0.5 * peak, 4.0 * peak, count + 1)
    omega = edges[:-1] + rng.random(count) * np.diff(edges)
    sigma = np.where(omega <= peak, 0.07, 0.09)
    density = omega**-5 * np.exp(-1.25 * (peak / omega) ** 4)
    density *= 3.3 ** np.exp(-((omega - peak) ** 2) / (2.0 * sigma**2 * peak**2))
    amplitude = np.sqrt(2.0 * density * np.diff(edges))
    amplitude *= np.sqrt(height**2 / 16.0 / np.sum(amplitude**2 / 2.0))
    angle = np.linspace(-np.pi, np.pi, 20001)
    fraction = np.cumsum(np.cos(angle / 2.0) ** (2.0 * spreading))
    where = (rng.permutation(count) + rng.random(count)) / count
    direction = np.pi / 6.0 + np.interp(where, fraction / fraction[-1], angle)
    return amplitude, omega**2 / GRAVITY, direction


def field(points, height, sea):
    """Return the factors of cos and sin of all components at points; height: z' of each [m]."""
    amplitude, number, direction = sea
    phase = number * (
        np.outer(points[:, 0], np.cos(direction)) + np.outer(points[:, 1], np.sin(direction))
    )
    size = amplitude * np.exp(np.outer(height, number))
    return np.concatenate([np.cos(phase) * size, np.sin(phase) * size], axis=1)


def rank(matrix, limit):
    """Return the number of functions after which each row's rest is at most `limit`."""
    left, values, _ = np.linalg.svd(matrix, full_matrices=False)
    rest = np.cumsum((left * values)[:, ::-1] ** 2, axis=1)[:, ::-1]
    below = np.nonzero(rest.max(axis=0) <= limit**2)[0]
    return int(below[0]) if below.size else values.size


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("mesh", help="OBJ file of the hull, waterline at z = 0")
    parser.add_argument("--tolerance", type=float, default=5e-6)
    parser.add_argument("--reach", type=float, default=1.5, help="change of z' either way [m]")
    parser.add_argument("--components", type=int, default=200)
    parser.add_argument("--height", type=float, default=2.5, help="significant height [m]")
    parser.add_argument("--period", type=float, default=9.0, help="peak period [s]")
    options = parser.parse_args()
    with open(options.mesh, encoding="utf-8") as file:
        lines = [line.split() for line in file if line.startswith("v ")]
    corners = np.array([[float(x) for x in line[1:4]] for line in lines])
    corners = corners[np.lexsort((corners[:, 2], corners[:, 1], corners[:, 0]))]
    sea = components(
        options.components, options.height, options.period, 10.0, np.random.default_rng(1)
    )
    # Six standard deviations over twice the standard deviation of the elevation.
    limit = options.tolerance * 2.0 * np.sqrt(np.sum(sea[0] ** 2)) / 6.0
    print("corners  elevation  elevation and pressure  wet corners")
    for count in (16, 64, 256):
        ranks, both, wet = [], [], []
        for first in range(0, len(corners) - count + 1, max(1, 3 * count)):
            part = corners[first : first + count]
            under = part[part[:, 2] < 0.0]
            rows = [field(part, np.zeros(count), sea)]
            ranks.append(rank(rows[0], limit))
            for step in np.linspace(-1.0, 1.0, 7):
                height = np.minimum(under[:, 2] + step * options.reach, 0.0)
                rows.append(field(under, height, sea))
            both.append(rank(np.concatenate(rows), limit))
            wet.append(len(under))
        print(f"{count:7d} {np.mean(ranks):10.0f} {np.mean(both):23.0f} {np.mean(wet):12.0f}")


if __name__ == "__main__":
    main()
