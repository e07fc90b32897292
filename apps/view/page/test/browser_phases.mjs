// SPDX-License-Identifier: Apache-2.0
// A picture of each phase of anchor handling for docs/anchor_handling.md:
//     node test/browser.mjs HAWSER phases
// Each starts at a saved state (tests/data/anchor_handling, or HAWSER_STATES=FOLDER before it) or at the
// start of its exercise, runs with the control file of the exercise to its time, and is drawn without
// panels. HAWSER_PHASES=haul,run: these alone. States of an exercise belong to its scene with its inputs.
import assert from 'node:assert/strict';
import {cpSync, existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {gunzipSync} from 'node:zlib';
import {palettePicture} from './png.mjs';

const kSize = {width: 1400, height: 900}, kMost = 400 * 1000;
const kFull = 'anchor_handling', kLower = 'anchor_handling_lower';

/// Sources are tried in their order. Camera: target in the frame of a body, distance [m], elevation and
/// azimuth [rad], the latter from the heading of `ahts1`; `between`: midway to another body; or a mode on board with its angle of view.
const kPhases = {
    pennant: {from: [{exercise: kFull, state: 'pennant', until: 20}, {exercise: kFull, until: 20}], camera: {body: 'ahts1/hull', at: [-33, 0, 9], distance: 84, elevation: 0.2, azimuth: 1.1}},
    haul: {from: [{exercise: kFull, state: 'roller', until: 206}, {exercise: kFull, state: 'haul', until: 206}], camera: {body: 'ahts1/hull', at: [-35, 0, 2], distance: 34, elevation: 0.2, azimuth: 2.4}},
    run: {from: [{exercise: kFull, state: 'run', until: 262}, {exercise: kFull, state: 'haul', until: 262}], camera: {body: 'ahts1/hull', mode: 'aft', fov: 52, elevation: -0.2}},
    lower: {from: [{exercise: kLower, state: 'lower', until: 58}, {exercise: kLower, until: 58}], camera: {body: 'ahts1/hull', at: [-38, 0, -3], distance: 34, elevation: 0.15, azimuth: 2.5}},
    set: {from: [{exercise: kFull, state: 'set', until: 1380}], camera: {body: 'anchor1', at: [0, 0, 0], distance: 17, elevation: 0.22, azimuth: 2.3}},
    disconnect: {from: [{exercise: kFull, state: 'disconnect', until: 1421}], camera: {body: 'anchor1', between: 'socket', at: [0, 0, 0], distance: 18, elevation: 0.22, azimuth: 1.75}},
};

/// Write the scene of an exercise with the inputs of the exercise, and its parts. Return its path.
function sceneOf(kit, exercise) {
    const folder = join(kit.out, `scene_${exercise}`), path = join(folder, `${exercise}.json`), scenes = join(kit.root, 'scenes');
    if (existsSync(path)) return path;
    mkdirSync(folder, {recursive: true});
    // As text: a state belongs to the numbers as they are written.
    const scene = readFileSync(join(scenes, `${exercise}.json`), 'utf8'), [, inputs] = readFileSync(join(kit.root, 'exercises', `${exercise}.json`), 'utf8').match(/"inputs": (\[\n[\s\S]*?\n {2}\])/);
    writeFileSync(path, scene.replace(/"\$schema": "[^"]*",/, () => `"inputs": ${inputs},`));
    for (const name of ['parts', JSON.parse(scene).state?.file].filter(Boolean)) cpSync(join(scenes, name), join(folder, name), {recursive: true});
    return path;
}

/// Return the path of a saved state, unpacked; '' if it does not exist.
function stateOf(kit, name) {
    const own = process.env.HAWSER_STATES && join(process.env.HAWSER_STATES, `${name}.hws`), packed = join(kit.root, 'tests/data/anchor_handling', `${name}.hws.gz`);
    if (own && existsSync(own)) return own;
    if (!existsSync(packed)) return '';
    const path = join(kit.out, `${name}.hws`);
    writeFileSync(path, gunzipSync(readFileSync(packed)));
    return path;
}

async function picture(kit, name, {from, camera}) {
    const source = from.find(f => !f.state || stateOf(kit, f.state));
    const server = await kit.serve(sceneOf(kit, source.exercise), '--wait', '--control', join(kit.root, 'exercises', `${source.exercise}.control.csv`), ...(source.state ? ['--restore', stateOf(kit, source.state)] : []));
    const page = await kit.open(kit.browser, server.instructor, {query: '?quality=high&clean', viewport: {width: 420, height: 270}});
    await kit.still(page);
    await page.evaluate(() => hawser.briefing.close());
    if (await page.evaluate(t => hawser.frame.time < t, source.until)) {
        await page.evaluate(() => { hawser.rate(10); hawser.play(); });
        await kit.until(page, t => hawser.frame.time >= t, source.until, 1200000);
        await page.evaluate(() => hawser.play());
        await kit.until(page, () => hawser.state.paused);
    }
    await page.setViewportSize(kSize);
    await kit.until(page, w => document.getElementById('canvas').clientWidth === w, kSize.width);
    const facts = await page.evaluate(async c => {
        const {stage} = hawser, body = stage.bodies.bodies.find(b => b.name === c.body), ship = stage.bodies.bodies.find(b => b.name === 'ahts1/hull'), q = ship.quaternion;
        Object.assign(stage.show, {tubes: 'tubes', contacts: false, names: false});
        stage.quality.decide = () => {};
        if (c.mode) {
            stage.follow(body);
            hawser.camera(c.mode);
            stage.rig.look.elevation = c.elevation;
            stage.camera.fov = c.fov;
        } else {
            hawser.camera('free');
            stage.rig.target.set(...c.at).applyMatrix4(body.matrix);
            if (c.between) stage.rig.target.lerp(stage.bodies.bodies.find(b => b.name === c.between).position, 0.5);
            Object.assign(stage.rig, {distance: c.distance, elevation: c.elevation, azimuth: c.azimuth + Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))});
        }
        stage.camera.updateProjectionMatrix();
        stage.shadowDue = 0;
        document.getElementById('toast').hidden = true;
        const of = n => hawser.frame.outputs[hawser.scene.outputs.findIndex(o => o.name === n)];
        return `${hawser.frame.time.toFixed(1)} s; work wire ${(of('work_tension') / 1e3).toFixed(0)} kN, chain ${(of('chain_tension') / 1e3).toFixed(0)} kN, anchor ${of('anchor_z').toFixed(1)} m, ${of('anchor_to_rig').toFixed(0)} m from the rig`;
    }, camera);
    await kit.still(page, false);
    await kit.still(page);
    const path = join(kit.pictures, `handling_${name}.png`);
    await palettePicture(page, path, kSize);
    await page.context().close();
    await server.end();
    assert.ok(kit.size(path) <= kMost, `${kit.size(path)} bytes`);
    return `${facts}; ${kit.size(path)} bytes`;
}

export async function phasesPart(kit) {
    console.log('--- pictures of the phases of anchor handling');
    const wanted = process.env.HAWSER_PHASES?.split(',') ?? Object.keys(kPhases);
    for (const name of wanted) await kit.check(`handling_${name}.png`, () => picture(kit, name, kPhases[name]));
}
