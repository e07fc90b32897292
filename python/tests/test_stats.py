# SPDX-License-Identifier: Apache-2.0
"""Test hawser.stats against published examples, closed forms and synthetic series."""
import math
import pathlib
import sys
import unittest

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from hawser import stats  # noqa: E402


class Moments(unittest.TestCase):
    def test_sine(self):
        t = np.arange(0, 100, 0.01)
        s = stats.summary(3.0 + 2.0 * np.sin(2.0 * math.pi * t))
        self.assertAlmostEqual(s.mean, 3.0, places=9)
        self.assertAlmostEqual(s.std, 2.0 / math.sqrt(2.0), places=9)
        self.assertAlmostEqual(s.kurtosis, 1.5, places=9)  # of an arcsine distribution
        self.assertAlmostEqual(s.skewness, 0.0, places=9)

    def test_refuses(self):
        for bad in ([], [1.0, math.nan], [[1.0, 2.0]]):
            with self.assertRaises(ValueError):
                stats.summary(bad)
        self.assertTrue(math.isnan(stats.summary([2.0, 2.0]).skewness))


class UpCrossings(unittest.TestCase):
    def test_period_of_a_sine(self):
        t = np.arange(0, 50, 0.05)
        x = np.sin(2.0 * math.pi * t / 3.7 + 0.3)
        self.assertAlmostEqual(stats.up_crossing_period(x, 0.05, 0.0), 3.7, places=3)
        self.assertTrue(math.isnan(stats.up_crossing_period([0.0, 1.0, 2.0], 1.0, 5.0)))

    def test_narrow_band_process(self):
        # Rayleigh process: mean up-crossing period 2π √(m0/m2), from the spectrum of its
        # generation.
        rng = np.random.default_rng(3)
        omega = np.linspace(0.9, 1.1, 400)
        amplitude = np.exp(-0.5 * ((omega - 1.0) / 0.03)**2)
        t = np.arange(0, 40000, 0.25)
        x = np.zeros_like(t)
        for w, a, p in zip(omega, amplitude, rng.uniform(0, 2 * math.pi, omega.size)):
            x += a * np.cos(w * t + p)
        m0, m2 = np.sum(amplitude**2), np.sum((omega * amplitude)**2)
        want = 2.0 * math.pi * math.sqrt(m0 / m2)
        self.assertLess(abs(stats.up_crossing_period(x, 0.25) / want - 1.0), 0.01)
        # Peaks of a narrow-band process have Rayleigh's distribution: Weibull of shape 2.
        fit = stats.weibull(stats.peaks(x))
        self.assertLess(abs(fit.shape / 2.0 - 1.0), 0.1)


class Extremes(unittest.TestCase):
    def test_gumbel_of_synthetic_maxima(self):
        rng = np.random.default_rng(7)
        x = 100.0 - 12.0 * np.log(-np.log(rng.uniform(size=10000)))
        fit = stats.gumbel(x)
        self.assertLess(abs(fit.location / 100.0 - 1.0), 0.01)
        self.assertLess(abs(fit.scale / 12.0 - 1.0), 0.01)
        # Quantiles of equal probability: no error of sampling.
        even = (np.arange(10000) + 0.5) / 10000
        fit_even = stats.gumbel(100.0 - 12.0 * np.log(-np.log(even)))
        self.assertLess(abs(fit_even.location / 100.0 - 1.0), 1e-5)
        self.assertLess(abs(fit_even.scale / 12.0 - 1.0), 5e-4)
        true = 100.0 - 12.0 * math.log(-math.log(0.99))
        low, high = fit.interval(0.99)
        self.assertLess(low, true)
        self.assertGreater(high, true)
        self.assertLess(high - low, 0.03 * true)
        # Scale and origin: the fit of a x + b is the transformed fit of x.
        moved = stats.gumbel(1e6 * x - 5e7)
        self.assertAlmostEqual(moved.location / (1e6 * fit.location - 5e7), 1.0, places=9)

    def test_intervals_cover_as_often_as_they_say(self):
        rng = np.random.default_rng(11)
        inside = 0
        for _ in range(400):
            x = -np.log(-np.log(rng.uniform(size=60)))
            low, high = stats.gumbel(x).interval(0.9, 0.9)
            inside += low < -math.log(-math.log(0.9)) < high
        # 90 % of 400, three standard deviations of the binomial count and its small-sample bias.
        self.assertTrue(330 <= inside <= 380, inside)

    def test_weibull(self):
        rng = np.random.default_rng(5)
        x = 3.0 + 8.0 * (-np.log(rng.uniform(size=20000)))**(1.0 / 1.7)
        fit = stats.weibull(x, 3.0)
        self.assertLess(abs(fit.shape / 1.7 - 1.0), 0.02)
        self.assertLess(abs(fit.scale / 8.0 - 1.0), 0.02)
        self.assertAlmostEqual(fit.quantile(1.0 - math.exp(-1.0)), 3.0 + fit.scale, places=9)
        with self.assertRaises(ValueError):
            stats.weibull([1.0, 2.0], 1.5)

    def test_most_probable_maximum_of_a_rayleigh_process(self):
        # x_mpm = σ √(2 ln N) of a narrow-band normal process.
        rng = np.random.default_rng(2)
        omega = np.linspace(0.8, 1.2, 300)
        amplitude = np.exp(-0.5 * ((omega - 1.0) / 0.05)**2)
        t = np.arange(0, 36000, 0.3)
        x = np.zeros_like(t)
        for w, a, p in zip(omega, amplitude, rng.uniform(0, 2 * math.pi, omega.size)):
            x += a * np.cos(w * t + p)
        period = stats.up_crossing_period(x, 0.3)
        want = x.std() * math.sqrt(2.0 * math.log(3 * 3600.0 / period))
        self.assertLess(abs(stats.most_probable_maximum(x, 0.3) / want - 1.0), 0.05)


class Cycles(unittest.TestCase):
    def test_example_of_the_standard(self):
        # ASTM E1049-85, figure 6: points A to I.
        x = [-2, 1, -3, 5, -1, 3, -4, 4, -2]
        cycles = stats.rainflow(x)
        by_range = {}
        for size, _, count in cycles:
            by_range[size] = by_range.get(size, 0.0) + count
        self.assertEqual(by_range, {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5})
        means = sorted((s, m) for s, m, c in cycles if c == 1.0)
        self.assertEqual(means, [(4.0, 1.0)])  # E-F
        self.assertEqual(list(stats.rainflow_histogram(x, [0, 3, 4, 8, 9])), [0.5, 1.5, 1.5, 0.5])

    def test_sine(self):
        t = np.linspace(0.0, 10.0, 10001)
        cycles = stats.rainflow(np.cos(2.0 * math.pi * t))
        self.assertAlmostEqual(cycles[:, 2].sum(), 10.0)
        self.assertTrue(np.allclose(cycles[:, 0], 2.0, atol=1e-5))

    def test_total_damage_does_not_depend_on_samples_between(self):
        rng = np.random.default_rng(1)
        x = rng.normal(size=200)
        fine = np.interp(np.linspace(0, 199, 199 * 7 + 1), np.arange(200), x)
        a, b = stats.rainflow(x), stats.rainflow(fine)
        self.assertTrue(np.allclose((a[:, 0]**3 * a[:, 2]).sum(), (b[:, 0]**3 * b[:, 2]).sum()))


class Spectra(unittest.TestCase):
    def test_variance_and_peak(self):
        rng = np.random.default_rng(4)
        t = np.arange(0, 4096, 0.5)
        x = 2.0 * np.sin(1.3 * t) + 0.5 * rng.normal(size=t.size) + 10.0
        omega, density = stats.spectrum(x, 0.5, 256.0)
        self.assertLess(abs(np.trapz(density, omega) / x.var() - 1.0), 0.05)
        self.assertLess(abs(omega[density.argmax()] - 1.3), 0.03)


class RangeGraph(unittest.TestCase):
    def test_extremes_along_a_wire(self):
        x = np.array([[1.0, 5.0], [3.0, -1.0], [2.0, 2.0]])
        low, mean, high = stats.range_graph(x)
        self.assertEqual(list(low), [1.0, -1.0])
        self.assertEqual(list(mean), [2.0, 2.0])
        self.assertEqual(list(high), [3.0, 5.0])
        with self.assertRaises(ValueError):
            stats.range_graph([1.0, 2.0])


class Document(unittest.TestCase):
    def test_example_of_the_page(self):
        import doctest
        page = pathlib.Path(__file__).resolve().parents[2] / "docs/statistics.md"
        failed, tried = doctest.testfile(str(page), module_relative=False)
        self.assertEqual(failed, 0)
        self.assertGreater(tried, 0)


if __name__ == "__main__":
    unittest.main()
