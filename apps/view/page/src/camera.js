// SPDX-License-Identifier: Apache-2.0
/// Cameras: free, follow, on board (deck), bridge (forward), aft (conning position), hook (down from the
/// jib on the load), top. Drag rotates, two fingers or the right button move,
/// wheel and pinch zoom. Angles in radians, azimuth from x towards y.
import {Quaternion, Vector3} from 'three';

export const kModes = ['free', 'follow', 'board', 'bridge', 'aft', 'hook', 'top'];
const kAboard = ['board', 'bridge', 'aft'];
const up = new Vector3(0, 0, 1);

/// Return the heading of a body from its quaternion: the direction of its x axis, seen from above.
export const heading = q => Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));

export class CameraRig {
    constructor(camera, element) {
        this.camera = camera;
        this.element = element;
        this.mode = 'free';
        this.target = new Vector3();
        this.azimuth = -2.2;
        this.elevation = 0.32;
        this.distance = 180;
        this.look = {azimuth: 0, elevation: -0.12};   // on board and bridge, against the body
        this.subject = null;                            // {position, quaternion, eye, size, bridge}
        this.held = new Map();
        this.moved = 0;
        this.enabled = true;
        this.listen();
    }

    listen() {
        const e = this.element;
        e.addEventListener('pointerdown', v => this.down(v));
        e.addEventListener('pointermove', v => this.move(v));
        for (const name of ['pointerup', 'pointercancel'])
            e.addEventListener(name, v => this.held.delete(v.pointerId));
        e.addEventListener('wheel', v => {
            v.preventDefault();
            this.zoom(Math.exp(v.deltaY * (v.deltaMode ? 0.03 : 0.001)));
        }, {passive: false});
        e.addEventListener('contextmenu', v => v.preventDefault());
    }

    down(v) {
        if (!this.enabled) return;
        this.element.setPointerCapture?.(v.pointerId);
        this.held.set(v.pointerId, {x: v.clientX, y: v.clientY, button: v.button});
        this.moved = 0;
    }

    move(v) {
        const was = this.held.get(v.pointerId);
        if (!was || !this.enabled) return;
        const dx = v.clientX - was.x, dy = v.clientY - was.y;
        this.moved += Math.abs(dx) + Math.abs(dy);
        if (this.held.size === 2) this.pinch(v, was);
        else if (was.button === 2 || was.button === 1 || v.shiftKey || this.mode === 'top') this.pan(dx, dy);
        else this.turn(dx, dy);
        Object.assign(was, {x: v.clientX, y: v.clientY});
    }

    pinch(v, was) {
        const other = [...this.held.entries()].find(([id]) => id !== v.pointerId)[1];
        const before = Math.hypot(was.x - other.x, was.y - other.y), now = Math.hypot(v.clientX - other.x, v.clientY - other.y);
        if (before > 5 && now > 5) this.zoom(before / now);
        this.pan((v.clientX - was.x) / 2, (v.clientY - was.y) / 2);
    }

    turn(dx, dy) {
        const k = 2.6 / Math.max(200, this.element.clientHeight);
        if (this.aboardShip) {
            this.look.azimuth += dx * k;
            this.look.elevation = Math.min(1.4, Math.max(-1.4, this.look.elevation + dy * k));
        } else {
            this.azimuth -= dx * k;
            this.elevation = Math.min(1.55, Math.max(-1.3, this.elevation + dy * k));
        }
    }

    pan(dx, dy) {
        if (this.mode !== 'free' && this.mode !== 'top') return;
        const k = this.perPixel();
        const a = this.mode === 'top' ? -Math.PI / 2 : this.azimuth;
        const side = new Vector3(-Math.sin(a), Math.cos(a), 0), forth = new Vector3(-Math.cos(a), -Math.sin(a), 0);
        this.target.addScaledVector(side, -dx * k).addScaledVector(forth, dy * k);
        if (this.mode === 'top') this.subject = null;
    }

    /// Return the metres per pixel at the target.
    perPixel() {
        return 2 * Math.tan(this.camera.fov * Math.PI / 360) * this.distance / Math.max(1, this.element.clientHeight);
    }

    zoom(by) {
        if (this.aboardShip)
            this.camera.fov = Math.min(80, Math.max(12, this.camera.fov * by));
        else this.distance = Math.min(6000, Math.max(2, this.distance * by));
        this.camera.updateProjectionMatrix();
    }

    setMode(mode, subject = this.subject) {
        if (!kModes.includes(mode)) return;
        if (this.mode === 'follow' && mode === 'free' && this.subject) this.azimuth += heading(this.subject.quaternion);
        if (this.mode !== 'follow' && mode === 'follow' && subject) this.azimuth = -2.5;
        this.mode = mode;
        this.subject = subject;
        this.camera.fov = kAboard.includes(mode) ? 62 : 42;
        const aft = mode === 'aft' || mode === 'board' && subject?.aft;
        this.look = {azimuth: aft ? Math.PI : 0, elevation: mode === 'aft' ? -0.2 : mode === 'bridge' ? -0.06 : -0.12};
        if (subject && (mode === 'follow' || mode === 'top')) {
            this.distance = (mode === 'top' ? 4.6 : 2.7) * Math.max(6, subject.size);
            if (mode === 'follow') this.elevation = 0.2;
            this.target.copy(subject.position);
        }
        if (mode === 'hook') this.distance = 24;
        this.camera.updateProjectionMatrix();
    }

    /// Move the camera to the position of its mode. Call after bodies have moved.
    update() {
        const {camera, subject, mode, target} = this;
        if (subject && this.aboardShip) return this.aboard(subject);
        if (mode === 'hook' && this.load) return this.overLoad(this.load());
        if (subject && mode === 'follow') target.copy(subject.position);
        const turn = subject && mode === 'follow' ? heading(subject.quaternion) : 0;
        if (mode === 'top') {
            camera.up.set(0, 1, 0);
            camera.position.set(target.x, target.y, target.z + this.distance);
        } else {
            const a = this.azimuth + turn, c = Math.cos(this.elevation);
            camera.up.copy(up);
            camera.position.set(target.x + this.distance * c * Math.cos(a), target.y + this.distance * c * Math.sin(a),
                                target.z + this.distance * Math.sin(this.elevation));
        }
        camera.lookAt(target);
        this.planes(this.distance);
    }

    aboard(subject) {
        const {camera} = this, at = (this.mode === 'aft' ? subject.conn : null) ?? (this.mode !== 'board' && subject.bridge ? subject.bridge : subject.eye);
        const q = subject.quaternion, {azimuth, elevation} = this.look;
        camera.position.copy(at).applyQuaternion(q).add(subject.position);
        const way = new Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
        camera.up.copy(up).applyQuaternion(q);
        camera.lookAt(way.applyQuaternion(q).add(camera.position));
        this.planes(12);
    }

    /// True if the camera stands on the body that it follows.
    get aboardShip() {
        return kAboard.includes(this.mode);
    }

    /// Look down on a load from `distance` above it, north up.
    overLoad(position) {
        const {camera, target} = this;
        target.copy(position);
        camera.up.set(0, 1, 0);
        camera.position.set(target.x, target.y - 0.25 * this.distance, target.z + this.distance);
        camera.lookAt(target);
        this.planes(this.distance);
    }

    planes(distance) {
        const near = Math.min(2, Math.max(0.15, distance * 0.01));
        if (Math.abs(this.camera.near - near) > 0.1 * near) {
            this.camera.near = near;
            this.camera.far = 20000;
            this.camera.updateProjectionMatrix();
        }
    }

    /// Return the bearing of the camera, from x towards y, for the compass.
    bearing() {
        if (this.mode === 'top' || this.mode === 'hook') return Math.PI / 2;
        const d = this.camera.getWorldDirection(new Vector3());
        return Math.atan2(d.y, d.x);
    }
}

/// Return the view of a body as a subject; each frame updates the same object.
export const makeSubject = (size, eye, bridge, aft = false, conn = null) =>
    ({position: new Vector3(), quaternion: new Quaternion(), size, eye, bridge, aft, conn});
