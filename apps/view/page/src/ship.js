// SPDX-License-Identifier: Apache-2.0
/// Ships, barges and rigs for bodies with only a box in the scene: hull lines, deck, bulwark, bridge.
/// Frame: that of the body, x forward, y to port, z up [m]; the box spans ±half.
import {Build} from './build.js';

const PAINT = {
    bottom: 0x8a2f25, hull: 0x27507f, line: 0xf2f2ee, deck: 0x59705f, wood: 0x8d7a58,
    house: 0xf1f2ee, glass: 0x16222d, funnel: 0xd9822b, steel: 0x7d868d, dark: 0x31383e,
    yellow: 0xe7b416, barge: 0x54606a,
};
export const HULLS = [0x27507f, 0xc2501f, 0x1f6a58, 0x6a2b4a];

/// Half-breadth of the deck over the half-breadth of the box, at ξ from stern −1 to bow 1.
export function deckLine(xi) {
    if (xi < -0.8) return 0.93 + 0.07 * (xi + 1) / 0.2;
    if (xi < 0.35) return 1;
    const t = (xi - 0.35) / 0.65;
    return Math.sqrt(Math.max(0, 1 - t ** 2.6));
}

/// The same at the keel: finer, and shorter at the bow.
export function keelLine(xi) {
    if (xi < -0.55) return 0.55 + 0.37 * (xi + 1) / 0.45;
    if (xi < 0.1) return 0.92;
    const t = Math.min(1, (xi - 0.1) / 0.78);
    return 0.92 * Math.max(0, 1 - t ** 1.8);
}

/// Rise of the keel from the bottom of the box, as a fraction of its depth.
const keelRise = xi => xi < -0.5 ? 0.62 * ((-0.5 - xi) / 0.5) ** 1.6 : xi > 0.86 ? (xi - 0.86) * 1.6 : 0;

const SECTION = [0, 0.12, 0.3, 0.5, 0.75, 1];  // heights of the points of a section

/// Points of a section at ξ, keel to deck edge: [y, z].
function section(xi, [hx, hy, hz], top) {
    const zk = -hz + keelRise(xi) * 2 * hz, yk = keelLine(xi) * hy, yd = deckLine(xi) * hy;
    return SECTION.map(s => {
        const bilge = Math.min(1, Math.sqrt(s / 0.3));     // round bilge up to a third
        const flare = s ** 1.4;
        return [(yk + (yd - yk) * flare) * (0.25 + 0.75 * bilge) * (s > 0 ? 1 : 0.999),
                zk + s * (top(xi) - zk)];
    });
}

/// Hull shell from stern to bow, painted below and above `water` (height in the frame).
function shell(b, half, top, water, paint) {
    const n = 28, stations = [];
    for (let i = 0; i <= n; ++i) {
        const xi = -1 + 2 * (i / n) ** 0.92;
        stations.push({x: xi * half[0] * 0.999, pts: section(Math.min(xi, 0.9985), half, top)});
    }
    const colour = z => z < water ? PAINT.bottom : z < water + 0.35 ? PAINT.line : paint;
    for (const side of [1, -1]) {
        for (let i = 0; i < n; ++i) {
            const p = stations[i], q = stations[i + 1];
            for (let k = 0; k + 1 < SECTION.length; ++k) {
                const quad = [[p.x, side * p.pts[k][0], p.pts[k][1]], [q.x, side * q.pts[k][0], q.pts[k][1]],
                              [q.x, side * q.pts[k + 1][0], q.pts[k + 1][1]],
                              [p.x, side * p.pts[k + 1][0], p.pts[k + 1][1]]];
                b.band(side > 0 ? quad.reverse() : quad, water, colour);
            }
        }
    }
    const stern = stations[0];
    for (let k = 0; k + 1 < SECTION.length; ++k) {
        const [y0, z0] = stern.pts[k], [y1, z1] = stern.pts[k + 1];
        b.band([[stern.x, y0, z0], [stern.x, y1, z1], [stern.x, -y1, z1], [stern.x, -y0, z0]], water, colour);
    }
    for (let i = 0; i < n; ++i) {      // bottom
        const p = stations[i], q = stations[i + 1];
        b.quad([p.x, p.pts[0][0], p.pts[0][1]], [p.x, -p.pts[0][0], p.pts[0][1]],
               [q.x, -q.pts[0][0], q.pts[0][1]], [q.x, q.pts[0][0], q.pts[0][1]], PAINT.bottom);
    }
    return stations;
}

/// A level deck between two stations, inside the hull's edge.
function deck(b, half, from, to, z, colour, inset = 0.985) {
    const n = 18;
    for (let i = 0; i < n; ++i) {
        const a = from + (to - from) * i / n, c = from + (to - from) * (i + 1) / n;
        const ya = deckLine(Math.min(a, 0.995)) * half[1] * inset, yc = deckLine(Math.min(c, 0.995)) * half[1] * inset;
        b.quad([a * half[0], -ya, z], [c * half[0], -yc, z], [c * half[0], yc, z], [a * half[0], ya, z], colour);
    }
}

/// Bulwark: a thin wall along the deck's edge, with a cap rail.
function bulwark(b, half, from, to, z0, z1, colour) {
    const n = 18, t = 0.22;
    for (const side of [1, -1]) {
        for (let i = 0; i < n; ++i) {
            const a = from + (to - from) * i / n, c = from + (to - from) * (i + 1) / n;
            const ya = side * deckLine(Math.min(a, 0.995)) * half[1], yc = side * deckLine(Math.min(c, 0.995)) * half[1];
            const A = a * half[0], C = c * half[0], in_ = side * t;
            b.both([A, ya - in_, z0], [C, yc - in_, z0], [C, yc - in_, z1], [A, ya - in_, z1], colour);
            b.both([A, ya, z1], [C, yc, z1], [C, yc - in_, z1], [A, ya - in_, z1], PAINT.line);
        }
    }
}

/// A house with a band of windows around its top storey; leans back a little at the front.
function house(b, x0, x1, hy, z0, storeys, h) {
    for (let s = 0; s < storeys; ++s) {
        const z = z0 + s * h, back = s * 0.02 * (x1 - x0), w = hy * (1 - 0.05 * s);
        b.box([x0 + back, -w, z], [x1 - 2.2 * back, w, z + h * 0.96], PAINT.house);
        const lo = z + h * 0.42, hi = z + h * (s === storeys - 1 ? 0.86 : 0.68);
        windows(b, x0 + back, x1 - 2.2 * back, w, lo, hi, s === storeys - 1);
        b.box([x0 + back - 0.25, -w - 0.25, z + h * 0.94], [x1 - 2.2 * back + 0.25, w + 0.25, z + h], PAINT.line);
    }
}

function windows(b, x0, x1, w, lo, hi, all) {
    const e = 0.04, n = Math.max(2, Math.round((x1 - x0) / 2.4));
    for (let i = 0; i < n; ++i) {
        const gap = all ? 0.06 : 0.3, a = x0 + (x1 - x0) * (i + gap) / n, c = x0 + (x1 - x0) * (i + 1 - gap) / n;
        b.box([a, -w - e, lo], [c, w + e, hi], PAINT.glass);
    }
    const m = Math.max(2, Math.round(2 * w / 2.4));
    for (let i = 0; i < m; ++i) {
        const gap = all ? 0.06 : 0.3, a = -w + 2 * w * (i + gap) / m, c = -w + 2 * w * (i + 1 - gap) / m;
        b.box([x0 - e, a, lo], [x1 + e, c, hi], PAINT.glass);
    }
}

/// A ship: {half, deck: height of the working deck or null, water, paint}.
/// Return the build and the position of the bridge (for cameras).
export function ship({half, deck: deckHeight = null, break: breakAt = null, water = 0, paint = HULLS[0]}) {
    const b = new Build(), [hx, hy, hz] = half, u = Math.min(hy / 9, hx / 30);   // u: scale of fittings
    const low = deckHeight ?? hz * 0.55;
    const split = Math.min(0.5, Math.max(-0.2, breakAt ?? 0.2));
    const high = Math.max(hz, low + 1.5 * u);
    const sheer = xi => xi < split ? low + 1.1 * u : xi < split + 0.06
        ? low + 1.1 * u + (high - low - 1.1 * u) * (xi - split) / 0.06
        : high + 1.2 * u * ((xi - split) / (1 - split)) ** 2;
    shell(b, half, sheer, water, paint);
    deck(b, half, -1, split + 0.01, low, PAINT.deck);
    for (let i = -3; i <= 3; ++i)      // wooden sheathing of the working deck
        b.box([-0.93 * hx, (i - 0.42) * hy * 0.24, low - 0.05], [(split - 0.03) * hx, (i + 0.42) * hy * 0.24, low + 0.012], PAINT.wood);
    deck(b, half, split, 0.985, high, PAINT.deck, 0.97);
    const wall = deckLine(split) * hy * 0.985;
    b.both([split * hx, -wall, low], [split * hx, wall, low], [split * hx, wall, high], [split * hx, -wall, high], PAINT.house);
    bulwark(b, half, -0.94, split, low, low + 1.1 * u, PAINT.house);
    bulwark(b, half, split + 0.06, 0.99, high, high + 1.0 * u, PAINT.house);
    // Forecastle, accommodation and bridge.
    const h = 2.7 * u, x0 = (split + 0.07) * hx, x1 = Math.min(0.74, split + 0.42) * hx;
    house(b, x0, x1, hy * 0.66, high, 2, h);
    const bridge0 = x0 + 0.18 * (x1 - x0), bridge1 = x1 - 0.16 * (x1 - x0), top = high + 2 * h;
    house(b, bridge0, bridge1, hy * 0.6, top, 1, h * 1.05);
    const roof = top + h * 1.05;
    b.box([bridge0 + 0.3, -hy * 0.74, top + 0.1 * h], [bridge0 + 2.6 * u, hy * 0.74, top + 0.5 * h], PAINT.house);
    mast(b, (bridge0 + bridge1) / 2, roof, u);
    for (const s of [1, -1]) {
        const x = x0 + 1.2 * u, y = s * hy * 0.5;
        b.box([x - 1.1 * u, y - 0.9 * u, high], [x + 1.6 * u, y + 0.9 * u, roof + 0.9 * u], PAINT.funnel);
        b.box([x - 1.0 * u, y - 0.8 * u, roof + 0.9 * u], [x + 1.2 * u, y + 0.8 * u, roof + 1.5 * u], PAINT.dark);
        b.box([-0.93 * hx, s * hy * 0.93 - 0.35 * u, low], [(split - 0.05) * hx, s * hy * 0.93 + 0.35 * u, low + 1.15 * u], PAINT.steel);
    }
    b.cylinder([0.86 * hx, 0, high], [0.86 * hx, 0, high + 1.1 * u], 0.9 * u, 10, PAINT.steel);
    return {build: b, bridge: [bridge0 + 0.4 * u, 0, roof + 1.1 * u], eye: [(split - 0.02) * hx, -0.62 * hy, low + 4.4 * u], low, high};
}

function mast(b, x, z, u) {
    b.cylinder([x, 0, z], [x, 0, z + 6.5 * u], 0.28 * u, 8, PAINT.house);
    b.box([x - 0.15 * u, -2.2 * u, z + 3.4 * u], [x + 0.15 * u, 2.2 * u, z + 3.65 * u], PAINT.house);
    b.box([x + 0.3 * u, -1.5 * u, z + 2.2 * u], [x + 0.7 * u, 1.5 * u, z + 2.5 * u], PAINT.dark);
    b.cylinder([x - 1.8 * u, 1.6 * u, z], [x - 1.8 * u, 1.6 * u, z + 1.5 * u], 0.75 * u, 10, PAINT.house);
    b.cylinder([x, 0, z + 6.5 * u], [x, 0, z + 8.2 * u], 0.06 * u, 6, PAINT.dark);
}

/// A barge: a pontoon with raked ends, fender strakes, bollards and a hatch.
export function barge({half: [hx, hy, hz], water = 0}) {
    const b = new Build(), rake = Math.min(hx * 0.18, 2 * hz);
    const pts = [[-hx, hz], [-hx, hz * 0.1], [-hx + rake, -hz], [hx - rake, -hz], [hx, hz * 0.1], [hx, hz]];
    const colour = z => z < water ? PAINT.bottom : z < water + 0.3 ? PAINT.line : PAINT.barge;
    for (let i = 0; i + 1 < pts.length; ++i) {
        const [xa, za] = pts[i], [xc, zc] = pts[i + 1];
        b.band([[xa, hy, za], [xa, -hy, za], [xc, -hy, zc], [xc, hy, zc]].reverse(), water, colour);
    }
    for (const s of [1, -1])
        for (let i = 0; i < 2; ++i) {
            const quads = i === 0
                ? [[pts[1], pts[2], pts[3], pts[4]]] : [[pts[0], pts[1], pts[4], pts[5]]];
            for (const q of quads) {
                const face = q.map(([x, z]) => [x, s * hy, z]);
                b.band(s > 0 ? face : face.reverse(), water, colour);
            }
        }
    b.quad([-hx, -hy, hz], [hx, -hy, hz], [hx, hy, hz], [-hx, hy, hz], PAINT.deck);
    const u = Math.min(hy / 7, 1);
    for (const s of [1, -1]) {
        b.box([-hx * 0.97, s * hy - 0.25 * u, hz], [hx * 0.97, s * hy + 0.0, hz + 0.35 * u], PAINT.yellow);
        for (let i = -2; i <= 2; ++i)
            for (const d of [-0.5, 0.5])
                b.cylinder([i * hx * 0.42 + d * u, s * hy * 0.86, hz], [i * hx * 0.42 + d * u, s * hy * 0.86, hz + 0.9 * u], 0.24 * u, 8, PAINT.dark);
    }
    b.box([-hx * 0.6, -hy * 0.5, hz], [hx * 0.6, hy * 0.5, hz + 0.7 * u], PAINT.steel);
    return {build: b, bridge: [0, 0, hz + 3]};
}

/// A semi-submersible: two pontoons, six columns, a deck box with a helideck and houses.
export function semi({half: [hx, hy, hz], water = 0}) {
    const b = new Build(), pw = hy * 0.2, ph = hz * 0.42, deckLow = hz * 0.38;
    const colour = z => z < water ? PAINT.bottom : z < water + 0.5 ? PAINT.line : 0xc9a227;
    for (const s of [1, -1]) {
        const y0 = s > 0 ? hy - 2 * pw : -hy, y1 = y0 + 2 * pw;
        b.box([-hx, y0, -hz], [hx, y1, -hz + 2 * ph], PAINT.bottom);
        for (const i of [-1, 0, 1]) {
            const x = i * hx * 0.72, y = (y0 + y1) / 2, r = pw * 0.72;
            b.tube([x, y, -hz + 2 * ph], [x, y, deckLow], r, 18, water, colour);
        }
    }
    for (const i of [-1, 1])
        b.cylinder([i * hx * 0.72, -hy * 0.6, -hz + 2.4 * ph], [i * hx * 0.72, hy * 0.6, -hz + 2.4 * ph], hz * 0.09, 10, PAINT.steel);
    b.box([-hx, -hy, deckLow], [hx, hy, hz], 0xc8cdd0);
    for (let i = 0; i < 9; ++i) {
        const y = -hy + 2 * hy * (i + 0.5) / 9;
        b.box([-hx - 0.06, y - hy * 0.06, deckLow + hz * 0.2], [hx + 0.06, y + hy * 0.06, deckLow + hz * 0.3], PAINT.glass);
    }
    b.quad([-hx, -hy, hz + 0.02], [hx, -hy, hz + 0.02], [hx, hy, hz + 0.02], [-hx, hy, hz + 0.02], PAINT.deck);
    b.box([-hx * 0.95, -hy * 0.55, hz], [-hx * 0.5, hy * 0.55, hz + hz * 0.9], PAINT.house);
    windows(b, -hx * 0.95, -hx * 0.5, hy * 0.55, hz + hz * 0.5, hz + hz * 0.7, false);
    windows(b, -hx * 0.95, -hx * 0.5, hy * 0.55, hz + hz * 0.15, hz + hz * 0.35, false);
    b.cylinder([-hx * 0.86, hy * 0.75, hz * 1.9], [-hx * 0.86, hy * 0.75, hz * 1.98], hx * 0.24, 24, 0x3f7a52);
    b.cylinder([-hx * 0.86, hy * 0.75, hz], [-hx * 0.86, hy * 0.75, hz * 1.9], hx * 0.03, 8, PAINT.steel);
    b.box([hx * 0.45, -hy * 0.8, hz], [hx * 0.9, -hy * 0.35, hz * 1.35], PAINT.steel);
    b.box([hx * 0.45, hy * 0.35, hz], [hx * 0.9, hy * 0.8, hz * 1.3], PAINT.funnel);
    return {build: b, bridge: [-hx * 0.5, 0, hz * 2.1]};
}
