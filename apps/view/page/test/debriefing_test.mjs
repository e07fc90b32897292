// SPDX-License-Identifier: Apache-2.0
// Curves of the debriefing, and what a page collects of a live run.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {controlCurves, curvePath, valueAt} from '../src/curves.js';
import {Collector} from '../src/debriefing.js';
import {curvesOf, entryRows, stampOf, tallyRows} from '../src/report_sheet.js';

test('a value is that of the last sample at or before a time', () => {
    assert.deepEqual([0.5, 1, 1.9, 2, 99].map(s => valueAt([1, 2, 3], [10, 20, 30], s)), [NaN, 10, 10, 20, 30]);
    assert.ok(Number.isNaN(valueAt([], [], 1)));
});

test('controls are steps up to the end', () => {
    const [a, b] = controlCurves([[1, 'bridge', 'mode', 2], [3, 'winch', 'speed', 0.5], [4, 'bridge', 'mode', 0]], 10);
    assert.deepEqual(a, {name: 'mode', role: 'bridge', times: [1, 4, 4, 10], values: [2, 2, 0, 0]});
    assert.deepEqual([b.times, b.values], [[3, 10], [0.5, 0.5]]);
});

test('a curve fills its box, with a gap where a display had no number', () => {
    assert.equal(curvePath([0, 5, 10], [0, 1, 2], [0, 10], [0, 2]), 'M0.0 33.0L500.0 18.0L1000.0 3.0');
    assert.equal(curvePath([0, 5, 10], [0, NaN, 2], [0, 10], [0, 2]), 'M0.0 33.0M1000.0 3.0');
});

test('a live run is sampled once a second; a restore drops what came after', () => {
    const c = new Collector(), scene = {inputs: [{name: 'speed', kind: 'lever'}, {name: 'inner', kind: 'inner'}], outputs: [{name: 'pull'}]};
    for (let k = 0; k <= 100; ++k) c.frame(scene, {time: k / 10, inputs: [k < 50 ? 0 : 1, k], outputs: [k]}, ['pull']);
    c.event({time: 3, kind: 'goal', name: 'g', words: 'goal reached: out, +10 points', value: 10});
    c.event({time: 4, kind: 'command', name: 'note', words: 'instructor note: too fast', value: 0});
    c.event({time: 4, kind: 'command', name: 'rate', words: 'instructor set the rate', value: 2});
    const m = c.message({name: 'x', displays: ['pull']});
    assert.deepEqual(m.values[0], [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
    assert.deepEqual(m.controls, [[0, '', 'speed', 0], [5, '', 'speed', 1]]);
    assert.deepEqual(m.entries.map(e => [e.kind, e.text]), [['goal', 'out, +10 points'], ['note', 'too fast']]);
    c.frame(scene, {time: 2.05, inputs: [0, 0], outputs: [7]}, ['pull']);
    assert.deepEqual(c.times, [0, 1, 2]);
    assert.equal(c.entries.length, 0);
});

test('the rows of the report on paper have marks, times and points', () => {
    assert.equal(stampOf(new Date(2026, 2, 1, 9, 5)), '2026-03-01 09:05');
    assert.deepEqual(tallyRows([{name: 'paid_out', text: '', possible: 20, points: 20, reached: 92.5}, {name: 'b', text: 'Turned', possible: 35, points: 0, reached: null}]),
        [['✓', 'Paid out', '1:32.5', '20 / 20'], ['✕', 'Turned', '–', '0 / 35']]);
    assert.deepEqual(tallyRows([{name: 'slip', text: '', possible: 0, points: -5, times: 2, seconds: 3.25}]), [['−', 'Slip', '2×, 3.3 s', '-5']]);
    assert.deepEqual(entryRows([{time: 4, kind: 'note', text: 'too fast', by: 'instructor', points: 0}, {time: 5, kind: 'penalty', name: 'slip', points: -5}]),
        [['0:04.0', '✎ too fast', 'Instructor', ''], ['0:05.0', '− Slip', '', '−5']]);
    const curves = curvesOf({displays: ['pull', 'empty'], times: [0, 1], values: [[1, 2]], controls: [[0, 'winch', 'speed', 0.5]]}, 1);
    assert.deepEqual(curves.map(c => [c.name, c.kind, c.values.length]), [['pull', 'display', 2], ['empty', 'display', 0], ['speed', 'control', 2]]);
});
