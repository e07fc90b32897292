// SPDX-License-Identifier: Apache-2.0
/// Bodies of a scene as instanced meshes: parts of equal appearance are instances of one mesh. Parts
/// out of sight or too small are omitted from the picture. Parts with many faces have a simple twin
/// for large distances.
import {BackSide, Frustum, InstancedMesh, Matrix4, MeshLambertMaterial, DynamicDrawUsage, Quaternion, Vector3, DoubleSide, Sphere} from 'three';
import {geometryOf} from './geometry.js';
import * as fit from './fittings.js';
import {heightfieldBuild, hullBuild, meshBuild, pointsBuild} from './meshes.js';
import {ballRadius, longAxis, roleOf, workingDeck} from './roles.js';
import * as ships from './ship.js';

const kLeast = 0.6, kFar = 20;   // [pixels] radius below which a part is left out, or its twin drawn
const unit = new Vector3(1, 1, 1), identity = new Matrix4();
const kTo = {   // a part about z laid along an axis
    x: new Quaternion(0, Math.SQRT1_2, 0, Math.SQRT1_2), y: new Quaternion(-Math.SQRT1_2, 0, 0, Math.SQRT1_2), z: new Quaternion(),
};
export const toQuaternion = ([w, x, y, z], out = new Quaternion()) => out.set(x, y, z, w);

/// Return the box of a ship along its wetted hull: half sizes, and the middle of its length in the
/// frame of the body, whose origin is the centre of mass.
export function shipBox(half, wetted) {
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < (wetted.vertices?.length ?? 0); i += 3) {
        low = Math.min(low, wetted.vertices[i]);
        high = Math.max(high, wetted.vertices[i]);
    }
    return high > low && high - low > half[0] ? {half: [(high - low) / 2, half[1], half[2]], x: (high + low) / 2} : {half, x: 0};
}

export class Bodies {
    /// @param paint  Material of all bodies; null: one that is lit at each pixel.
    constructor(scene, paint = null) {
        this.scene = scene;
        this.material = paint ?? new MeshLambertMaterial({vertexColors: true, side: DoubleSide, shadowSide: BackSide});
        this.batches = new Map();
        this.bodies = [];
        this.scratch = {m: new Matrix4(), p: new Vector3(), q: new Quaternion(), turn: new Quaternion(), local: new Matrix4(), ball: new Sphere(), frustum: new Frustum()};
    }

    clear() {
        for (const batch of this.batches.values()) {
            this.scene.remove(batch.mesh);
            batch.mesh.geometry.dispose();
            batch.mesh.dispose();
        }
        this.batches.clear();
        this.bodies = [];
    }

    /// Build all bodies of the scene. @param level  Height of still water [m].
    setScene(scene, level) {
        this.clear();
        const origin = new Vector3(...scene.origin);
        const floats = new Set((scene.hulls ?? []).map(h => h.body));
        for (const j of scene.joints) if (/hydrostatic|buoyan/.test(j.kind)) for (const b of j.bodies) floats.add(b);
        let ship = 0;
        this.bodies = scene.bodies.map(def => {
            const half = def.half_size?.some(v => v > 0) ? def.half_size : null;
            const body = {
                def, half, id: def.id, name: def.name, slot: def.slot,
                position: new Vector3(...def.position).sub(origin), quaternion: toQuaternion(def.orientation),
                matrix: new Matrix4(), shapes: scene.shapes.filter(s => s.body === def.id), coordinate: 0,
            };
            body.role = roleOf({name: def.name, kind: def.kind, half, afloat: floats.has(def.id)});
            body.size = half ? Math.max(...half) : 1;
            body.water = level - body.position.z;
            if (body.role === 'ship') body.paint = ships.HULLS[ship++ % ships.HULLS.length];
            return body;
        });
        this.byId = new Map(this.bodies.map(b => [b.id, b]));
        for (const body of this.bodies) this.dress(body, scene);
        this.turning = [];
        this.dressMachines(scene);
        for (const batch of this.batches.values()) this.finish(batch);
    }

    /// Add a part: `make()` returns a Build, `far()` its simple twin; parts with equal keys share a mesh.
    part(body, key, make, local = identity, {far, ...more} = {}) {
        if (!this.batches.has(key)) this.batches.set(key, {key, geometry: geometryOf(make()), members: [], shown: []});
        const batch = this.batches.get(key), member = {body, local: local.clone(), world: new Matrix4(), ...more};
        batch.members.push(member);
        if (far && !batch.twin) this.batches.set(`far ${key}`, batch.twin = {key: `far ${key}`, geometry: geometryOf(far()), members: [], shown: [], of: batch});
        return member;
    }

    finish(batch) {
        batch.mesh = new InstancedMesh(batch.geometry, this.material, (batch.of ?? batch).members.length);
        batch.mesh.count = 0;
        batch.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
        batch.mesh.frustumCulled = false;
        batch.mesh.castShadow = batch.mesh.receiveShadow = true;
        batch.mesh.userData.batch = batch;
        this.scene.add(batch.mesh);
    }

    dress(body, scene) {
        const wetted = (scene.hulls ?? []).find(h => h.body === body.id);
        const {half, role} = body, key = `${role} ${half}`;
        if (role === 'ship' || role === 'barge' || role === 'semi') {
            this.dressHull(body, wetted);
        } else if (wetted) {
            this.part(body, `wet ${body.id}`, () => meshBuild(wetted, fit.PAINT.cargo));
        } else if (role === 'anchor') this.part(body, key, () => fit.anchor(half));
        else if (role === 'hook') this.part(body, key, () => fit.hook(half));
        else if (role === 'boom') this.part(body, key, () => half[0] > 12 * Math.max(half[1], half[2]) ? fit.truss(half) : fit.boom(half));
        else if (role === 'lattice') this.part(body, key, () => fit.tower(half));
        else if (role === 'cylinder') this.dressCylinder(body);
        else if (role === 'ball') {
            const r = ballRadius(body.def.mass);
            this.part(body, `ball ${r}`, () => fit.ball(r));
        } else if (role === 'box' && !body.shapes.length) this.part(body, key, () => fit.crate(half));
        for (const s of body.shapes) this.dressShape(body, s);
    }

    dressHull(body, wetted) {
        const {water} = body, ship = body.role === 'ship' && wetted ? shipBox(body.half, wetted) : {half: body.half, x: 0}, {half} = ship, found = workingDeck(body.shapes, body.half);
        const deck = body.deck = found && {...found, front: (found.front * body.half[0] - ship.x) / half[0]};
        const paint = body.paint ?? ships.HULLS[0];
        const made = body.role === 'semi' ? ships.semi({half, water}) : body.role === 'barge' ? ships.barge({half, water})
            : ships.ship({half, water, paint, deck: deck?.z ?? null, break: deck ? deck.front + 0.14 : null});
        body.bridge = new Vector3(...made.bridge).setX(made.bridge[0] + ship.x);
        body.eye = made.eye ? new Vector3(...made.eye).setX(made.eye[0] + ship.x) : null;
        this.part(body, `hull ${body.role} ${half} ${paint} ${water.toFixed(2)} ${deck?.z}`, () => made.build, new Matrix4().makeTranslation(ship.x, 0, 0));
        body.wetted = wetted;
    }

    dressCylinder(body) {
        const axis = longAxis(body.half), k = 'xyz'.indexOf(axis), r = Math.max(...body.half.filter((_, i) => i !== k));
        const thin = r < 0.25 * body.half[k], colour = /rod/.test(body.name) ? 0xd5dade : thin || /tower|column|barrel/.test(body.name) ? fit.PAINT.crane : fit.PAINT.steel;
        this.part(body, `cylinder ${axis} ${body.half} ${colour}`, () => fit.roller(r, 2 * body.half[k], colour, !thin), this.laid(axis));
    }

    laid(axis, at = [0, 0, 0], turn = new Quaternion()) {
        return new Matrix4().compose(new Vector3(...at), turn.clone().multiply(kTo[axis]), unit);
    }

    dressShape(body, s) {
        const local = new Matrix4().compose(new Vector3(...s.position), toQuaternion(s.orientation), unit);
        const painted = ['ship', 'barge', 'semi', 'anchor', 'hook', 'boom', 'lattice'].includes(body.role);
        const key = JSON.stringify([s.kind, s.radius, s.half_length, s.half_size]);
        if (s.kind === 'sphere') this.part(body, key, () => fit.ball(s.radius), local);
        else if (s.kind === 'capsule') this.part(body, key, () => fit.capsule(s.radius, 2 * s.half_length, 0x2c3136), local, {far: () => fit.capsule(s.radius, 2 * s.half_length, 0x2c3136, 7, 2)});
        else if (s.kind === 'cylinder') {
            if (body.role !== 'cylinder') this.part(body, key, () => fit.roller(s.radius, 2 * s.half_length), local);
        } else if (s.kind === 'box') {
            if (!painted) this.part(body, key, () => fit.crate(s.half_size, body.def.kind === 'fixed' ? 0x8a8f86 : fit.PAINT.cargo), local);
        } else if (s.kind === 'heightfield') this.part(body, `field ${body.id} ${s.name}`, () => heightfieldBuild(s, 0x9c8b6a), local);
        else if (painted) return;
        else if (s.kind === 'hull') this.part(body, `convex ${body.id} ${s.name} ${s.vertices?.length}`, () => hullBuild(s.vertices, fit.PAINT.cargo), local);
        else if (s.kind === 'mesh') this.part(body, `mesh ${body.id} ${s.name} ${s.vertices?.length}`, () => meshBuild(s, fit.PAINT.steel), local);
        else if (s.kind === 'points') this.part(body, `points ${body.id} ${s.vertices?.length} ${s.vertices?.[0]}`, () => pointsBuild(s, fit.PAINT.steel), local);
    }

    /// Drums of winches and sheaves, without hydraulic cylinders; they turn with the coordinate of a scalar body.
    dressMachines(scene) {
        for (const d of scene.drums ?? []) {
            const body = this.byId.get(d.body), r = d.radius;
            if (!body || !(r > 0) || /\/cylinder$/.test(d.name) || body.role === 'none' && body.def.kind !== 'fixed') continue;
            // A wire that leaves less than a diameter above the deck leaves from below its drum.
            const above = body.deck ? d.point[2] - body.deck.z : Infinity, under = above > -r && above < 2 * r;
            const local = this.laid('y', [d.point[0], d.point[1], d.point[2] + (under ? r : -r)]), foot = under ? Math.max(1.1 * r, above + r) : 1.5 * r;
            const scalar = this.byId.get(d.drum);
            const head = body.role === 'boom';   // a hoist's wire comes over the head
            const long = Math.min(4 * r, 2.4);
            if (!head) this.part(body, `bearings ${r} ${foot}`, () => fit.bearings(r, long, foot), local);
            this.turning.push(head ? this.part(body, `sheave ${r}`, () => fit.sheave(r), local, {scalar, ratio: 1, far: () => fit.farSheave(r)})
                : this.part(body, `drum ${r}`, () => fit.drum(r, long), local, {scalar, ratio: 1, far: () => fit.farDrum(r, long)}));
        }
        for (const w of scene.wheels ?? []) {
            const body = this.byId.get(w.body), r = Math.abs(w.radius);
            if (!body || !(r > 0)) continue;
            const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...w.axis).normalize());
            const local = new Matrix4().compose(new Vector3(...w.point), turn, unit), scalar = this.byId.get(w.slide);
            this.turning.push(this.part(body, `sheave ${r}`, () => fit.sheave(r), local, {scalar, ratio: scalar ? 1 / w.radius : 0, far: () => fit.farSheave(r)}));
        }
    }

    /// Set the poses of a frame.
    update(frame) {
        const {turn, local} = this.scratch;
        for (const b of this.bodies) {
            if (b.slot < 0) {
                b.matrix.compose(b.position, b.quaternion, unit);
                continue;
            }
            if (b.def.kind === 'scalar') b.coordinate = frame.scalars[b.slot];
            else if (b.def.kind === 'lump') b.position.fromArray(frame.lumps, 3 * b.slot);
            else {
                const r = frame.rigid, k = 7 * b.slot;
                b.position.set(r[k], r[k + 1], r[k + 2]);
                b.quaternion.set(r[k + 4], r[k + 5], r[k + 6], r[k + 3]);
            }
            b.matrix.compose(b.position, b.quaternion, unit);
        }
        for (const batch of this.batches.values())
            for (const member of batch.members) {
                member.world.multiplyMatrices(member.body.matrix, member.local);
                if (member.scalar) member.world.multiply(local.makeRotationFromQuaternion(turn.setFromAxisAngle(kAxis, (member.scalar.coordinate * member.ratio) % (2 * Math.PI))));
            }
    }

    /// Choose the parts for the next picture. @param pixel  Size of a pixel at 1 m [m]. @param lit  Area
    /// of new shadows; parts out of sight that throw a shadow there are drawn, too.
    place(camera, pixel, lit = null) {
        const {m, ball, frustum} = this.scratch, eye = camera.position;
        frustum.setFromProjectionMatrix(m.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
        for (const batch of this.batches.values()) batch.shown.length = 0;
        for (const batch of this.batches.values())
            for (const member of batch.members) {
                ball.copy(batch.geometry.boundingSphere).applyMatrix4(member.world);
                const size = ball.radius / (pixel * Math.max(1e-3, ball.center.distanceTo(eye)));
                if (size < kLeast || !frustum.intersectsSphere(ball) && !lit?.intersectsSphere(ball)) continue;
                (size < kFar && batch.twin || batch).shown.push(member);
            }
        for (const {mesh, shown} of this.batches.values()) {
            shown.forEach((member, i) => mesh.setMatrixAt(i, member.world));
            mesh.count = shown.length;
            mesh.visible = shown.length > 0;
            mesh.instanceMatrix.needsUpdate = true;
        }
    }

    /// Return the first hit of a ray: {body, point} in the world of the picture; null: none.
    pick(raycaster) {
        let best = null;
        for (const {mesh, shown} of this.batches.values()) {
            mesh.boundingSphere = null;
            for (const hit of raycaster.intersectObject(mesh, false))
                if (!best || hit.distance < best.distance)
                    best = {distance: hit.distance, point: hit.point, body: shown[hit.instanceId].body};
        }
        return best;
    }
}
const kAxis = new Vector3(0, 0, 1);
