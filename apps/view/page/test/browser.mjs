// SPDX-License-Identifier: Apache-2.0
// Drives the page in a browser against the real program: node test/browser.mjs HAWSER [PART …]
// Parts: act (levers to restore), exercise (roles, faults, score), station (instruments, keys), record
// (scrubbing), look (pictures, rates), handling (anchor handling by three stations), trainer (every exercise
// by two stations and the instructor, layout, axe-core), stills (pictures for
// docs/trainer.md, draw calls). All by default. On request: phases
// (pictures of the phases of anchor handling).
// HAWSER_PAGE=build/page/files serves the page's files from that folder instead of the program's.
// Debian's chromium without a graphics card: software GL. CHROMIUM names another one.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {mkdirSync, mkdtempSync, readFileSync, statSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {chromium} from 'playwright-core';
import {actPart} from './browser_act.mjs';
import {exercisePart} from './browser_exercise.mjs';
import {lookPart} from './browser_look.mjs';
import {handlingPart} from './browser_handling.mjs';
import {stationPart} from './browser_station.mjs';
import {phasesPart} from './browser_phases.mjs';
import {recordPart} from './browser_record.mjs';
import {stillsPart} from './browser_stills.mjs';
import {trainerPart} from './browser_trainer.mjs';

const here = dirname(fileURLToPath(import.meta.url)), root = resolve(here, '../../../..');
const hawser = resolve(process.argv[2] ?? join(root, 'build/release/bin/hawser'));
const parts = process.argv.length > 3 ? process.argv.slice(3) : ['act', 'exercise', 'station', 'record', 'look', 'handling', 'trainer', 'stills'];
const kArguments = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--disable-features=LocalNetworkAccessChecks'];

let passed = 0, failed = 0;
const children = new Set();
const problems = [];

/// One thing that is checked; what it returns is printed behind its name.
async function check(name, f) {
    try {
        const words = await f();
        ++passed;
        console.log(`ok    ${name}${words ? `: ${words}` : ''}`);
    } catch (e) {
        ++failed;
        problems.push(name);
        console.log(`FAIL  ${name}: ${String(e.message).split('\n').slice(0, 3).join(' | ')}`);
    }
}

/// The program on a port of its own: {instructor, watcher, end}. Option `--wait`: it waits for Start.
function serve(scene, ...options) {
    const wait = options[0] === '--wait' || scene.endsWith('.hwr') ? [] : ['--go'];
    if (options[0] === '--wait') options.shift();
    const child = spawn(hawser, ['view', scene, '--port', '0', ...wait, ...options], {cwd: root, stdio: ['ignore', 'pipe', 'pipe']});
    const addresses = {};
    children.add(child);
    child.once('exit', () => children.delete(child));
    let text = '';
    return new Promise((done, fail) => {
        const late = setTimeout(() => fail(new Error(`no address within 30 s: ${text}`)), 30000);
        const read = chunk => {
            text += chunk;
            for (const m of text.matchAll(/^(\w+)\s+(http:\S+)$/gm)) addresses[m[1]] = m[2];
            if (!/Ctrl-C/.test(text)) return;
            clearTimeout(late);
            done({...addresses, pid: child.pid, end: () => new Promise(over => {
                if (child.exitCode !== null) return over(child.exitCode);
                child.once('exit', over);
                child.kill('SIGINT');
            })});
        };
        child.stdout.on('data', read);
        child.stderr.on('data', read);
        child.once('exit', code => fail(new Error(`hawser view ended with ${code}: ${text}`)));
    });
}

/// A page at an address, connected. Whatever it says as an error counts as a failure.
async function open(browser, address, {query = '', ...options} = {}) {
    const context = await browser.newContext({viewport: {width: 640, height: 360}, ...options}), page = await context.newPage();
    page.errors = [];
    page.on('pageerror', e => page.errors.push(e.message));
    page.on('console', m => { if (m.type() === 'error') page.errors.push(m.text()); });
    await page.addInitScript(() => {
        window.fakePads = [];
        navigator.getGamepads = () => window.fakePads;
    });
    const folder = process.env.HAWSER_PAGE && resolve(root, process.env.HAWSER_PAGE);
    for (const name of folder ? ['', 'view.js', 'view.css'] : []) await page.route(u => u.pathname === `/${name}`, r => r.fulfill({path: join(folder, name || 'index.html')}));
    await page.goto(address.replace('/#', `/${query}#`), {timeout: 90000});
    await until(page, () => window.hawser?.frame !== undefined, null, 240000);   // drawing may hold up the page's own clock
    return page;
}

/// Stop drawing of the picture: without a graphics card it takes the processors from all else. Panels,
/// controls and instruments go on. @param still  False: draw again, and wait for two pictures.
async function still(page, on = true) {
    await page.evaluate(async s => {
        const {stage} = hawser;
        stage.drawn ??= stage.draw.bind(stage);
        stage.draw = s ? () => {} : stage.drawn;
        for (let i = 0; !s && i < 2; ++i) await new Promise(done => requestAnimationFrame(done));
    }, on);
}

/// Waits for an expression of the page; tells its last value where it does not come true.
async function until(page, f, argument, timeout = 20000) {
    const end = Date.now() + timeout;
    for (;;) {
        const value = await page.evaluate(f, argument);
        if (value) return value;
        if (Date.now() > end) throw new Error(`not within ${timeout / 1000} s: ${f.toString().slice(0, 160)}`);
        await page.waitForTimeout(60);
    }
}

const out = mkdtempSync(join(tmpdir(), 'hawser-page-')), pictures = join(root, 'docs/pictures');
mkdirSync(pictures, {recursive: true});
const browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: kArguments});
const kit = {browser, serve, open, until, still, check, out, root, pictures, hawser, size: f => statSync(f).size, load: () => readFileSync('/proc/loadavg', 'utf8').split(' ')[0],
    quiet: page => check('the page said no error', () => assert.ok(!page.errors.length, page.errors.slice(0, 3).join(' ; ').slice(0, 500)))};
try {
    if (parts.includes('act')) await actPart(kit);
    if (parts.includes('exercise')) await exercisePart(kit);
    if (parts.includes('station')) await stationPart(kit);
    if (parts.includes('record')) await recordPart(kit);
    if (parts.includes('look')) await lookPart(kit);
    if (parts.includes('handling')) await handlingPart(kit);
    if (parts.includes('trainer')) await trainerPart(kit);
    if (parts.includes('stills')) await stillsPart(kit);
    if (parts.includes('phases')) await phasesPart(kit);
} catch (e) {
    ++failed;
    problems.push(e.message);
    console.log(e.stack);
} finally {
    await browser.close();
    for (const child of children) child.kill('SIGINT');   // of a part that ended by an error
}
if (problems.length) console.log(`not ok: ${problems.join('; ')}`);
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
