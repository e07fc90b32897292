// SPDX-License-Identifier: Apache-2.0
/// Forces as arrows from their points of application. The length grows with the cube root of the
/// force, so that a chain's weight on the seabed and a tow's tension are visible in one picture.
import {Color, DynamicDrawUsage, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, Vector3} from 'three';
import {Build} from './build.js';
import {geometryOf} from './geometry.js';

const kUp = new Vector3(0, 0, 1);

/// Return the length of an arrow [m] for a force [N]: `unit` metres for 1 kN.
export const arrowLength = (force, unit) => unit * Math.cbrt(Math.max(0, force) / 1000);

function shape() {
    const b = new Build(), white = 0xffffff;
    b.cylinder([0, 0, 0], [0, 0, 0.74], 0.028, 5, white);
    b.cylinder([0, 0, 0.72], [0, 0, 1], 0.085, 7, white, 1e-4);
    return geometryOf(b, 40);
}

export class Arrows {
    constructor(scene) {
        this.scene = scene;
        this.geometry = shape();
        this.material = new MeshLambertMaterial({vertexColors: true, emissive: 0x222222});
        this.mesh = null;
        this.count = 0;
        this.scratch = {m: new Matrix4(), q: new Quaternion(), p: new Vector3(), d: new Vector3(), s: new Vector3(), c: new Color()};
    }

    reserve(n) {
        if (this.mesh && n <= this.mesh.instanceMatrix.count) return;
        if (this.mesh) {
            this.scene.remove(this.mesh);
            this.mesh.dispose();
        }
        const capacity = Math.max(64, 2 ** Math.ceil(Math.log2(n || 1)));
        this.mesh = new InstancedMesh(this.geometry, this.material, capacity);
        this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
        this.mesh.setColorAt(0, this.scratch.c.set(0xffffff));
        this.mesh.frustumCulled = false;
        this.mesh.count = 0;
        this.scene.add(this.mesh);
    }

    begin() {
        this.count = 0;
    }

    /// Add an arrow. @param unit  Metres for 1 kN.
    add(x, y, z, fx, fy, fz, unit, colour) {
        const force = Math.hypot(fx, fy, fz), {m, q, p, d, s, c} = this.scratch;
        if (!(force > 1) || !this.mesh || this.count >= this.mesh.instanceMatrix.count) return;
        const length = arrowLength(force, unit);
        q.setFromUnitVectors(kUp, d.set(fx, fy, fz).divideScalar(force));
        m.compose(p.set(x, y, z), q, s.set(length, length, length));
        this.mesh.setMatrixAt(this.count, m);
        this.mesh.setColorAt(this.count++, c.set(colour));
    }

    end() {
        if (!this.mesh) return;
        this.mesh.count = this.count;
        this.mesh.instanceMatrix.needsUpdate = true;
        this.mesh.instanceColor.needsUpdate = true;
    }
}
