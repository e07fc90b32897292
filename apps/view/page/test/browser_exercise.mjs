// SPDX-License-Identifier: Apache-2.0
// An exercise in the page: instructor, station and watcher beside each other.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

/// Print the debriefing to PDF; return its size.
async function printed(kit, page) {
    await page.locator('#over-debrief').click();
    await page.getByLabel('Names for the report').fill('A. Mate, B. Winchman');
    await page.evaluate(() => { window.print = () => { window.printed = true; }; });
    await page.locator('#print').click();
    await kit.until(page, () => window.printed);
    await page.emulateMedia({media: 'print'});
    const text = await page.locator('#sheet').innerText();
    assert.match(text, /A\. Mate, B\. Winchman, \d{4}-\d\d-\d\d \d\d:\d\d/);
    assert.match(text, /points, 10 needed[\s\S]*Tow taut[\s\S]*✓?[\s\S]*Events and notes[\s\S]*Curves/);
    assert.equal(await page.locator('#sheet .curve.display').count(), 1);
    assert.ok(await page.locator('#sheet .curve.control').count() >= 1);
    assert.equal(await page.locator('#levers').isVisible() || await page.locator('#bar').isVisible(), false);
    const pdf = await page.pdf({path: join(kit.out, 'debriefing.pdf'), preferCSSPageSize: true});
    assert.equal(pdf.subarray(0, 5).toString(), '%PDF-');
    await page.emulateMedia({media: null});
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await page.locator('#sheet').count(), 0);
    await page.evaluate(() => hawser.debriefing.open(false));
    return `${pdf.length} bytes`;
}

export async function exercisePart(kit) {
    const {check, until, out} = kit;
    console.log('--- an exercise: apps/view/page/test/harbour_exercise.json');
    const report = join(out, 'report.html'), score = join(out, 'score.json');
    const server = await kit.serve('apps/view/page/test/harbour_exercise.json', '--wait', '--report', report, '--summary', score);
    const size = {viewport: {width: 960, height: 540}, query: '?quality=low'}, small = {query: '?quality=low'};
    const opened = async (address, options) => {
        const page = await kit.open(kit.browser, address, options);
        await kit.still(page);
        return page;
    };
    const instructor = await opened(server.instructor, size), station = await opened(server.winch, small), watcher = await opened(server.watcher, small);
    const picture = async name => {
        await kit.still(instructor, false);
        await instructor.screenshot({path: join(kit.pictures, name)});
        await kit.still(instructor);
    };
    const fault = name => instructor.locator(`[data-fault="${name}"]`);
    await check('the briefing waits for the instructor, who starts the run', async () => {
        for (const page of [instructor, station, watcher]) await page.locator('#briefing').waitFor();
        assert.match(await station.locator('#briefing').innerText(), /Your station: Winch[\s\S]*Tow taut: 10 points[\s\S]*The instructor starts/);
        assert.equal(await station.locator('#start').count(), 0);
        assert.equal(await station.evaluate(() => hawser.frame.time), 0);
        await picture('view_briefing.png');
        await instructor.keyboard.press('Enter');   // Start has the focus
        await until(station, () => document.getElementById('briefing').hidden && hawser.frame.time > 0);
    });
    await check('instruments show ship and winch in sailors’ units, and SI on request', async () => {
        await until(instructor, () => /°/.test(document.querySelector('#instruments .ship')?.innerText ?? ''));
        const text = await instructor.locator('#instruments').innerText();
        assert.match(text, /Heading\s+\d{3}°/);
        await instructor.evaluate(() => hawser.useSi(true));
        await until(instructor, () => /m\/s/.test(document.querySelector('#instruments').innerText));
        await instructor.evaluate(() => hawser.useSi(false));
        return text.replaceAll('\n', ' ').slice(0, 90);
    });
    await check('a station has its own lever alone, and no faults', async () => {
        assert.deepEqual(await station.evaluate(() => hawser.levers.levers.map(l => l.def.name)), ['winch_speed']);
        assert.equal(await station.locator('#faults').isVisible(), false);
        assert.equal(await station.locator('#play').isDisabled(), true);
        assert.equal(await watcher.locator('#levers').isVisible(), false);
        assert.equal(await instructor.locator("#faults [data-fault]").count(), 2);
        assert.match(await station.locator('#exercise').innerText(), /Winch of the tow/);
    });
    await check('goals to do and too late are told apart', async () => {
        await until(station, () => document.querySelectorAll('#goals .late').length === 1);
        assert.match(await station.locator('#goals').innerText(), /○[\s\S]*Tow taut[\s\S]*✕[\s\S]*Never in time[\s\S]*too late/);
    });
    await check("a fault of the instructor's holds the station's lever", async () => {
        await fault('stuck').click();
        await until(instructor, () => document.querySelector('[data-fault="stuck"]').getAttribute('aria-pressed') === 'true');
        await station.locator('input[data-input="winch_speed"]').focus();
        await station.keyboard.down('PageDown');
        await station.waitForTimeout(700);
        assert.equal(await station.evaluate(() => hawser.frame.inputs[0]), 0);
        assert.ok(await station.evaluate(() => hawser.levers.levers[0].value) < 0, 'the lever stays where the trainee put it');
        await until(station, () => /in force/.test(document.querySelector('.lever .force').textContent));
        await fault('stuck').click();
        await until(station, () => hawser.frame.inputs[0] < 0);
        assert.doesNotMatch(await station.locator('#events').innerText(), /fault|stuck/i);
        assert.match(await instructor.locator('#events').innerText(), /fault/i);
    });
    await check('hauling reaches the goal, sounds the alarm and costs points', async () => {
        await until(station, () => document.querySelectorAll('#goals .done').length === 1, null, 60000);
        await until(watcher, () => document.querySelectorAll('#alarms .alarm').length === 1, null, 60000);
        await until(station, () => document.querySelectorAll('#penalties li').length === 1);
        await station.keyboard.up('PageDown');
        const shown = await station.locator('#displays dd').innerText();
        assert.match(shown, / t/);
        return `${await station.locator('#score').innerText()}, ${shown}`;
    });
    await check('an alarm stays until it is acknowledged', async () => {
        await until(station, () => !document.getElementById('alarm-list').hidden);
        await until(station, () => document.querySelectorAll('#alarm-list li').length === 1);
        await station.locator('#alarm-list button').first().click();
        await until(station, () => !hawser.alarms.book.sounding);
        assert.equal(await watcher.evaluate(() => hawser.alarms.book.sounding), true);
    });
    await check('a frozen display stands still', async () => {
        await fault('frozen').click();
        await until(instructor, () => document.querySelector('[data-fault="frozen"]').getAttribute('aria-pressed') === 'true');
        await station.waitForTimeout(300);
        const a = await station.evaluate(() => hawser.frame.outputs[0]);
        await station.waitForTimeout(800);
        assert.equal(await station.evaluate(() => hawser.frame.outputs[0]), a);
        await fault('frozen').click();
        await until(station, v => hawser.frame.outputs[0] !== v, a);
    });
    await picture('view_exercise.png');
    await check('the end is shown to all, with points', async () => {
        await instructor.locator('#end-exercise').click();
        for (const page of [instructor, station, watcher]) await page.locator('#over').waitFor();
        const text = (await watcher.locator('#over').innerText()).replaceAll('\n', ' ');
        assert.match(text, /points, 10 needed.*ended by the instructor/);
        return text.slice(0, 90);
    });
    await check('the debriefing is printed alone, with names, date, score, goals, events and curves', () => printed(kit, instructor));
    await check('a restore takes the end back', async () => {
        await instructor.evaluate(() => hawser.restore('start'));
        await until(station, () => document.getElementById('over').hidden && hawser.exercise.exercise.outcome === 'running');
        assert.equal(await station.locator('#goals .done').count(), 0);
    });
    for (const page of [instructor, station, watcher]) await kit.quiet(page);
    await check('the program ends in order and leaves report and score', async () => {
        assert.equal(await server.end(), 0);
        assert.equal(JSON.parse(readFileSync(score, 'utf8')).end, 'interrupted');
        assert.match(readFileSync(report, 'utf8'), /harbour_tow/);
    });
    for (const page of [instructor, station, watcher]) await page.context().close();
}
