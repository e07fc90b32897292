// SPDX-License-Identifier: Apache-2.0
/// A Build as geometry of three.js, with normals smoothed where faces meet at a small angle.
import {BufferAttribute, BufferGeometry} from 'three';

export function geometryOf(build, crease = 32) {
    const g = new BufferGeometry(), position = new Float32Array(build.position);
    g.setAttribute('position', new BufferAttribute(position, 3));
    g.setAttribute('normal', new BufferAttribute(smooth(position, build.normal, crease), 3));
    g.setAttribute('color', new BufferAttribute(new Float32Array(build.colour), 3));
    g.computeBoundingSphere();
    return g;
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
