// SPDX-License-Identifier: Apache-2.0
/// Convert a Build to geometry of three.js. Normals are smoothed between faces at a small angle, and
/// corners are shared by faces.
import {BufferAttribute, BufferGeometry} from 'three';

export function geometryOf(build, crease = 32) {
    const g = new BufferGeometry(), position = new Float32Array(build.position);
    const {index, corners} = shared([position, smooth(position, build.normal, crease), new Float32Array(build.colour)]);
    for (const [i, name] of ['position', 'normal', 'color'].entries()) g.setAttribute(name, new BufferAttribute(corners[i], 3));
    g.setIndex(new BufferAttribute(corners[0].length / 3 > 65535 ? new Uint32Array(index) : new Uint16Array(index), 1));
    g.computeBoundingSphere();
    return g;
}

/// Merge corners with equal `values` (three numbers each): {index, corners}.
export function shared(values) {
    const known = new Map(), index = [], first = [];
    for (let i = 0; i < values[0].length / 3; ++i) {
        const key = values.map(v => [0, 1, 2].map(k => Math.round(v[3 * i + k] * 4096)).join()).join();
        if (!known.has(key)) {
            known.set(key, first.length);
            first.push(i);
        }
        index.push(known.get(key));
    }
    return {index, corners: values.map(v => Float32Array.from({length: 3 * first.length}, (_, k) => v[3 * first[Math.floor(k / 3)] + k % 3]))};
}

function smooth(position, normal, crease) {
    const least = Math.cos(crease * Math.PI / 180), at = new Map(), n = position.length / 3;
    const key = i => `${Math.round(position[3 * i] * 500)},${Math.round(position[3 * i + 1] * 500)},${Math.round(position[3 * i + 2] * 500)}`;
    for (let i = 0; i < n; ++i) {
        const k = key(i);
        if (!at.has(k)) at.set(k, []);
        at.get(k).push(i);
    }
    const out = new Float32Array(normal.length);
    for (const group of at.values()) {
        for (const i of group) {
            let x = 0, y = 0, z = 0;
            for (const k of group) {
                const dot = normal[3 * i] * normal[3 * k] + normal[3 * i + 1] * normal[3 * k + 1] + normal[3 * i + 2] * normal[3 * k + 2];
                if (dot < least) continue;
                x += normal[3 * k]; y += normal[3 * k + 1]; z += normal[3 * k + 2];
            }
            const l = Math.hypot(x, y, z) || 1;
            out[3 * i] = x / l; out[3 * i + 1] = y / l; out[3 * i + 2] = z / l;
        }
    }
    return out;
}
