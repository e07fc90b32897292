// SPDX-License-Identifier: Apache-2.0
/// The picture: renderer, surroundings, bodies, wires, forces, and the actions of the pointer.
import {
    ACESFilmicToneMapping, BasicShadowMap, BufferAttribute, BufferGeometry, Color, Fog, Line, LineBasicMaterial, NoToneMapping, PCFShadowMap,
    PerspectiveCamera, Plane, Raycaster, Scene, Sphere, SRGBColorSpace, Vector2, Vector3, WebGLRenderer,
} from 'three';
import {arrowLength, Arrows} from './arrows.js';
import {Bodies} from './bodies.js';
import {CameraRig, makeSubject} from './camera.js';
import {Labels} from './labels.js';
import {Lights} from './lights.js';
import {nearestPiece} from './picking.js';
import {makePlainSky, plainBed, plainPaint, plainWater} from './plain.js';
import {Quality} from './quality.js';
import {seaComponents, seaState} from './protocol.js';
import {air, AIR, fogOf, HORIZON, kClear, kSun, setAir} from './air.js';
import {aimSun, encode, kWaveSum, lightUp, makeLight, makeSky, Seabed, tile, Water} from './surroundings.js';
import {Wake} from './wake.js';
import {Wires} from './wires.js';

export const FORCE = {contact: 0x9b2fae, joint: 0x0a7d5a};

/// Return the scene's box, or that of its bodies.
function viewBox(scene) {
    if (scene.view_box?.length === 2) return scene.view_box;
    const lo = [Infinity, Infinity, Infinity], hi = lo.map(v => -v);
    for (const b of scene.bodies) {
        if (b.kind === 'scalar') continue;
        const r = Math.max(0.5, ...(b.half_size ?? []));
        b.position.forEach((v, i) => {
            lo[i] = Math.min(lo[i], v - r);
            hi[i] = Math.max(hi[i], v + r);
        });
    }
    return hi[0] > lo[0] ? [lo, hi] : [[-10, -10, -5], [10, 10, 10]];
}

/// True if the processor draws the pictures.
function softwareGl() {
    const gl = document.createElement('canvas').getContext('webgl2'), info = gl?.getExtension('WEBGL_debug_renderer_info');
    const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
    gl?.getExtension('WEBGL_lose_context')?.loseContext();
    return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class Stage {
    /// @param quality  'high', 'low', or '': chosen for the machine.
    constructor(canvas, labelLayer, quality = '') {
        this.canvas = canvas;
        this.low = quality === 'low' || quality !== 'high' && softwareGl();
        this.renderer = new WebGLRenderer({canvas, antialias: !this.low, powerPreference: 'high-performance'});
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.type = this.low ? BasicShadowMap : PCFShadowMap;
        this.renderer.shadowMap.autoUpdate = false;
        this.renderer.toneMapping = this.low ? NoToneMapping : ACESFilmicToneMapping;
        this.renderer.toneMappingExposure = 1.15;
        document.body.classList.toggle('low', this.low);
        this.scene = new Scene();
        this.scene.fog = new Fog(HORIZON, 500, 9000);
        this.camera = new PerspectiveCamera(42, 1, 0.5, 20000);
        this.rig = new CameraRig(this.camera, canvas);
        this.bodies = new Bodies(this.scene, this.low ? plainPaint() : null);
        this.wires = new Wires(this.low);
        this.water = new Water(this.low ? plainWater : null);
        this.wake = new Wake({waves: kWaveSum, encode, tile, defines: this.low ? {LOW: 1} : {}}, this.water.material.uniforms);
        this.lights = new Lights();
        this.seabed = new Seabed(this.low ? plainBed : null);
        this.light = makeLight(this.low);
        this.arrows = new Arrows(this.scene);
        this.labels = new Labels(labelLayer);
        this.quality = new Quality();
        this.show = {names: true, contacts: true, joints: false, water: true, clear: true, seabed: true, shadows: true, tubes: 'auto'};
        this.sky = this.low ? makePlainSky() : makeSky();
        this.scene.add(this.sky, this.light, this.water.mesh, this.wake.mesh, this.lights.mesh, this.seabed.mesh, this.wires.tubes, this.wires.lines);
        this.spring = this.makeSpring();
        this.full = 0.5;
        this.scratch = {ray: new Raycaster(), v: new Vector3(), p: new Vector2(), plane: new Plane(), lit: new Sphere()};
        this.selected = null;
        this.stats = {ms: 0, fps: 0};
        this.shadowDue = 0;
    }

    makeSpring() {
        const g = new BufferGeometry();
        g.setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
        const line = new Line(g, new LineBasicMaterial({color: 0xffe14d, depthTest: false}));
        line.frustumCulled = false;
        line.visible = false;
        line.renderOrder = 20;
        this.scene.add(line);
        return line;
    }

    setScene(scene) {
        const first = !this.info || this.info.name !== scene.name;
        this.info = scene;
        this.level = scene.sea?.level ?? 0;
        this.waveFactor = scene.sea?.waves_factor ?? 1;
        this.bodies.setScene(scene, this.level);
        this.wires.setScene(scene.wires.map(w => ({...w, radius: Math.max(0.01, (w.diameter || 0.06) / 2)})));
        this.water.setWaves(seaComponents(scene.sea, scene.origin));
        this.wake.setScene(scene, this.bodies.bodies);
        this.lights.setScene(this.bodies.bodies);
        this.windAt = scene.outputs.findIndex(o => o.name === 'sea.wind');
        this.afloat = Boolean(scene.sea) || this.bodies.bodies.some(b => ['ship', 'semi', 'barge'].includes(b.role));
        this.findBed(scene);
        this.labels.setScene(this.bodies.bodies, scene.wires);
        if (first) this.airOf(scene);
        if (first) this.firstView(scene);
        else if (this.subjectBody) this.follow(this.bodies.byId.get(this.subjectBody.id) ?? null);
    }

    /// Return the bottom: of the sea, else a plane that faces up, else the lowest body.
    findBed(scene) {
        const oz = scene.origin[2], box = viewBox(scene);
        let bed = scene.sea ? -scene.sea.depth - oz : null;
        for (const s of scene.shapes) {
            if (s.kind !== 'plane') continue;
            const body = this.bodies.byId.get(s.body), up = new Vector3(0, 0, 1).applyQuaternion(body.quaternion);
            if (up.z > 0.97 && bed === null) bed = body.position.z + s.position[2];
        }
        this.bed = bed ?? (this.afloat ? box[0][2] - oz - 20 : box[0][2] - oz - 0.02 * Math.max(1, box[1][2] - box[0][2]));
        this.seabed.set(this.bed, this.afloat ? this.level - this.bed : 0);
    }

    firstView(scene) {
        const [lo, hi] = viewBox(scene), o = scene.origin;
        const size = Math.hypot(...hi.map((v, i) => v - lo[i]));
        this.rig.target.set(...hi.map((v, i) => (v + lo[i]) / 2 - o[i]));
        this.rig.distance = Math.max(3, 1.15 * size);
        this.rig.elevation = this.afloat ? 0.35 : 0.18;
        this.rig.azimuth = -1.9;
        const ship = this.mainBody();
        if (ship) {
            this.follow(ship);
            this.rig.setMode('follow', this.subject);
        } else this.rig.setMode('free', null);
    }

    /// Return the first body for cameras: the first ship, else a barge or rig, else none.
    mainBody() {
        const all = this.bodies.bodies;
        for (const role of ['ship', 'barge', 'semi']) {
            const found = all.find(b => b.role === role);
            if (found) return found;
        }
        return null;
    }

    /// Return the bodies that a camera can follow.
    subjects() {
        return this.bodies.bodies.filter(b => b.half && b.size > 0.8 && b.role !== 'none' && b.slot >= 0);
    }

    follow(body) {
        this.subjectBody = body;
        if (!body) return this.subject = null;
        const [hx, , hz] = body.half ?? [1, 1, 1];
        this.subject = makeSubject(body.size, body.eye ?? new Vector3(-0.15 * hx, 0, hz + Math.max(1.8, 0.15 * hz)), body.bridge ?? null, Boolean(body.eye), body.conn ?? null);
        this.subject.position.copy(body.position);
        this.subject.quaternion.copy(body.quaternion);
        this.rig.subject = this.subject;
        return this.subject;
    }

    /// Hooks in the scene, the nearest to the followed body first.
    hooks() {
        const at = this.subjectBody?.position ?? this.rig.target;
        return this.bodies.bodies.filter(b => b.role === 'hook' && b.slot >= 0).sort((a, b) => a.position.distanceTo(at) - b.position.distanceTo(at));
    }

    setMode(mode) {
        if (mode === 'hook') {
            const [hook] = this.hooks();
            if (!hook) return false;
            this.rig.load = () => hook.position;
            this.rig.setMode(mode, this.subject ?? null);
            return true;
        }
        if (mode !== 'free' && !this.subjectBody) this.follow(this.mainBody() ?? this.subjects()[0] ?? null);
        if (!this.subjectBody && mode !== 'free' && mode !== 'top') return false;
        this.rig.setMode(mode, this.subject);
        return true;
    }

    resize(width, height, ratio) {
        this.width = width;
        this.height = height;
        this.ratio = ratio;
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.inset(this.left ?? 0, this.right ?? 0);
    }

    /// Set the pixels that panels cover at the left and right: the picture's middle is between them.
    inset(left, right) {
        this.left = left;
        this.right = right;
        this.camera.setViewOffset(this.width, this.height, (right - left) / 2, 0, this.width, this.height);
        this.camera.updateProjectionMatrix();
    }

    /// Read a frame without drawing it.
    take(frame) {
        this.frame = frame;
        ({level: this.level, factor: this.waveFactor} = seaState(this.info, frame));
        this.bodies.update(frame);
        this.water.setWind(this.windAt < 0 ? NaN : frame.outputs[this.windAt], this.waveFactor);
        this.wake.take(frame);
        this.wires.fill(frame, this.full);
        if (this.subjectBody) {
            this.subject.position.copy(this.subjectBody.position);
            this.subject.quaternion.copy(this.subjectBody.quaternion);
        }
    }

    draw(now) {
        const {camera, frame} = this;
        this.rig.update();
        camera.updateMatrixWorld();
        const eye = camera.position, pixel = 2 * Math.tan(camera.fov * Math.PI / 360) / this.height;
        const under = this.afloat && eye.z < this.level - 0.3;
        this.water.mesh.visible = this.afloat && this.show.water;
        this.water.material.uniforms.opacity.value = this.show.clear ? 0.42 : 0.97;
        this.water.update(frame?.time ?? 0, this.level, camera, this.waveFactor);
        this.wake.mesh.visible = this.water.mesh.visible && !under && this.wake.ships.length > 0;
        this.wake.level.value = this.level;
        this.lights.update(eye, AIR.bright.value < 0.8 || air.visibility < 3000 ? 1 : 0);
        this.seabed.mesh.visible = this.show.seabed;
        this.seabed.update(camera);
        this.water.material.uniforms.pixel.value = pixel;
        this.haze(under);
        this.wires.view(pixel, this.width, this.height, this.ratio, this.level, this.afloat && !under ? 1 : 0);
        this.wires.asTubes = this.show.tubes === 'auto' ? this.quality.tubes : this.show.tubes === 'tubes';
        this.drawForces(eye, pixel);
        this.bodies.place(camera, pixel, this.shadows(now));
        this.renderer.render(this.scene, camera);
        this.counts = {calls: this.renderer.info.render.calls, triangles: this.renderer.info.render.triangles};
        this.labels.update(this, this.show.names);
    }

    /// Set the air to that of the scene. @param choice  Light or visibility that the user prefers.
    airOf(scene, choice = {}) {
        const {light = 'day', visibility = null, sun_azimuth = null, sun_elevation = null} = scene.light ?? {};
        this.setAir({light, visibility: visibility ?? kClear, azimuth: sun_azimuth ?? kSun.azimuth, elevation: sun_elevation, ...choice, ...choice.light && choice.light !== light ? {elevation: null} : {}});
    }

    /// Set light and visibility: {light: 'day', 'dusk' or 'night', visibility [m], azimuth, elevation [rad]}.
    setAir(change) {
        setAir(change);
        lightUp(this.light);
        this.sky.repaint?.();
        this.shadowDue = 0;
    }

    haze(under) {
        const {fog} = this.scene;
        if (under === this.under && air.version === this.aired) return;
        this.under = under;
        this.aired = air.version;
        const bright = AIR.bright.value, rgb = [0x1c, 0x52, 0x66].map(v => v * Math.max(0.25, bright)), {near, far} = fogOf(air.visibility);
        if (under) fog.color.setRGB(...rgb.map(v => v / 255), SRGBColorSpace);
        else fog.color.copy(HORIZON);
        // Under water no sky shows between the surface and the bottom.
        this.sky.visible = !under;
        this.scene.background = under ? new Color().setRGB(...rgb.map(v => this.low ? Math.sqrt(v / 255) : v / 255), SRGBColorSpace) : null;   // as shaders show the haze
        fog.near = under ? 5 : near;
        fog.far = under ? 700 : far;
    }

    /// Return the area of new shadows for the next picture; null: keep the old shadows.
    shadows(now) {
        const map = this.renderer.shadowMap, on = this.show.shadows && !this.quality.poor;
        if (this.light.sun.castShadow !== on) this.light.sun.castShadow = on;
        if (!on || now < this.shadowDue) return null;
        this.shadowDue = now + (this.quality.tubes ? 60 : 250);
        const {aboard} = this;
        const {lit} = this.scratch;
        lit.center.copy(aboard && this.subject ? this.subject.position : this.rig.target);
        lit.radius = aimSun(this.light, lit.center, aboard ? 70 : 0.62 * this.rig.distance);
        map.needsUpdate = true;
        return lit;
    }

    /// Draw the arrows; arrows shorter than four pixels are omitted.
    drawForces(eye, pixel) {
        const {frame, arrows, show, info} = this;
        if (!frame) return;
        arrows.reserve((show.contacts ? frame.contactCount : 0) + (show.joints ? frame.jointCount : 0));
        arrows.begin();
        const {v} = this.scratch, unit = 0.006 * (this.aboard ? 30 : Math.min(this.rig.distance, 400));
        this.forceUnit = unit;
        if (show.contacts) {
            const c = frame.contacts;
            for (let i = 0; i < c.length; i += 6) {
                const far = Math.hypot(c[i] - eye.x, c[i + 1] - eye.y, c[i + 2] - eye.z);
                const long = arrowLength(Math.hypot(c[i + 3], c[i + 4], c[i + 5]), unit);
                if (long > 4 * pixel * far) arrows.add(c[i], c[i + 1], c[i + 2], c[i + 3], c[i + 4], c[i + 5], unit, FORCE.contact);
            }
        }
        if (show.joints) {
            for (let j = 0; j < frame.jointCount; ++j) {
                const def = info.joints[j], body = this.bodies.byId.get(def.bodies[1]) ?? this.bodies.byId.get(def.bodies[0]), f = frame.joints;
                if (!body) continue;
                v.set(...(def.point ?? [0, 0, 0])).applyMatrix4(body.matrix);
                arrows.add(v.x, v.y, v.z, f[3 * j], f[3 * j + 1], f[3 * j + 2], unit, FORCE.joint);
            }
        }
        arrows.end();
    }

    /// True if the camera is on the body that it follows.
    get aboard() {
        return this.rig.aboardShip;
    }

    ray(x, y) {
        const {ray, p} = this.scratch, r = this.canvas.getBoundingClientRect();
        p.set((x - r.left) / r.width * 2 - 1, 1 - (y - r.top) / r.height * 2);
        ray.setFromCamera(p, this.camera);
        return ray;
    }

    /// Return the object at a point of the window: {body, point} or {wire, share}; null: none.
    pick(x, y) {
        const body = this.bodies.pick(this.ray(x, y)), r = this.canvas.getBoundingClientRect();
        const wire = this.frame && nearestPiece(this.frame, this.camera, x - r.left, y - r.top, r.width, r.height, 9);
        if (wire && (!body || wire.distance < body.distance + 0.5)) return {wire: wire.wire, share: wire.share, point: wire.point};
        return body && {body: body.body, point: body.point.clone()};
    }

    /// Intersect a ray through the window with the plane through `through` that faces the camera.
    onPlane(x, y, through) {
        const {plane, v} = this.scratch, at = new Vector3();
        plane.setFromNormalAndCoplanarPoint(this.camera.getWorldDirection(v), through);
        return this.ray(x, y).ray.intersectPlane(plane, at) ? at : null;
    }

    /// Project a point of the world to the screen [pixels of the canvas]; null: behind the eye.
    project(point, out = this.scratch.v) {
        out.copy(point).project(this.camera);
        return out.z > 1 || out.z < -1 ? null : {x: (out.x + 1) / 2 * this.width, y: (1 - out.y) / 2 * this.height};
    }

    /// Draw the spring of a drag from a to b; remove it if they are missing.
    setSpring(a, b) {
        this.spring.visible = Boolean(a);
        if (!a) return;
        const p = this.spring.geometry.getAttribute('position');
        p.setXYZ(0, a.x, a.y, a.z);
        p.setXYZ(1, b.x, b.y, b.z);
        p.needsUpdate = true;
    }

    choose(what) {
        this.selected = what;
        this.wires.choose(what?.wire ?? -1);
    }

    /// Draw the picture and return it as a PNG.
    screenshot() {
        this.renderer.render(this.scene, this.camera);
        return new Promise(done => this.canvas.toBlob(done, 'image/png'));
    }
}
