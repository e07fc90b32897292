// SPDX-License-Identifier: Apache-2.0
// Stills of ships, sea and rig for docs/trainer.md, with the draw calls and triangles of a frame at the
// middle quality level (quality=high in the address): at most 300 and 600,000.
//     node test/browser.mjs HAWSER stills            HAWSER_STILLS=stern,night: these alone
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {palettePicture} from './png.mjs';

const kSize = {width: 1280, height: 720}, kCalls = 300, kTriangles = 600000;

/// Each still: scene, seconds to run, inputs, air, `drops`: least number of drops of spray, waited for at rate 1; camera: a mode, or target in the frame of a body, distance [m],
/// elevation and azimuth [rad], the latter from the heading of the body.
const kStills = {
    stern: {scene: 'exercises/anchor_handling.json', run: 6, camera: {body: 'ahts1/hull', at: [-30, 0, 2], distance: 46, elevation: 0.2, azimuth: 2.5}},
    sea: {scene: 'exercises/tow_to_sea.json', run: 70, set: {mode: 2, speed_order: 3}, camera: {body: 'ahts/hull', at: [-20, 0, 2], distance: 120, elevation: 0.16, azimuth: 2.3}},
    bridge_aft: {scene: 'exercises/tow_to_sea.json', run: 70, set: {mode: 2, speed_order: 3}, camera: {body: 'ahts/hull', mode: 'aft'}},
    rig: {scene: 'exercises/anchor_handling.json', run: 6, camera: {body: 'rig/hull', at: [0, 0, 10], distance: 210, elevation: 0.16, azimuth: 0.7}},
    night: {scene: 'exercises/anchor_handling.json', run: 6, air: {light: 'night'}, camera: {body: 'ahts1/hull', at: [0, 0, 4], distance: 130, elevation: 0.14, azimuth: 0.6}},
    dusk: {scene: 'exercises/tow_gob.json', run: 20, set: {mode: 2, speed_order: 3}, air: {light: 'dusk'}, camera: {body: 'tug/hull', at: [-10, 0, 2], distance: 75, elevation: 0.14, azimuth: 2.4}},
    fog: {scene: 'exercises/tow_to_sea.json', run: 70, set: {mode: 2, speed_order: 3}, air: {visibility: 300}, camera: {body: 'ahts/hull', mode: 'bridge'}},
    splash: {scene: 'exercises/subsea_lift.json', run: 16, set: {hoist_mode: 0, hoist_speed: 0.35}, camera: {body: 'csv/hull', at: [-8, -14, 2], distance: 60, elevation: 0.12, azimuth: -1.2}},
    berth: {scene: 'exercises/berthing.json', run: 60, camera: {body: 'barge/hull', at: [0, -10, 2], distance: 190, elevation: 0.3, azimuth: -2.2}},
    spray: {scene: 'exercises/tow_gob.json', run: 30, set: {mode: 2, speed_order: 4, 'sea.waves': 1.8, 'sea.wind': 16}, drops: 500, camera: {body: 'tug/hull', at: [6, 0, 1], distance: 46, elevation: 0.13, azimuth: 0.85}},
    cab: {scene: 'exercises/crane_lift.json', run: 6, camera: {body: 'barge', mode: 'cab'}},
    heli: {scene: 'exercises/tow_to_sea.json', run: 70, set: {mode: 2, speed_order: 3}, camera: {body: 'ahts/hull', mode: 'heli'}},
    under: {scene: 'exercises/anchor_handling.json', run: 6, camera: {body: 'ahts1/hull', at: [-20, 0, -8], distance: 90, elevation: -0.14, azimuth: 2.6}},
};

/// Aim the camera and draw; return the counts of the frame.
async function draw(page, camera, air) {
    return page.evaluate(async ([c, a]) => {
        const {stage} = hawser, body = stage.bodies.bodies.find(b => b.name === c.body), q = body.quaternion;
        Object.assign(stage.show, {tubes: 'tubes', contacts: false, names: false});
        stage.quality.decide = () => {};
        stage.airOf(hawser.scene, a ?? {});
        stage.follow(body);
        if (c.mode) hawser.camera(c.mode);
        else {
            hawser.camera('free');
            stage.rig.target.set(...c.at).applyMatrix4(body.matrix);
            Object.assign(stage.rig, {distance: c.distance, elevation: c.elevation, azimuth: c.azimuth + Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))});
        }
        stage.shadowDue = 0;
        document.getElementById('toast').hidden = true;
        stage.draw(performance.now());
        return {...stage.counts, drops: stage.spray.count, time: hawser.frame.time};
    }, [camera, air]);
}

async function still(kit, name, {scene, run, set = {}, drops = 0, camera, air}) {
    const server = await kit.serve(scene, '--wait');
    const page = await kit.open(kit.browser, server.instructor, {query: `?quality=${process.env.HAWSER_QUALITY ?? 'high'}&clean`, viewport: {width: 320, height: 200}});
    await kit.still(page);
    await page.evaluate(inputs => {
        hawser.briefing.close();
        if (inputs.length) hawser.link.send({type: 'set', inputs});
        hawser.rate(10);
        hawser.play();
    }, Object.entries(set));
    await kit.until(page, t => hawser.frame.time >= t, run, 300000);
    if (drops) {
        await page.evaluate(() => hawser.rate(1));
        await kit.until(page, n => hawser.stage.spray.count >= n, drops, 180000);
    }
    await page.evaluate(() => hawser.play());
    await kit.until(page, () => hawser.state.paused);
    await page.setViewportSize(kSize);
    await kit.until(page, w => document.getElementById('canvas').clientWidth === w, kSize.width);
    await page.evaluate(() => { const {stage} = hawser; stage.draw = stage.drawn; });
    const counts = await draw(page, camera, air);
    await page.evaluate(() => { hawser.stage.draw = () => {}; });
    const path = join(kit.pictures, `trainer_${name}.png`);
    await palettePicture(page, path, kSize);
    await kit.quiet(page);
    await page.context().close();
    await server.end();
    assert.ok(counts.drops >= 0.3 * drops && counts.calls > 5 && counts.calls <= kCalls && counts.triangles <= kTriangles, JSON.stringify(counts));
    const thrown = drops ? `${counts.drops} drops, ` : '';
    return `${thrown}${counts.calls} draw calls, ${counts.triangles} triangles; ${counts.time.toFixed(0)} s; ${kit.size(path)} bytes`;
}

export async function stillsPart(kit) {
    console.log('--- stills: draw calls and triangles of a frame at the middle quality level (wanted: 300 and 600,000)');
    const wanted = process.env.HAWSER_STILLS?.split(',') ?? Object.keys(kStills);
    for (const name of wanted) await kit.check(`still ${name}`, () => still(kit, name, kStills[name]));
}
