// SPDX-License-Identifier: Apache-2.0
/// Logic of controls, independent of the page: ranges, steps, springs, dead zones.

/// Return the range of an input [min, max] for its control. An open end becomes `nominal`, or ten
/// times the present value, or 1.
export function leverRange(input) {
    const size = input.nominal > 0 ? input.nominal : Math.max(1, 10 * Math.abs(input.value ?? 0));
    const min = Number.isFinite(input.min) ? input.min : -size;
    const max = Number.isFinite(input.max) ? input.max : size;
    return min < max ? [min, max] : [min, min + size];
}

/// Return the neutral value: 0 if it is in the range, else the end nearest to 0.
export const neutral = ([min, max]) => Math.min(max, Math.max(min, 0));

export const clampTo = ([min, max], v) => Math.min(max, Math.max(min, v));

/// Return the value for a deflection −1 to 1: 0 is neutral, ±1 the ends.
export function fromDeflection(range, d) {
    const rest = neutral(range), x = Math.min(1, Math.max(-1, d));
    return x >= 0 ? rest + x * (range[1] - rest) : rest + x * (rest - range[0]);
}

/// Return the deflection −1 to 1 of a value.
export function toDeflection(range, v) {
    const rest = neutral(range), side = v >= rest ? range[1] - rest : rest - range[0];
    return side > 0 ? Math.min(1, Math.max(-1, (v - rest) / side)) : 0;
}

/// Move by one press of a key: a twentieth of the range, in round steps from neutral. A choice moves to
/// the next one.
export function nudge(range, v, steps, choices = false) {
    if (choices) return clampTo(range, Math.round(v) + Math.sign(steps));
    const unit = (range[1] - range[0]) / 20, rest = neutral(range);
    const at = Math.round((v - rest) / unit) + steps;
    return clampTo(range, rest + at * unit);
}

/// Return to neutral at a constant rate: the whole range in `seconds`.
export function springHome(range, v, dt, seconds = 0.3) {
    const rest = neutral(range), most = (range[1] - range[0]) * dt / seconds;
    return Math.abs(v - rest) <= most ? rest : v - Math.sign(v - rest) * most;
}

/// Return the deflection of a stick beyond its dead zone, from 0 at its edge to ±1; NaN counts as 0.
/// @param curve  1: linear, 2: finer near the middle.
export function deadZone(x, zone = 0.12, curve = 1.5) {
    if (!Number.isFinite(x)) return 0;
    const size = Math.abs(x);
    if (size <= zone) return 0;
    const beyond = Math.min(1, (size - zone) / (1 - zone));
    return Math.sign(x) * beyond ** curve;
}

/// Limits the rate of sent values: at most one per `every` [ms], and always the last value.
export class Throttle {
    constructor(send, every = 40) {
        this.send = send;
        this.every = every;
        this.last = -Infinity;
        this.waiting = new Map();
    }
    set(name, value) {
        this.waiting.set(name, value);
    }
    /// Send due values. Call each frame with a clock [ms].
    flush(now) {
        if (!this.waiting.size || now - this.last < this.every) return 0;
        this.last = now;
        const due = [...this.waiting];
        this.waiting.clear();
        for (const [name, value] of due) this.send(name, value);
        return due.length;
    }
}

/// Sort controls by heading: the `group` of the scene, else the name up to its last "/".
export function groupLevers(inputs) {
    const groups = new Map();
    inputs.forEach((input, index) => {
        const cut = input.name.lastIndexOf('/');
        const group = input.group || (cut > 0 ? input.name.slice(0, cut) : 'Levers');
        if (!groups.has(group)) groups.set(group, []);
        groups.get(group).push(index);
    });
    return groups;
}

/// Return the value of an input in words, if it has words for its values.
export const valueWords = (input, value, unit = '') => input.words?.[Math.round(value)] ?? quantity(value, unit);

/// Format a number with four digits and its unit, thousands as k, M: "612 kN".
export function quantity(value, unit = '', digits = 3) {
    if (!Number.isFinite(value)) return '–';
    const scaled = /^(N|N m|W|J|kg|Pa|Hz|m\^2|N\/m|N s\/m)$/.test(unit);
    let v = value, prefix = '';
    if (scaled && unit !== 'kg') {
        const size = Math.abs(value);
        if (size >= 0.9995e9) [v, prefix] = [value / 1e9, 'G'];
        else if (size >= 0.9995e6) [v, prefix] = [value / 1e6, 'M'];
        else if (size >= 0.9995e3) [v, prefix] = [value / 1e3, 'k'];
    } else if (unit === 'kg' && Math.abs(value) >= 1000) {
        [v, unit] = [value / 1000, 't'];
    }
    const size = Math.abs(v);
    let text;
    if (size !== 0 && (size < 1e-3 || size >= 1e6)) text = v.toExponential(digits - 1);
    else text = v.toFixed(Math.max(0, digits - 1 - Math.max(0, Math.floor(Math.log10(size || 1)))));
    if (/^-0(\.0*)?$/.test(text)) text = text.slice(1);
    return (text + ' ' + prefix + unit).trim().replaceAll('-', '−');
}
