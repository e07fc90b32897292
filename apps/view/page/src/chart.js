// SPDX-License-Identifier: Apache-2.0
/// Chart of the site, north up: ships, barges, rigs and other bodies from above, wires, wind, scale.
import {svg} from './dom.js';
import {readable} from './roles.js';
import {bearing} from './units.js';
import {kOutline} from './vessel.js';

const kDrawn = {ship: 3, barge: 3, semi: 3, box: 1, anchor: 2, ball: 1, hook: 0, cylinder: 0, boom: 0, lattice: 0};

/// Return the view of a chart: middle and half width [m], from boxes [x, y, radius], in a square.
export function chartView(boxes, margin = 1.15) {
    if (!boxes.length) return {x: 0, y: 0, half: 100};
    const lo = [0, 1].map(k => Math.min(...boxes.map(b => b[k] - b[2]))), hi = [0, 1].map(k => Math.max(...boxes.map(b => b[k] + b[2])));
    return {x: (lo[0] + hi[0]) / 2, y: (lo[1] + hi[1]) / 2, half: Math.max(20, margin * Math.max(hi[0] - lo[0], hi[1] - lo[1]) / 2)};
}

/// Return a round length of a scale bar, at most a third of the chart's width [m].
export function scaleLength(half) {
    const most = 2 * half / 3, unit = 10 ** Math.floor(Math.log10(most));
    return [5, 2, 1].map(k => k * unit).find(v => v <= most) ?? unit;
}

const heading = q => Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));

/// Draw the chart. @param bodies  Of the stage. @param frame  Last frame, for wires; may be missing.
/// @param wind  {speed, to: direction to which it blows, from x towards y [rad]} or null.
export function siteChart(bodies, scene, frame, wind = null) {
    const shown = bodies.filter(b => b.half && kDrawn[b.role] && Number.isFinite(b.position.x) && Math.max(b.half[0], b.half[1]) < 2000).sort((a, b) => kDrawn[b.role] - kDrawn[a.role] || b.size - a.size).slice(0, 40);
    const big = shown.filter(b => kDrawn[b.role] === 3), view = chartView((big.length ? big : shown).map(b => [b.position.x, b.position.y, Math.hypot(b.half[0], b.half[1])]));
    const k = 100 / view.half, x = v => (v - view.x) * k, y = v => -(v - view.y) * k, parts = [];
    if (frame) {
        let at = 0;
        frame.counts.forEach((n, i) => {
            const wire = scene.wires[i];
            if (n > 1 && wire?.kind !== 'rod') {
                const d = [];
                for (let j = 0; j < n; j += Math.max(1, Math.floor(n / 24))) d.push(`${d.length ? 'L' : 'M'}${x(frame.wirePoints[3 * (at + j)]).toFixed(1)} ${y(frame.wirePoints[3 * (at + j) + 1]).toFixed(1)}`);
                d.push(`L${x(frame.wirePoints[3 * (at + n - 1)]).toFixed(1)} ${y(frame.wirePoints[3 * (at + n - 1) + 1]).toFixed(1)}`);
                parts.push(svg('path', {d: d.join(''), class: 'chart-wire'}));
            }
            at += n;
        });
    }
    for (const b of [...shown].reverse()) {
        const turn = 90 - heading(b.quaternion) * 180 / Math.PI, place = `translate(${x(b.position.x).toFixed(1)} ${y(b.position.y).toFixed(1)}) rotate(${turn.toFixed(1)})`;
        parts.push(b.role === 'ship' ? svg('path', {d: kOutline, transform: `${place} scale(${(k * b.half[1]).toFixed(2)} ${(k * b.half[0]).toFixed(2)})`, class: 'chart-ship'})
            : svg('rect', {x: -k * b.half[1], y: -k * b.half[0], width: 2 * k * b.half[1], height: 2 * k * b.half[0], transform: place, class: b.role === 'box' ? 'chart-land' : 'chart-ship'}));
    }
    for (const b of big.slice(0, 5)) {
        const text = svg('text', {x: Math.max(-78, Math.min(78, x(b.position.x))), y: Math.max(-88, y(b.position.y) - k * Math.hypot(b.half[0], b.half[1]) * 0.6 - 3), 'text-anchor': 'middle'});
        text.textContent = readable(b.name.replace(/\/hull$/, ''));
        parts.push(text);
    }
    const long = scaleLength(view.half), bar = svg('path', {d: `M-94 90V94H${(-94 + long * k).toFixed(1)}V90`, class: 'chart-bar'}), words = svg('text', {x: -94, y: 87});
    words.textContent = long >= 1852 ? `${(long / 1852).toFixed(1)} M` : `${long} m`;
    const north = svg('path', {d: 'M88-94 93-80 88-84 83-80Z', class: 'chart-north'});
    parts.push(bar, words, north);
    if (wind && wind.speed > 0.2) {
        const text = svg('text', {x: 94, y: 94, 'text-anchor': 'end'});
        text.textContent = `${(wind.speed / 0.514444).toFixed(0)} kn ${bearing(270 - wind.to * 180 / Math.PI)}`;
        parts.push(svg('path', {d: 'M-9 0H6M2-4 8 0 2 4', transform: `translate(80 78) rotate(${(-wind.to * 180 / Math.PI).toFixed(0)})`, class: 'chart-wind'}), text);
    }
    return svg('svg', {viewBox: '-100 -100 200 200', class: 'chart', role: 'img', 'aria-label': big.map(b => readable(b.name.replace(/\/hull$/, ''))).join(', ') || 'Chart'}, ...parts);
}
