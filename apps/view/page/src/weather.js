// SPDX-License-Identifier: Apache-2.0
/// Weather sliders: the inputs of the sea as significant wave height, wind, direction of the wind, current and
/// water level, in sailors' units and within the range of an exercise.
import {bearing, shown} from './units.js';
import {signalOf} from './vessel.js';

export const kWeather = 'Weather';
const kStill = 0.01;          // [m] or [m/s] below which a factor has no effect
const deg = 180 / Math.PI;

/// Return the significant wave height of components at factor 1: four standard deviations [m].
export const significantHeight = components => 4 * Math.sqrt((components ?? []).reduce((sum, [amplitude]) => sum + 0.5 * amplitude * amplitude, 0));

/// Return the slider of an input of the sea: {label, range, text(value), step}, or null for another input.
/// `hidden`: its factor has no effect. Factors of waves and current are shown as heights and speeds.
/// @param sea  Of the scene.
export function weatherOf(input, sea) {
    const match = /^sea\.(waves|wind|wind_direction|current|level)$/.exec(signalOf(input));
    if (!match || !sea) return null;
    const value = Number.isFinite(input.value) ? input.value : 0, within = (lo, hi) => [Math.max(lo, input.min ?? lo), Math.min(hi, input.max ?? hi)];
    /// A factor of a quantity, up to `most` or 1.5 times the present amount.
    const factor = (label, amount, most, text) => amount < kStill ? {hidden: true} : {label, range: within(0, Math.max(most / amount, 1.5 * value)), text: v => text(v * amount)};
    switch (match[1]) {
    case 'waves': return factor('Wave height (Hs)', significantHeight(sea.components), 6, v => `${v.toFixed(1)} m`);
    case 'current': return sea.current ? factor('Current', sea.current.speed, 1.5, v => shown(v, 'm/s', 'current')) : {label: 'Current', range: within(0, Math.max(3, 1.5 * value)), text: v => `${Math.round(100 * v)} %`};
    case 'wind': return {label: 'Wind', range: within(0, Math.max(30, value)), text: v => shown(v, 'm/s', 'wind')};
    // The signal is the direction to which the wind blows, from x (east) towards y; sailors name that from which it comes.
    case 'wind_direction': return {label: 'Wind from', range: [value - Math.PI, value + Math.PI], text: v => bearing(270 - v * deg), step: Math.PI / 18};
    default: return {label: 'Water level', range: within(value - 5, value + 5), text: v => `${v.toFixed(1)} m`};
    }
}
