// SPDX-License-Identifier: Apache-2.0
/// Builds from the shapes of a scene: meshes, heightfields, convex hulls of points.
import {Build} from './build.js';

const at = (v, i) => [v[3 * i], v[3 * i + 1], v[3 * i + 2]];

export function meshBuild({vertices, triangles}, colour) {
    const b = new Build();
    for (let i = 0; i + 2 < triangles.length; i += 3)
        b.tri(at(vertices, triangles[i]), at(vertices, triangles[i + 1]), at(vertices, triangles[i + 2]), colour);
    return b;
}

export function heightfieldBuild({rows, columns, cell, heights}, colour) {
    const b = new Build();
    const p = (i, j) => [(j - (columns - 1) / 2) * cell[0], (i - (rows - 1) / 2) * cell[1], heights[i * columns + j]];
    for (let i = 0; i + 1 < rows; ++i)
        for (let j = 0; j + 1 < columns; ++j) b.quad(p(i, j), p(i, j + 1), p(i + 1, j + 1), p(i + 1, j), colour);
    return b;
}

/// Return the faces of the convex hull of a few points, outwards: each triple with all other points on
/// one side. The cost is cubic, so only the first 64 points count; scenes have 4 to 30.
export function convexFaces(vertices) {
    const n = Math.min(64, vertices.length / 3), p = Array.from({length: n}, (_, i) => at(vertices, i)), faces = [];
    const size = Math.max(...p.flat().map(Math.abs), 1e-9);
    const taken = new Set();
    for (let i = 0; i < n; ++i)
        for (let j = i + 1; j < n; ++j)
            for (let k = j + 1; k < n; ++k) {
                const plane = planeOf(p[i], p[j], p[k]);
                if (!plane) continue;
                const sides = p.map(q => plane.n[0] * q[0] + plane.n[1] * q[1] + plane.n[2] * q[2] - plane.d);
                const e = 1e-6 * size, over = sides.some(s => s > e), under = sides.some(s => s < -e);
                if (over && under) continue;
                const flat = sides.map((s, l) => Math.abs(s) <= e ? l : -1).filter(l => l >= 0), key = flat.join();
                if (taken.has(key)) continue;
                taken.add(key);
                faces.push(ordered(flat, p, over ? plane.n.map(v => -v) : plane.n));
            }
    return faces.map(f => f.map(i => p[i]));
}

function planeOf(a, b, c) {
    const u = b.map((v, k) => v - a[k]), w = c.map((v, k) => v - a[k]);
    const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]], l = Math.hypot(...n);
    if (l < 1e-12) return null;
    const m = n.map(v => v / l);
    return {n: m, d: m[0] * a[0] + m[1] * a[1] + m[2] * a[2]};
}

function ordered(indices, p, n) {
    const mid = [0, 1, 2].map(k => indices.reduce((s, i) => s + p[i][k], 0) / indices.length);
    const x = p[indices[0]].map((v, k) => v - mid[k]), y = [n[1] * x[2] - n[2] * x[1], n[2] * x[0] - n[0] * x[2], n[0] * x[1] - n[1] * x[0]];
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const angle = i => {
        const d = p[i].map((v, k) => v - mid[k]);
        return Math.atan2(dot(d, y), dot(d, x));
    };
    return [...indices].sort((a, b) => angle(a) - angle(b));
}

export function hullBuild(vertices, colour) {
    const b = new Build();
    for (const face of convexFaces(vertices)) for (let i = 1; i + 1 < face.length; ++i) b.tri(face[0], face[i], face[i + 1], colour);
    return b;
}

/// A recording's shape: points with a radius round each. One: a ball; two: a capsule; else the hull.
export function pointsBuild({vertices, radius = 0}, colour) {
    const n = vertices.length / 3, b = new Build();
    const ball = p => {
        for (let i = 0; i < 6; ++i) {
            const z = k => p[2] + radius * Math.sin(Math.PI * (k / 6 - 0.5)), r = k => radius * Math.cos(Math.PI * (k / 6 - 0.5)) + 1e-6;
            b.cylinder([p[0], p[1], z(i)], [p[0], p[1], z(i + 1)], r(i), 14, colour, r(i + 1));
        }
    };
    if (n <= 2) {
        for (let i = 0; i < n; ++i) if (radius > 0) ball(at(vertices, i));
        if (n === 2 && radius > 0) b.cylinder(at(vertices, 0), at(vertices, 1), radius, 14, colour);
        return b;
    }
    return hullBuild(vertices, colour);
}
