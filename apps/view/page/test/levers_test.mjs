// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {defaultMapping, kButtons, readPad} from '../src/gamepad.js';
import {deadZone, fromDeflection, groupLevers, leverRange, neutral, nudge, quantity, springHome, Throttle, toDeflection, valueWords} from '../src/lever_logic.js';
import {goalState} from '../src/exercise.js';

test('ranges: given, open at an end, degenerate', () => {
    assert.deepEqual(leverRange({min: -2, max: 3}), [-2, 3]);
    assert.deepEqual(leverRange({min: 0, max: null, value: 5}), [0, 50]);
    assert.deepEqual(leverRange({min: null, max: null, nominal: 7}), [-7, 7]);
    assert.deepEqual(leverRange({min: 4, max: 4, value: 0}), [4, 5]);
});

test('deflection and value are each other’s inverse, with neutral at 0', () => {
    for (const range of [[-1, 1], [-2, 8], [0, 5], [-6, -2]]) {
        assert.equal(fromDeflection(range, 0), neutral(range));
        assert.equal(fromDeflection(range, 1), range[1]);
        assert.equal(fromDeflection(range, -1), range[0]);
        for (const d of [-0.7, -0.2, 0.4, 0.9]) {
            const v = fromDeflection(range, d), side = d > 0 ? range[1] - neutral(range) : neutral(range) - range[0];
            if (side > 0) assert.ok(Math.abs(toDeflection(range, v) - d) < 1e-12);
            else assert.equal(v, neutral(range));
        }
    }
    assert.equal(neutral([0.5, 2]), 0.5);
});

test('keys move by twentieths and pass through neutral exactly', () => {
    const range = [-0.8, 0.8];
    assert.ok(Math.abs(nudge(range, 0, 1) - 0.08) < 1e-15);
    assert.equal(nudge(range, 0.0799, -1), 0);
    assert.equal(nudge(range, 0.79, 1), 0.8);
    assert.equal(nudge(range, -0.8, -1), -0.8);
});

test('a spring takes the whole range in 0.3 s and ends at neutral', () => {
    let v = 1, steps = 0;
    while (v !== 0) {
        const was = v;
        v = springHome([-1, 1], v, 1 / 60);
        assert.ok(v < was);
        ++steps;
    }
    assert.ok(steps / 60 >= 0.15 && steps / 60 <= 0.17, `${steps} steps`);   // half of the range
});

test('the dead zone: nothing inside, continuous at its edge, whole at the end', () => {
    assert.equal(deadZone(0.1), 0);
    assert.equal(deadZone(-0.12), 0);
    assert.ok(Math.abs(deadZone(0.1201)) < 1e-4);
    assert.equal(deadZone(1), 1);
    assert.equal(deadZone(-1), -1);
    assert.equal(deadZone(1.7), 1);
    assert.equal(deadZone(NaN), 0);
    assert.equal(deadZone(undefined), 0);
    let before = -2;
    for (let x = -1; x <= 1; x += 0.01) {
        assert.ok(deadZone(x) >= before);
        before = deadZone(x);
    }
});

test('a pad moves mapped levers, lets go once, and tells each button once', () => {
    const mapping = {...defaultMapping(['a', 'b', 'c']), zone: 0.2};
    assert.deepEqual(mapping.axes[3].lever, '');
    const pad = (axes, pressed = []) => ({axes, buttons: Array.from({length: 10}, (_, i) => ({pressed: pressed.includes(i)}))});
    let r = readPad(pad([0.1, 0, 0, 0.9]), mapping);
    assert.deepEqual(r.moves, []);                       // the fourth axis has no lever
    r = readPad(pad([1, -1, 0, 0], [0, 5]), mapping, r);
    assert.deepEqual(r.moves, [{lever: 'a', deflection: 1, holding: true}, {lever: 'b', deflection: 1, holding: true}]);  // up is forward
    assert.deepEqual(r.commands, ['play', 'next']);
    r = readPad(pad([0, 0.05, 0, 0], [0]), mapping, r);
    assert.deepEqual(r.moves.map(m => [m.lever, m.holding]), [['a', false], ['b', false]]);
    assert.deepEqual(r.commands, []);
    r = readPad(pad([0, 0, 0, 0]), mapping, r);
    assert.deepEqual(r.moves, []);
});

test('values are sent at most once in 40 ms, the newest of each lever', () => {
    const sent = [], t = new Throttle((name, value) => sent.push([name, value]));
    t.set('a', 1); t.set('a', 2); t.set('b', 3);
    assert.equal(t.flush(100), 2);
    assert.deepEqual(sent, [['a', 2], ['b', 3]]);
    t.set('a', 4);
    assert.equal(t.flush(120), 0);
    assert.equal(t.flush(141), 1);
    assert.deepEqual(sent.at(-1), ['a', 4]);
    assert.equal(t.flush(999), 0);
});

test('levers are grouped by their group, else by the path of their name', () => {
    const g = groupLevers([{name: 'ahts1/tow'}, {name: 'x'}, {name: 'y', group: 'Deck'}, {name: 'ahts1/crane/slew'}, {name: 'ahts1/work'}]);
    assert.deepEqual([...g], [['ahts1', [0, 4]], ['Levers', [1]], ['Deck', [2]], ['ahts1/crane', [3]]]);
});

test('numbers with units', () => {
    assert.equal(quantity(612345, 'N'), '612 kN');
    assert.equal(quantity(-3.4e6, 'N'), '−3.40 MN');
    assert.equal(quantity(0, 'm/s'), '0.00 m/s');
    assert.equal(quantity(-1e-9, 'm'), '−1.00e−9 m');
    assert.equal(quantity(5760000, 'kg'), '5760 t');
    assert.equal(quantity(NaN, 'N'), '–');
    assert.equal(quantity(12.345, 'm', 4), '12.35 m');
});

test('a goal is open, reached or too late', () => {
    const goal = {reached: null, late: false, by: 60};
    assert.deepEqual(goalState(goal, 20), {mark: '○', className: '', words: '0:40.0 left'});
    assert.equal(goalState({...goal, by: null}, 20).words, '');
    assert.equal(goalState({...goal, reached: 12.5}, 20).words, 'reached at 0:12.5');
    assert.equal(goalState({...goal, late: true}, 70).className, 'late');
});

test('a choice has words and goes on by one', () => {
    const mode = {min: 0, max: 2, words: ['speed', 'tension', 'brake']}, range = leverRange(mode);
    assert.equal(valueWords(mode, 2), 'brake');
    assert.equal(valueWords({words: []}, 2, 'm/s'), quantity(2, 'm/s'));
    assert.equal(valueWords({}, 2, 'm/s'), quantity(2, 'm/s'));
    assert.deepEqual([nudge(range, 0, 1, true), nudge(range, 0, 5, true), nudge(range, 2, 1, true), nudge(range, 1, -1, true)], [1, 1, 2, 0]);
});

test('a button of the gamepad has a command of its own and repeats while it is held', () => {
    const mapping = {...defaultMapping([]), buttons: {...kButtons, 2: 'more'}}, pad = on => ({axes: [], buttons: Array.from({length: 12}, (_, i) => ({pressed: i === on}))});
    let read = readPad(pad(2), mapping);
    assert.deepEqual(read.commands, ['more']);
    let times = 0;
    for (let i = 0; i < 60; ++i) {
        read = readPad(pad(2), mapping, read);
        times += read.commands.length;
    }
    assert.equal(times, 7);   // from the 24th poll on, each sixth
    assert.deepEqual(readPad(pad(0), mapping, readPad(pad(0), mapping)).commands, []);   // play does not repeat
    assert.deepEqual([6, 7, 8, 10].map(b => readPad(pad(b), defaultMapping([])).commands[0]), ['less', 'more', 'acknowledge', 'release']);
});
