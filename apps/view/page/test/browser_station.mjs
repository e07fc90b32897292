// SPDX-License-Identifier: Apache-2.0
// Stations of exercises/tow_to_sea.json: all instruments in view, and some minutes sailed with events
// of keyboard and gamepad alone. One page at a time: three would starve each other without a
// graphics card.
import assert from 'node:assert/strict';
import {join} from 'node:path';

/// What a bridge and a winch station show (words of the cards, by label).
const kShown = {
    Ship: [/Heading\s*\d{3}°/, /SOG\s*[\d.]+ kn/, /ROT/, /Wind\s*[\d.]+ kn \d{3}°/],
    Propulsion: [/Port\s*−?[\d.]+ t/, /Bow 1\s*[\d.]+ t/, /Azimuth\s*−?[\d.]+ t\s*\d{3}°/, /Rudder P\s*[\d.]+°/],
    'DP desk': [/Levers|Autopilot|DP/, /Set heading|Off position/],
    Winch: [/Tension\s*[\d.]+ t \(\d+ %\)/, /Wire out\s*[\d.]+ m/, /WLL/, /MBL/],
    'Stability gauge': [/Permissible\s*[\d.]+ t/, /Limited by/, /Heel/],
};

/// Check that each card is in the window, covered by nothing, and has its words.
async function instrumentsInView(kit, page) {
    await kit.until(page, () => /SOG\s*[\d.]+ kn/.test(document.getElementById('instruments').innerText));
    const seen = await page.evaluate(() => [...document.querySelectorAll('#instruments .instrument')].filter(e => e.offsetParent).map(e => {
        const r = e.getBoundingClientRect(), free = [0.1, 0.5, 0.9].every(f => e.contains(document.elementFromPoint(r.left + f * r.width, r.top + f * r.height)));
        return {label: e.getAttribute('aria-label'), text: e.innerText, inside: r.left >= 0 && r.top >= 0 && r.right <= innerWidth && r.bottom <= innerHeight, free, narrow: e.scrollWidth > e.clientWidth + 1};
    }));
    for (const [label, words] of Object.entries(kShown)) {
        const card = seen.find(c => c.label.startsWith(label));
        assert.ok(card, `no card ${label} among ${seen.map(c => c.label)}`);
        assert.ok(card.inside && card.free && !card.narrow, `${label}: ${JSON.stringify(card)}`);
        for (const w of words) assert.match(card.text, w);
    }
    const drawn = await page.evaluate(() => [...document.querySelectorAll('#instruments .plan .hub, #instruments .rudder, #instruments .footprint .ship, #instruments .gauge .needle')].length);
    assert.equal(drawn, 6 + 2 + 1 + 1);
    return `${seen.length} cards`;
}

const output = (page, name) => page.evaluate(n => hawser.frame.outputs[hawser.scene.outputs.findIndex(o => o.name === n)], name);
/// Select a control by the key ].
async function select(page, name) {
    await page.locator('#canvas').focus();
    for (let i = 0; i < 40 && !await page.evaluate(n => hawser.levers.levers[hawser.levers.active].def.name === n, name); ++i) await page.keyboard.press(']');
}
const press = async (page, key, times) => { for (let i = 0; i < times; ++i) await page.keyboard.press(key); };

async function sailBridge(kit, address) {
    const page = await kit.open(kit.browser, address, {viewport: {width: 1180, height: 820}, query: '?quality=low'}), {check, until} = kit;
    await kit.still(page);
    await check('bridge at 1180×820: thrusters, azimuth, rudders, heading, speed, DP, wire, stability in view', () => instrumentsInView(kit, page));
    await check('bridge: bow thruster by gamepad, autopilot and speed by keyboard', async () => {
        // In levers: the autopilot orders the thrusters itself.
        await page.evaluate(() => { window.fakePads = [{id: 'Stub', index: 0, connected: true, axes: [0, 0, 0, 0], buttons: Array.from({length: 16}, () => ({pressed: false}))}]; });
        const axis = await page.evaluate(() => hawser.pads.mapping.axes.findIndex(a => a.lever === 'bow_thruster'));
        assert.ok(axis >= 0, 'the thruster has an axis');
        await page.evaluate(a => { window.fakePads[0].axes[a] = 1; }, axis);
        await until(page, () => Math.abs(hawser.frame.inputs[3]) > 0.9);
        await page.evaluate(a => { window.fakePads[0].axes[a] = 0; }, axis);
        await until(page, () => hawser.frame.inputs[3] === 0);
        await select(page, 'mode');
        await press(page, 'ArrowUp', 2);                        // mode: levers, joystick, autopilot
        await until(page, () => hawser.frame.inputs[0] === 2);
        await page.keyboard.press(']');
        await press(page, 'ArrowUp', 9);                        // 9 of 20 steps to 4 m/s
        await until(page, () => Math.abs(hawser.frame.inputs[1] - 1.8) < 1e-3);
    });
    await check('bridge: the ship makes way on her heading; propellers and speed are shown', async () => {
        const t0 = await page.evaluate(() => hawser.frame.time);
        await until(page, t => hawser.frame.time > t + 60, t0, 240000);
        assert.ok(await output(page, 'ahts/ship.ground_speed') > 0.8);
        const words = await page.locator('#instruments').innerText();
        assert.match(words, /Autopilot/);
        assert.match(words, /Set speed\s*3\.5 kn|Set speed\s*3\.50 kn/);
        const [heading] = words.match(/\d{3}°/);
        assert.ok(Math.abs(Number(heading.slice(0, 3)) - 90) < 15, heading);
        assert.ok(await page.evaluate(() => [...document.querySelectorAll('.plan .thrust')].filter(e => e.getAttribute('d')).length) >= 2);
        await kit.still(page, false);
        await page.screenshot({path: join(kit.pictures, 'view_station_bridge.png')});
        return `${(await output(page, 'ahts/ship.ground_speed')).toFixed(2)} m/s, heading ${heading}`;
    });
    await kit.quiet(page);
    await page.context().close();
}

async function sailWinch(kit, address) {
    const page = await kit.open(kit.browser, address, {viewport: {width: 1180, height: 820}, query: '?quality=low'}), {check, until} = kit;
    await kit.still(page);
    await check('winch at 1180×820: the same instruments in view, the winch first', async () => {
        await instrumentsInView(kit, page);
        assert.match(await page.locator('#instruments .instrument').first().getAttribute('aria-label'), /^Winch/);
    });
    await check('winch: brake off by keyboard, wire veered by gamepad, brake on again', async () => {
        const before = await output(page, 'tow_winch.wire_out');
        await page.evaluate(() => { window.fakePads = [{id: 'Stub', index: 0, connected: true, axes: [0, 0, 0, 0], buttons: Array.from({length: 16}, () => ({pressed: false}))}]; });
        const axis = await page.evaluate(() => hawser.pads.mapping.axes.findIndex(a => a.lever === 'winch_speed'));
        const [sign] = await page.evaluate(a => [hawser.pads.mapping.axes[a].invert ? -1 : 1], axis);
        await select(page, 'winch_mode');
        await press(page, 'ArrowDown', 3);                      // brake, render, tension, haul and veer
        await until(page, () => hawser.frame.inputs[4] === 0);
        await page.evaluate(([a, s]) => { window.fakePads[0].axes[a] = 0.7 * s; }, [axis, sign]);   // selects the speed
        await until(page, w => hawser.frame.outputs[hawser.scene.outputs.findIndex(o => o.name === 'tow_winch.wire_out')] > w + 5, before, 60000);
        await page.evaluate(a => { window.fakePads[0].axes[a] = 0; }, axis);
        await until(page, () => hawser.frame.inputs[5] === 0);   // the spring
        await select(page, 'winch_mode');
        await press(page, 'ArrowUp', 3);
        await until(page, () => hawser.frame.inputs[4] === 3);
        await until(page, () => /Mode\s*Brake/.test(document.getElementById('instruments').innerText));
        await kit.still(page, false);
        await page.screenshot({path: join(kit.pictures, 'view_station_winch.png')});
        return `${before.toFixed(0)} to ${(await output(page, 'tow_winch.wire_out')).toFixed(0)} m at ${(await page.evaluate(() => hawser.frame.time)).toFixed(0)} s`;
    });
    await check('winch: emergency release needs two presses', async () => {
        const release = page.locator('button[data-input="winch_mode"].guarded');
        await release.focus();
        await page.keyboard.press('Enter');
        await until(page, () => /Press again/.test(document.querySelector('.guarded').textContent));
        assert.equal(await page.evaluate(() => hawser.frame.inputs[4]), 3);
        await press(page, 'ArrowUp', 1);
    });
    await page.setViewportSize({width: 1600, height: 1000});
    await check('winch at 1600×1000', async () => {
        await kit.until(page, () => document.getElementById('canvas').clientWidth === 1600);
        await instrumentsInView(kit, page);
        await kit.still(page, false);
        await page.screenshot({path: join(kit.pictures, 'view_station_winch_wide.png')});
    });
    await kit.quiet(page);
    await page.context().close();
}

export async function stationPart(kit) {
    console.log('--- stations: exercises/tow_to_sea.json, keyboard and gamepad alone');
    const server = await kit.serve('exercises/tow_to_sea.json', '--wait');
    await kit.check('the instructor starts and sets the rate by keys', async () => {
        const page = await kit.open(kit.browser, server.instructor, {viewport: {width: 320, height: 240}, query: '?quality=low'});
        await page.locator('#briefing').waitFor();
        await page.keyboard.press('Enter');
        await kit.until(page, () => hawser.frame.time > 0);
        await page.locator('#rate').focus();
        await page.keyboard.press('End');                       // as fast as the machine, up to ×10
        await kit.until(page, () => hawser.state.rate === 10);
        await page.context().close();
    });
    await sailBridge(kit, server.bridge);
    await sailWinch(kit, server.winch);
    await kit.check('the program ends in order', async () => assert.equal(await server.end(), 0));
}
