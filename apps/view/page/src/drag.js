// SPDX-License-Identifier: Apache-2.0
/// Pulling with a spring. In this mode a drag that begins on a body or a wire pulls there, in the plane
/// through that point that faces the camera. Other drags rotate the picture as usual.
import {Matrix4, Vector3} from 'three';
import {$, toast} from './dom.js';

/// Return the stiffness [N/m] for a mass [kg]. Up to 100 t a displacement of 2 m lifts the body. For
/// heavier bodies the program chooses (0): softer for the mass, like a tug.
export const pullStiffness = mass => mass > 0 && mass <= 1e5 ? 9.81 / 2 * mass : 0;

export class Drag {
    constructor(app) {
        this.app = app;
        this.on = false;
        this.held = null;
        this.next = 0;
        const c = $('canvas');
        // Before the camera, which listens on the same element in the order of adding.
        c.addEventListener('pointerdown', e => this.down(e), {capture: true});
        c.addEventListener('pointermove', e => this.move(e), {capture: true});
        for (const name of ['pointerup', 'pointercancel']) c.addEventListener(name, e => { if (this.held?.pointer === e.pointerId) this.end(); });
    }

    mode(on) {
        this.on = on && this.app.mayControl;
        $('pull').setAttribute('aria-pressed', String(this.on));
        $('canvas').classList.toggle('pulling', this.on);
    }

    down(e) {
        if (!(this.on || e.altKey) || !this.app.mayControl || this.held || e.button !== 0) return;
        const {stage} = this.app, what = stage.pick(e.clientX, e.clientY);
        if (!what || (what.body && what.body.slot < 0)) return;
        e.stopImmediatePropagation();
        e.preventDefault();
        $('canvas').setPointerCapture(e.pointerId);
        const point = what.body ? what.point.clone().applyMatrix4(new Matrix4().copy(what.body.matrix).invert()) : null;
        this.held = {pointer: e.pointerId, what, point, through: what.point.clone(), target: what.point.clone(), fresh: true};
        stage.choose(what);
        this.app.inspector.show(what);
        this.update(performance.now());
    }

    move(e) {
        if (this.held?.pointer !== e.pointerId) return;
        e.stopImmediatePropagation();
        const at = this.app.stage.onPlane(e.clientX, e.clientY, this.held.through);
        if (!at) return;
        this.held.target.copy(at);
        this.held.fresh = true;
    }

    /// Draw the spring for each picture; send it at most 25 times a second.
    update(now) {
        const {held, app} = this;
        if (!held) return;
        app.stage.setSpring(this.pulled(), held.target);
        if (!held.fresh || now < this.next) return;
        this.next = now + 40;
        held.fresh = false;
        const o = app.scene.origin, target = held.target.toArray().map((v, i) => v + o[i]);
        const of = held.what.body ? {body: held.what.body.id, point: held.point.toArray(), stiffness: pullStiffness(held.what.body.def.mass)} : {wire: app.scene.wires[held.what.wire].id, s: held.what.share};
        if (!app.link.send({type: 'drag', ...of, target})) {
            toast('There is no connection');
            this.end();
        }
    }

    /// Return the present position of the pulled point.
    pulled() {
        const {what, point} = this.held;
        if (what.body) return point.clone().applyMatrix4(what.body.matrix);
        const {frame} = this.app, n = frame.counts[what.wire];
        if (n < 2) return what.point;
        const first = frame.counts.subarray(0, what.wire).reduce((a, b) => a + b, 0), k = Math.min(n - 1, Math.round(what.share * (n - 1)));
        return new Vector3().fromArray(frame.wirePoints, 3 * (first + k));
    }

    end() {
        if (!this.held) return;
        this.held = null;
        this.app.stage.setSpring(null);
        this.app.link.send({type: 'release'});
    }
}
