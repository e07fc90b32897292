// SPDX-License-Identifier: Apache-2.0
// Cameras of the crane's cab and of the helicopter.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Matrix4, PerspectiveCamera, Vector3} from 'three';
import {CameraRig, cabOf, kCircle, kModes, makeSubject} from '../src/camera.js';

const near = (a, b, e = 1e-9) => a.forEach((v, i) => assert.ok(Math.abs(v - b[i]) < e, `${a} for ${b}`));
const rig = () => new CameraRig(new PerspectiveCamera(), {addEventListener() {}, clientHeight: 500});
const body = (id, name, half, at = [0, 0, 0]) => ({id, name, half, position: new Vector3(...at), matrix: new Matrix4().makeTranslation(...at)});

test('the seat is on the column of the hook’s crane, else at its boom', () => {
    const hook = body(1, 'crane/hook', [0.4, 0.4, 0.5]), column = body(2, 'crane/column', [1, 1, 2]), boom = body(3, 'crane/boom', [5, 0.5, 0.6]), other = body(4, 'b/column', [9, 9, 9]);
    assert.equal(cabOf(hook, [other, hook, boom, column], {}).body, column);
    const seat = cabOf(hook, [other, hook, boom], {});
    assert.equal(seat.body, boom);
    near(seat.eye.toArray(), [-5, -2, 1.6]);
    assert.equal(cabOf(hook, [other, hook], {}), null);
});

test('a hook on a winch without a boom has its seat on the ship, inboard of the wire', () => {
    const hook = body(7, 'block', [0.3, 0.3, 0.7]), ship = {...body(1, 'csv/hull', [40, 9, 4]), stern: {deck: 3}};
    const seat = cabOf(hook, [hook, ship], {wires: [{ends: [1, 7]}], drums: [{wire: 0, body: 1, point: [-8, -14, 12]}]});
    assert.equal(seat.body, ship);
    assert.ok(Math.abs(seat.eye.y) < 9 && seat.eye.z > 3);
});

test('the cab looks at its hook; a drag looks beside it', () => {
    const r = rig(), at = {eye: new Vector3(0, 0, 10), hook: new Vector3(20, 0, 2)};
    r.cab = () => at;
    r.setMode('cab', null);
    r.update();
    near(r.camera.position.toArray(), [0, 0, 10]);
    const way = () => r.camera.getWorldDirection(new Vector3()).toArray();
    near(way(), new Vector3(20, 0, -8).normalize().toArray(), 1e-6);
    at.hook.set(0, 15, 10);                       // the hook has moved: the view follows
    r.update();
    near(way(), [0, 1, 0], 1e-6);
    r.look.azimuth = Math.PI / 2;
    r.update();
    near(way(), [-1, 0, 0], 1e-6);
});

test('the helicopter circles the ship in its time, and hovers when it is turned by hand', () => {
    const r = rig(), subject = makeSubject(40, new Vector3(), null);
    subject.position.set(100, 0, 0);
    r.setMode('heli', subject);
    const start = r.azimuth;
    for (let k = 0; k < kCircle; ++k) r.update(1);
    assert.ok(Math.abs(r.azimuth - start - 2 * Math.PI) < 1e-9);
    assert.ok(Math.abs(r.camera.position.distanceTo(subject.position) - r.distance) < 1e-6 && r.camera.position.z > 30);
    r.turn(10, 0);
    const turned = r.azimuth;
    r.update(1);
    assert.equal(r.azimuth, turned);
    assert.equal(kModes.length, 9);               // keys 1 to 9
});
