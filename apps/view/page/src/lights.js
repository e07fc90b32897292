// SPDX-License-Identifier: Apache-2.0
/// Navigation lights of ships at night and in fog (COLREGS rules 21 to 23): masthead, sidelights and stern
/// light, each seen in its sector, and a white light on a rig or barge. All are points of one mesh.
import {AdditiveBlending, BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Points, PointsMaterial} from 'three';

const kMost = 96, deg = Math.PI / 180;
/// Sectors by bearing from ahead, positive to starboard [rad].
export const kSectors = {masthead: [-112.5 * deg, 112.5 * deg], port: [-112.5 * deg, 0], starboard: [0, 112.5 * deg], stern: [112.5 * deg, 247.5 * deg], round: [-Math.PI, Math.PI]};
const kColours = {masthead: 0xfff4d8, port: 0xff2a1a, starboard: 0x1fe06a, stern: 0xfff4d8, round: 0xfff4d8};

/// True if a light of this sector is seen from a bearing [rad from ahead, positive to starboard].
export function seen(kind, bearing) {
    const [a, b] = kSectors[kind], turn = ((bearing - a) % (2 * Math.PI) + 2 * Math.PI) % (2 * Math.PI);
    return turn <= b - a + 1e-9;
}

export class Lights {
    constructor() {
        const g = new BufferGeometry();
        this.position = new BufferAttribute(new Float32Array(3 * kMost), 3).setUsage(DynamicDrawUsage);
        this.colour = new BufferAttribute(new Float32Array(3 * kMost), 3).setUsage(DynamicDrawUsage);
        g.setAttribute('position', this.position);
        g.setAttribute('color', this.colour);
        this.mesh = new Points(g, new PointsMaterial({size: 5, sizeAttenuation: false, vertexColors: true, transparent: true, depthWrite: false, blending: AdditiveBlending, fog: false}));
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = 8;
        this.mesh.visible = false;
        this.all = [];
    }

    setScene(bodies) {
        this.all = [];
        const add = (body, kind, at) => { if (this.all.length < kMost) this.all.push({body, kind, at, colour: new Color(kColours[kind])}); };
        for (const b of bodies) {
            if (b.role === 'ship' && b.bridge) {
                const [x, y, z] = b.bridge.toArray(), beam = b.half[1];
                add(b, 'masthead', [x - 0.04 * b.half[0], y, z + 0.9 * beam]);
                add(b, 'port', [x, 0.76 * beam, z + 0.05 * beam]);
                add(b, 'starboard', [x, -0.76 * beam, z + 0.05 * beam]);
                add(b, 'stern', [x - 0.3 * b.half[0], 0, z + 0.3 * beam]);
            } else if (b.role === 'semi' || b.role === 'barge') {
                const z = (b.top ?? b.half[2]) + 3;
                for (const [i, k] of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) add(b, 'round', [0.95 * i * b.half[0], 0.95 * k * b.half[1], z]);
            }
        }
    }

    /// @param strength  0: off.
    update(eye, strength) {
        this.mesh.visible = strength > 0 && this.all.length > 0;
        if (!this.mesh.visible) return;
        let n = 0;
        const p = this.mesh.position.clone();
        for (const l of this.all) {
            const q = l.body.quaternion, heading = Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
            p.set(...l.at).applyMatrix4(l.body.matrix);
            if (!seen(l.kind, heading - Math.atan2(eye.y - p.y, eye.x - p.x))) continue;
            this.position.setXYZ(n, p.x, p.y, p.z);
            this.colour.setXYZ(n, l.colour.r * strength, l.colour.g * strength, l.colour.b * strength);
            ++n;
        }
        this.mesh.geometry.setDrawRange(0, n);
        this.position.needsUpdate = this.colour.needsUpdate = true;
    }
}
