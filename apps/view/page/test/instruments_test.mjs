// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {AlarmBook} from '../src/alarms.js';
import {craneHost, cranesOf, gaugesOf, prefixOf, tensionBar, winchesOf} from '../src/instruments.js';
import {attitude, Motion} from '../src/motion.js';
import {readable} from '../src/roles.js';
import {bearing, convert, shown, sided} from '../src/units.js';

const near = (a, b, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} against ${b}`);
/// Quaternion of a rotation about a unit axis.
const rotation = (axis, angle) => [Math.cos(angle / 2), ...axis.map(a => a * Math.sin(angle / 2))];
const times = ([w, x, y, z], [a, b, c, d]) => [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];

test('sailors’ units: knots are 1852 m an hour, tonnes the weight of 1000 kg', () => {
    near(convert(1852 / 3600, 'm/s', 'ground_speed', false)[0], 1);
    assert.equal(convert(1, 'm/s', 'sea.wind', false)[1], 'kn');
    assert.deepEqual(convert(0.5, 'm/s', 'ahts1/tow_speed', false), [30, 'm/min']);
    near(convert(1e6, 'N', 'pull', false)[0], 101.97162129779283);
    near(convert(Math.PI, 'rad', '', false)[0], 180);
    near(convert(Math.PI / 180 / 60, 'rad/s', 'turn_rate', false)[0], 1);
    near(convert(2 * Math.PI, 'rad/s', 'shaft', false)[0], 60);
    assert.deepEqual(convert(3, 'm', '', false), [3, 'm']);
    for (const unit of ['N', 'm/s', 'rad', 'rad/s', 'N m']) assert.deepEqual(convert(2.5, unit, 'tow', true), [2.5, unit]);
    assert.equal(shown(981e3, 'N', '', 3, false), '100 t');
    assert.equal(shown(NaN, 'N', '', 3, false), '–');
    assert.equal(shown(3e-5, 'm', '', 3, false), '0.00 m');
    assert.equal(shown(2e-5, 'm/s', 'ground', 3, false), '0.00 kn');
    assert.equal(shown(0.02, 'm', '', 3, false), '0.02 m');
});

test('bearings have three digits and wrap', () => {
    assert.deepEqual([0, 7.4, 359.6, 360, -90, 725].map(bearing), ['000°', '007°', '000°', '000°', '270°', '005°']);
    assert.equal(sided(-2.34, 'S', 'P'), '2.3° P');
    assert.equal(sided(0.02, 'S', 'P'), '0.0°');
});

test('attitude: heading clockwise from north, heel to starboard and bow down positive', () => {
    near(attitude([1, 0, 0, 0]).heading, 90);                                       // x is east
    near(attitude(rotation([0, 0, 1], Math.PI / 2)).heading, 0);                    // x is north
    near(attitude(rotation([0, 0, 1], -Math.PI / 2)).heading, 180);
    for (const heading of [0, 0.3, 2, 4]) {
        const q = times(rotation([0, 0, 1], heading), times(rotation([0, 1, 0], 0.05), rotation([1, 0, 0], 0.2)));
        near(attitude(q).heel, 0.2 * 180 / Math.PI, 1e-6);
        near(attitude(q).trim, 0.05 * 180 / Math.PI, 1e-6);
        near(attitude(q).heading, ((90 - heading * 180 / Math.PI) % 360 + 360) % 360, 1e-6);
    }
});

test('motion of a ship on a circle: speed, course and rate of turn; through north; a restore begins anew', () => {
    const m = new Motion(), radius = 200, omega = 0.02;
    assert.equal(m.read(), null);
    for (let t = 0; t < 40; t += 1 / 60) {
        const a = -omega * t;                                                       // clockwise
        m.take(t, [radius * Math.cos(a), radius * Math.sin(a), 0], rotation([0, 0, 1], a - Math.PI / 2));
        const r = m.read();
        if (t < 2) continue;
        near(r.speed, radius * omega, 1e-3);
        near(r.rate, omega * 180 / Math.PI * 60, 1e-6);
        near(((r.course - r.heading + 540) % 360) - 180, -omega * 180 / Math.PI / 2, 0.02);  // half a second old
    }
    m.take(3, [0, 0, 0], [1, 0, 0, 0]);
    assert.ok(Number.isNaN(m.read().speed));
});

test('the station’s ship is the prefix of most of its inputs', () => {
    assert.equal(prefixOf(['ahts1/tow', 'ahts1/work', 'rig.crane']), 'ahts1');
    assert.equal(prefixOf(['thrust']), '');
    assert.equal(prefixOf([]), '');
});

test('winches of a ship: by drum, joined with their system, others left out', () => {
    const scene = {
        systems: [], bodies: [],
        wires: [{name: 'tow'}, {name: 'work'}, {name: 'crane'}],
        drums: [{name: 'tow_winch', wire: 0, body: 4}, {name: 'work', wire: 1, body: 4}, {name: 'crane', wire: 2, body: 9}],
        outputs: ['tow_winch.pull', 'work/feed.paid_out', 'crane.pull'].map(name => ({name})),
    };
    const found = winchesOf(scene, 4);
    assert.deepEqual(found.map(w => [w.name, w.wire, w.system]), [['tow_winch', 0, 'tow_winch'], ['work', 1, '']]);
    assert.equal(found[1].feed, 'work/feed');
});

test('cranes from the names of outputs', () => {
    const outputs = ['osv.port', 'osv.port_thrust', 'osv.port_turned', 'osv.bow1_thrust', 'other.x_thrust', 'ahts1/crane.utilisation', 'rig.utilisation', 'ground.utilisation', 'ground.capacity', 'gauge.utilisation', 'gauge.permissible'].map(name => ({name}));
    assert.deepEqual(cranesOf(outputs, 'ahts1'), ['ahts1/crane']);
    assert.deepEqual(cranesOf(outputs, ''), ['ahts1/crane', 'rig']);
    assert.deepEqual(cranesOf([], 'rig'), []);
});

test('a crane has the host of its joint, a gauge the ship that the scene names', () => {
    const scene = {bodies: [{id: 1, name: 'rig/hull'}, {id: 2, name: 'crane/column'}, {id: 3, name: 'crane/boom'}], joints: [{bodies: [2, 3]}, {bodies: [1, 2]}],
        outputs: ['a.permissible', 'b.permissible'].map(name => ({name})), gauges: [{name: 'a', body: 1}, {name: 'b', body: 7}]};
    assert.equal(craneHost(scene, 'crane'), 1);
    assert.equal(craneHost(scene, 'other'), undefined);
    assert.deepEqual(gaugesOf(scene, 1), ['a']);
    assert.deepEqual(gaugesOf({...scene, gauges: undefined}, 1), ['a', 'b']);
});

test('tension against working and breaking load', () => {
    assert.equal(tensionBar(1e5, 0), null);
    assert.deepEqual(tensionBar(2e5, 1e6), {share: 0.2, percent: 20, state: 'good'});
    assert.equal(tensionBar(6e5, 1e6).state, 'warn');
    assert.deepEqual(tensionBar(1.2e6, 1e6), {share: 1, percent: 120, state: 'danger'});
    assert.equal(tensionBar(-1, 1e6).share, 0);
});

test('an alarm stays until it is acknowledged and over, in either order', () => {
    const book = new AlarmBook();
    book.raise('a', 'Tension', 1);
    assert.equal(book.raise('a', 'Tension', 2), false);                            // the same alarm
    book.clear('a');
    assert.deepEqual(book.list().map(e => [e.active, e.seen]), [[false, false]]);   // over, not seen: stays
    assert.ok(book.sounding);
    book.acknowledge('a');
    assert.equal(book.list().length, 0);
    book.raise('a', 'Tension', 3);
    book.acknowledge('a');
    assert.equal(book.sounding, false);
    assert.equal(book.list().length, 1);                                           // seen, still active
    book.clear('a');
    assert.equal(book.list().length, 0);
});

test('alarms are listed by acknowledgement, priority and age; all are acknowledged at once', () => {
    const book = new AlarmBook();
    book.raise('w1', '', 1);
    book.raise('d', '', 2, 'danger');
    book.raise('w2', '', 3);
    assert.deepEqual(book.list().map(e => e.key), ['d', 'w2', 'w1']);
    book.acknowledge('d');
    assert.deepEqual(book.list().map(e => e.key), ['w2', 'w1', 'd']);
    book.acknowledgeAll();
    assert.equal(book.sounding, false);
    book.clear('w1');
    assert.equal(book.raise('w1', '', 9), true);
    assert.equal(book.list()[0].times, 1);
});

test('names in words of the trade', () => {
    assert.deepEqual(['ahts1/crane/wire', 'tow_speed', 'work1/feed.paid_out', 'rig_crane_port'].map(readable), ['AHTS 1 crane wire', 'Tow speed', 'Work 1 paid out', 'Rig crane port']);
});
