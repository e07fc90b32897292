// SPDX-License-Identifier: Apache-2.0
// Exercises in the page: the instructor and two stations at once, with events of keyboard and gamepad
// alone. Every control is reached, no text is cut or outside the window at three sizes, and axe-core finds
// no serious violation.
//     HAWSER_EXERCISES=berthing,tow_gob: these alone. HAWSER_TRAINER_TIME: simulated seconds (300).
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

const kSizes = [{width: 1600, height: 1000}, {width: 1180, height: 820}, {width: 820, height: 1180}];
const kTime = Number(process.env.HAWSER_TRAINER_TIME ?? 300);
/// Exercises of the default run. anchor_handling has a part of its own (browser_handling.mjs).
const kExercises = ['berthing', 'tow_gob', 'subsea_lift', 'emergency_release', 'tow_to_sea', 'tow_out', 'crane_lift', 'anchor_over_roller'];
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const none = list => assert.ok(!list.length, list.join('; '));

/// Serious and critical violations of WCAG 2.1 A and AA, in words.
async function violations(page) {
    if (!await page.evaluate(() => Boolean(window.axe))) await page.evaluate(axe);
    return page.evaluate(async () => {
        const found = await window.axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'], resultTypes: ['violations']});
        return found.violations.filter(v => ['serious', 'critical'].includes(v.impact)).flatMap(v => v.nodes.slice(0, 3).map(n => `${v.id}: ${n.target.join(' ')} ${n.failureSummary?.split('\n')[1]?.trim().slice(0, 120) ?? ''}`));
    });
}

/// Texts that are cut by their box or lie outside the window. Boxes that scroll show all of their text;
/// the line of events moves on.
const overflows = page => page.evaluate(() => {
    const out = [], scrolls = e => { for (let p = e; p; p = p.parentElement) if (/auto|scroll/.test(getComputedStyle(p).overflowY) && p.scrollHeight > p.clientHeight + 1) return true; return false; };
    for (const e of document.querySelectorAll('body *')) {
        if (!e.checkVisibility?.({checkVisibilityCSS: true}) || e.closest('#events, #labels, .sr, .skip, svg, canvas')) continue;
        if (![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
        const r = e.getBoundingClientRect(), style = getComputedStyle(e), name = `${e.id ? `#${e.id}` : e.className || e.tagName} “${e.textContent.trim().slice(0, 24)}”`;
        if (!r.width || style.position === 'absolute' && style.clipPath !== 'none') continue;
        if (style.display !== 'inline' && e.scrollWidth > e.clientWidth + 1 && style.overflowX !== 'visible') out.push(`cut ${name} ${e.scrollWidth}>${e.clientWidth}`);
        if (r.left < -1 || r.right > innerWidth + 1) out.push(`outside ${name} ${r.left.toFixed(0)}…${r.right.toFixed(0)}`);
        else if ((r.top < -1 || r.bottom > innerHeight + 1) && !scrolls(e)) out.push(`below ${name} ${r.top.toFixed(0)}…${r.bottom.toFixed(0)}`);
        const panel = e.closest('.panel, .instrument'), p = panel?.getBoundingClientRect();
        if (p && (r.left < p.left - 1 || r.right > p.right + 1)) out.push(`out of its panel ${name}`);
    }
    return [...new Set(out)].slice(0, 6);
});

/// Controls of the levers panel that can be brought into view and are not covered.
const covered = page => page.evaluate(async () => {
    const out = [];
    for (const box of document.querySelectorAll('#levers details')) box.open = true;
    for (const e of document.querySelectorAll('#levers [data-input], #levers [data-move]')) {
        e.scrollIntoView({block: 'center'});
        const r = e.getBoundingClientRect(), top = document.elementFromPoint(r.left + r.width / 2, r.top + r.height / 2);
        if (!e.contains(top) && top !== e && !top?.contains(e)) out.push(`${e.dataset.input ?? e.dataset.move} under ${top?.id || top?.className}`);
    }
    return out;
});

async function layout(kit, page, who) {
    for (const size of kSizes) {
        await kit.check(`${who} at ${size.width}×${size.height}: no text is cut or outside, controls are free`, async () => {
            await page.setViewportSize(size);
            await kit.until(page, w => innerWidth === w && document.getElementById('canvas').clientWidth === w, size.width);
            await page.waitForTimeout(600);
            none(await overflows(page));
            none(await covered(page));
        });
    }
}

const pad = page => page.evaluate(() => { window.fakePads = [{id: 'Stub', index: 0, connected: true, axes: [0, 0, 0, 0], buttons: Array.from({length: 17}, () => ({pressed: false}))}]; });
async function button(page, index) {
    for (const pressed of [true, false]) await page.evaluate(async ([b, p]) => {
        window.fakePads[0].buttons[b] = {pressed: p};
        for (let i = 0; i < 3; ++i) await new Promise(done => requestAnimationFrame(done));
    }, [index, pressed]);
}
const levers = page => page.evaluate(() => hawser.levers.levers.map(l => ({name: l.def.name, value: l.value, range: l.range, spring: l.def.spring})));

/// Move each control by the buttons of the gamepad that select and move: RB, RT, LT.
async function byGamepad(kit, page, who) {
    await kit.check(`${who}: each control is reached and moved by the gamepad`, async () => {
        await pad(page);
        const all = await levers(page);
        for (let i = 0; i < all.length; ++i) {
            const at = await page.evaluate(() => hawser.levers.active), before = (await levers(page))[at], up = before.value < before.range[1] - 1e-9;
            await page.evaluate(() => { window.moved = false; const l = hawser.levers, send = l.throttle.set.bind(l.throttle); l.throttle.set = (n, v) => { window.moved = n; send(n, v); }; });
            await button(page, up ? 7 : 6);
            assert.equal(await page.evaluate(() => window.moved), before.name);
            await button(page, up ? 6 : 7);
            await button(page, 5);
        }
        return `${all.length} controls`;
    });
}

async function byKeyboard(kit, page, who) {
    await kit.check(`${who}: each control is reached and moved by the keyboard`, async () => {
        await page.evaluate(() => document.getElementById('canvas').focus());
        const all = await levers(page);
        for (let i = 0; i < all.length; ++i) {
            const at = await page.evaluate(() => hawser.levers.active), before = (await levers(page))[at], up = before.value < before.range[1] - 1e-9;
            await page.keyboard.down(up ? 'ArrowUp' : 'ArrowDown');
            await kit.until(page, ([k, v]) => Math.abs(hawser.levers.levers[k].value - v) > 1e-9, [at, before.value]);
            await page.keyboard.up(up ? 'ArrowUp' : 'ArrowDown');
            await page.keyboard.press(up ? 'ArrowDown' : 'ArrowUp');
            await page.keyboard.press(']');
        }
        return `${all.length} controls`;
    });
}

/// Press Tab until an element has the focus.
async function tabTo(page, selector, most = 160) {
    for (let i = 0; i < most; ++i) {
        if (await page.evaluate(s => document.activeElement?.matches(s), selector)) return;
        await page.keyboard.press('Tab');
    }
    throw new Error(`Tab does not reach ${selector}`);
}

async function exercise(kit, name) {
    const {check, until} = kit, file = JSON.parse(readFileSync(join(kit.root, 'exercises', `${name}.json`), 'utf8'));
    console.log(`--- ${name}: ${file.stations.map(s => s.name).join(', ')} and instructor`);
    const server = await kit.serve(`exercises/${name}.json`, '--wait'), size = {viewport: {width: 320, height: 200}, query: '?quality=low'};
    const instructor = await kit.open(kit.browser, server.instructor, size), [first, second] = file.stations.slice(0, 2);
    // Pages open small and stop to draw: without a graphics card a picture takes the processors from the program.
    await kit.still(instructor);
    const pages = {};
    for (const s of [first, second].filter(Boolean)) {
        pages[s.name] = await kit.open(kit.browser, server[s.name], size);
        await kit.still(pages[s.name]);
    }
    for (const page of [instructor, ...Object.values(pages)]) await page.setViewportSize(kSizes[1]);
    const axeOf = (page, who) => check(`axe-core: ${who}`, async () => none(await violations(page)));
    await axeOf(instructor, 'instructor before the start');
    await check('the instructor starts by the keyboard; both stations run', async () => {
        await instructor.locator('#briefing').waitFor();
        await instructor.keyboard.press('Enter');
        for (const page of Object.values(pages)) await until(page, () => hawser.frame.time > 0 && document.getElementById('briefing').hidden);
        await instructor.evaluate(() => document.getElementById('canvas').focus());
        await tabTo(instructor, '#rate');
        await instructor.keyboard.press('End');
        await until(instructor, () => hawser.state.rate === 10);
    });
    for (const [k, [who, page]] of Object.entries(pages).entries()) {
        await layout(kit, page, who);
        await (k ? byKeyboard : byGamepad)(kit, page, who);
        await axeOf(page, who);
    }
    await layout(kit, instructor, 'instructor');
    await check('the instructor begins and ends a fault and writes a note by the keyboard', async () => {
        await instructor.evaluate(() => document.getElementById('canvas').focus());
        const fault = file.faults.find(f => f.kind !== 'line_parts' && f.at === undefined) ?? file.faults[0];
        await tabTo(instructor, `[data-fault="${fault.name}"]`);
        await instructor.keyboard.press('Enter');
        await until(instructor, f => hawser.exercise.faults.find(x => x.name === f).active, fault.name);
        await tabTo(instructor, `[data-fault="${fault.name}"]`);
        await instructor.keyboard.press('Enter');
        await until(instructor, f => !hawser.exercise.faults.find(x => x.name === f).active, fault.name);
        await tabTo(instructor, '#note-text');
        await instructor.keyboard.type('watch the drift');
        await instructor.keyboard.press('Enter');
        await until(Object.values(pages)[0], () => /watch the drift/.test(document.getElementById('events').textContent));
    });
    for (const [id, key] of [['keys', '?'], ['layers', '']]) {
        await check(`panel ${id} fits at 1180×820 and 820×1180`, async () => {
            for (const s of kSizes.slice(1)) {
                await instructor.setViewportSize(s);
                await instructor.evaluate(([i, open]) => { document.getElementById('canvas').focus(); if (!open) hawser.panel(i); }, [id, key]);
                if (key) await instructor.keyboard.press(key);
                await until(instructor, i => !document.getElementById(i).hidden, id);
                none(await overflows(instructor));
                none(await violations(instructor));
                await instructor.keyboard.press('Escape');
                await until(instructor, i => document.getElementById(i).hidden, id);
            }
        });
    }
    await check(`the exercise runs to ${kTime} s or its end`, async () => {
        await until(instructor, t => hawser.frame.time >= t || hawser.exercise.exercise.ended !== null, kTime, 900000);
        return instructor.evaluate(() => `${hawser.frame.time.toFixed(0)} s, ${hawser.exercise.exercise.points} points${hawser.exercise.exercise.end ? `, ${hawser.exercise.exercise.end}` : ''}`);
    });
    await check('the end is shown to all; the debriefing has no violation and fits', async () => {
        if (await instructor.evaluate(() => hawser.exercise.exercise.ended === null)) {
            await instructor.evaluate(() => document.getElementById('canvas').focus());
            await tabTo(instructor, '#end-exercise');
            await instructor.keyboard.press('Enter');
        }
        for (const page of [instructor, ...Object.values(pages)]) await page.locator('#over').waitFor();
        none(await violations(instructor));
        await instructor.keyboard.press('Enter');   // Close has the focus
        await instructor.keyboard.press('d');
        await until(instructor, () => !document.getElementById('debriefing').hidden);
        for (const s of kSizes) {
            await instructor.setViewportSize(s);
            await instructor.waitForTimeout(300);
            none(await overflows(instructor));
        }
        none(await violations(instructor));
    });
    for (const page of [instructor, ...Object.values(pages)]) {
        await kit.quiet(page);
        await page.context().close();
    }
    await server.end();
}

export async function trainerPart(kit) {
    for (const name of process.env.HAWSER_EXERCISES?.split(',') ?? kExercises) await exercise(kit, name);
}
