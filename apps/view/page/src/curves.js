// SPDX-License-Identifier: Apache-2.0
/// Curves of displays and controls over the time line of a debriefing, and the marks of its entries.

export const kWide = 1000, kHigh = 36, kMostRows = 24;   // box of a curve; curves at most
export const kMarks = {goal: '✓', penalty: '−', alarm: '!', alarm_end: '·', fault: '⚡', fault_end: '·', restored: '↺', end: '■', note: '✎', command: '›'};

/// Return the value at a time of samples (times ascend); NaN before the first one.
export function valueAt(times, values, time) {
    let lo = 0, hi = times.length;
    while (lo < hi) {
        const mid = (lo + hi) >> 1;
        if (times[mid] <= time + 1e-9) lo = mid + 1;
        else hi = mid;
    }
    return lo ? values[lo - 1] ?? NaN : NaN;
}

/// Return the controls of a debriefing as steps: {name, role, times, values}, the last value kept to
/// `end`.
export function controlCurves(controls, end) {
    const rows = new Map();
    for (const [time, role, input, value] of controls) {
        if (!rows.has(input)) rows.set(input, {name: input, role, times: [], values: []});
        const row = rows.get(input);
        if (row.times.length) {   // a step: the old value up to this time
            row.times.push(time);
            row.values.push(row.values.at(-1));
        }
        row.times.push(time);
        row.values.push(value);
    }
    for (const row of rows.values()) {
        row.times.push(Math.max(end, row.times.at(-1)));
        row.values.push(row.values.at(-1));
    }
    return [...rows.values()];
}

/// Return the path of a curve in a box of kWide × kHigh; gaps where there is no number.
export function curvePath(times, values, [begin, end], [lo, hi]) {
    let path = '', pen = false;
    for (let i = 0; i < times.length; ++i) {
        if (!Number.isFinite(values[i])) { pen = false; continue; }
        const x = kWide * (times[i] - begin) / Math.max(1e-9, end - begin), y = kHigh - 3 - (kHigh - 6) * (values[i] - lo) / Math.max(1e-12, hi - lo);
        path += `${pen ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
        pen = true;
    }
    return path;
}

/// Return the range of the finite values of lists; one of width 0 is widened.
export const rangeOf = lists => {
    let lo = Infinity, hi = -Infinity;
    for (const v of lists.flat()) if (Number.isFinite(v)) { lo = Math.min(lo, v); hi = Math.max(hi, v); }
    return lo <= hi ? hi > lo ? [lo, hi] : [lo - 0.5, hi + 0.5] : [0, 1];
};
