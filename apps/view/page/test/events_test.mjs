// SPDX-License-Identifier: Apache-2.0
// Weather sliders, positions and texts of events, the map's list.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Matrix4, Vector3} from 'three';
import {eventText, sourceOf} from '../src/event_words.js';
import {Recent} from '../src/map.js';
import {placeOf, shorter} from '../src/places.js';
import {significantHeight, weatherOf} from '../src/weather.js';
import {kWords} from '../src/word_table.js';

const sea = {components: [[0.5, 0.1, 0, 1, 0], [0.5, 0.2, 0, 1.4, 0]], current: {speed: 0.5, direction: 0}};

test('the slider of the waves shows the significant height', () => {
    assert.ok(Math.abs(significantHeight(sea.components) - 2) < 1e-12);   // 4 sqrt(2 · 0.5²/2)
    const waves = weatherOf({name: 'sea.waves', min: 0, max: 10, value: 1}, sea);
    assert.equal(waves.text(1), '2.0 m');
    assert.deepEqual(waves.range, [0, 3]);                                // up to 6 m
    assert.deepEqual(weatherOf({name: 'sea.waves', min: 0, max: 10, value: 4}, sea).range, [0, 6]);
    assert.equal(weatherOf({name: 'sea.waves', min: 0, max: 10, value: 1}, {components: []}).hidden, true);
    assert.equal(weatherOf({name: 'swell', drives: 'sea.waves', min: 0, max: 2, value: 1}, sea).range[1], 2);
    assert.equal(weatherOf({name: 'winch.speed'}, sea), null);
});

test('wind is in knots and named by the direction from which it comes', () => {
    const wind = weatherOf({name: 'sea.wind', min: 0, max: 100, value: 10}, sea), from = weatherOf({name: 'sea.wind_direction', min: -1e3, max: 1e3, value: Math.PI / 2}, sea);
    assert.match(wind.text(10), /^19\.4 kn$/);
    assert.equal(from.text(Math.PI / 2), '180°');                          // blows to the north
    assert.equal(from.text(0), '270°');                                    // blows to the east
    assert.match(weatherOf({name: 'sea.current', min: -10, max: 10, value: 1}, sea).text(1), /^0\.97 kn$/);
    assert.equal(weatherOf({name: 'sea.current', min: -10, max: 10, value: 1}, {...sea, current: undefined}).text(1.5), '150 %');
});

const body = (id, name, x, kind = 'rigid') => ({id, name, def: {kind}, position: new Vector3(x, 0, 0), matrix: new Matrix4().makeTranslation(x, 0, 0)});
const bodies = [body(1, 'tug/hull', 10), body(2, 'barge/hull', -200), body(3, 'tow_winch/drum', 0, 'scalar'), body(4, 'crane/boom', 50)];
const scene = {
    wires: [{name: 'gob'}, {name: 'towline'}], bodies: [{id: 3, name: 'tow_winch/drum'}], inputs: [{name: 'port', drives: 'tug/ship.port'}],
    drums: [{name: 'towline/s0', wire: 1, body: 1, point: [-5, 1, 2], drum: 3}], vessels: [{name: 'tug/ship', body: 1}], gauges: [], joints: [{name: 'foot', bodies: [0, 4], point: [1, 0, 0]}],
};
const frame = {counts: [2, 3], wirePoints: [0, 0, 0, 1, 0, 0, -5, 0, 2, -100, 0, -20, -150, 0, 0]};

test('events have the position of the thing that they name', () => {
    const at = (name, faults) => placeOf(name, {scene, frame, bodies, faults});
    assert.deepEqual(at('towline'), [-100, 0, -20]);
    assert.deepEqual(at('towline/s39 (towline at 197.5 m)'), [-100, 0, -20]);
    assert.deepEqual(at('barge/hull'), [-200, 0, 0]);
    assert.deepEqual(at('tug/ship.mode'), [10, 0, 0]);
    assert.deepEqual(at('port'), [10, 0, 0]);
    assert.deepEqual(at('tow_winch/drum'), [5, 1, 2]);                     // the drum on the tug at x = 10
    assert.deepEqual(at('foot'), [51, 0, 0]);
    assert.deepEqual(at('crane.hoist'), [50, 0, 0]);
    assert.deepEqual(at('brake', [{name: 'brake', target: 'tow_winch'}]), [5, 1, 2]);
    assert.equal(at('seabed'), null);
    assert.equal(at('loop', [{name: 'loop', target: 'loop'}]), null);
    assert.deepEqual(['a/b.c', 'a/b', 'a', ''].map(shorter), ['a/b', 'a', '', '']);
});

test('texts of events have the words and units of the trade', () => {
    assert.equal(eventText({kind: 'line_break', name: 'towline/s39 (towline at 197.5 m)', value: 1961330, words: 'towline/s39 (towline at 197.5 m) broke at 1.961 MN (131 % of its breaking load)'}), 'Towline at 198 m: parted at 200 t (131 % of MBL)');
    assert.equal(eventText({kind: 'brake_slip', name: 'tow_winch/drum', value: 98066.5}), 'Tow winch: brake slips at 10.0 t m');
    assert.equal(eventText({kind: 'layer', name: 'winch', value: 3}), 'Winch: wire layer 3');
    assert.equal(eventText({kind: 'alarm', name: 'crane/hook', value: 0.957}), 'Crane: load alarm 96 %');
    assert.equal(eventText({kind: 'alarm', name: 'overload', value: 0, words: 'alarm overload: Tension high'}, ['overload']), 'alarm overload: Tension high');
    assert.equal(eventText({kind: 'energy_created', name: 'x', value: 1, words: 'x gained energy'}), 'x gained energy');
    assert.equal(sourceOf('towline cable_element 12'), 'Towline');
});

test('each kind with words of its own is in the table', () => {
    for (const kind of ['line_break', 'brake_slip', 'release', 'position_lost', 'hauled_in', 'overload', 'saturation']) {
        const text = eventText({kind, name: 'winch', value: 1, words: 'own'});
        assert.ok(kWords[`event ${kind}`] && !/event |own/.test(text), `${kind}: ${text}`);
    }
});

test('the map lists the last ten minutes, newest first, and forgets events after a restored time', () => {
    const recent = new Recent();
    assert.equal(recent.take({kind: 'slack', time: 1}), false);
    assert.equal(recent.take({kind: 'command', time: 1, words: 'instructor paused'}), false);
    assert.equal(recent.take({kind: 'command', time: 1, words: 'instructor note: fog'}), true);
    for (let k = 0; k < 9; ++k) recent.take({kind: 'goal', name: `g${k}`, time: 100 * k});
    assert.deepEqual(recent.list(800).map(e => e.name), ['g8', 'g7', 'g6', 'g5', 'g4', 'g3']);
    assert.deepEqual(recent.list(1100).map(e => e.name), ['g8', 'g7', 'g6', 'g5']);
    assert.equal(recent.list(350)[0].name, 'g3');
    assert.equal(recent.list(900)[0].name, 'g3');
});
