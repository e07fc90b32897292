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

/// Return the box of a ship along its wetted hull: half sizes, the middle of its length and the height
/// of its keel in the frame of the body, whose origin is the centre of mass.
export function shipBox(half, wetted) {
    let low = Infinity, high = -Infinity, keel = Infinity;
    for (let i = 0; i < (wetted?.vertices?.length ?? 0); i += 3) {
        low = Math.min(low, wetted.vertices[i]);
        high = Math.max(high, wetted.vertices[i]);
        keel = Math.min(keel, wetted.vertices[i + 2]);
    }
    return high > low && high - low > half[0] ? {half: [(high - low) / 2, half[1], half[2]], x: (high + low) / 2, keel} : {half, x: 0, keel: -half[2]};
}

/// Return the stern roller of a ship: a cylinder of the same vessel at its stern, in the frame of the
/// ship's body; null: none. @param bodies  All bodies with poses at the start.
export function rollerOf(ship, bodies) {
    const family = name => name.slice(0, Math.max(0, name.lastIndexOf('/'))), turn = ship.quaternion.clone().invert();
    for (const b of bodies) {
        if (b === ship || b.role !== 'cylinder' || !/roller/.test(b.name) || family(b.name) !== family(ship.name)) continue;
        const at = b.position.clone().sub(ship.position).applyQuaternion(turn), k = 'xyz'.indexOf(longAxis(b.half));
        if (at.x < -0.6 * ship.half[0] && Math.abs(at.y) < 0.5 * ship.half[1])
            return {x: at.x, z: at.z, radius: Math.max(...b.half.filter((_, i) => i !== k)), half: 1.03 * b.half[k]};
    }
    return null;
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
            this.dressHull(body, wetted, scene);
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
        } else if (role === 'box' && !body.shapes.length) this.part(body, `${key} ${body.def.kind}`, () => body.def.kind === 'fixed' ? fit.quay(half) : fit.crate(half));
        for (const s of body.shapes) this.dressShape(body, s);
    }

    dressHull(body, wetted, scene) {
        const {water} = body, ship = body.role === 'ship' ? shipBox(body.half, wetted) : {half: body.half, x: 0}, {half} = ship, found = workingDeck(body.shapes, body.half);
        const deck = body.deck = found && {...found, front: (found.front * body.half[0] - ship.x) / half[0]};
        const paint = body.paint ?? ships.HULLS[0];
        let made, key = `hull ${body.id}`;
        if (body.role === 'semi') made = ships.semi({half, water, wetted, derrick: !this.bodies.some(b => b.role === 'lattice')});
        else if (body.role === 'barge') made = ships.barge({half, water});
        else {
            const works = deck || (scene.drums ?? []).some(d => d.body === body.id), given = rollerOf(body, this.bodies), low = deck?.z ?? 0.55 * half[2];
            const roller = given ? {...given, x: given.x - ship.x} : works ? ships.sternRoller(half, low) : null;
            made = ships.ship({half, keel: ship.keel, water, paint, deck: deck?.z ?? null, break: deck ? deck.front + 0.14 : null, roller, own: !given});
            key = `hull ship ${half} ${paint} ${water.toFixed(2)} ${deck?.z} ${JSON.stringify(roller)} ${given === null}`;
            body.stern = {x: ship.x - half[0], half: half[1], deck: made.low, front: made.front + ship.x};
        }
        body.bridge = new Vector3(...made.bridge).setX(made.bridge[0] + ship.x);
        body.conn = made.conn ? new Vector3(...made.conn).setX(made.conn[0] + ship.x) : null;
        body.eye = made.eye ? new Vector3(...made.eye).setX(made.eye[0] + ship.x) : null;
        body.top = made.low;
        this.part(body, key, () => made.build, new Matrix4().makeTranslation(ship.x, 0, 0));
        body.wetted = wetted;
        this.dressPropellers(body, scene);
    }

    /// Nozzles with propellers, and rudders, of a vessel.
    dressPropellers(body, scene) {
        const vessel = (scene.vessels ?? []).find(v => v.body === body.id);
        if (!vessel || body.role === 'semi') return;
        const draught = Math.max(1, body.water - (body.wetted ? shipBox(body.half, body.wetted).keel : -body.half[2])), radius = 0.34 * draught;
        for (const p of vessel.propulsors)
            if (p.kind !== 'tunnel') this.part(body, `nozzle ${radius.toFixed(3)}`, () => fit.nozzle(radius), new Matrix4().makeTranslation(...p.point));
        for (const r of vessel.rudders) this.part(body, `rudder ${radius.toFixed(3)}`, () => fit.rudder(radius), new Matrix4().makeTranslation(...r.point));
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
        const taken = new Map();
        for (const d of scene.drums ?? []) {
            const body = this.byId.get(d.body), r = d.radius;
            if (!body || !(r > 0) || /\/cylinder$/.test(d.name) || body.role === 'none' && body.def.kind !== 'fixed') continue;
            const {at, foot, lead, davit} = this.drumPlace(body, d.point, r, taken), local = this.laid('y', at), scalar = this.byId.get(d.drum);
            const head = body.role === 'boom';   // a hoist's wire comes over the head
            const long = Math.min(4 * r, 2.4);
            if (davit) this.davit(body, d.point, davit, r);
            if (lead) this.lead(body, davit ? davit.head : d.point, lead, scene.wires[d.wire]);
            if (head) {
                this.turning.push(this.part(body, `sheave ${r}`, () => fit.sheave(r), local, {scalar, ratio: 1, far: () => fit.farSheave(r)}));
                continue;
            }
            this.part(body, `bearings ${r} ${foot}`, () => fit.bearings(r, long, foot), local);
            this.turning.push(this.part(body, `flanges ${r}`, () => fit.flanges(r, long), local, {scalar, ratio: 1, far: () => fit.flanges(r, long, 10)}));
            // The rope on the drum grows and shrinks by whole layers.
            const layer = scene.outputs.findIndex(o => o.name === `${d.name}.layer`), thick = scene.wires[d.wire]?.diameter || 0.06;
            this.turning.push(this.part(body, `rope ${r}`, () => fit.rope(r, long), local, {scalar, ratio: 1, far: () => fit.rope(r, long, 10),
                layers: layer < 0 ? null : {output: layer, step: 0.866 * thick / r, first: null}}));
        }
        for (const w of scene.wheels ?? []) {
            const body = this.byId.get(w.body), r = Math.abs(w.radius);
            if (!body || !(r > 0)) continue;
            const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...w.axis).normalize());
            const local = new Matrix4().compose(new Vector3(...w.point), turn, unit), scalar = this.byId.get(w.slide);
            this.turning.push(this.part(body, `sheave ${r}`, () => fit.sheave(r), local, {scalar, ratio: scalar ? 1 / w.radius : 0, far: () => fit.farSheave(r)}));
        }
    }

    /// Return the position of a drum's shaft in the frame of its body, the height of its feet and the upper
    /// end of the wire's lead to the point where it leaves the body; null: the drum stands at this point.
    drumPlace(body, point, r, taken) {
        const n = taken.get(body) ?? 0, above = body.deck ? point[2] - body.deck.z : Infinity;
        if (body.role === 'semi') {   // windlass on deck, fairlead at the column
            const at = [Math.min(0.93, Math.max(-0.93, point[0] / body.half[0])) * body.half[0], Math.min(0.93, Math.max(-0.93, point[1] / body.half[1])) * body.half[1], body.top + 1.4 * r];
            if (at[2] - point[2] > 4 * r) return {at, foot: 1.4 * r, lead: [point[0], point[1], body.top]};
        }
        if (body.stern && point[0] < body.stern.x + 0.15 * body.half[0]) {   // a wire that leaves at the stern: its winch is forward
            taken.set(body, n + 1);
            const side = n % 2 ? -1 : n ? 1 : 0, at = [body.stern.front - 2.6 * r - 3 * r * Math.floor(n / 3), side * 0.45 * body.stern.half, body.stern.deck + 1.5 * r];
            return {at, foot: 1.5 * r, lead: [at[0], at[1], at[2] + r]};
        }
        if (body.stern && (Math.abs(point[1]) > 0.97 * body.stern.half || point[2] > body.stern.deck + 5)) {   // over the side or high above deck: a davit
            const y = Math.sign(point[1] || 1) * 0.6 * body.stern.half, deck = body.stern.deck, head = [point[0], y, Math.max(point[2], deck + 4)];
            return {at: [point[0] + 4 * r, y * 0.4, deck + 1.5 * r], foot: 1.5 * r, lead: [point[0] + 4 * r, y * 0.4, deck + 2.5 * r], davit: {foot: [point[0], y, deck], head}};
        }
        // A wire that leaves less than a diameter above the deck leaves from below its drum.
        const under = above > -r && above < 2 * r;
        return {at: [point[0], point[1], point[2] + (under ? r : -r)], foot: under ? Math.max(1.1 * r, above + r) : 1.5 * r, lead: null};
    }

    /// Draw a davit from the deck to the point where a wire leaves.
    davit(body, point, {foot, head}, r) {
        this.part(body, `davit ${foot} ${point}`, () => fit.davit(foot, head, point));
        this.part(body, `sheave ${0.7 * r}`, () => fit.sheave(0.7 * r), this.laid('x', [point[0], point[1], point[2] + 0.2 * r]), {far: () => fit.farSheave(0.7 * r)});
    }

    /// Draw the part of a wire between the point where it leaves a body and its drum.
    lead(body, from, to, wire) {
        const a = new Vector3(...from), b = new Vector3(...to), long = a.distanceTo(b), radius = Math.max(0.04, (wire?.diameter || 0.06) / 2);
        const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), b.clone().sub(a).normalize());
        this.part(body, `lead ${radius} ${long.toFixed(2)}`, () => fit.lead(radius, long), new Matrix4().compose(a.add(b).multiplyScalar(0.5), turn, unit));
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
                if (member.layers) member.world.multiply(local.makeScale(...ropeScale(member.layers, frame.outputs)));
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

/// Return the scale of a drum's rope from the number of its layers.
export function ropeScale(layers, outputs) {
    const now = outputs[layers.output];
    if (Number.isFinite(now)) layers.first ??= now;
    const k = Number.isFinite(now) ? Math.min(1.3, Math.max(0.35, 1 + (now - layers.first) * layers.step)) : 1;
    return [k, k, 1];
}
