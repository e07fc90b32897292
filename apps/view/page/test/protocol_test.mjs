// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {mayRetry, retryDelay, Connection} from '../src/connection.js';
import {decodeFrame, largestTensions, leftOutWords, seaComponents, seaState, tokenOf} from '../src/protocol.js';
import {waveHeight} from '../src/surroundings.js';

/// A frame as docs/live.md has it, written field by field from its table.
export function makeFrame({counts = [3, 0, 2], tensions = [5, 7, 9], bits = 1, rigid = 1, epoch = 1, time = 1.5} = {}) {
    const P = counts.reduce((a, b) => a + b, 0), T = tensions.length;
    const n = {R: rigid, L: 1, S: 2, W: counts.length, P, T, C: 1, J: 1, O: 2, I: 1, Q: 2};
    const floats = 7 * n.R + 3 * n.L + n.S + n.W + 3 * P + T + 6 + 3 + 2 + 1 + 2, length = 128 + 4 * floats;
    const d = new DataView(new ArrayBuffer(length));
    d.setUint8(0, 0x48); d.setUint8(1, 0x57); d.setUint8(2, 0x4c); d.setUint8(3, 0x56);
    d.setUint16(4, 1, true); d.setUint16(6, 9, true); d.setUint32(8, length, true); d.setUint32(12, epoch, true);
    d.setUint32(16, 77, true); d.setUint32(20, 3, true); d.setBigInt64(24, 90n, true); d.setFloat64(32, time, true); d.setFloat64(40, 1000.25, true);
    Object.values(n).forEach((v, i) => d.setUint32(48 + 4 * i, v, true));
    d.setUint32(92, 4, true); d.setUint32(96, bits, true); d.setInt32(100, 6, true); d.setBigUint64(104, 5n, true); d.setInt32(112, 2, true); d.setUint32(116, 1, true);
    let at = 128, v = 0;
    const put = k => { for (let i = 0; i < k; ++i, at += 4) d.setFloat32(at, ++v, true); };
    put(7 * n.R + 3 + 2);
    for (const c of counts) { d.setUint32(at, c, true); at += 4; }
    put(3 * P);
    for (const t of tensions) { d.setFloat32(at, t, true); at += 4; }
    put(6 + 3 + 2 + 1 + 2);
    assert.equal(at, length);
    return d.buffer;
}

test('a frame is read as the table of docs/live.md says', () => {
    const f = decodeFrame(makeFrame({bits: 1 | 2 | 4 | 3 << 8}));
    assert.deepEqual([f.flags, f.epoch, f.number, f.leftOut, f.steps, f.time, f.clock], [9, 1, 77, 3, 90, 1.5, 1000.25]);
    assert.deepEqual([f.certified, f.budgetEnded, f.late, f.cause, f.contactsLeftOut], [true, true, true, 3, 4]);
    assert.deepEqual([...f.rigid], [1, 2, 3, 4, 5, 6, 7]);
    assert.deepEqual([...f.lumps], [8, 9, 10]);
    assert.deepEqual([...f.scalars], [11, 12]);
    assert.deepEqual([...f.counts], [3, 0, 2]);
    assert.equal(f.wirePoints.length, 15);
    assert.equal(f.wirePoints[0], 13);
    assert.deepEqual([...f.tensions], [5, 7, 9]);
    assert.deepEqual([...f.contacts], [28, 29, 30, 31, 32, 33]);
    assert.deepEqual([...f.joints, ...f.outputs, ...f.inputs, ...f.stats], [34, 35, 36, 37, 38, 39, 40, 41]);
});

test('what is no frame is refused with what is wrong', () => {
    const good = makeFrame(), change = (at, v) => { const b = good.slice(0); new DataView(b).setUint32(at, v, true); return b; };
    assert.throws(() => decodeFrame('text'), /binary/);
    assert.throws(() => decodeFrame(new ArrayBuffer(40)), /no header/);
    assert.throws(() => decodeFrame(change(0, 1)), /HWLV/);
    assert.throws(() => decodeFrame(change(4, 9)), /version 9/);
    assert.throws(() => decodeFrame(change(8, 12)), /says 12 bytes/);
    assert.throws(() => decodeFrame(change(48, 2)), /sections take/);
    assert.throws(() => decodeFrame(change(48, 0xffffffff)), /sections take/);
    assert.throws(() => decodeFrame(good.slice(0, good.byteLength - 4)), /bytes/);
    const torn = good.slice(0);
    new DataView(torn).setUint32(128 + 4 * 12, 4, true);   // the first wire says four points
    assert.throws(() => decodeFrame(torn), /add up/);
});

test('every prefix and a flipped byte at every place of a header are refused or read, never worse', () => {
    const good = new Uint8Array(makeFrame());
    for (let n = 0; n < good.length; n += 3) assert.throws(() => decodeFrame(good.slice(0, n).buffer));
    for (let i = 0; i < 128; ++i)
        for (const bit of [1, 128]) {
            const b = good.slice();
            b[i] ^= bit;
            try { decodeFrame(b.buffer); } catch (e) { assert.ok(e instanceof Error && !(e instanceof RangeError), e.message); }
        }
});

test('the largest tension of each wire: gone is no number, parted everywhere −1', () => {
    const f = decodeFrame(makeFrame({counts: [3, 0, 2], tensions: [5, -1, -1]}));
    assert.deepEqual([...largestTensions(f)], [5, NaN, -1]);
});

test('what a budget left out is said in words', () => {
    const none = {iterationsEnded: 0, cuts: 0n, coarser: 0, hasty: false, budgetEnded: false};
    assert.equal(leftOutWords(none), '');
    assert.equal(leftOutWords({...none, iterationsEnded: 1}), 'ended after 1 Newton iteration');
    assert.equal(leftOutWords({...none, cuts: 5n, coarser: 2, hasty: true}), '2 interfaces between groups cut, wires 2 levels coarser, ended with the factorisation at hand');
    assert.equal(leftOutWords({...none, budgetEnded: true}), 'ended the solve early');
});

test('the token comes from the fragment', () => {
    const t = '0123456789abcdef0123456789abcdef';
    assert.equal(tokenOf(`#token=${t}`), t);
    assert.equal(tokenOf(`#a=1&token=${t}`), t);
    assert.equal(tokenOf('#token=12'), '');
    assert.equal(tokenOf(''), '');
});

test('components of the sea have names', () => {
    assert.deepEqual(seaComponents({components: [[1, 2, 3, 4, 5]]}), [{amplitude: 1, wave_number: 2, direction: 3, frequency: 4, phase: 5}]);
    assert.deepEqual(seaComponents(null), []);
});

class FakeSocket {
    static all = [];
    constructor() { FakeSocket.all.push(this); this.readyState = 1; this.sent = []; }
    send(m) { this.sent.push(JSON.parse(m)); }
}

test('the connection says hello, leaves out frames of other epochs, answers by id, tries again', t => {
    t.mock.timers.enable({apis: ['setTimeout']});
    const c = new Connection('ws://x/live', 'abc', FakeSocket), s = FakeSocket.all.at(-1), seenFrames = [], states = [];
    c.addEventListener('frame', e => seenFrames.push(e.detail.time));
    c.addEventListener('status', e => states.push(e.detail.state));
    s.onopen();
    assert.deepEqual(s.sent[0], {type: 'hello', version: 1, token: 'abc'});
    s.onmessage({data: makeFrame({epoch: 2})});
    s.onmessage({data: JSON.stringify({type: 'scene', epoch: 2})});
    s.onmessage({data: makeFrame({epoch: 1, time: 3})});
    s.onmessage({data: makeFrame({epoch: 2, time: 4})});
    assert.deepEqual(seenFrames, [4]);
    const answer = c.ask({type: 'step'});
    assert.equal(s.sent[1].id, 1);
    s.onmessage({data: JSON.stringify({type: 'ok', id: 1})});
    s.onclose({code: 1006});
    t.mock.timers.tick(399);
    assert.equal(FakeSocket.all.at(-1), s);
    t.mock.timers.tick(2);
    assert.notEqual(FakeSocket.all.at(-1), s);
    FakeSocket.all.at(-1).onclose({code: 1008});
    t.mock.timers.tick(60000);
    assert.deepEqual(states, ['open', 'lost', 'connecting', 'refused']);
    return answer.then(a => assert.equal(a.type, 'ok'));
});

test('waiting times double up to 6 s; a refusal is final', () => {
    assert.deepEqual([0, 1, 2, 3, 4, 9].map(retryDelay), [400, 800, 1600, 3200, 6000, 6000]);
    assert.deepEqual([1000, 1006, 1013, 1008].map(mayRetry), [true, true, true, false]);
});

test('level and waves are those of the frame, and of recordings, which do not know them, those of the scene', () => {
    const scene = {
        inputs: [{name: 'sea.waves'}, {name: 'sea.level'}], outputs: [{name: 'speed'}, {name: 'sea.tide'}],
        sea: {level: 1.25, waves_factor: 0.5},
    };
    assert.deepEqual(seaState(scene, {inputs: [2, 5], outputs: [0, 1.5]}), {level: 6.5, factor: 2});
    assert.deepEqual(seaState(scene, {inputs: [NaN, NaN], outputs: [NaN, NaN]}), {level: 1.25, factor: 0.5});
    assert.deepEqual(seaState(scene, null), {level: 1.25, factor: 0.5});
    assert.deepEqual(seaState({inputs: [], outputs: [], sea: null}, {inputs: [], outputs: []}), {level: 0, factor: 1});
});

test('waves have the phase of the world wherever the origin of the frames is', () => {
    const sea = {components: [[2, 0.1, 0.4, 1, 0.3], [1, 0.2, -2, 1.4, 5]]}, origin = [1210, -740, 0], at = [33, -12];
    const world = seaComponents(sea), here = seaComponents(sea, origin);
    const want = waveHeight(world, 7, origin[0] + at[0], origin[1] + at[1]);
    assert.ok(Math.abs(waveHeight(here, 7, ...at) - want) < 1e-9);   // phases of some hundred radians
});
