// SPDX-License-Identifier: Apache-2.0
// A recording in the page: scrubbing, events on the line, poses as recorded.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {join} from 'node:path';

/// Show 5 of the page: a minute of the largest scene, each seek timed until its frame has been drawn.
async function longRecording(kit) {
    const {check, until} = kit, file = join(kit.out, 'minute.hwr');
    console.log('--- a recording: scenes/anchor_contact.json, 60 s');
    execFileSync(kit.hawser, ['run', 'scenes/anchor_contact.json', '--duration', '60', '--record', file, '--record-every', '2', '--quiet'], {cwd: kit.root, stdio: 'ignore'});
    const server = await kit.serve(file), page = await kit.open(kit.browser, server.instructor);
    await check('60 s of anchor_contact: a seek is drawn (wanted: within 100 ms)', async () => {
        await page.evaluate(() => hawser.state.paused || hawser.play());
        await until(page, () => hawser.state.paused);
        await page.waitForTimeout(500);
        const took = [];
        for (const t of [50, 10, 59, 0.5, 30, 45])
            took.push(await page.evaluate(async time => {
                const begin = performance.now(), s = document.getElementById('scrub');
                s.value = time;
                s.dispatchEvent(new Event('input'));
                while (Math.abs(hawser.frame.time - time) > 0.034) {   // frames are 1/30 s apart
                    if (performance.now() - begin > 10000) throw new Error(`at ${hawser.frame.time} for ${time}`);
                    await new Promise(done => setTimeout(done, 1));
                }
                return performance.now() - begin;
            }, t));
        return `the first after ${took[0].toFixed(0)} ms, then ${took.slice(1).map(v => v.toFixed(0)).join(', ')} ms; load ${kit.load()}`;
    });
    await kit.quiet(page);
    await page.context().close();
    await server.end();
}

export async function recordPart(kit) {
    const {check, until} = kit, file = join(kit.out, 'part.hwr');
    console.log('--- a recording: scenes/wire_part.json, 9 s');
    execFileSync(kit.hawser, ['run', 'scenes/wire_part.json', '--record', file, '--record-every', '4', '--quiet'], {cwd: kit.root, stdio: 'ignore'});
    const server = await kit.serve(file), page = await kit.open(kit.browser, server.instructor);
    await check('it has a time line with its events', async () => {
        await until(page, () => document.querySelectorAll('#marks i').length > 0);
        assert.equal(await page.locator('#track').isVisible(), true);
        return `${await page.locator('#marks i').count()} marks`;
    });
    await check('scrubbing shows the frame at or before the time', async () => {
        await page.evaluate(() => hawser.state.paused || hawser.play());
        await until(page, () => hawser.state.paused);
        const took = [];
        for (const t of [7.5, 1.25, 4.0, 8.9, 0.1]) {
            took.push(await page.evaluate(async time => {
                const begin = performance.now(), s = document.getElementById('scrub');
                s.value = time;
                s.dispatchEvent(new Event('input'));
                while (Math.abs(hawser.link.frame.time - time) > 0.02) {
                    if (performance.now() - begin > 10000) throw new Error(`at ${hawser.link.frame.time} for ${time}`);
                    await new Promise(done => setTimeout(done, 1));
                }
                return performance.now() - begin;
            }, t));
        }
        return `there within ${took.map(v => v.toFixed(0)).join(', ')} ms`;
    });
    await check('the wire is whole before it parts and parted behind', async () => {
        const at = async t => {
            await page.evaluate(time => hawser.timeline.want(time), t);
            await until(page, time => Math.abs(hawser.frame.time - time) < 0.02, t);
            return page.evaluate(() => hawser.frame.tensions.some(v => v < 0) || hawser.frame.counts.length > 1);
        };
        assert.deepEqual([await at(0.5), await at(8.8)], [false, true]);
    });
    await check('an arrow key goes to the next event', async () => {
        await page.evaluate(time => hawser.timeline.want(time), 0.1);
        await until(page, () => hawser.frame.time < 0.2);
        await page.locator('#canvas').focus();
        await page.keyboard.press('ArrowRight');
        const t = await until(page, () => hawser.frame.time > 0.3 && hawser.frame.time);
        return `at ${t.toFixed(2)} s`;
    });
    await check('it plays', async () => {
        const t = await page.evaluate(() => hawser.frame.time);
        await page.locator('#play').click();
        await until(page, was => hawser.frame.time !== was, t);
    });
    await kit.quiet(page);
    await page.context().close();
    await server.end();
    await longRecording(kit);
}
