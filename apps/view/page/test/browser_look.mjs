// SPDX-License-Identifier: Apache-2.0
// Pictures of each camera for docs/, and how fast pictures are drawn: scenes/anchor_contact.json.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const kSize = {width: 1240, height: 698}, kScale = 0.7, kMost = 300 * 1000;

/// Pictures are taken of a paused world, so that the processors have time to draw.
async function pictures(kit, address) {
    const page = await kit.open(kit.browser, address, {query: '?quality=high', viewport: kSize, deviceScaleFactor: kScale});
    await page.evaluate(() => { hawser.stage.show.tubes = 'tubes'; });
    await page.waitForTimeout(1500);
    await page.evaluate(() => hawser.play());
    await kit.until(page, () => hawser.state.paused);
    const take = async (name, f, argument) => kit.check(`picture view_${name}.png`, async () => {
        await page.evaluate(f, argument);
        await page.evaluate(async () => {   // three pictures on, so that light, names and plots are there
            document.getElementById('toast').hidden = true;
            for (let i = 0; i < 3; ++i) await new Promise(done => requestAnimationFrame(done));
        });
        await page.waitForTimeout(400);
        const path = join(kit.pictures, `view_${name}.png`);
        await page.screenshot({path});
        const size = kit.size(path), colours = await page.evaluate(async () => {
            const bitmap = await createImageBitmap(await hawser.stage.screenshot()), c = new OffscreenCanvas(64, 36).getContext('2d');
            c.drawImage(bitmap, 0, 0, 64, 36);
            const d = c.getImageData(0, 0, 64, 36).data, seen = new Set();
            for (let i = 0; i < d.length; i += 4) seen.add(d[i] >> 4 << 8 | d[i + 1] >> 4 << 4 | d[i + 2] >> 4);
            return seen.size;
        });
        assert.ok(colours > 20, `only ${colours} colours: nothing was drawn`);
        assert.ok(size <= kMost, `${size} bytes`);
        return `${size} bytes`;
    });
    for (const mode of ['follow', 'bridge', 'aft', 'board', 'hook', 'top'])
        await take(mode, m => hawser.camera(m), mode);
    await take('free', () => {
        hawser.camera('free');
        hawser.stage.rig.target.set(-120, 0, -30);
        Object.assign(hawser.stage.rig, {distance: 620, elevation: 0.2, azimuth: -2.05});
    });
    await take('under_water', () => {
        const b = hawser.stage.bodies.bodies.find(x => x.name === 'ahts1/hull');
        hawser.stage.rig.target.copy(b.position);
        Object.assign(hawser.stage.rig, {distance: 150, elevation: -0.25, azimuth: 2.6});
    });
    await take('plots', () => {
        hawser.camera('follow');
        hawser.panel('plots');
        const wire = hawser.scene.wires.findIndex(w => w.name === 'tow1');
        hawser.stage.choose({wire, share: 0.5});
        hawser.inspector.show({wire, share: 0.5});
        document.getElementById('canvas').focus();
    });
    await kit.quiet(page);
    await page.context().close();
}

/// Processor time of a browser's processes of one type [s]; each has its type in its command line.
function cpu(browser) {
    try {
        return browser.map(pid => {
            const s = readFileSync(`/proc/${pid}/stat`, 'utf8'), f = s.slice(s.lastIndexOf(')') + 2).split(' ');
            return (Number(f[11]) + Number(f[12])) / 100;
        }).reduce((a, b) => a + b, 0);
    } catch {
        return NaN;
    }
}

async function rates(kit, address) {
    const page = await kit.open(kit.browser, address);
    const session = await page.context().newCDPSession(page), whole = await kit.browser.newBrowserCDPSession();
    const gpu = (await whole.send('SystemInfo.getProcessInfo')).processInfo.filter(p => p.type === 'GPU').map(p => p.id);
    await session.send('Performance.enable', {timeDomain: 'threadTicks'});
    const script = async () => Object.fromEntries((await session.send('Performance.getMetrics')).metrics.map(m => [m.name, m.value])).ScriptDuration;
    const wanted = {lines: 25, tubes: 8};
    for (const how of ['lines', 'tubes'])
        await kit.check(`pictures/s at 640×360 with ${how} (wanted: ${wanted[how]}; script ≤ 4 ms)`, async () => {
            await page.evaluate(h => { hawser.stage.show.tubes = h; }, how);
            await page.waitForTimeout(1500);
            const count = () => page.evaluate(() => [performance.now(), hawser.script.n, hawser.link.frames]);
            const three = [];
            for (let k = 0; k < 3; ++k) {
                const a = await count(), s0 = await script(), g0 = cpu(gpu);
                await page.waitForTimeout(4000);
                const b = await count(), n = b[1] - a[1];
                assert.ok(n > 2, `${n} pictures in 4 s`);
                three.push([1000 * n / (b[0] - a[0]), (await script() - s0) * 1000 / n, (cpu(gpu) - g0) * 1000 / n, 1000 * (b[2] - a[2]) / (b[0] - a[0])]);
            }
            const median = i => three.map(t => t[i]).sort((x, y) => x - y)[1];
            return `${median(0).toFixed(1)} pictures/s (${three.map(t => t[0].toFixed(1)).join(', ')}); of a picture ${median(1).toFixed(2)} ms script, ` +
                `${median(2).toFixed(1)} ms of a processor for drawing; ${median(3).toFixed(1)} frames/s arrived; load ${kit.load()}`;
        });
    await page.context().close();
}

export async function lookPart(kit) {
    console.log('--- looking: scenes/anchor_contact.json');
    const server = await kit.serve('scenes/anchor_contact.json');
    await rates(kit, server.instructor);
    await pictures(kit, server.instructor);
    await server.end();
}
