// SPDX-License-Identifier: Apache-2.0
// What a trainee and an instructor do in the page acts on the world: scene harbour.json.
import assert from 'node:assert/strict';
import {join} from 'node:path';

/// The reddest of the pixels round points of a wire, (r − b)/(r + b), from the picture itself.
export const redness = (page, wire) => page.evaluate(async w => {
    const {stage} = hawser, {frame} = stage;
    stage.draw(performance.now());   // the camera is where it will be
    let first = 0;
    for (let i = 0; i < w; ++i) first += frame.counts[i];
    window.places ??= [];
    if (frame.counts[w] > 2 && !window.keepPlaces)
        window.places = [0.3, 0.4, 0.5, 0.6, 0.7].map(s => {
            const k = 3 * (first + Math.round(s * (frame.counts[w] - 1))), p = stage.camera.position.clone().fromArray(frame.wirePoints, k);
            return stage.project(p);
        }).filter(Boolean);
    stage.draw(performance.now());
    const bitmap = await createImageBitmap(await stage.screenshot()), c = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d', {willReadFrequently: true});
    c.drawImage(bitmap, 0, 0);
    const all = window.places.map(({x, y}) => {
        const d = c.getImageData(Math.round(x * stage.ratio) - 4, Math.round(y * stage.ratio) - 4, 9, 9).data;
        let most = -1;
        for (let i = 0; i < d.length; i += 4) most = Math.max(most, (d[i] - d[i + 2]) / (d[i] + d[i + 2] + 1));
        return most;
    });
    return all.sort((a, b) => a - b)[Math.floor(all.length / 2)];
}, wire);

const input = (page, name) => page.evaluate(n => hawser.frame.inputs[hawser.scene.inputs.findIndex(i => i.name === n)], name);
/// Press a tool of the header; on narrow pages it is in the menu.
async function tool(page, selector) {
    if (await page.locator('#menu').isVisible()) await page.locator('#menu').click();
    await page.locator(selector).click();
}
const slider = (page, name) => page.locator(`input[data-input="${name}"]`);

async function levers(kit, page) {
    const {check, until} = kit, all = await page.evaluate(() => hawser.levers.levers.map(l => ({name: l.def.name, spring: l.def.spring, range: l.range})));
    assert.ok(all.length >= 3);
    for (const lever of all)
        await check(`lever ${lever.name}: keys move it, ${lever.spring === null ? 'it stays' : 'it springs home'}`, async () => {
            const s = slider(page, lever.name);
            await s.focus();
            await page.keyboard.down('PageUp');
            const at = await until(page, n => {
                const v = hawser.frame.inputs[hawser.scene.inputs.findIndex(i => i.name === n)];
                return v > 0 && {v, text: document.activeElement.getAttribute('aria-valuetext')};
            }, lever.name);
            await page.keyboard.up('PageUp');
            assert.ok(at.v > 0.2 * lever.range[1], `${at.v}`);
            if (lever.spring !== null) await until(page, n => hawser.frame.inputs[hawser.scene.inputs.findIndex(i => i.name === n)] === 0, lever.name);
            else {
                await page.waitForTimeout(600);
                assert.equal(await input(page, lever.name), at.v);
                await page.keyboard.press('0');
                await until(page, n => hawser.frame.inputs[hawser.scene.inputs.findIndex(i => i.name === n)] === 0, lever.name);
            }
            return `to ${at.text}`;
        });
}

async function running(kit, page) {
    const {check, until} = kit;
    await check('space pauses: time stands', async () => {
        await page.locator('#canvas').focus();
        await page.keyboard.press(' ');
        await until(page, () => hawser.state.paused && (hawser.frame.flags & 1));
        const t = await page.evaluate(() => hawser.frame.time);
        await page.waitForTimeout(500);
        assert.equal(await page.evaluate(() => hawser.frame.time), t);
    });
    await check('the button takes one step', async () => {
        const n = await page.evaluate(() => hawser.frame.steps);
        await page.locator('#step').click();
        await until(page, m => hawser.frame.steps === m + 1, n);
    });
    await check('the rate: at ×2 simulated time runs about twice as fast as the clock', async () => {
        await page.locator('#play').click();
        await page.locator('#rate').evaluate(e => { e.value = Math.log10(2); e.dispatchEvent(new Event('input', {bubbles: true})); });
        await until(page, () => Math.abs(hawser.state.rate - 2) < 1e-6);
        const ratio = await page.evaluate(async () => {
            const at = () => [hawser.frame.time, hawser.frame.clock], a = at();
            await new Promise(done => setTimeout(done, 2500));
            const b = at();
            return (b[0] - a[0]) / (b[1] - a[1]);
        });
        await page.evaluate(() => hawser.rate(1));
        await until(page, () => hawser.state.rate === 1);
        assert.ok(ratio > 1.8 && ratio < 2.2, `${ratio}`);
        return `×${ratio.toFixed(3)}`;
    });
}

const placeOf = (page, name) => page.evaluate(n => {
    const b = hawser.stage.bodies.bodies.find(x => x.name === n), r = document.getElementById('canvas').getBoundingClientRect();
    hawser.stage.draw(performance.now());
    const p = hawser.stage.project(b.position.clone());
    return p && {x: p.x + r.left, y: p.y + r.top};
}, name);

const lookAt = (page, name, distance, elevation = 0.5, azimuth = -1.4) => page.evaluate(([n, d, e, a]) => {
    const b = hawser.stage.bodies.bodies.find(x => x.name === n);
    hawser.camera('free');
    Object.assign(hawser.stage.rig, {distance: d, elevation: e, azimuth: a});
    hawser.stage.rig.target.copy(b.position);
}, [name, distance, elevation, azimuth]);

async function picking(kit, page) {
    const {check, until} = kit;
    await check('a click on the crate shows its numbers and offers plots', async () => {
        await lookAt(page, 'crate', 30);
        const p = await placeOf(page, 'crate');
        await page.mouse.click(p.x, p.y);
        await until(page, () => document.querySelectorAll('#picked dd').length > 3);
        const text = await page.locator('#picked').innerText();
        await page.getByRole('button', {name: 'Plot: height'}).click();
        await until(page, () => document.querySelectorAll('.plot canvas').length > 0);
        return text.split('\n').slice(0, 6).join(' ');
    });
    await check('a click on the wire shows its numbers and plots its tension', async () => {
        const p = await page.evaluate(() => {
            const {stage} = hawser, f = stage.frame, k = 3 * Math.floor(f.points / 2);
            stage.rig.target.fromArray(f.wirePoints, k);
            Object.assign(stage.rig, {distance: 40, elevation: 0.4, azimuth: -1.5});
            stage.draw(performance.now());
            const at = stage.project(stage.camera.position.clone().fromArray(f.wirePoints, k)), r = stage.canvas.getBoundingClientRect();
            return {x: at.x + r.left, y: at.y + r.top};
        });
        await page.mouse.click(p.x, p.y);
        await page.getByRole('button', {name: 'Plot: Tension'}).click();
        await until(page, () => [...document.querySelectorAll('.plot')].some(e => /Tension: Tow/.test(e.getAttribute('aria-label'))));
        return (await page.locator('#picked').innerText()).replaceAll('\n', ' ').slice(0, 100);
    });
    await page.keyboard.press('g');
}

async function dragging(kit, page) {
    await kit.check('a drag pulls the crate with a spring until it is let go', async () => {
        await lookAt(page, 'crate', 30, 0.9);
        const at = () => page.evaluate(() => hawser.stage.bodies.bodies.find(b => b.name === 'crate').position.toArray());
        await page.locator('#canvas').focus();
        await page.keyboard.press('p');
        assert.equal(await page.locator('#pull').getAttribute('aria-pressed'), 'true');
        const before = await at(), p = await placeOf(page, 'crate');
        await page.mouse.move(p.x, p.y);
        await page.mouse.down();
        await page.mouse.move(p.x + 60, p.y - 150, {steps: 6});   // the spring pulls k d: beyond friction
        try {
            await kit.until(page, () => (hawser.frame.flags & 8) !== 0 && hawser.stage.spring.visible);
            await kit.until(page, b => {
                const c = hawser.stage.bodies.bodies.find(x => x.name === 'crate').position;
                return Math.hypot(c.x - b[0], c.y - b[1], c.z - b[2]) > 0.5;
            }, before);
        } finally {
            await page.mouse.up();
        }
        await kit.until(page, () => (hawser.frame.flags & 8) === 0);
        await page.keyboard.press('Escape');
        const after = await at();
        return `moved ${Math.hypot(...after.map((v, i) => v - before[i])).toFixed(2)} m`;
    });
}

async function pad(kit, page) {
    const {check, until} = kit;
    await page.evaluate(() => {
        window.fakePads = [{id: 'Stub', index: 0, connected: true, axes: [0, 0, 0, 0], buttons: Array.from({length: 16}, () => ({pressed: false}))}];
    });
    const tilt = (axis, v) => page.evaluate(([a, x]) => { window.fakePads[0].axes[a] = x; }, [axis, v]);
    await check('a gamepad: nothing within the dead zone, the whole lever at the end, home when let go', async () => {
        await tilt(0, 0.1);
        await page.waitForTimeout(700);
        assert.equal(await input(page, 'winch_speed'), 0);
        await tilt(0, 1);
        await until(page, () => hawser.frame.inputs[0] === 1);
        await tilt(0, 0);
        await until(page, () => hawser.frame.inputs[0] === 0);
    });
    await check('a button of the gamepad pauses', async () => {
        const press = down => page.evaluate(d => { window.fakePads[0].buttons[0] = {pressed: d}; }, down);
        for (const paused of [true, false]) {
            await press(true);
            await until(page, p => hawser.state.paused === p, paused);
            await press(false);
            await until(page, () => !hawser.pads.before.get(0).pressed[0]);   // seen by the page
        }
    });
    await page.evaluate(() => { window.fakePads = []; });
}

async function wire(kit, page) {
    const {check, until} = kit;
    let cold;
    await page.evaluate(() => {
        hawser.camera('free');
        const f = hawser.frame, k = 3 * Math.floor(f.points / 2);
        hawser.stage.rig.target.fromArray(f.wirePoints, k);
        Object.assign(hawser.stage.rig, {distance: 34, elevation: 0.35, azimuth: -1.5});
        hawser.stage.show.contacts = hawser.stage.show.names = false;
        hawser.stage.choose(null);
        hawser.stage.full = 0.25;
    });
    await check('a restore point goes back in time', async () => {
        await tool(page, '[data-panel="restore"]');
        await page.locator('#save-name').fill('slack wire');
        await page.locator('#save').click();
        const t = await until(page, () => hawser.state.restore_points.find(p => p.name === 'slack wire')?.time);
        await page.waitForTimeout(1000);
        await page.evaluate(() => document.activeElement.blur());
        await page.evaluate(() => hawser.play());
        await until(page, () => hawser.state.paused && (hawser.frame.flags & 1));
        const later = await page.evaluate(() => hawser.frame.time);
        assert.ok(later > t + 0.5, `${t} to ${later}`);
        await page.getByRole('button', {name: /slack wire/}).click();
        await until(page, a => Math.abs(hawser.frame.time - a) < 0.02, t);
        await page.evaluate(() => hawser.state.paused && hawser.play());
        await until(page, () => !hawser.state.paused);
        await tool(page, '[data-panel="restore"]');
        return `from ${later.toFixed(2)} s to ${t.toFixed(2)} s`;
    });
    await check('hauling makes the wire redder', async () => {
        await page.waitForTimeout(500);
        cold = await redness(page, 0);
        await slider(page, 'winch_speed').focus();
        const haul = 'PageDown';   // the wire gets shorter
        await page.keyboard.down(haul);
        const most = await until(page, () => {
            const i = hawser.scene.outputs.findIndex(o => o.name === 'tow_tension');
            return hawser.frame.outputs[i] > 40e3 && hawser.frame.outputs[i];
        }, null, 40000);
        await page.evaluate(() => hawser.play());
        await until(page, () => hawser.state.paused);
        await page.keyboard.up(haul);
        await page.waitForTimeout(300);
        const hot = await redness(page, 0);
        await page.screenshot({path: join(kit.out, 'hauled.png')});
        assert.ok(hot > cold + 0.4, `${cold} to ${hot}`);
        return `(r − b)/(r + b) from ${cold.toFixed(2)} to ${hot.toFixed(2)} at ${(most / 1000).toFixed(0)} kN`;
    });
    await check('a parted wire is gone from where it was', async () => {
        const hot = await redness(page, 0);
        await page.evaluate(() => { window.keepPlaces = true; });
        await page.evaluate(() => hawser.part({wire: 0, share: 0.5}));
        await page.evaluate(() => hawser.play());
        await until(page, () => hawser.frame.tensions.some(t => t < 0) || hawser.frame.counts.length > 1);
        await page.waitForTimeout(2500);
        const gone = await redness(page, 0);
        await page.evaluate(() => { window.keepPlaces = false; });
        await page.screenshot({path: join(kit.out, 'parted.png')});
        assert.ok(gone < hot - 0.4, `${hot} to ${gone}`);
        const events = await page.locator('#events').innerText();
        assert.match(events, /part|break/i);
        return `${hot.toFixed(2)} to ${gone.toFixed(2)}; told: ${events.split('\n')[0]}`;
    });
    await check('a restore brings the wire back', async () => {
        await page.evaluate(() => hawser.restore('slack wire'));
        await until(page, () => hawser.frame.counts.length === 1 && hawser.frame.tensions.every(t => t >= 0));
    });
}

async function rest(kit, page) {
    const {check, until} = kit;
    await check('a lost connection comes back by itself', async () => {
        await page.evaluate(() => hawser.link.socket.close());
        await until(page, () => hawser.link.tries > 0);
        await until(page, () => hawser.link.isOpen && hawser.link.frame && document.getElementById('lost').hidden);
    });
    await check('a failed step is shown with time, element, remedy and the last restore point (message stubbed)', async () => {
        await page.evaluate(() => hawser.link.tell('failure', {time: 3.5, status: 'diverged', element: 'tow/s3', reason: 'stretched by 40 %', remedy: 'a smaller step', restore_point: 'slack wire'}));
        const box = page.getByRole('alertdialog');
        await box.waitFor();
        assert.match(await box.innerText(), /0:03\.5[\s\S]*tow\/s3[\s\S]*a smaller step[\s\S]*Restore “slack wire”/);
        assert.equal(await page.evaluate(() => document.activeElement.id), 'failure-restore');
        const t = await page.evaluate(() => hawser.frame.time);
        await page.keyboard.press('Enter');
        await until(page, was => hawser.frame.time < was, t + 1);
    });
    await page.evaluate(() => hawser.state.paused && hawser.play());
    await check('every control has a name and can be reached by Tab', async () => {
        const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, select')].filter(e => {
            const label = e.labels?.[0]?.textContent || e.getAttribute('aria-label') || e.textContent;
            return !label.trim();
        }).map(e => e.id || e.outerHTML.slice(0, 80)));
        assert.deepEqual(nameless, []);
        const seen = new Set();
        await page.evaluate(() => hawser.menu(true));
        await page.evaluate(() => document.body.focus());
        for (let i = 0; i < 40; ++i) {
            await page.keyboard.press('Tab');
            seen.add(await page.evaluate(() => document.activeElement.id || document.activeElement.textContent));
        }
        await page.evaluate(() => hawser.menu(false));
        for (const id of ['play', 'step', 'rate', 'subject', 'shot', 'canvas', 'lever-0']) assert.ok(seen.has(id), `${id} is not among ${[...seen].join()}`);
    });
    await check('a screenshot is a PNG of the picture', async () => {
        const [download] = await Promise.all([page.waitForEvent('download'), tool(page, '#shot')]);
        assert.match(download.suggestedFilename(), /^harbour_[\d.]+s\.png$/);
        await download.saveAs(join(kit.out, 'shot.png'));
        return `${kit.size(join(kit.out, 'shot.png'))} bytes`;
    });
}

async function touching(kit, address) {
    const page = await kit.open(kit.browser, address, {viewport: {width: 820, height: 600}, hasTouch: true, isMobile: true});
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) => session.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
    await kit.check('touch: a tap pauses and goes on', async () => {
        for (const paused of [true, false]) {
            await page.locator('#play').tap();
            await kit.until(page, p => hawser.state.paused === p, paused);
        }
    });
    await kit.check('touch: a finger moves a lever, which springs home when it lifts', async () => {
        const box = await slider(page, 'winch_speed').boundingBox(), y = box.y + box.height / 2;
        await touch('touchStart', [box.x + box.width / 2, y]);
        for (let i = 1; i <= 6; ++i) await touch('touchMove', [box.x + box.width * (0.5 + 0.05 * i), y]);
        const v = await kit.until(page, () => hawser.frame.inputs[0] > 0.3 && hawser.frame.inputs[0]);
        await touch('touchEnd');
        await kit.until(page, () => hawser.frame.inputs[0] === 0);
        return `to ${v.toFixed(2)} m/s`;
    });
    await kit.check('touch: one finger turns the picture, two come nearer', async () => {
        const before = await page.evaluate(() => ({a: hawser.stage.rig.azimuth, d: hawser.stage.rig.distance})), x = 560, y = 300;
        await touch('touchStart', [x, y]);
        for (let i = 1; i <= 5; ++i) await touch('touchMove', [x + 12 * i, y]);
        await touch('touchEnd');
        await touch('touchStart', [x - 40, y], [x + 40, y]);
        for (let i = 1; i <= 5; ++i) await touch('touchMove', [x - 40 - 8 * i, y], [x + 40 + 8 * i, y]);
        await touch('touchEnd');
        const after = await page.evaluate(() => ({a: hawser.stage.rig.azimuth, d: hawser.stage.rig.distance}));
        assert.ok(Math.abs(after.a - before.a) > 0.1, JSON.stringify([before, after]));
        assert.ok(after.d < 0.8 * before.d, JSON.stringify([before, after]));
        return `distance ${before.d.toFixed(0)} m to ${after.d.toFixed(0)} m`;
    });
    await kit.quiet(page);
    await page.context().close();
}

async function watching(kit, address) {
    const page = await kit.open(kit.browser, address);
    await kit.check('a watcher has no levers, no pull and no pause', async () => {
        assert.equal(await page.locator('#levers').isVisible(), false);
        assert.equal(await page.locator('#pull').isVisible(), false);
        assert.equal(await page.locator('#play').isDisabled(), true);
    });
    await page.context().close();
}

export async function actPart(kit) {
    console.log('--- acting: apps/view/page/test/harbour.json');
    const server = await kit.serve('apps/view/page/test/harbour.json', '--record', join(kit.out, 'act.hwr'));
    const page = await kit.open(kit.browser, server.instructor, {viewport: {width: 1024, height: 576}});   // narrower pages have no button for a step
    await levers(kit, page);
    await running(kit, page);
    await picking(kit, page);
    await dragging(kit, page);
    await pad(kit, page);
    await wire(kit, page);
    await rest(kit, page);
    await kit.quiet(page);
    await page.context().close();
    await touching(kit, server.instructor);
    await watching(kit, server.watcher);
    await kit.check('the program ends in order', async () => assert.equal(await server.end(), 0));
}
