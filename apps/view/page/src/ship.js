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
    if (xi < -0.55) return 0.72 + 0.2 * (xi + 1) / 0.45;
    if (xi < 0.1) return 0.92;
    const t = Math.min(1, (xi - 0.1) / 0.78);
    return 0.92 * Math.max(0, 1 - t ** 1.8);
}

/// Height of the bottom at ξ. Aft it rises to just below the water, so that the transom stands in it.
function bottomLine(xi, {keel, water}) {
    const stern = Math.max(keel, water - 0.14 * Math.max(0, water - keel));
    const bow = keel + 1.6 * Math.max(0, xi - 0.86) * Math.abs(keel);
    return xi < -0.45 ? keel + (stern - keel) * ((-0.45 - xi) / 0.55) ** 1.5 : xi > 0.86 ? bow : keel;
}

const SECTION = [0, 0.12, 0.3, 0.5, 0.75, 1];  // heights of the points of a section

/// Points of a section at ξ, keel to deck edge: [y, z]. @param h  {hx, hy, keel, water}
function section(xi, h, top) {
    const zk = bottomLine(xi, h), yk = keelLine(xi) * h.hy, yd = deckLine(xi) * h.hy;
    return SECTION.map(s => {
        const bilge = Math.min(1, Math.sqrt(s / 0.3));     // round bilge up to a third
        const flare = s ** 1.4;
        return [(yk + (yd - yk) * flare) * (0.25 + 0.75 * bilge) * (s > 0 ? 1 : 0.999),
                zk + s * (top(xi) - zk)];
    });
}

/// Hull shell from stern to bow, painted below and above the water. @param roller  {x, z, radius, half}:
/// the stern is open across it; null: closed.
function shell(b, h, top, paint, roller) {
    const n = 28, stations = [], {water} = h;
    for (let i = 0; i <= n; ++i) {
        const xi = -1 + 2 * (i / n) ** 0.92;
        stations.push({x: xi * h.hx * 0.999, pts: section(Math.min(xi, 0.9985), h, top)});
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
    transom(b, stations[0], water, colour, roller);
    for (let i = 0; i < n; ++i) {      // bottom
        const p = stations[i], q = stations[i + 1];
        b.quad([p.x, p.pts[0][0], p.pts[0][1]], [p.x, -p.pts[0][0], p.pts[0][1]],
               [q.x, -q.pts[0][0], q.pts[0][1]], [q.x, q.pts[0][0], q.pts[0][1]], PAINT.bottom);
    }
    return stations;
}

/// The stern plate. Across a roller it ends below the roller; behind the roller is an apron.
function transom(b, {x, pts}, water, colour, roller) {
    const {half = 0, z = 0, radius = 0} = roller ?? {}, sill = z - 1.1 * radius, back = roller ? roller.x + 1.12 * radius : 0;
    for (let k = 0; k + 1 < SECTION.length; ++k) {
        const [y0, z0] = pts[k], [y1, z1] = pts[k + 1];
        if (!roller || z1 <= sill) {
            b.band([[x, y0, z0], [x, y1, z1], [x, -y1, z1], [x, -y0, z0]], water, colour);
            continue;
        }
        const lo = Math.max(z0, Math.min(z1, sill)), yl = z1 > z0 ? y0 + (y1 - y0) * (lo - z0) / (z1 - z0) : y0;
        if (lo > z0) b.band([[x, y0, z0], [x, yl, lo], [x, -yl, lo], [x, -y0, z0]], water, colour);
        for (const s of [1, -1]) {
            const quad = [[x, s * half, lo], [x, s * half, z1], [x, s * Math.max(y1, half), z1], [x, s * Math.max(yl, half), lo]];
            b.band(s > 0 ? quad.reverse() : quad, water, colour);
        }
    }
    if (!roller) return;
    const top = pts.at(-1)[1], floor = Math.max(sill, pts[0][1]);
    for (const s of [1, -1]) b.both([x, s * half, floor], [back, s * half, floor], [back, s * half, top], [x, s * half, top], PAINT.dark);
    b.both([x, -half, floor], [x, half, floor], [back, half, floor], [back, -half, floor], PAINT.dark);
    b.both([back, -half, floor], [back, half, floor], [back, half, top], [back, -half, top], PAINT.dark);
}

/// A level deck between two stations, inside the hull's edge. @param half  Half width left open; 0: none.
function deck(b, {hx, hy}, from, to, z, colour, inset = 0.985, half = 0) {
    const n = 18;
    for (let i = 0; i < n; ++i) {
        const a = from + (to - from) * i / n, c = from + (to - from) * (i + 1) / n;
        const ya = deckLine(Math.min(a, 0.995)) * hy * inset, yc = deckLine(Math.min(c, 0.995)) * hy * inset;
        if (!half) b.quad([a * hx, -ya, z], [c * hx, -yc, z], [c * hx, yc, z], [a * hx, ya, z], colour);
        else for (const s of [1, -1]) {
            const quad = [[a * hx, s * half, z], [c * hx, s * half, z], [c * hx, s * yc, z], [a * hx, s * ya, z]];
            b.quad(...(s > 0 ? quad : quad.reverse()), colour);
        }
    }
}

/// Bulwark: a thin wall along the deck's edge, with a cap rail.
function bulwark(b, {hx, hy}, from, to, z0, z1, colour) {
    const n = 18, t = 0.22;
    for (const side of [1, -1]) {
        for (let i = 0; i < n; ++i) {
            const a = from + (to - from) * i / n, c = from + (to - from) * (i + 1) / n;
            const ya = side * deckLine(Math.min(a, 0.995)) * hy, yc = side * deckLine(Math.min(c, 0.995)) * hy;
            const A = a * hx, C = c * hx, in_ = side * t;
            b.both([A, ya, z0], [C, yc, z0], [C, yc, z1], [A, ya, z1], colour);
            b.both([A, ya - in_, z0], [C, yc - in_, z0], [C, yc - in_, z1], [A, ya - in_, z1], PAINT.house);
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

/// A ship: {half, keel: height of the keel, deck: height of the working deck or null, water, paint,
/// roller: {x, z, radius, half} in the open stern or null, own: the roller is drawn with the ship}.
/// Return the build, the position of the bridge (for cameras), the deck and its forward end.
export function ship({half, keel = -half[2], deck: deckHeight = null, break: breakAt = null, water = 0, paint = HULLS[0], roller = null, own = false}) {
    const b = new Build(), [hx, hy, hz] = half, u = Math.min(hy / 9, hx / 30), h = {hx, hy, keel, water};   // u: scale of fittings
    const low = deckHeight ?? hz * 0.55;
    const split = Math.min(0.5, Math.max(-0.2, breakAt ?? 0.2));
    const high = Math.max(hz, low + 1.5 * u);
    const sheer = xi => xi < split ? low : xi < split + 0.06
        ? low + (high - low) * (xi - split) / 0.06
        : high + 1.2 * u * ((xi - split) / (1 - split)) ** 2;
    shell(b, h, sheer, paint, roller);
    const front = roller ? Math.max(-0.98, (roller.x + 0.72 * roller.radius) / hx) : -1;
    if (roller) deck(b, h, -0.999, front, low, PAINT.deck, 0.985, roller.half);
    deck(b, h, front, split + 0.01, low, PAINT.deck);
    for (let i = -3; i <= 3; ++i)      // wooden sheathing of the working deck
        b.box([(front + 0.05) * hx, (i - 0.42) * hy * 0.24, low - 0.05], [(split - 0.03) * hx, (i + 0.42) * hy * 0.24, low + 0.012], PAINT.wood);
    deck(b, h, split, 0.985, high, PAINT.deck, 0.97);
    const wall = deckLine(split) * hy * 0.985;
    b.both([split * hx, -wall, low], [split * hx, wall, low], [split * hx, wall, high], [split * hx, -wall, high], PAINT.house);
    bulwark(b, h, -0.985, split + 0.03, low - 0.05, low + 1.1 * u, paint);
    bulwark(b, h, split + 0.06, 0.99, high - 0.05, high + 1.0 * u, PAINT.house);
    // Crash rails inside the bulwark, with stanchions.
    for (const s of [1, -1]) {
        const y = s * hy * 0.86;
        b.box([-0.93 * hx, y - 0.3 * u, low + 1.5 * u], [(split - 0.05) * hx, y + 0.3 * u, low + 1.95 * u], PAINT.steel);
        for (let i = 0; i <= 8; ++i) {
            const x = -0.92 * hx + (split + 0.86) * hx * i / 8;
            b.box([x - 0.15 * u, y - 0.2 * u, low], [x + 0.15 * u, y + 0.2 * u, low + 1.5 * u], PAINT.steel);
        }
    }
    // Forecastle, accommodation and bridge.
    const storey = 2.7 * u, x0 = (split + 0.07) * hx, x1 = Math.min(0.74, split + 0.42) * hx;
    house(b, x0, x1, hy * 0.66, high, 2, storey);
    const bridge0 = x0 + 0.18 * (x1 - x0), bridge1 = x1 - 0.16 * (x1 - x0), top = high + 2 * storey;
    house(b, bridge0, bridge1, hy * 0.6, top, 1, storey * 1.05);
    const roof = top + storey * 1.05;
    b.box([bridge0 + 0.3, -hy * 0.74, top + 0.1 * storey], [bridge0 + 2.6 * u, hy * 0.74, top + 0.5 * storey], PAINT.house);
    mast(b, (bridge0 + bridge1) / 2, roof, u);
    for (const s of [1, -1]) {
        const x = x0 + 1.2 * u, y = s * hy * 0.5;
        b.box([x - 1.1 * u, y - 0.9 * u, high], [x + 1.6 * u, y + 0.9 * u, roof + 0.9 * u], PAINT.funnel);
        b.box([x - 1.0 * u, y - 0.8 * u, roof + 0.9 * u], [x + 1.2 * u, y + 0.8 * u, roof + 1.5 * u], PAINT.dark);
    }
    b.cylinder([0.86 * hx, 0, high], [0.86 * hx, 0, high + 1.1 * u], 0.9 * u, 10, PAINT.steel);
    if (roller && own) {
        b.cylinder([roller.x, -roller.half, roller.z], [roller.x, roller.half, roller.z], roller.radius, 24, PAINT.steel);
        for (let i = 0; i < 4; ++i) {
            const w = i * Math.PI / 2 + 0.6, e = roller.radius * 1.004, c = Math.cos(w), n = Math.sin(w), t = 0.08 * roller.radius;
            const p = (d, y) => [roller.x + e * c - d * n, y, roller.z + e * n + d * c];
            b.both(p(-t, -roller.half), p(t, -roller.half), p(t, roller.half), p(-t, roller.half), PAINT.dark);
        }
    }
    // Eyes at the windows of the wheelhouse: forward, and aft over the working deck.
    return {build: b, bridge: [bridge1 + 0.5 * u, 0, top + 0.66 * storey], conn: [bridge0 - 0.6 * u, 0, top + 0.72 * storey], eye: [(split - 0.02) * hx, -0.62 * hy, low + 4.4 * u], low, high, front: split * hx};
}

/// Roller that a ship has if its scene has none: its top is at the level of the working deck.
export const sternRoller = ([hx, hy], deck) => {
    const radius = 0.17 * hy;
    return {x: -hx + 0.25 * radius, z: deck - 0.8 * radius, radius, half: 0.36 * hy};
};

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

/// A semi-submersible: pontoons and columns, by its wetted mesh if there is one, a deck box on the
/// columns, houses, helideck, cranes' pedestals and, unless the scene has one, a derrick.
export function semi({half: [hx, hy, hz], water = 0, wetted = null, derrick = true}) {
    const b = new Build(), pw = hy * 0.2, ph = hz * 0.42;
    const colour = z => z < water ? PAINT.bottom : z < water + 0.5 ? PAINT.line : 0xc9a227;
    const v = wetted?.vertices ?? [], at = i => [v[3 * i], v[3 * i + 1], v[3 * i + 2]];
    let columns = -Infinity;   // top of the wetted mesh
    for (let i = 2; i < v.length; i += 3) columns = Math.max(columns, v[i]);
    const high = columns > -hz && columns < hz ? columns + 0.35 * (hz - columns) : hz, deckLow = columns > -hz && columns < hz ? columns - 0.3 * (hz - columns) : hz * 0.38;
    if (columns > -Infinity)
        for (let i = 0; i + 2 < wetted.triangles.length; i += 3) b.band([0, 1, 2].map(k => at(wetted.triangles[i + k])), water, colour, 0.5);
    else {
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
    }
    const t = high - deckLow, d = 0.45 * hz;   // thickness of the deck box, height of a storey of two
    b.box([-hx, -hy, deckLow], [hx, hy, high], 0xc8cdd0);
    for (let i = 0; i < 9; ++i) {
        const y = -hy + 2 * hy * (i + 0.5) / 9;
        b.box([-hx - 0.06, y - hy * 0.06, deckLow + t * 0.35], [hx + 0.06, y + hy * 0.06, deckLow + t * 0.6], PAINT.glass);
    }
    b.quad([-hx, -hy, high + 0.02], [hx, -hy, high + 0.02], [hx, hy, high + 0.02], [-hx, hy, high + 0.02], PAINT.deck);
    for (const s of [1, -1]) {   // rails
        b.box([-hx, s * hy - 0.1, high + 1], [hx, s * hy + 0.1, high + 1.15], PAINT.yellow);
        b.box([s * hx - 0.1, -hy, high + 1], [s * hx + 0.1, hy, high + 1.15], PAINT.yellow);
    }
    b.box([-hx * 0.95, -hy * 0.55, high], [-hx * 0.5, hy * 0.55, high + 2 * d], PAINT.house);
    windows(b, -hx * 0.95, -hx * 0.5, hy * 0.55, high + 1.1 * d, high + 1.5 * d, false);
    windows(b, -hx * 0.95, -hx * 0.5, hy * 0.55, high + 0.35 * d, high + 0.75 * d, false);
    b.cylinder([-hx * 0.86, hy * 0.75, high + 2 * d], [-hx * 0.86, hy * 0.75, high + 2.1 * d], hx * 0.24, 24, 0x3f7a52);
    b.cylinder([-hx * 0.86, hy * 0.75, high], [-hx * 0.86, hy * 0.75, high + 2 * d], hx * 0.03, 8, PAINT.steel);
    b.box([hx * 0.55, -hy * 0.8, high], [hx * 0.9, -hy * 0.35, high + 0.7 * d], PAINT.steel);
    b.box([hx * 0.1, hy * 0.25, high], [hx * 0.4, hy * 0.6, high + 0.6 * d], PAINT.funnel);
    for (let i = 0; i < 5; ++i)   // pipe rack
        b.cylinder([-hx * 0.3, -hy * (0.35 + 0.05 * i), high + 1.1], [hx * 0.35, -hy * (0.35 + 0.05 * i), high + 1.1], 0.45, 6, PAINT.dark);
    if (derrick) {
        const base = 0.17 * hy, tall = 0.95 * hx, foot = high + 0.5 * d, tower = new Build();
        b.box([-base * 1.3, -base * 1.3, high], [base * 1.3, base * 1.3, foot], PAINT.steel);
        tower.lattice(tall / 2, [base, base], [base * 0.3, base * 0.3], 9, 0.055 * base, 0xb5481f, PAINT.line);
        tower.transform([[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, foot + tall / 2]]);
        b.append(tower);
        b.box([-base * 0.34, -base * 0.34, foot + tall], [base * 0.34, base * 0.34, foot + tall * 1.03], PAINT.yellow);
    }
    return {build: b, bridge: [-hx * 0.5, 0, high + 2.2 * d], low: high};
}
