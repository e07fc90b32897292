# SPDX-License-Identifier: Apache-2.0
"""Statistics of time series: moments, extremes, up-crossings, cycles and spectra.

All functions take arrays of equal steps in time. Units are those of the input, times are in
seconds. They need numpy alone.

Sources
-------
- E. J. Gumbel, *Statistics of Extremes*, Columbia University Press, 1958.
- ASTM E1049-85 (2017), *Standard Practices for Cycle Counting in Fatigue Analysis*.
- P. D. Welch, *The use of fast Fourier transform for the estimation of power spectra*, IEEE Trans.
  Audio Electroacoust. 15 (1967).
- DNV-RP-C205 (2021), *Environmental conditions and environmental loads*, section 3.
"""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

__all__ = ["Extreme", "Summary", "fit_peaks", "gumbel", "weibull", "most_probable_maximum", "peaks", "rainflow",
           "rainflow_histogram", "range_graph", "spectrum", "summary", "turning_points",
           "up_crossings", "up_crossing_period"]

EULER_GAMMA = 0.5772156649015329


def _series(values, least: int = 1) -> np.ndarray:
    x = np.asarray(values, dtype=float)
    if x.ndim != 1:
        raise ValueError(f"a series has one dimension, this array has shape {x.shape}")
    if x.size < least:
        raise ValueError(f"at least {least} values are needed, {x.size} are given")
    if not np.all(np.isfinite(x)):
        raise ValueError(f"value {int(np.flatnonzero(~np.isfinite(x))[0])} is not finite")
    return x


@dataclass(frozen=True)
class Summary:
    """Moments of a series."""

    count: int
    mean: float
    std: float  #: Standard deviation, with n in the denominator.
    minimum: float
    maximum: float
    skewness: float  #: 0 for a normal distribution.
    kurtosis: float  #: 3 for a normal distribution.


def summary(values) -> Summary:
    """Return count, mean, standard deviation, extremes, skewness and kurtosis.

    >>> summary([1.0, 2.0, 3.0]).mean
    2.0
    """
    x = _series(values)
    mean = float(x.mean())
    d = x - mean
    variance = float(np.mean(d * d))
    if variance > 0.0:
        skewness = float(np.mean(d**3)) / variance**1.5
        kurtosis = float(np.mean(d**4)) / variance**2
    else:
        skewness = kurtosis = math.nan
    return Summary(x.size, mean, math.sqrt(variance), float(x.min()), float(x.max()), skewness,
                   kurtosis)


def up_crossings(values, level: float | None = None) -> np.ndarray:
    """Return the positions, in samples, at which the series crosses a level upwards.

    Positions are interpolated linearly. The default level is the mean.
    """
    x = _series(values, 2)
    y = x - (x.mean() if level is None else level)
    before = np.flatnonzero((y[:-1] < 0.0) & (y[1:] >= 0.0))
    return before + y[before] / (y[before] - y[before + 1])


def up_crossing_period(values, step: float, level: float | None = None) -> float:
    """Return the mean time between up-crossings [s], NaN with fewer than two."""
    if not step > 0.0:
        raise ValueError(f"the step must be above 0 s, it is {step}")
    at = up_crossings(values, level)
    return float(step * (at[-1] - at[0]) / (at.size - 1)) if at.size > 1 else math.nan


def peaks(values, level: float | None = None) -> np.ndarray:
    """Return the largest value between each two up-crossings of a level (default: the mean)."""
    x = _series(values, 2)
    at = up_crossings(x, level)
    if at.size < 2:
        return np.empty(0)
    first = np.ceil(at).astype(int)
    return np.array([x[a:b].max() for a, b in zip(first[:-1], first[1:]) if b > a])


@dataclass(frozen=True)
class Extreme:
    """A fitted distribution of extremes.

    gumbel: F(x) = exp(−exp(−(x − location)/scale)), shape is 0.
    weibull: F(x) = 1 − exp(−((x − location)/scale)^shape).
    """

    kind: str
    location: float
    scale: float
    shape: float
    count: int
    covariance: np.ndarray  #: Asymptotic covariance of (location, scale) or (scale, shape).

    def quantile(self, probability: float) -> float:
        """Return x with F(x) = probability."""
        if not 0.0 < probability < 1.0:
            raise ValueError(f"a probability lies between 0 and 1, not at {probability}")
        if self.kind == "gumbel":
            return self.location - self.scale * math.log(-math.log(probability))
        return self.location + self.scale * (-math.log1p(-probability))**(1.0 / self.shape)

    def interval(self, probability: float, confidence: float = 0.95) -> tuple[float, float]:
        """Return a confidence interval of a quantile by the delta method."""
        x = self.quantile(probability)
        if self.kind == "gumbel":
            gradient = np.array([1.0, -math.log(-math.log(probability))])
        else:
            y = -math.log1p(-probability)
            power = y**(1.0 / self.shape)
            gradient = np.array([power, -self.scale * power * math.log(y) / self.shape**2])
        deviation = math.sqrt(max(0.0, float(gradient @ self.covariance @ gradient)))
        z = _normal_quantile(0.5 + 0.5 * confidence)
        return x - z * deviation, x + z * deviation


def _normal_quantile(p: float) -> float:
    """Invert the normal distribution by Newton's method on erf."""
    x = 0.0
    for _ in range(60):
        error = 0.5 * (1.0 + math.erf(x / math.sqrt(2.0))) - p
        x -= error * math.sqrt(2.0 * math.pi) * math.exp(0.5 * x * x)
        if abs(error) < 1e-14:
            break
    return x


def gumbel(maxima) -> Extreme:
    """Fit Gumbel's distribution to maxima by maximum likelihood.

    The scale b solves b = mean(x) − Σ x e^{−x/b}/Σ e^{−x/b}; the location is −b ln mean(e^{−x/b}).
    The covariance is that of the expected information (Gumbel 1958, 6.2.6).
    """
    x = _series(maxima, 2)
    mean, deviation = float(x.mean()), float(x.std())
    if deviation == 0.0:
        raise ValueError("all maxima are equal")
    y = (x - mean) / deviation
    low, high = 1e-3, 1e3

    def residual(b: float) -> float:
        weight = np.exp(-(y - y.min()) / b)
        return b + float((y * weight).sum() / weight.sum())

    for _ in range(200):  # bisection: the residual rises with b
        b = math.sqrt(low * high)
        if residual(b) > 0.0:
            high = b
        else:
            low = b
    b = math.sqrt(low * high)
    place = y.min() - b * math.log(float(np.mean(np.exp(-(y - y.min()) / b))))
    scale, location = b * deviation, mean + place * deviation
    six = 6.0 / math.pi**2
    g = 1.0 - EULER_GAMMA
    covariance = scale**2 / x.size * np.array([[1.0 + six * g * g, six * g], [six * g, six]])
    return Extreme("gumbel", location, scale, 0.0, x.size, covariance)


def weibull(values, location: float = 0.0) -> Extreme:
    """Fit Weibull's distribution to values above a known location by maximum likelihood.

    The shape k solves 1/k = Σ x^k ln x/Σ x^k − mean(ln x); the scale is mean(x^k)^{1/k}.
    """
    x = _series(values, 2) - location
    if not np.all(x > 0.0):
        raise ValueError(f"all values must lie above the location {location}")
    largest = float(x.max())
    y = x / largest
    logs = np.log(y)
    if float(logs.std()) == 0.0:
        raise ValueError("all values are equal")

    def residual(k: float) -> float:
        power = y**k
        return float((power * logs).sum() / power.sum() - logs.mean()) - 1.0 / k

    low, high = 1e-3, 1e3
    for _ in range(200):  # bisection: the residual rises with k
        k = math.sqrt(low * high)
        if residual(k) > 0.0:
            high = k
        else:
            low = k
    k = math.sqrt(low * high)
    scale = largest * float(np.mean(y**k))**(1.0 / k)
    # Inverse of the expected information of (scale, shape).
    g = 1.0 - EULER_GAMMA
    six = 6.0 / math.pi**2
    covariance = np.array([[scale**2 / k**2 * (1.0 + six * g * g), six * g * scale],
                           [six * g * scale, six * k**2]]) / x.size
    return Extreme("weibull", location, scale, k, x.size, covariance)


def fit_peaks(values, level: float | None = None) -> Extreme:
    """Fit Weibull's distribution to the peaks above a level (default: mean).

    Raises
    ------
    ValueError
        If there are fewer than 10 peaks.
    """
    x = _series(values, 3)
    base = float(x.mean()) if level is None else level
    tops = peaks(x, base)
    if tops.size < 10:
        raise ValueError(f"{tops.size} peaks between up-crossings are too few: 10 at least")
    least = float(tops.min())
    return weibull(tops, min(base, least - 1e-12 * max(1.0, abs(least))))


def most_probable_maximum(values, step: float, duration: float = 3 * 3600.0,
                          level: float | None = None) -> float:
    """Return the most probable maximum in a duration [s] by a Weibull fit of the peaks.

    With N = duration / mean up-crossing period, the peaks' distribution F has F(x) = 1 − 1/N at
    the most probable maximum x (DNV-RP-C205, 3.6.3). `level` separates the peaks (default: mean).
    """
    fit = fit_peaks(values, level)
    count = duration / up_crossing_period(values, step, level)
    if not count > 1.0:
        raise ValueError(f"the duration of {duration} s holds less than one cycle")
    return fit.quantile(1.0 - 1.0 / count)


def turning_points(values) -> np.ndarray:
    """Return the local extremes of a series, with its first and last value."""
    x = _series(values)
    x = x[np.concatenate(([True], np.diff(x) != 0.0))]
    if x.size < 3:
        return x
    slope = np.sign(np.diff(x))
    inner = np.flatnonzero(slope[1:] != slope[:-1]) + 1
    return np.concatenate(([x[0]], x[inner], [x[-1]]))


def rainflow(values) -> np.ndarray:
    """Count cycles by ASTM E1049-85, 5.4.4 (rainflow counting).

    Returns an array of rows (range, mean, count); count is 1 for a cycle and 0.5 for a half cycle,
    in the order in which the standard's procedure finds them.
    """
    stack: list[float] = []
    found: list[tuple[float, float, float]] = []
    for value in turning_points(values):
        stack.append(float(value))
        while len(stack) >= 3:
            last = abs(stack[-1] - stack[-2])
            before = abs(stack[-2] - stack[-3])
            if last < before:
                break
            mean = 0.5 * (stack[-2] + stack[-3])
            if len(stack) == 3:  # the range has the start of the series: half a cycle
                found.append((before, mean, 0.5))
                del stack[0]
            else:
                found.append((before, mean, 1.0))
                del stack[-3:-1]
    for a, b in zip(stack[:-1], stack[1:]):
        found.append((abs(b - a), 0.5 * (a + b), 0.5))
    return np.array(found, dtype=float).reshape(-1, 3)


def rainflow_histogram(values, edges) -> np.ndarray:
    """Return the number of cycles in each bin of ranges, (edges[i], edges[i+1]]."""
    edges = _series(edges, 2)
    if not np.all(np.diff(edges) > 0.0):
        raise ValueError("the edges of bins must increase")
    cycles = rainflow(values)
    bins = np.searchsorted(edges, cycles[:, 0], side="left") - 1
    out = np.zeros(edges.size - 1)
    for bin_, count in zip(bins, cycles[:, 2]):
        if 0 <= bin_ < out.size:
            out[bin_] += count
    return out


def spectrum(values, step: float, segment: float | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Return angular frequencies [rad/s] and the one-sided spectral density by Welch's method.

    Segments of `segment` seconds (default: an eighth of the series) overlap by half and have Hann
    windows. The integral of the density over the frequencies is the variance.
    """
    x = _series(values, 8)
    if not step > 0.0:
        raise ValueError(f"the step must be above 0 s, it is {step}")
    size = max(8, int(round((segment or x.size * step / 8.0) / step)))
    size = min(size, x.size)
    hop = max(1, size // 2)
    window = 0.5 - 0.5 * np.cos(2.0 * math.pi * np.arange(size) / size)
    total = np.zeros(size // 2 + 1)
    count = 0
    centred = x - x.mean()
    for begin in range(0, x.size - size + 1, hop):
        total += np.abs(np.fft.rfft(window * centred[begin:begin + size]))**2
        count += 1
    density = 2.0 * total / count * step / float((window * window).sum()) / (2.0 * math.pi)
    density[0] *= 0.5
    if size % 2 == 0:
        density[-1] *= 0.5
    return 2.0 * math.pi * np.fft.rfftfreq(size, step), density


def range_graph(values) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return minimum, mean and maximum over time of an array of shape (times, positions)."""
    x = np.asarray(values, dtype=float)
    if x.ndim != 2 or x.shape[0] < 1:
        raise ValueError(f"an array of shape (times, places) is needed, this one has {x.shape}")
    if not np.all(np.isfinite(x)):
        raise ValueError("values must be finite")
    return x.min(axis=0), x.mean(axis=0), x.max(axis=0)
