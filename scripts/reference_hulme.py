#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compute added mass and damping of a half-immersed sphere that heaves in deep water.

Source: A. Hulme, "The wave forces acting on a floating hemisphere undergoing forced periodic
oscillations", Journal of Fluid Mechanics 121 (1982). Potentials are a wave source at the centre and
wave-free ones. z points down, R across; K = omega^2/g, time as e^(-i omega t):

    phi_0 = 1/r + K F + pi i K e^(-Kz) J0(KR),   F = PV int e^(-kz) J0(kR)/(k - K) dk
    phi_n = P_2n(cos)/r^(2n+1) + K/(2n) P_2n-1(cos)/r^2n

Their sum has the normal velocity cos(theta) on the sphere, by least squares at Gauss' points. With
(d/dz + K) F = -1/r and F(R, 0) = -(pi/2) (H0 + Y0)(KR)

    F = -e^(-Kz) [(pi/2) (H0 + Y0)(KR) + int_0^z e^(Ks)/sqrt(R^2 + s^2) ds]

Prints the results, the typed table of scripts/make_sphere_decay.py, and the largest differences.
Needs numpy.
"""

import argparse
import math

import numpy as np

from make_sphere_decay import ADDED, DAMPING, KA


def bessel(x):
    """Return J0, J1, Y0, Y1 and Struve's H0, H1 by their power series (x below about 12)."""
    q = x * x / 4
    j0 = j1 = y0 = y1 = 0.0
    term, harmonic = 1.0, 0.0  # (-q)^k/(k!)^2, sum of 1/k
    for k in range(80):
        if k > 0:
            term *= -q / (k * k)
            harmonic += 1 / k
        j0 += term
        j1 += term / (k + 1)
        y0 -= term * harmonic
        y1 += term / (k + 1) * (2 * harmonic + 1 / (k + 1))
    j1 *= x / 2
    log = math.log(x / 2) + np.euler_gamma
    y0 = 2 / math.pi * (log * j0 + y0)
    y1 = 2 / math.pi * (log * j1 - 1 / x) - x / (2 * math.pi) * y1
    h0 = h1 = 0.0
    term0, term1 = 2 / math.pi * x, 2 / math.pi * x * x / 3
    for k in range(80):
        h0 += term0
        h1 += term1
        term0 *= -x * x / ((2 * k + 3) ** 2)
        term1 *= -x * x / ((2 * k + 3) * (2 * k + 5))
    return j0, j1, y0, y1, h0, h1


GAUSS = np.polynomial.legendre.leggauss(60)


def source(K, R, z):
    """Return phi_0 and its derivatives by R and z."""
    r = math.hypot(R, z)
    j0, j1, y0, y1, h0, h1 = bessel(K * R)
    # s = R sinh u makes the integrands smooth.
    top = math.asinh(z / R)
    u = 0.5 * top * (GAUSS[0] + 1)
    rising = np.exp(K * R * np.sinh(u)) * GAUSS[1] * 0.5 * top
    part, part_r = rising.sum(), (rising / np.cosh(u) ** 2).sum() / R
    fall = math.exp(-K * z)
    F = -fall * (math.pi / 2 * (h0 + y0) + part)
    F_R = -fall * (math.pi / 2 * K * (2 / math.pi - h1 - y1) - part_r)
    F_z = -K * F - 1 / r
    wave = 1j * math.pi * K * fall
    return (1 / r + K * F + wave * j0,
            -R / r**3 + K * F_R - wave * K * j1,
            -z / r**3 + K * F_z - wave * K * j0)


def heave(K, terms=40, points=160):
    """Return mu and lambda: A and B/omega over the mass of the displaced water, radius 1."""
    x, w = np.polynomial.legendre.leggauss(points)
    theta = math.pi / 4 * (x + 1)
    w = math.pi / 4 * w
    c, s = np.cos(theta), np.sin(theta)
    phi = np.zeros((points, terms), complex)
    slope = np.zeros((points, terms), complex)
    for i in range(points):
        value, by_R, by_z = source(K, s[i], c[i])
        phi[i, 0], slope[i, 0] = value, s[i] * by_R + c[i] * by_z
    P = np.polynomial.legendre.legvander(c, 2 * terms)
    for n in range(1, terms):
        phi[:, n] = P[:, 2 * n] + K / (2 * n) * P[:, 2 * n - 1]
        slope[:, n] = -(2 * n + 1) * P[:, 2 * n] - K * P[:, 2 * n - 1]
    root = np.sqrt(w * s)[:, None]
    size = np.abs(slope).max(axis=0)
    a = np.linalg.lstsq(slope / size * root, c * root[:, 0], rcond=None)[0] / size
    force = 2 * math.pi * (w * s * c * (phi @ a)).sum() / (2 * math.pi / 3)
    return -force.real, -force.imag


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--terms", type=int, default=40)
    terms = parser.parse_args().terms
    worst = [0.0, 0.0]
    print("   Ka     mu typed   computed    lambda typed   computed")
    for K, mu, lam in zip(KA, ADDED, DAMPING):
        got = heave(K, terms)
        worst = [max(worst[0], abs(got[0] - mu)), max(worst[1], abs(got[1] - lam))]
        print(f"{K:5.2f} {mu:12.4f} {got[0]:10.6f} {lam:15.4f} {got[1]:10.6f}")
    print(f"largest differences: {worst[0]:.1e} of mu, {worst[1]:.1e} of lambda")


if __name__ == "__main__":
    main()
