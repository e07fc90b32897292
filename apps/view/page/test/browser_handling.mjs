// SPDX-License-Identifier: Apache-2.0
// Stations of exercises/anchor_handling.json: bridge, winch and crane sail the exercise with events of
// keyboard and gamepad alone, by the plan of its control file. HAWSER_HANDLING_TIME: simulated seconds
// to sail (default 62; 600 for the first ten minutes). Pages are small and do not draw while
// they sail: without a graphics card three pictures would take the processors from the program.
import assert from 'node:assert/strict';
import {join} from 'node:path';

const kTime = Number(process.env.HAWSER_HANDLING_TIME ?? 62);
const kWide = {width: 1600, height: 1000}, kSmall = {width: 1180, height: 820};

/// Instruments of bridge and winch: words of the cards, by label.
const kShown = {
    Ship: [/Heading\s*\d{3}°/, /SOG\s*[\d.]+ kn/, /COG/, /ROT\s*[\d.]+°/, /Wind\s*[\d.]+ kn \d{3}°/],
    Propulsion: [/Port\s*−?[\d.]+ t/, /Starboard\s*−?[\d.]+ t/, /Bow 1\s*[\d.]+ t/, /Bow 2\s*[\d.]+ t/, /Stern\s*[\d.]+ t/, /Azimuth\s*−?[\d.]+ t\s*\d{3}°/, /Rudder P\s*[\d.]+°/, /Rudder S\s*[\d.]+°/],
    'DP desk': [/DP/, /Off position\s*[\d.]+ m/, /Off heading\s*[\d.]+°/, /Worst failure/],
    'Winch Work winch': [/Tension\s*[\d.]+ t \(\d+ %\)/, /Wire out\s*[\d.]+ m/, /Wire speed\s*−?[\d.]+ m\/min/, /Left on drum\s*[\d.]+ m/, /Mode\s*\S+/, /WLL/, /MBL/],
    'Stability gauge': [/Tension\s*[\d.]+ t/, /Permissible\s*[\d.]+ t/, /Limited by/, /Heel\s*[\d.]+°/],
};

const value = (page, name) => page.evaluate(n => hawser.frame.outputs[hawser.scene.outputs.findIndex(o => o.name === n)], name);
const input = (page, name) => page.evaluate(n => hawser.frame.inputs[hawser.scene.inputs.findIndex(i => i.name === n)], name);
const clockOf = page => page.evaluate(() => hawser.frame.time);

/// Check that each instrument is in the window, covered by nothing, with its words; that no text of
/// panels and cards is cut; and that no name of the program's is in view.
async function instrumentsInView(kit, page, size) {
    await page.setViewportSize(size);
    await kit.until(page, w => innerWidth === w && document.getElementById('canvas').clientWidth === w && /SOG\s*[\d.]+ kn/.test(document.getElementById('instruments').innerText), size.width);
    // Panels leave room for the console after it has been laid out.
    await kit.until(page, () => {
        const top = document.getElementById('instruments').getBoundingClientRect().top;
        return ['levers', 'exercise'].every(id => document.getElementById(id).getBoundingClientRect().bottom <= top + 1);
    });
    const seen = await page.evaluate(() => [...document.querySelectorAll('#instruments .instrument')].filter(e => e.offsetParent).map(e => {
        const r = e.getBoundingClientRect(), free = [0.1, 0.5, 0.9].every(f => e.contains(document.elementFromPoint(r.left + f * r.width, r.top + f * r.height)));
        return {label: e.getAttribute('aria-label'), text: e.innerText, inside: r.left >= 0 && r.top >= 0 && r.right <= innerWidth && r.bottom <= innerHeight, free, narrow: e.scrollWidth > e.clientWidth + 1};
    }));
    for (const [label, words] of Object.entries(kShown)) {
        const cards = seen.filter(c => c.label.startsWith(label));
        assert.equal(cards.length, 1, `${cards.length} cards ${label} among ${seen.map(c => c.label)}`);
        assert.ok(cards[0].inside && cards[0].free && !cards[0].narrow, `${label}: ${JSON.stringify(cards[0])}`);
        for (const w of words) assert.match(cards[0].text, w);
        assert.doesNotMatch(cards[0].text, /NaN|undefined|Infinity/);
    }
    const cut = await page.evaluate(() => [...document.querySelectorAll('#bar, #bar > *, #levers label, #levers output, #levers .head span, #levers button, .instrument h3, .instrument td, .instrument b, .limits span, #exercise dd, #exercise dt, #exercise li')]
        .filter(e => e.offsetParent && e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== 'inline' && e.id !== 'title').map(e => `${e.id || e.className || e.tagName}: ${e.textContent.slice(0, 30)} ${e.scrollWidth}>${e.clientWidth}`));
    assert.deepEqual(cut, []);
    const words = await page.evaluate(() => ['levers', 'instruments', 'exercise'].map(id => document.getElementById(id).innerText).join('\n'));
    const raw = words.match(/\b\w*_\w+|\b\w+\/\w*ship\b|NaN|undefined|null/g)?.filter(w => !/^m\/min$/.test(w));
    assert.ok(!raw, `names of the program in view: ${raw}`);
    return `${seen.length} cards`;
}

/// A station: its page, with a stub of a gamepad.
class Station {
    constructor(kit, name, page) {
        Object.assign(this, {kit, name, page, sent: 0});
    }

    static async open(kit, name, address) {
        const page = await kit.open(kit.browser, address, {viewport: {width: 640, height: 400}, query: '?quality=low'});
        await kit.still(page);
        await page.evaluate(() => { window.fakePads = [{id: 'Stub', index: 0, connected: true, axes: [0, 0, 0, 0], buttons: Array.from({length: 16}, () => ({pressed: false}))}]; });
        return new Station(kit, name, page);
    }

    /// Select a control by "[" and "]", from the picture.
    async select(name) {
        const {page} = this;
        const by = await page.evaluate(n => { document.getElementById('canvas').focus(); return hawser.levers.levers.findIndex(l => l.def.name === n) - hawser.levers.active; }, name);
        for (let i = 0; i < Math.abs(by); ++i) await page.keyboard.press(by > 0 ? ']' : '[');
        assert.equal(await page.evaluate(() => hawser.levers.levers[hawser.levers.active].def.name), name);
    }

    /// Set a switch or choice by arrow keys.
    async choose(name, to) {
        await this.select(name);
        for (let i = 0; i < 12; ++i) {
            const at = await this.page.evaluate(n => Math.round(hawser.levers.levers.find(l => l.def.name === n).value), name);
            if (at === to) break;
            await this.page.keyboard.press(at < to ? 'ArrowUp' : 'ArrowDown');
        }
        await this.inForce(name, to);
    }

    /// Set a control that stays by arrow keys: steps of a twentieth of its range.
    async set(name, to) {
        await this.select(name);
        const steps = await this.page.evaluate(([n, v]) => { const l = hawser.levers.levers.find(x => x.def.name === n); return Math.round((v - l.value) / ((l.range[1] - l.range[0]) / 20)); }, [name, to]);
        for (let i = 0; i < Math.abs(steps); ++i) await this.page.keyboard.press(steps > 0 ? 'ArrowUp' : 'ArrowDown');
        await this.inForce(name, to, 0.06 * await this.page.evaluate(n => { const {range} = hawser.levers.levers.find(x => x.def.name === n); return range[1] - range[0]; }, name));
    }

    /// Deflect the stick of a control with a spring so that it has a value, and hold it.
    async stick(name, to) {
        const {page} = this;
        await page.evaluate(([n, v]) => {
            const l = hawser.levers.levers.find(x => x.def.name === n), {axes, zone} = hawser.pads.mapping, axis = axes.findIndex(a => a.lever === n);
            if (axis < 0) throw new Error(`no axis for ${n}`);
            const d = v / (v >= 0 ? l.range[1] : -l.range[0]), tilt = d ? Math.sign(d) * (zone + (1 - zone) * Math.abs(d) ** (1 / 1.5)) : 0;
            window.fakePads[0].axes[axis] = tilt * (axes[axis].invert ? -1 : 1);
        }, [name, to]);
        const span = await page.evaluate(n => { const {range} = hawser.levers.levers.find(x => x.def.name === n); return range[1] - range[0]; }, name);
        await this.inForce(name, to, 0.01 * span);
    }

    /// Press a button of the gamepad.
    async pad(button) {
        const set = on => this.page.evaluate(([b, p]) => { window.fakePads[0].buttons[b] = {pressed: p}; }, [button, on]), polls = n => this.page.evaluate(async m => { for (let i = 0; i < m; ++i) await new Promise(done => requestAnimationFrame(done)); }, n);
        await set(true);
        await polls(2);
        await set(false);
        await polls(2);
    }

    async inForce(name, to, by = 1e-4) {
        await this.kit.until(this.page, ([n, v, d]) => Math.abs(hawser.frame.inputs[hawser.scene.inputs.findIndex(i => i.name === n)] - v) <= d, [name, to, by], 30000);
        ++this.sent;
    }

    shot(name) {
        return this.page.screenshot({path: join(this.kit.pictures, name)});
    }
}

/// The plan of exercises/anchor_handling.control.csv: [time, station, action]. Moves of the ordered
/// position in steps of 5 m, by the cross of the gamepad.
function plan(bridge, winch, crane) {
    const out = [
        [3, crane, 'crane: luff, knuckle and slew out, hook down', async () => {
            await crane.stick('luff', -0.06);
            await crane.stick('knuckle', 0.06);
            await crane.stick('hoist', 0.1);
            await crane.stick('slew', -0.012);
        }],
        [5, crane, 'crane: slew stops', () => crane.stick('slew', 0)],
        [8, winch, 'winch: hook takes', () => winch.choose('hook', 1)],
        [15, crane, 'crane: stops', async () => { for (const s of ['luff', 'knuckle', 'hoist']) await crane.stick(s, 0); }],
        [22, winch, 'winch: haul', async () => { await winch.choose('work_mode', 0); await winch.stick('work_speed', -0.5); }],
        [22, crane, 'crane: hoist', () => crane.stick('hoist', -0.1)],
        [36, crane, 'crane: lets the pennant go', async () => { await crane.stick('hoist', 0); await crane.choose('crane_hook', 0); }],
        [36, bridge, 'bridge: ahead', () => bridge.pad(12)],
        [38, crane, 'crane: clear of the deck', async () => { await crane.stick('luff', 0.08); await crane.stick('hoist', 0.4); }],
        [40, winch, 'winch: stops, pins up', async () => { await winch.stick('work_speed', 0); await winch.choose('port_pin', 1); await winch.choose('starboard_pin', 1); }],
        [45, crane, 'windlass: veer', async () => { await crane.stick('hoist', 0); await crane.stick('luff', 0); await crane.choose('windlass_mode', 0); await crane.mapAxis('hoist', 'windlass_speed'); await crane.stick('windlass_speed', 0.6); }],
        [151, crane, 'windlass: constant tension', async () => { await crane.stick('windlass_speed', 0); await crane.choose('windlass_mode', 1); await crane.set('windlass_pull', 200000); }],
        [153, winch, 'winch: haul', () => winch.stick('work_speed', -0.6)],
        [183, winch, 'winch: pins down', async () => { await winch.choose('port_pin', 0); await winch.choose('starboard_pin', 0); }],
        [189, winch, 'winch: haul slowly over the roller', () => winch.stick('work_speed', -0.3)],
        [243, winch, 'winch: stops', () => winch.stick('work_speed', 0)],
        [247, winch, 'winch: shark jaw closes', () => winch.choose('jaw_close', 1)],
        [252, winch, 'winch: eases off', () => winch.stick('work_speed', 0.3)],
        [256, winch, 'winch: stops', () => winch.stick('work_speed', 0)],
        [258, crane, 'windlass: 300 kN', () => crane.set('windlass_pull', 300000)],
    ];
    // The control file moves 3.48 m in 5 s until 146 s, and 5.98 m in 5 s from 260 s on.
    for (let k = 1, t = 41; t < 150; ++k) { out.push([t, bridge, '', () => bridge.pad(12)]); t = 41 + k * 7.19; }
    for (let k = 1, t = 260; t < 1020; ++k) { out.push([t, bridge, '', () => bridge.pad(12)]); t = 260 + k * 4.18; }
    return out.sort((a, b) => a[0] - b[0]);
}

/// Give an axis of the gamepad another control, in the panel of the keyboard and gamepad, by keys alone.
Station.prototype.mapAxis = async function (from, to) {
    const {page} = this, axis = await page.evaluate(n => hawser.pads.mapping.axes.findIndex(a => a.lever === n), from);
    await page.evaluate(() => document.getElementById('canvas').focus());
    await page.keyboard.press('?');
    await page.locator(`#pad-axis-${axis}`).focus();
    const steps = await page.evaluate(([a, n]) => { const s = document.getElementById(`pad-axis-${a}`), at = [...s.options].findIndex(o => o.value === n); return at - s.selectedIndex; }, [axis, to]);
    for (let i = 0; i < Math.abs(steps); ++i) await page.keyboard.press(steps > 0 ? 'ArrowDown' : 'ArrowUp');
    await this.kit.until(page, ([a, n]) => hawser.pads.mapping.axes[a].lever === n, [axis, to]);
    await page.keyboard.press('Escape');
    await page.evaluate(() => { document.getElementById('keys').hidden = true; document.getElementById('canvas').focus(); });
};

async function sail(kit, stations, instructor) {
    const {check, until} = kit, [bridge, winch, crane] = stations, reached = () => instructor.evaluate(() => hawser.exercise.exercise.goals.filter(g => g.reached !== null).map(g => g.name));
    const begun = Date.now();
    let late = 0, moves = 0;
    for (const [at, station, words, act] of plan(bridge, winch, crane)) {
        if (at > kTime) break;
        await until(instructor, t => hawser.frame.time >= t, at, 600000);
        const now = await clockOf(instructor);
        late = Math.max(late, now - at);
        if (words) await check(`${words}, due at ${at} s`, async () => { await act(); return `${now.toFixed(1)} s`; });
        else { await act(); ++moves; }
        void station;
    }
    await until(instructor, t => hawser.frame.time >= t, kTime, 600000);
    await check('the bridge moved the ordered position by the cross of the gamepad', async () => {
        const state = await bridge.page.evaluate(() => ['x_order', 'y_order'].map(n => hawser.levers.levers.find(l => l.def.name === n).value));
        await until(bridge.page, ([x, y]) => Math.abs(hawser.frame.inputs[1] - x) < 1e-2 && Math.abs(hawser.frame.inputs[2] - y) < 1e-2, state);
        assert.ok(state[0] > 90, `${state}`);
        return `${moves} moves to ${state.map(v => v.toFixed(0))}; worst delay ${late.toFixed(1)} s; ${((await clockOf(instructor)) / ((Date.now() - begun) / 1000)).toFixed(2)} × real time`;
    });
    await check('the pennant is on the work wire and the crane is free', async () => {
        assert.deepEqual((await reached()).slice(0, 1), ['pennant']);
        return instructor.evaluate(() => hawser.exercise.exercise.goals.filter(g => g.reached !== null).map(g => `${g.name} at ${g.reached.toFixed(1)} s`).join(', '));
    });
    if (kTime >= 280) await check('the anchor is on deck, the chain in the shark jaw', async () => assert.deepEqual((await reached()).slice(0, 2), ['pennant', 'in_jaw']));
}

/// Check that each control of a station moves by keys alone, in the pause, and set it back.
async function byKeyboard(kit, station) {
    await kit.check(`${station.name}: each control is reached and moved by keyboard alone`, async () => {
        const {page} = station, names = await page.evaluate(() => hawser.levers.levers.map(l => l.def.name));
        await page.evaluate(() => window.fakePads[0].axes.fill(0));   // a stick that is held would move its control back
        await kit.until(page, () => hawser.levers.levers.every(l => l.def.spring !== 0 || Math.abs(l.value) < 1e-9));
        for (const name of names) {
            await station.select(name);
            const before = await page.evaluate(n => hawser.levers.levers.find(l => l.def.name === n).value, name), up = await page.evaluate(n => { const l = hawser.levers.levers.find(x => x.def.name === n); return l.value < l.range[1] - 1e-9; }, name);
            await page.keyboard.down(up ? 'ArrowUp' : 'ArrowDown');
            await kit.until(page, ([n, v]) => Math.abs(hawser.levers.levers.find(l => l.def.name === n).value - v) > 1e-9, [name, before]);
            await page.keyboard.up(up ? 'ArrowUp' : 'ArrowDown');
            await page.keyboard.press(up ? 'ArrowDown' : 'ArrowUp');
            await kit.until(page, ([n, v]) => { const l = hawser.levers.levers.find(x => x.def.name === n); const one = l.step || l.buttons && 1e-6 || 0.051 * (l.range[1] - l.range[0]);   // steps are round
                return Math.abs(l.value - v) < 1.001 * one; }, [name, before]);
            await page.keyboard.press('Escape');
        }
        // Tab reaches all of them, too.
        await page.evaluate(() => { document.querySelector('.skip').focus(); });
        const tabbed = new Set();
        for (let i = 0; i < 90; ++i) {
            await page.keyboard.press('Tab');
            tabbed.add(await page.evaluate(() => document.activeElement?.dataset.input ?? document.activeElement?.dataset.move ?? ''));
        }
        assert.deepEqual(names.filter(n => !tabbed.has(n)), []);
        await page.evaluate(() => document.getElementById('canvas').focus());
        return `${names.length} controls`;
    });
}

export async function handlingPart(kit) {
    console.log(`--- anchor handling: exercises/anchor_handling.json, ${kTime} s by keyboard and gamepad`);
    const server = await kit.serve('exercises/anchor_handling.json', '--wait', '--threads', '2');
    const bridge = await Station.open(kit, 'bridge', server.bridge), winch = await Station.open(kit, 'winch', server.winch), crane = await Station.open(kit, 'crane', server.crane), all = [bridge, winch, crane];
    const instructor = await kit.open(kit.browser, server.instructor, {viewport: {width: 320, height: 240}, query: '?quality=low'});
    await kit.still(instructor);
    await kit.check('the instructor starts and sets the rate by keys', async () => {
        await instructor.locator('#briefing').waitFor();
        await instructor.keyboard.press('Enter');
        await kit.until(instructor, () => hawser.frame.time > 0);
        await instructor.evaluate(() => document.getElementById('rate').focus());
        await instructor.keyboard.press('End');
        await kit.until(instructor, () => hawser.state.rate === 10);
    });
    await kit.check('orders of the DP are those of the ship before a station sets them', async () => {
        const [x, y, heading] = await kit.until(bridge.page, () => { const of = n => hawser.levers.levers.find(l => l.def.name === n).value; return of('x_order') > 80 && [of('x_order'), of('y_order'), of('heading_order')]; });
        assert.ok(Math.abs(x - 87.7) < 5 && Math.abs(y - 65) < 5 && Math.abs(heading + 0.5236) < 0.1, `${x} ${y} ${heading}`);
    });
    await sail(kit, all, instructor);
    await instructor.evaluate(() => document.getElementById('canvas').focus());
    await instructor.keyboard.press(' ');
    await kit.until(instructor, () => hawser.state.paused);
    for (const station of [bridge, winch])
        for (const [size, end] of [[kSmall, ''], [kWide, '_wide']])
            await kit.check(`${station.name} at ${size.width}×${size.height}: thrusters, rudders, heading, speed, DP, wire, stability in view`, async () => {
                const words = await instrumentsInView(kit, station.page, size);
                await kit.still(station.page, false);
                await station.shot(`view_handling_${station.name}${end}.png`);
                await kit.still(station.page);
                return words;
            });
    await kit.check('crane: load, windlass and chain in view', async () => {
        const text = await crane.page.locator('#instruments').innerText();
        for (const w of [/Rated load\s*[\d.]+ t/, /Radius\s*[\d.]+ m/, /Windlass/, /Wire out\s*[\d.]+ m/, /Mode\s*Haul/]) assert.match(text, w);
    });
    for (const station of all) await byKeyboard(kit, station);
    await kit.check('no input was refused', async () => {
        for (const s of all) assert.equal(await s.page.evaluate(() => document.getElementById('toast').textContent), '');
        return `${all.map(s => `${s.name} ${s.sent}`).join(', ')} inputs in force`;
    });
    for (const s of all) await kit.quiet(s.page);
    await kit.quiet(instructor);
    for (const page of [...all.map(s => s.page), instructor]) await page.context().close();
    await kit.check('the program ends in order', async () => assert.equal(await server.end(), 0));
}
