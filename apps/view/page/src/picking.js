// SPDX-License-Identifier: Apache-2.0
/// Find the piece of a wire nearest to a point on the screen.
import {Matrix4, Vector3} from 'three';

const m = new Matrix4(), v = new Vector3();

/// Return the distance of (x, y) from the segment a–b in the plane, and the position along it.
export function toSegment(x, y, ax, ay, bx, by) {
    const dx = bx - ax, dy = by - ay, l = dx * dx + dy * dy;
    const t = l > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / l)) : 0;
    return [Math.hypot(x - ax - t * dx, y - ay - t * dy), t];
}

/// Return {wire, share of its length 0 to 1, point, distance from the eye}; null: none within `reach`
/// pixels.
export function nearestPiece(frame, camera, x, y, width, height, reach) {
    m.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const p = frame.wirePoints, e = m.elements, screen = new Float32Array(3 * frame.points);
    for (let i = 0; i < frame.points; ++i) {
        const [a, b, c] = [p[3 * i], p[3 * i + 1], p[3 * i + 2]], w = e[3] * a + e[7] * b + e[11] * c + e[15];
        screen[3 * i] = (1 + (e[0] * a + e[4] * b + e[8] * c + e[12]) / w) / 2 * width;
        screen[3 * i + 1] = (1 - (e[1] * a + e[5] * b + e[9] * c + e[13]) / w) / 2 * height;
        screen[3 * i + 2] = w;
    }
    let best = null, point = 0, piece = 0;
    frame.counts.forEach((n, wire) => {
        for (let k = 0; k + 1 < n; ++k, ++piece) {
            const i = 3 * (point + k), j = i + 3;
            if (frame.tensions[piece] < 0 || screen[i + 2] < 0.1 || screen[j + 2] < 0.1) continue;
            const [d, t] = toSegment(x, y, screen[i], screen[i + 1], screen[j], screen[j + 1]);
            if (d > reach || (best && d > best.off - 1e-3)) continue;
            best = {off: d, wire, k, t, n, i: point + k};
        }
        point += n;
    });
    if (!best) return null;
    const {i, t} = best, at = [0, 1, 2].map(k => p[3 * i + k] + t * (p[3 * i + 3 + k] - p[3 * i + k]));
    v.set(...at);
    return {wire: best.wire, share: shareAlong(frame, best), point: v.clone(), distance: v.distanceTo(camera.position)};
}

function shareAlong(frame, {i, k, t, n}) {
    const p = frame.wirePoints, first = i - k;
    let whole = 0, before = 0;
    for (let s = 0; s + 1 < n; ++s) {
        const a = 3 * (first + s), l = Math.hypot(p[a + 3] - p[a], p[a + 4] - p[a + 1], p[a + 5] - p[a + 2]);
        if (s < k) before += l;
        else if (s === k) before += t * l;
        whole += l;
    }
    return whole > 0 ? Math.min(1, before / whole) : 0;
}
