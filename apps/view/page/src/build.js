// SPDX-License-Identifier: Apache-2.0
/// Collects coloured triangles; flat shaded, one geometry at the end. Plain numbers, so that hull
/// lines and lattices are tested without a renderer.

const channels = hex => [(hex >> 16 & 255) / 255, (hex >> 8 & 255) / 255, (hex & 255) / 255];
const linear = s => s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
const cut = (p, q, z) => {
    const t = (z - p[2]) / (q[2] - p[2]);
    return [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), z];
};

export class Build {
    constructor() {
        this.position = [];
        this.normal = [];
        this.colour = [];
    }

    tri(a, b, c, hex) {
        const u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]], v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        const l = Math.hypot(...n);
        if (!(l > 1e-12)) return;
        const rgb = channels(hex).map(linear);
        for (const p of [a, b, c]) {
            this.position.push(...p);
            this.normal.push(n[0] / l, n[1] / l, n[2] / l);
            this.colour.push(...rgb);
        }
    }

    quad(a, b, c, d, hex) {
        this.tri(a, b, c, hex);
        this.tri(a, c, d, hex);
    }

    /// A thin wall: seen from both sides, as materials here are.
    both(a, b, c, d, hex) {
        this.quad(a, b, c, d, hex);
    }

    /// A convex polygon, cut at a height and just above it, painted by the height of each part.
    band(points, z, colour, stripe = 0.35) {
        for (const [lo, hi] of [[-Infinity, z], [z, z + stripe], [z + stripe, Infinity]]) {
            const part = clip(clip(points, lo, 1), hi, -1);
            const mid = part.reduce((s, p) => s + p[2], 0) / (part.length || 1);
            for (let i = 1; i + 1 < part.length; ++i) this.tri(part[0], part[i], part[i + 1], colour(mid));
        }
    }

    /// Axis-aligned box between two corners.
    box(lo, hi, hex) {
        const [a, b, c] = lo, [x, y, z] = hi;
        this.quad([x, b, c], [x, y, c], [x, y, z], [x, b, z], hex);
        this.quad([a, y, c], [a, b, c], [a, b, z], [a, y, z], hex);
        this.quad([x, y, c], [a, y, c], [a, y, z], [x, y, z], hex);
        this.quad([a, b, c], [x, b, c], [x, b, z], [a, b, z], hex);
        this.quad([a, b, z], [x, b, z], [x, y, z], [a, y, z], hex);
        this.quad([a, y, c], [x, y, c], [x, b, c], [a, b, c], hex);
    }

    /// A cylinder from p to q with n sides, its ends closed or not; its side is shaded round.
    cylinder(p, q, r, n, hex, r1 = r, closed = true) {
        const [e1, e2] = across(p, q), rgb = channels(hex).map(linear);
        const ring = (at, radius, i) => {
            const w = 2 * Math.PI * i / n, c = Math.cos(w), s = Math.sin(w);
            return at.map((v, k) => v + radius * (c * e1[k] + s * e2[k]));
        };
        const out = i => {
            const w = 2 * Math.PI * i / n;
            return e1.map((v, k) => Math.cos(w) * v + Math.sin(w) * e2[k]);
        };
        for (let i = 0; i < n; ++i) {
            const corner = [[p, r, i], [p, r, i + 1], [q, r1, i + 1], [p, r, i], [q, r1, i + 1], [q, r1, i]];
            for (const [at, radius, k] of corner) {
                this.position.push(...ring(at, radius, k));
                this.normal.push(...out(k));
                this.colour.push(...rgb);
            }
            if (!closed) continue;
            this.tri(p, ring(p, r, i + 1), ring(p, r, i), hex);
            this.tri(q, ring(q, r1, i), ring(q, r1, i + 1), hex);
        }
    }

    /// An upright cylinder painted by height.
    tube(p, q, r, n, z, colour) {
        const cuts = [p[2], z, z + 0.5, q[2]].filter((v, i) => i === 0 || i === 3 || (v > p[2] && v < q[2]));
        for (let i = 0; i + 1 < cuts.length; ++i)
            this.cylinder([p[0], p[1], cuts[i]], [q[0], q[1], cuts[i + 1]], r, n, colour((cuts[i] + cuts[i + 1]) / 2));
    }

    /// A lattice along x in a box [−hx, hx] that narrows from `from` to `to` (half sizes [y, z]).
    lattice(hx, from, to, bays, r, hex, other = hex) {
        const at = i => {
            const t = i / bays, y = from[0] + t * (to[0] - from[0]), z = from[1] + t * (to[1] - from[1]);
            return [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([a, b]) => [-hx + 2 * hx * t, a * y, b * z]);
        };
        for (let i = 0; i < bays; ++i) {
            const a = at(i), b = at(i + 1), hue = i % 2 ? other : hex;
            for (let k = 0; k < 4; ++k) {
                const n = (k + 1) % 4;
                this.cylinder(a[k], b[k], r, 5, hue);
                this.cylinder(...(i % 2 ? [a[k], b[n]] : [a[n], b[k]]), r * 0.55, 4, hue);
                this.cylinder(b[k], b[n], r * 0.55, 4, hue);
            }
        }
    }

    /// Transform all triangles by a matrix of rows [[…3, t], …].
    transform(m) {
        const apply = (array, w) => {
            for (let i = 0; i < array.length; i += 3) {
                const [x, y, z] = [array[i], array[i + 1], array[i + 2]];
                for (let k = 0; k < 3; ++k) array[i + k] = m[k][0] * x + m[k][1] * y + m[k][2] * z + w * m[k][3];
            }
        };
        apply(this.position, 1);
        apply(this.normal, 0);
        return this;
    }

    append(other) {
        for (const key of ['position', 'normal', 'colour'])
            for (const v of other[key]) this[key].push(v);
        return this;
    }

    get triangles() {
        return this.position.length / 9;
    }
}

function clip(points, z, sign) {
    if (!Number.isFinite(z)) return points;
    const out = [], side = p => sign * (p[2] - z) >= 0;
    points.forEach((p, i) => {
        const q = points[(i + 1) % points.length];
        if (side(p)) out.push(p);
        if (side(p) !== side(q)) out.push(cut(p, q, z));
    });
    return out;
}

function across(p, q) {
    const d = q.map((v, k) => v - p[k]), l = Math.hypot(...d) || 1, u = d.map(v => v / l);
    const ref = Math.abs(u[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
    const c = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const e1 = c(ref, u), n = Math.hypot(...e1), w = e1.map(v => v / n);
    return [w, c(u, w)];
}
