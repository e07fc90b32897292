// SPDX-License-Identifier: Apache-2.0
/// Booms, towers, hooks, anchors, drums and sheaves from boxes and cylinders. Frames and sizes are
/// those of the body [m].
import {Build} from './build.js';

export const PAINT = {crane: 0xe7a416, dark: 0x31383e, steel: 0x8b949a, anchor: 0x4a5157,
                      red: 0xb5481f, white: 0xf1f2ee, rope: 0x9a8f78, cargo: 0x4d7a8c};

/// A box girder that narrows towards its head (+x), with dark pins at both ends.
export function boom([hx, hy, hz], colour = PAINT.crane) {
    const b = new Build(), t = 0.6;
    const a = [[-hx, -hy, -hz], [-hx, hy, -hz], [-hx, hy, hz], [-hx, -hy, hz]];
    const c = [[hx, -hy * t, -hz * t], [hx, hy * t, -hz * t], [hx, hy * t, hz * t], [hx, -hy * t, hz * t]];
    for (let i = 0; i < 4; ++i) b.quad(a[i], a[(i + 1) % 4], c[(i + 1) % 4], c[i], colour);
    b.quad(...[...a].reverse(), colour);
    b.quad(...c, colour);
    b.cylinder([-hx, -hy * 1.25, 0], [-hx, hy * 1.25, 0], hz * 0.8, 12, PAINT.dark);
    b.cylinder([hx, -hy * t * 1.3, 0], [hx, hy * t * 1.3, 0], hz * 0.65, 12, PAINT.dark);
    return b;
}

/// A long truss boom along x.
export function truss([hx, hy, hz], colour = PAINT.crane) {
    const b = new Build(), bays = Math.max(4, Math.min(16, Math.round(hx / Math.max(hy, hz))));
    b.lattice(hx, [hy, hz], [hy * 0.6, hz * 0.6], bays, Math.min(hy, hz) * 0.12, colour);
    return b;
}

/// An upright lattice tower: a derrick with a crown block.
export function tower([hx, hy, hz]) {
    const b = new Build();
    b.lattice(hz, [hx, hy], [hx * 0.3, hy * 0.3], 9, Math.min(hx, hy) * 0.055, PAINT.red, PAINT.white);
    b.transform([[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0]]);
    b.box([-hx * 0.34, -hy * 0.34, hz - 0.02 * hz], [hx * 0.34, hy * 0.34, hz * 1.03], PAINT.crane);
    b.box([-hx, -hy, -hz], [hx, hy, -hz * 0.97], PAINT.steel);
    return b;
}

/// Hook block: two cheeks with a sheave, and the hook below.
export function hook([hx, hy, hz]) {
    const b = new Build(), r = Math.min(hx, hy, hz);
    for (const s of [1, -1]) b.box([-hx, s * hy * 0.7 - 0.1 * hy, -0.2 * hz], [hx, s * hy * 0.7 + 0.1 * hy, hz], PAINT.crane);
    b.cylinder([0, -hy * 0.6, hz * 0.35], [0, hy * 0.6, hz * 0.35], r * 0.75, 16, PAINT.dark);
    b.cylinder([0, 0, -0.2 * hz], [0, 0, -0.55 * hz], r * 0.22, 8, PAINT.dark);
    const n = 9;
    for (let i = 0; i < n; ++i) {
        const at = k => [r * 0.5 * Math.sin(-0.4 + 4.2 * k / n), 0, -hz * 0.75 + r * 0.5 * Math.cos(-0.4 + 4.2 * k / n)];
        b.cylinder(at(i), at(i + 1), r * 0.17, 7, PAINT.dark, r * (0.17 - 0.01 * i));
    }
    return b;
}

/// Stockless-type anchor in its box: shank along +x, two flukes.
export function anchor([hx, hy, hz]) {
    const b = new Build(), c = PAINT.anchor;
    b.box([-hx, -hy * 0.1, -hz * 0.35], [hx * 0.85, hy * 0.1, hz * 0.35], c);
    b.cylinder([-hx, -hy * 0.22, 0], [-hx, hy * 0.22, 0], hz * 0.5, 12, c);
    b.box([hx * 0.55, -hy * 0.7, -hz * 0.6], [hx, hy * 0.7, hz * 0.6], c);
    for (const s of [1, -1]) {
        const y0 = s * hy * 0.3, y1 = s * hy * 0.98;
        const f = [[hx * 0.95, y0, 0], [hx * 0.95, y1, 0], [-hx * 0.45, s * hy * 0.55, hz * 0.95]];
        const g = f.map(([x, y, z]) => [x, y, z - hz * 0.35]);
        b.tri(f[0], f[1], f[2], c);
        b.tri(g[0], g[2], g[1], c);
        for (let i = 0; i < 3; ++i) b.both(f[i], f[(i + 1) % 3], g[(i + 1) % 3], g[i], c);
    }
    return b;
}

/// A cylinder about z, with darker caps and stripes that show its rotation.
export function roller(radius, length, colour = PAINT.steel, stripes = true) {
    const b = new Build(), h = length / 2;
    b.cylinder([0, 0, -h], [0, 0, h], radius, 28, colour);
    if (stripes && radius > 0.25)
        for (let i = 0; i < 4; ++i) {
            const w = i * Math.PI / 2, c = Math.cos(w), s = Math.sin(w), e = radius * 1.004, t = radius * 0.09;
            const p = (d, z) => [e * c - d * s, e * s + d * c, z];
            b.both(p(-t, -h), p(t, -h), p(t, h), p(-t, h), PAINT.dark);
        }
    return b;
}

/// Rope on a drum about z, in lays.
export function rope(radius, length, sides = 24) {
    const b = new Build(), h = length / 2, lays = sides < 16 ? 1 : 9;
    for (let i = 0; i < lays; ++i) {
        const z = -h + length * (i + 0.5) / lays;
        b.cylinder([0, 0, z - length / lays / 2], [0, 0, z + length / lays / 2], radius, sides, i % 2 ? 0x847a63 : PAINT.rope, radius, false);
    }
    return b;
}

/// Flanges of a drum about z with spokes, and its core and shaft.
export function flanges(radius, length, sides = 28) {
    const b = new Build(), h = length / 2;
    b.cylinder([0, 0, -h], [0, 0, h], 0.34 * radius, Math.min(12, sides), PAINT.steel, 0.34 * radius, false);
    for (const s of [1, -1]) {
        if (sides > 16) b.cylinder([0, 0, s * h], [0, 0, s * (h + 0.5 * radius)], radius * 0.17, 10, PAINT.steel);
        b.cylinder([0, 0, s * h - 0.08 * radius], [0, 0, s * h + 0.08 * radius], radius * 1.35, sides, PAINT.crane);
        for (let i = 0; i < 6 && sides > 16; ++i) {
            const w = i * Math.PI / 3, c = Math.cos(w), n = Math.sin(w), z = s * (h + 0.09 * radius);
            const lo = radius * 0.3, hi = radius * 1.3, t = radius * 0.09;
            b.both([lo * c - t * n, lo * n + t * c, z], [hi * c - t * n, hi * n + t * c, z],
                   [hi * c + t * n, hi * n - t * c, z], [lo * c + t * n, lo * n - t * c, z], PAINT.dark);
        }
    }
    return b;
}

/// A straight piece of wire about z.
export function lead(radius, length) {
    const b = new Build();
    b.cylinder([0, 0, -length / 2], [0, 0, length / 2], radius, 6, 0x5b656c, radius, false);
    return b;
}

/// A davit: a column from `foot` to `head`, and a boom from there to the point where the wire hangs.
export function davit(foot, head, point) {
    const b = new Build(), out = point.map((v, k) => v - head[k]), long = Math.hypot(...out) || 1;
    b.cylinder(foot, [foot[0], foot[1], head[2] + 0.6], 0.75, 14, PAINT.crane, 0.55);
    b.cylinder(foot, [foot[0], foot[1], foot[2] + 0.5], 1.1, 14, PAINT.dark);
    b.cylinder([head[0], head[1], head[2] + 0.3], [point[0], point[1], point[2] + 0.5], 0.5, 10, PAINT.crane, 0.32);
    b.cylinder([foot[0], foot[1], head[2] - 0.35 * (head[2] - foot[2])], head.map((v, k) => v + out[k] / long * 0.65 * long + (k === 2 ? 0.2 : 0)), 0.2, 8, PAINT.steel);
    return b;
}

/// A quay or another fixed block: concrete with a coping and a rail of bollards.
export function quay([hx, hy, hz]) {
    const b = new Build(), t = Math.min(0.4, 0.1 * hz);
    b.box([-hx, -hy, -hz], [hx, hy, hz - t], 0x8b8d87);
    b.box([-hx - 0.1, -hy - 0.1, hz - t], [hx + 0.1, hy + 0.1, hz], 0xb3b4ad);
    const n = Math.min(16, Math.floor(hx / 6));
    for (let i = 0; i < n; ++i)
        for (const s of [1, -1]) b.cylinder([-hx + 2 * hx * (i + 0.5) / n, s * (hy - 0.7), hz], [-hx + 2 * hx * (i + 0.5) / n, s * (hy - 0.7), hz + 0.6], 0.3, 8, PAINT.dark);
    return b;
}

/// A nozzle along x with a propeller of four blades.
export function nozzle(radius) {
    const b = new Build(), n = 18, l = 0.5 * radius;
    b.cylinder([-l, 0, 0], [l, 0, 0], radius, n, PAINT.red, 1.12 * radius, false);
    b.cylinder([-l, 0, 0], [l, 0, 0], 0.94 * radius, n, PAINT.dark, 0.98 * radius, false);
    b.cylinder([-0.6 * l, 0, 0], [l, 0, 0], 0.2 * radius, 8, 0xb08d3c);
    for (let i = 0; i < 4; ++i) {
        const w = i * Math.PI / 2 + 0.4, c = Math.cos(w), s = Math.sin(w), t = 0.22 * radius, e = 0.9 * radius;
        b.both([0.2 * l, -t * s, t * c], [-0.2 * l, t * s, -t * c], [-0.3 * l, e * c + t * s, e * s - t * c], [0.3 * l, e * c - t * s, e * s + t * c], 0xb08d3c);
    }
    b.box([-0.3 * radius, -0.12 * radius, 0.95 * radius], [0.3 * radius, 0.12 * radius, 1.9 * radius], PAINT.red);
    return b;
}

/// A rudder blade about its stock.
export function rudder(radius) {
    const b = new Build();
    b.box([-0.9 * radius, -0.09 * radius, -1.1 * radius], [0.4 * radius, 0.09 * radius, 1.1 * radius], PAINT.red);
    return b;
}

/// Supports of a drum at both ends of its shaft: bearings on feet down to the deck (+y of the part,
/// which points down if the drum lies athwart), `foot` below the shaft.
export function bearings(radius, length, foot = 1.5 * radius) {
    const b = new Build(), steel = PAINT.dark;
    for (const s of [1, -1]) {
        const z = s * (length / 2 + 0.32 * radius), t = 0.1 * radius;
        b.cylinder([0, 0, z - t], [0, 0, z + t], 0.3 * radius, 12, steel);
        b.quad([0.2 * radius, 0, z - t], [-0.2 * radius, 0, z - t], [-0.75 * radius, foot, z - t], [0.75 * radius, foot, z - t], steel);
        b.quad([-0.2 * radius, 0, z + t], [0.2 * radius, 0, z + t], [0.75 * radius, foot, z + t], [-0.75 * radius, foot, z + t], steel);
        for (const e of [1, -1]) b.both([e * 0.2 * radius, 0, z - t], [e * 0.2 * radius, 0, z + t], [e * 0.75 * radius, foot, z + t], [e * 0.75 * radius, foot, z - t], steel);
    }
    return b;
}

/// A sheave about z: a grooved wheel with holes that show its rotation.
export function sheave(radius, width = radius * 0.25) {
    const b = new Build(), h = width / 2;
    b.cylinder([0, 0, -h * 0.4], [0, 0, h * 0.4], radius * 0.94, 24, PAINT.steel);
    for (const s of [1, -1]) b.cylinder([0, 0, s * h], [0, 0, s * h * 0.4], radius, 24, PAINT.crane);
    for (const s of [1, -1])
        for (let i = 0; i < 5; ++i) {
            const w = i * 2 * Math.PI / 5, at = [0.6 * radius * Math.cos(w), 0.6 * radius * Math.sin(w)];
            b.cylinder([...at, s * h * 1.0], [...at, s * h * 1.04], radius * 0.15, 10, PAINT.dark);
        }
    b.cylinder([0, 0, -h * 1.3], [0, 0, h * 1.3], radius * 0.2, 12, PAINT.dark);
    return b;
}

/// The distant form of a sheave.
export function farSheave(radius, width = radius * 0.25) {
    const b = new Build();
    b.cylinder([0, 0, -width / 2], [0, 0, width / 2], radius, 12, PAINT.crane);
    return b;
}

/// A capsule about z.
export function capsule(radius, length, colour = PAINT.dark, sides = 16, n = 4) {
    const b = new Build(), h = length / 2;
    b.cylinder([0, 0, -h], [0, 0, h], radius, sides, colour, radius, false);
    for (const s of [1, -1])
        for (let i = 0; i < n; ++i) {
            const a = Math.PI / 2 * i / n, c = Math.PI / 2 * (i + 1) / n;
            b.cylinder([0, 0, s * (h + radius * Math.sin(a))], [0, 0, s * (h + radius * Math.sin(c))],
                       radius * Math.cos(a), sides, colour, radius * Math.cos(c) + 1e-6, false);
        }
    return b;
}

/// A ball.
export function ball(radius, colour = PAINT.red) {
    const b = new Build(), n = 10, m = 18;
    const at = (i, k) => {
        const a = Math.PI * i / n - Math.PI / 2, w = 2 * Math.PI * k / m;
        return [Math.cos(a) * Math.cos(w), Math.cos(a) * Math.sin(w), Math.sin(a)];
    };
    for (let i = 0; i < n; ++i)
        for (let k = 0; k < m; ++k) {
            const hue = i === n / 2 ? PAINT.white : colour;
            const p = [at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)].map(v => v.map(x => x * radius));
            b.quad(...p, hue);
        }
    return b;
}

/// A container-like box with ribs.
export function crate([hx, hy, hz], colour = PAINT.cargo) {
    const b = new Build(), t = 0.04 * Math.min(hx, hy, hz);
    b.box([-hx + t, -hy + t, -hz], [hx - t, hy - t, hz - t], colour);
    const e = 0.09 * Math.min(hx, hy, hz);
    for (const x of [-1, 1])
        for (const y of [-1, 1]) {
            const [a, c] = [x * hx, y * hy];
            b.box([Math.min(a, a - x * e), Math.min(c, c - y * e), -hz], [Math.max(a, a - x * e), Math.max(c, c - y * e), hz], PAINT.dark);
        }
    for (const z of [-hz, hz - e]) {
        for (const y of [-1, 1]) b.box([-hx, y > 0 ? hy - e : -hy, z], [hx, y > 0 ? hy : -hy + e, z + e], PAINT.dark);
        for (const x of [-1, 1]) b.box([x > 0 ? hx - e : -hx, -hy, z], [x > 0 ? hx : -hx + e, hy, z + e], PAINT.dark);
    }
    return b;
}
