// SPDX-License-Identifier: Apache-2.0
/// The grid of sea surface and seabed: rings about the eye. Only the visible part is drawn.
import {BufferAttribute, BufferGeometry, Vector3} from 'three';

/// Rings about the eye: fine near it, to `far` metres. Vertices in units of 1 m, scaled by script.
export function rings(far, inner, spokes = 96, count = 76) {
    const position = [0, 0, 0], index = [];
    for (let i = 0; i < count; ++i) {
        const r = inner * (far / inner) ** (i / (count - 1));
        for (let k = 0; k < spokes; ++k)
            position.push(r * Math.cos(2 * Math.PI * k / spokes), r * Math.sin(2 * Math.PI * k / spokes), 0);
    }
    for (let k = 0; k < spokes; ++k) {   // one spoke behind the other: drawSector() draws some of them
        index.push(0, 1 + k, 1 + (k + 1) % spokes);
        for (let i = 0; i + 1 < count; ++i) {
            const a = 1 + i * spokes + k, b = 1 + i * spokes + (k + 1) % spokes;
            index.push(a, a + spokes, b + spokes, a, b + spokes, b);
        }
    }
    const g = new BufferGeometry();
    g.userData = {spokes, corners: 3 + 6 * (count - 1)};
    g.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
    g.setIndex(index);
    return g;
}

/// Return the visible spokes, from `first` on, from the bearings [rad] of the picture's corners about
/// its middle. Return all spokes for a steep view, in which they lie around the eye.
export function sector(middle, corners, spokes) {
    const step = 2 * Math.PI / spokes, off = corners.map(a => Math.atan2(Math.sin(a - middle), Math.cos(a - middle)));
    const least = Math.min(...off, 0), most = Math.max(...off, 0);
    if (Math.max(-least, most) > 1.4) return {first: 0, count: spokes};
    const first = Math.floor((middle + least) / step);
    return {first, count: Math.min(spokes, Math.ceil((middle + most) / step) - first)};
}

const kCorners = [[0, 0], [-1, -1], [1, -1], [1, 1], [-1, 1]], corner = new Vector3();

/// Draw only the visible part of the rings about the eye.
export function drawSector(mesh, camera) {
    const {spokes, corners} = mesh.geometry.userData;
    const [middle, ...others] = kCorners.map(([x, y]) => {
        corner.set(x, y, 0.5).applyMatrix4(camera.projectionMatrixInverse).transformDirection(camera.matrixWorld);
        return Math.atan2(corner.y, corner.x);
    });
    const {first, count} = sector(middle, others, spokes);
    mesh.rotation.z = 2 * Math.PI * first / spokes;
    mesh.geometry.setDrawRange(0, count * corners);
}
