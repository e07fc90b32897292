// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Build} from '../src/build.js';
import {History} from '../src/history.js';
import {convexFaces, heightfieldBuild} from '../src/meshes.js';
import {toSegment} from '../src/picking.js';
import {Quality} from '../src/quality.js';
import {longAxis, readable, roleOf, workingDeck} from '../src/roles.js';
import {shipBox} from '../src/bodies.js';
import {barge, deckLine, keelLine, semi, ship} from '../src/ship.js';
import {arrowLength} from '../src/arrows.js';
import {exceeded, fogOf, kLights, setAir, air, AIR, SUN, whitecaps} from '../src/air.js';
import {chartView, scaleLength} from '../src/chart.js';
import {ropeScale, rollerOf} from '../src/bodies.js';
import {seen} from '../src/lights.js';
import {Track, wakeStrength} from '../src/wake.js';
import {shared} from '../src/geometry.js';
import {sector} from '../src/rings.js';
import {waveHeight, largestWaves, noiseTile, windOf} from '../src/surroundings.js';

test('bodies look like what they are', () => {
    const rigid = (name, half, afloat = false) => roleOf({name, kind: 'rigid', half, afloat});
    assert.equal(rigid('ahts1/hull', [40, 9, 4]), 'ship');
    assert.equal(rigid('thing', [40, 9, 4], true), 'ship');
    assert.equal(rigid('thing', [40, 9, 4]), 'box');
    assert.equal(rigid('rig', [40, 36, 13]), 'semi');
    assert.equal(rigid('barge', [30, 7, 3]), 'barge');
    assert.equal(rigid('barge/hull', [45, 13, 3], true), 'barge');
    assert.equal(rigid('tug/hull', [16, 5, 3], true), 'ship');
    assert.equal(rigid('a/deck_anchor1', [2.5, 2.5, 0.8]), 'anchor');
    assert.equal(rigid('derrick', [7, 7, 24]), 'lattice');
    assert.equal(rigid('crane/luff_rod', [1.9, 0.1, 0.1]), 'cylinder');
    assert.equal(rigid('x', null), 'none');
    assert.equal(roleOf({name: 'n', kind: 'lump', half: null}), 'ball');
    assert.equal(roleOf({name: 'drum', kind: 'scalar', half: null}), 'none');
    assert.deepEqual([[1, 1, 2.5], [1.9, 0.1, 0.1], [1.75, 3, 1.75]].map(longAxis), ['z', 'x', 'y']);
    assert.equal(readable('ahts1/work_drum'), 'AHTS 1 work drum');
});

test('the working deck is the top of the largest flat box', () => {
    const shapes = [{kind: 'box', position: [-18, 0, 0.7], half_size: [20, 8, 0.5]}, {kind: 'box', position: [0, 0, 0], half_size: [35, 9, 3]}, {kind: 'capsule', position: [0, 0, 0]}];
    const d = workingDeck(shapes, [40, 9, 4]);
    assert.ok(Math.abs(d.z - 1.2) < 1e-12 && Math.abs(d.front - 0.05) < 1e-12);
    assert.equal(workingDeck([], [40, 9, 4]), null);
});

test('hulls stay within their boxes below the deck and are mirror images of themselves', () => {
    assert.ok(deckLine(1) === 0 && keelLine(1) === 0);
    for (const make of [ship, barge, semi]) {
        const half = make === semi ? [40, 36, 13] : [40, 9, 4], {build} = make({half, water: -1, deck: 1.2, break: 0.1}), p = build.position;
        assert.ok(build.triangles > 50 && p.every(Number.isFinite));
        let sum = 0, least = Infinity;
        for (let i = 0; i < p.length; i += 3) {
            sum += p[i + 1];
            least = Math.min(least, p[i + 2]);
            if (p[i + 2] < half[2] * 0.3) assert.ok(Math.abs(p[i]) <= half[0] + 1 && Math.abs(p[i + 1]) <= half[1] * 1.02, `${p.slice(i, i + 3)}`);
        }
        assert.ok(Math.abs(sum / p.length) < 0.02 * half[1], `${make.name}: ${sum / p.length}`);
        assert.ok(Math.abs(least + half[2]) < 1e-6 * half[2] + 1e-9, `${make.name}: ${least}`);
    }
});

test('a box of a Build has outward normals and the right area', () => {
    const b = new Build();
    b.box([-1, -2, -3], [1, 2, 3], 0xffffff);
    let area = 0;
    for (let i = 0; i < b.position.length; i += 9) {
        const [p, q, r] = [0, 3, 6].map(k => b.position.slice(i + k, i + k + 3)), u = q.map((v, k) => v - p[k]), w = r.map((v, k) => v - p[k]);
        const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
        area += Math.hypot(...n) / 2;
        assert.ok(n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0);
    }
    assert.ok(Math.abs(area - 2 * (8 + 12 + 24)) < 1e-9);
});

test('the convex hull of a cube with a point inside has six faces', () => {
    const v = [];
    for (const x of [-1, 1]) for (const y of [-1, 1]) for (const z of [-1, 1]) v.push(x, y, z);
    const faces = convexFaces([...v, 0.1, 0.2, 0]);
    assert.equal(faces.length, 6);
    assert.ok(faces.every(f => f.length === 4));
});

test('a heightfield has its heights where docs/live.md says', () => {
    const b = heightfieldBuild({rows: 2, columns: 3, cell: [2, 4], heights: [0, 1, 2, 3, 4, 5]}, 0);
    assert.equal(b.triangles, 4);
    const has = (x, y, z) => b.position.some((_, i) => i % 3 === 0 && b.position[i] === x && b.position[i + 1] === y && b.position[i + 2] === z);
    assert.ok(has(-2, -2, 0) && has(2, -2, 2) && has(0, 2, 4));
});

test('the drawn surface is the sum of the components', () => {
    const waves = [{amplitude: 2, wave_number: 0.1, direction: Math.PI / 2, frequency: 1, phase: 0.3}, {amplitude: 1, wave_number: 0.2, direction: 0, frequency: 1.4, phase: 0}];
    const want = 2 * Math.cos(0.1 * 7 - 3 + 0.3) + Math.cos(0.2 * 5 - 1.4 * 3);   // docs/live.md, `sea`
    assert.ok(Math.abs(waveHeight(waves, 3, 5, 7) - want) < 1e-12);
    assert.deepEqual(largestWaves([{amplitude: 1}, {amplitude: 3}, {amplitude: 2}], 2).map(w => w.amplitude), [3, 2]);
});

test('the noise tile is periodic and not flat', () => {
    const n = 32, t = noiseTile(n), blue = (i, j) => t[4 * (j * n + i) + 2];
    let jump = 0, least = 255, most = 0;
    for (let i = 0; i < n; ++i) {
        jump = Math.max(jump, Math.abs(blue(0, i) - blue(n - 1, i)));
        for (let j = 0; j < n; ++j) [least, most] = [Math.min(least, blue(i, j)), Math.max(most, blue(i, j))];
    }
    assert.ok(most - least > 60 && jump < 70, `${least}…${most}, ${jump}`);
});

test('the history keeps the newest, forgets what lies after a time that went back', () => {
    const h = new History(['a', 'b'], 4, 0.1), add = t => h.add(t, i => t * (i + 1));
    for (const t of [0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5]) add(t);
    assert.deepEqual(h.columns([1], 10)[0], [0.2, 0.3, 0.4, 0.5]);
    add(0.25);                                      // a restore
    assert.deepEqual(h.columns([0], 10)[0], [0.2]);   // 0.25 is too near to be kept
    add(0.3);
    const [time, b] = h.columns([1], 10);
    assert.deepEqual(time, [0.2, 0.3]);
    assert.ok(Math.abs(b[1] - 0.6) < 1e-6);
});

test('wires become lines where pictures are slow, and tubes again after a while', () => {
    const q = new Quality();
    let now = 0;
    const run = (gap, time) => { for (const end = now + time; now < end; now += gap) q.shown(now, 1); };
    run(16, 2000);
    assert.ok(q.tubes);
    run(60, 1500);
    assert.ok(!q.tubes && !q.poor && Math.abs(q.fps - 1000 / 60) < 3);
    run(60, 1500);
    assert.ok(q.poor);
    run(16, 10000);
    assert.ok(!q.tubes);
    run(16, 15000);
    assert.ok(q.tubes);
});

test('distance to a piece; lengths of arrows', () => {
    assert.deepEqual(toSegment(5, 3, 0, 0, 10, 0), [3, 0.5]);
    assert.deepEqual(toSegment(-4, 3, 0, 0, 10, 0), [5, 0]);
    assert.deepEqual(toSegment(3, 4, 0, 0, 0, 0), [5, 0]);
    assert.ok(Math.abs(arrowLength(1e6, 2) - 20) < 1e-9 && arrowLength(-5, 1) === 0);
});

test('corners that faces share are one, others stay apart', () => {
    const b = new Build();
    b.box([-1, -2, -3], [1, 2, 3], 0xffffff);
    const {index, corners} = shared([b.position, b.normal, b.colour]);
    assert.equal(index.length, 36);
    assert.equal(corners[0].length / 3, 24);   // four of each of six faces: normals differ
    index.forEach((c, i) => { for (let v = 0; v < 3; ++v) for (let k = 0; k < 3; ++k) assert.ok(Math.abs(corners[v][3 * c + k] - [b.position, b.normal, b.colour][v][3 * i + k]) < 1e-3); });
});

test('the sector of rings covers what the corners of the picture see, all where it looks down', () => {
    const step = 2 * Math.PI / 56;
    for (const middle of [-3.1, -1, 0, 0.4, 3.1]) {
        const bearings = [-0.6, 0.6, 0.5, -0.5].map(d => middle + d), {first, count} = sector(middle, bearings, 56);
        assert.ok(count < 56 / 2);
        for (const b of bearings) assert.ok(first * step <= b + 1e-9 && (first + count) * step >= b - 1e-9, `${middle} ${b}`);
    }
    assert.deepEqual(sector(1, [0.5, 3, -2, -0.4], 56), {first: 0, count: 56});
});

test('a ship is drawn along its wetted hull, whose middle is not the centre of mass', () => {
    const at = (...x) => ({vertices: x.flatMap(v => [v, 1, -2])});
    assert.deepEqual(shipBox([41.5, 9, 4], at(-37, 0, 46)), {half: [41.5, 9, 4], x: 4.5, keel: -2});
    assert.deepEqual(shipBox([41.5, 9, 4], at()), {half: [41.5, 9, 4], x: 0, keel: -4});
});

test('foam covers the area of whitecaps, by the deviation of the surface', () => {
    // Quantiles of the normal distribution; Monahan and O'Muircheartaigh: 1.0 % at 10 m/s, 4.0 % at 15 m/s.
    for (const [p, z] of [[0.5, 0], [0.1, 1.2816], [0.01, 2.3263], [0.001, 3.0902]]) assert.ok(Math.abs(exceeded(p) - z) < 5e-4, `${p}`);
    assert.ok(Math.abs(whitecaps(10) - 0.00987) < 1e-4 && Math.abs(whitecaps(15) - 0.0393) < 2e-4 && whitecaps(0) === 0);
    // A fully developed sea of Hs 2.46 m: 10 m/s.
    assert.ok(Math.abs(windOf([{amplitude: 2.46 / 4 * Math.SQRT2}]) - 10) < 1e-9);
});

test('night is darker than dusk than day, fog hides the sky', () => {
    const light = name => { setAir({light: name, visibility: 9000, elevation: null}); return [AIR.bright.value, AIR.lampMean.value.g, AIR.horizon.value.g, SUN.z]; };
    const [day, dusk, night] = Object.keys(kLights).map(light);
    for (const k of [0, 1, 2]) assert.ok(day[k] > dusk[k] && dusk[k] > night[k], `${k}`);
    assert.ok(dusk[3] < day[3]);
    setAir({light: 'day', visibility: 300});
    assert.ok(fogOf(300).far === 300 && Math.abs(AIR.zenith.value.r - AIR.horizon.value.r) < 1e-9);
    setAir({light: 'day', visibility: 9000});
    assert.equal(air.visibility, 9000);
});

test('navigation lights are seen in their sectors', () => {
    const deg = Math.PI / 180, at = b => Object.fromEntries(['masthead', 'port', 'starboard', 'stern'].map(k => [k, seen(k, b * deg)]));
    assert.deepEqual(at(10), {masthead: true, port: false, starboard: true, stern: false});
    assert.deepEqual(at(-60), {masthead: true, port: true, starboard: false, stern: false});
    assert.deepEqual(at(180), {masthead: false, port: false, starboard: false, stern: true});
    assert.deepEqual(at(-130), {masthead: false, port: false, starboard: false, stern: true});
});

test('a track keeps positions some metres apart and starts again when time goes back', () => {
    const t = new Track();
    for (let s = 0; s < 60; ++s) t.take(s, 2 * s, 0, 0.5);
    assert.equal(t.points.length, 30);
    assert.equal(t.take(10, 0, 0, 0.5), true);
    assert.equal(t.points.length, 1);
    assert.ok(wakeStrength(0) === 0 && wakeStrength(0, 1) === 0 && wakeStrength(5) > 0.9);
});

test('rope on a drum grows by its layers', () => {
    const layers = {output: 0, step: 0.1, first: null};
    assert.deepEqual(ropeScale(layers, [3]), [1, 1, 1]);
    assert.ok(Math.abs(ropeScale(layers, [1])[0] - 0.8) < 1e-12 && ropeScale(layers, [NaN])[0] === 1);
});

test('the stern roller is the cylinder at the stern of its ship', async () => {
    const {Quaternion, Vector3} = await import('three');
    const body = (name, role, half, x, y) => ({name, role, half, position: new Vector3(x, y, 0), quaternion: new Quaternion()});
    const ship = body('ahts1/hull', 'ship', [40, 9, 4], 100, 50), roller = body('ahts1/roller', 'cylinder', [1.75, 3, 1.75], 62, 50);
    assert.deepEqual(rollerOf(ship, [ship, roller]), {x: -38, z: 0, radius: 1.75, half: 3.09});
    assert.equal(rollerOf(ship, [ship, body('ahts2/roller', 'cylinder', [1, 3, 1], 62, 50)]), null);
});

test('a chart shows all boxes, its scale is round', () => {
    assert.deepEqual(chartView([[0, 0, 10], [100, 0, 10]], 1), {x: 50, y: 0, half: 60});
    assert.deepEqual([60, 400, 1500].map(scaleLength), [20, 200, 1000]);
});
