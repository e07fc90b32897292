// SPDX-License-Identifier: Apache-2.0
// Logic of stations: the ship of a station, forms and words of controls, thrusts, footprint, gauge,
// words of the page.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import {driftRate, formOf, inPercent, keyStep} from '../src/forms.js';
import {choicesOf, gaugeState, plotRadius, stateWord, stationBody, thrustDirection, Trail, winchOfDrum} from '../src/vessel.js';
import {chooseLanguage, t} from '../src/words.js';
import {kWords} from '../src/word_table.js';
import {shown} from '../src/units.js';

const ship = {name: 'ahts/ship', body: 4, origin: [4.5, 0, -1.2], rudders: [{name: 'rudder_port'}],
    propulsors: [{name: 'port', kind: 'shaft'}, {name: 'bow1', kind: 'tunnel'}, {name: 'azimuth', kind: 'azimuth'}]};
const scene = {
    vessels: [ship], systems: ['ahts/ship', 'tow_winch'].map(name => ({name})), bodies: [{id: 37, name: 'tow_winch/drum'}],
    drums: [{name: 'towline/s0', wire: 0, body: 4, drum: 37}], outputs: [{name: 'tow_winch.pull'}],
    inputs: [{name: 'mode', drives: 'ahts/ship.mode', max: 3}, {name: 'haul', drives: 'tow_winch.speed'}, {name: 'push', drives: ''}],
};

test('a station works on the ship of its vessel or of its winch', () => {
    assert.equal(winchOfDrum(scene, scene.drums[0]), 'tow_winch');
    assert.equal(stationBody(scene, ['mode']), 4);
    assert.equal(stationBody(scene, ['haul']), 4);
    assert.equal(stationBody(scene, ['push']), null);
    assert.equal(stationBody(scene, []), null);
});

test('a crane station on a rig works on the rig, not on the cylinders of its crane', () => {
    const rig = {vessels: [], systems: ['crane', 'windlass'].map(name => ({name})), bodies: [{id: 1, name: 'rig/hull'}, {id: 8, name: 'crane/luff/stroke'}, {id: 9, name: 'windlass/drum'}],
        drums: [{name: 'crane/luff/cylinder', wire: 0, body: 5, drum: 8}, {name: 'chain/s0', wire: 1, body: 1, drum: 9}], outputs: [{name: 'windlass.pull'}],
        inputs: [{name: 'slew', drives: 'crane.slew'}, {name: 'luff', drives: 'crane.luff'}, {name: 'lever', drives: 'windlass.speed'}]};
    assert.equal(stationBody(rig, ['slew', 'luff', 'lever']), 1);
});

test('hooks, jaws and pins are switches; their states have words', () => {
    const input = drives => ({name: 'x', drives, min: 0, max: 1});
    assert.deepEqual(choicesOf(input('jaw.close')), ['jaw open', 'jaw closed']);
    assert.deepEqual(choicesOf(input('pin_port.up')), ['pin down', 'pin up']);
    assert.deepEqual(choicesOf(input('crane.take')), ['hook open', 'hook takes']);
    assert.deepEqual(choicesOf(input('winch.brake')), []);
    const names = new Set(['jaw.close', 'hook.take']);
    assert.equal(stateWord('jaw.state', 2, names), 'holds');
    assert.equal(stateWord('hook.held', 1, names), 'yes');
    assert.equal(stateWord('winch.state', 1, names), '');
});

test('an ordered position moves in metres, by keys and by stick', () => {
    const form = formOf({name: 'x', drives: 'ahts/ship.x_order', unit: 'm', min: -500, max: 2000}, scene);
    assert.equal(form, 'position');
    assert.equal(keyStep(form), 1);
    assert.equal(driftRate(form, [-500, 2000]), 2);
    assert.equal(driftRate('', [-1, 1]), 0.5);
});

test('modes of a vessel have words within the range of their control', () => {
    assert.deepEqual(choicesOf(scene.inputs[0], scene.vessels), ['off', 'joystick', 'heading', 'position']);
    assert.deepEqual(choicesOf({name: 'other.mode', max: 3}, scene.vessels), []);
    assert.deepEqual(choicesOf({name: 'w.mode', words: ['a', 'b']}, []), ['a', 'b']);
});

test('a control has the form of the thing that it operates', () => {
    const form = (drives, unit = '1', min = -1, max = 1) => formOf({name: 'x', drives, unit, min, max}, scene);
    assert.deepEqual(['heading_order', 'joystick_x', 'rudder_port', 'port', 'bow1', 'azimuth', 'azimuth_angle'].map(n => form(`ahts/ship.${n}`)), ['heading', 'joystick', 'helm', 'telegraph', 'side', 'azimuth', 'azimuth']);
    assert.equal(form('tow_winch.speed', 'm/s', -2, 2), 'winch');
    assert.equal(form('tow_winch.brake', '1', 0, 1), 'share');
    assert.equal(form('', 'N', 0, 1e6), '');
    assert.equal(inPercent('share', '1', [0, 1]), true);
    assert.equal(inPercent('', '1', [0, 1]), false);
    assert.ok(Math.abs(keyStep('heading') * 180 / Math.PI - 1) < 1e-12);
});

test('thrusts point where the water pushes the ship', () => {
    const near = (a, b) => a.forEach((v, i) => assert.ok(Math.abs(v - b[i]) < 1e-12, `${a} for ${b}`));
    near(thrustDirection('shaft', 5), [1, 0]);
    near(thrustDirection('shaft', -5), [-1, 0]);
    near(thrustDirection('tunnel', 5), [0, -1]);                    // to starboard, y is to port
    near(thrustDirection('azimuth', 5, Math.PI / 2), [0, -1]);      // clockwise from ahead
    near(thrustDirection('azimuth', -5, Math.PI / 2), [0, 1]);
});

test('the footprint keeps one point a second for its span, and starts again after a restore', () => {
    const trail = new Trail(10);
    for (let k = 0; k <= 600; ++k) trail.take(k / 30, k, 0);
    assert.equal(trail.points.length, 11);
    assert.equal(trail.points.at(-1).time, 20);
    trail.take(5, 1, 2);
    assert.deepEqual(trail.points, [{time: 5, x: 1, y: 2}]);
    assert.equal(trail.take(7, NaN, 0), false);
    assert.deepEqual([plotRadius([]), plotRadius([[3, 4.1]]), plotRadius([[700, 700]])], [5, 10, 1000]);
});

test('the stability gauge warns at 0.8 and alarms at 1 of the permissible tension', () => {
    assert.deepEqual([0.5, 0.8, 1, 3].map(f => gaugeState(f * 1e6, 1e6).state), ['good', 'warn', 'danger', 'danger']);
    assert.equal(gaugeState(3e6, 1e6).share, 1.2);
    assert.equal(gaugeState(5e5, 1e6).percent, 50);
    assert.equal(gaugeState(1, 0).state, 'danger');     // no tension is permissible
    assert.equal(gaugeState(-5, 1e6).share, 0);
});

test('headings are shown as on a compass: x is east, y north', () => {
    assert.equal(shown(0, 'rad', 'ahts/ship.heading_order'), '090°');
    assert.equal(shown(-Math.PI / 6, 'rad', 'ahts/ship.heading_order'), '060°');   // to port
    assert.equal(shown(Math.PI / 6, 'rad', 'course'), '060°');                     // yaw of a pose, anticlockwise
    assert.equal(shown(2, 'm/s', 'ahts/ship.speed_order'), '3.89 kn');
});

test('the table of words has three languages, and each key of the page is in it', () => {
    for (const [key, row] of Object.entries(kWords)) assert.ok(row.length === 3 && row.every(w => w.length > 0), key);
    assert.equal(t('Brake', 'de'), 'Bremse');
    assert.equal(t('tow_tension', 'de'), 'tow_tension');
    assert.deepEqual([['nb-NO', 'en'], ['fr', 'de-AT'], ['fr']].map(chooseLanguage), ['no', 'de', 'en']);
    const folder = new URL('../src/', import.meta.url), missing = new Set();
    const sources = ['curves', 'event_words', 'map', 'report_sheet', 'forms', 'instruments', 'levers', 'vessel_cards', 'exercise', 'alarms', 'briefing', 'main', 'panels', 'debriefing', 'plots', 'timeline'];
    for (const file of sources)
        for (const [, key] of readFileSync(new URL(`${file}.js`, folder), 'utf8').matchAll(/\bt\('((?:[^'\\]|\\.)*)'/g)) if (!kWords[key]) missing.add(key);
    assert.deepEqual([...missing], []);
});
