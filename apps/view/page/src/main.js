// SPDX-License-Identifier: Apache-2.0
/// The page of `hawser view`: connects the WebSocket, picture, controls, plots and panels.
import {AlarmList} from './alarms.js';
import {Briefing} from './briefing.js';
import {Connection} from './connection.js';
import {Debriefing} from './debriefing.js';
import {gradient, kPalettes} from './colour.js';
import {$, clock, el, memory, toast} from './dom.js';
import {Drag} from './drag.js';
import {defaultMapping, Gamepads} from './gamepad.js';
import {ExercisePanel} from './exercise.js';
import {Instruments} from './instruments.js';
import {kMove, kMoves} from './forms.js';
import {bindKeys} from './keyboard.js';
import {quantity} from './lever_logic.js';
import {Levers} from './levers.js';
import {Inspector, keysPanel, layersPanel, restorePanel} from './panels.js';
import {Plots, showPlots} from './plots.js';
import {tokenOf} from './protocol.js';
import {readable} from './roles.js';
import {Stage} from './stage.js';
import {Timeline} from './timeline.js';
import {kModes} from './camera.js';
import {chooseLanguage, language, t, translatePage} from './words.js';

const kPause = 'M3 2h4v12H3zM9 2h4v12H9z', kPlay = 'M4 2v12l10-6z';
const kCameraNames = {free: 'Free', follow: 'Follow', board: 'Deck', bridge: 'Bridge', aft: 'Aft', hook: 'Hook', top: 'Chart'};
const kRanges = [0.25, 0.5, 1];

class App {
    constructor() {
        this.stage = new Stage($('canvas'), $('labels'), new URLSearchParams(location.search).get('quality') ?? '');
        this.levers = new Levers($('levers'), (input, value) => this.link.send({type: 'set', input, value}));
        this.pads = new Gamepads(this.levers, c => this.command(c));
        this.inspector = new Inspector($('plots'), this);
        this.plots = new Plots($('plots'));
        this.plots.mount();
        this.exercise = new ExercisePanel($('exercise'), this);
        this.alarms = new AlarmList($('alarm-list'));
        this.briefing = new Briefing($('briefing'), this);
        this.debriefing = new Debriefing($('debriefing'), this);
        this.instruments = new Instruments($('instruments'), this);
        this.timeline = new Timeline(time => this.link.ask({type: 'seek', time}));
        this.drag = new Drag(this);
        this.state = {paused: false, rate: 1, restore_points: [], failure: null, range: null};
        this.script = {ms: 0, n: 0};
        layersPanel($('layers'), this);
        this.paintRestore = restorePanel($('restore'), this);
        this.paintKeys = keysPanel($('keys'), this);
        this.bind();
        this.connect();
        if (new URLSearchParams(location.search).has('clean')) this.clean(true);
        new ResizeObserver(() => this.resize()).observe($('view'));
        this.resize();
        requestAnimationFrame(t => this.tick(t));
    }

    get mayControl() {
        return Boolean(this.scene?.role.control) && this.scene.mode === 'live';
    }
    get mayRun() {
        return Boolean(this.scene) && (this.scene.role.control || this.scene.mode === 'recording');
    }

    connect() {
        const url = `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/live`;
        this.link = new Connection(url, tokenOf(location.hash));
        const on = (name, f) => this.link.addEventListener(name, e => f(e.detail));
        on('status', s => this.paintLink(s));
        on('scene', s => this.setScene(s));
        on('state', s => this.setState(s));
        on('frame', () => { this.fresh = true; });
        on('event', e => {
            this.timeline.tell(e);
            this.alarms.event(e);
            this.debriefing.collector.event(e);
            if (e.kind === 'command' && /restored/.test(e.words ?? '')) this.restored();
        });
        on('timeline', m => { this.timeline.setEvents(m.events); this.debriefing.timeline(m.events); });
        on('debriefing', d => this.debriefing.set(d));
        on('exercise', e => this.exercise.setExercise(e));
        on('faults', f => this.exercise.setFaults(f.faults));
        on('failure', f => this.paintFailure(f));
        on('error', e => { if (e.id === undefined || e.of !== 'pick') toast(e.reason); });
        on('broken', words => toast(`A frame could not be read: ${words}`));
    }

    paintLink(s) {
        const chip = $('link'), words = {connecting: t('connecting'), open: t('live'), lost: t('connection lost'), refused: t('refused')};
        chip.className = `chip ${s.state === 'open' ? 'good' : s.state === 'refused' ? 'bad' : 'wait'}`;
        chip.textContent = s.state === 'open' && this.scene ? `${t(this.scene.mode === 'recording' ? 'recording' : 'live')} · ${t(readable(this.scene.role.name)).toLowerCase()}` : words[s.state];
        $('lost').hidden = s.state === 'open' || s.state === 'connecting' && !this.wasLost;
        this.wasLost = s.state === 'lost' || s.state === 'refused' || this.wasLost && s.state !== 'open';
        if (s.state === 'lost') $('lost-text').textContent = `${s.reason ? `The program says: ${s.reason}. ` : 'The connection is lost. '}Trying again in ${(s.wait / 1000).toFixed(1)} s.`;
        if (s.state === 'refused') $('lost-text').textContent = `Refused: ${s.reason ?? 'no reason given'}. Use the address that hawser view prints, with its token.`;
    }

    setScene(scene) {
        const first = this.scene?.name !== scene.name;
        this.scene = scene;
        document.title = `${readable(scene.name)} – Hawser`;
        $('title').textContent = readable(scene.name);
        $('title').title = scene.description ?? '';
        this.stage.setScene(scene);
        this.levers.setScene(scene, scene.mode === 'live', this.stage.bodies.bodies.filter(b => b.role === 'ship').map(b => b.name.split('/')[0]));
        this.levers.keepsRequests = this.exercise.on;
        this.instruments.setScene(scene);
        this.plots.setScene(scene);
        if (first) this.inspector.clear();
        // Sticks move continuous controls: those that spring back like a stick first, a joystick as it
        // stands (sideways before ahead), ordered positions last.
        const rank = l => l.form === 'position' ? 3 : l.def.spring === null || l.def.spring === undefined ? 2 : /\.joystick_x$/.test(l.def.drives) ? 0.5 : 0;
        const names = this.levers.levers.filter(l => !l.buttons).map(l => ({name: l.def.name, rank: /\.joystick_n$/.test(l.def.drives) ? 1 : rank(l)})).sort((a, b) => a.rank - b.rank).map(l => l.name);
        this.pads.setMapping(memory.get(`pad.${scene.name}`, defaultMapping(names)));
        $('subject').replaceChildren(...this.stage.subjects().map(b => el('option', {value: b.id, textContent: readable(b.name.replace(/\/hull$/, ''))})));
        if (this.stage.subjectBody) $('subject').value = this.stage.subjectBody.id;
        $('pull').hidden = !this.mayControl;
        $('pull').setAttribute('aria-pressed', 'false');
        this.drag.mode(false);
        for (const id of ['play', 'step', 'rate']) $(id).disabled = !this.mayRun;
        document.querySelector('[data-panel="restore"]').hidden = scene.mode === 'recording';
        this.paintCamera();
        this.inset();
        this.paintLink({state: 'open'});
        this.paintLegend();
    }

    setState(s) {
        this.state = s;
        $('play-icon').setAttribute('d', s.paused ? kPlay : kPause);
        $('play-text').textContent = t(s.paused ? 'Go on' : 'Pause');
        $('play').setAttribute('aria-pressed', String(s.paused));
        if (document.activeElement !== $('rate')) $('rate').value = Math.log10(s.rate);
        $('rate-text').textContent = `×${Number(s.rate.toPrecision(2))}`;
        this.timeline.setRange(s.range);
        this.paintRestore();
        this.paintFailure(s.failure);
        this.briefing.paint();
    }

    paintFailure(f) {
        const box = $('failure'), was = box.hidden;
        if (!f) return void (box.hidden = true);
        if (this.closedFailure === f.time) return;
        const rows = [[t('Time'), clock(f.time)], [t('Element'), f.element || '–'], [t('What'), `${f.status}${f.reason ? `: ${f.reason}` : ''}`], [t('Remedy'), f.remedy || '–']];
        $('failure-text').replaceChildren(...rows.flatMap(([a, b]) => [el('dt', {textContent: a}), el('dd', {textContent: b})]));
        const back = $('failure-restore');
        back.hidden = !f.restore_point || !this.mayControl;
        back.textContent = `Restore “${f.restore_point}”`;
        this.failure = f;
        box.hidden = false;
        if (was) (back.hidden ? $('failure-close') : back).focus();
    }

    // --- Commands ---------------------------------------------------------------------------
    async ask(message, done) {
        const a = await this.link.ask(message);
        if (a.type !== 'error' && done) toast(done);
        return a;
    }
    /// After a restore: requests and alarms of before no longer hold.
    restored() {
        this.levers.forget();
        this.alarms.reset();
    }
    play() { if (this.mayRun) this.link.send({type: this.state.paused ? 'resume' : 'pause'}); }
    step() { if (this.mayRun) this.link.send({type: 'step', count: 1}); }
    rate(value) { this.link.send({type: 'rate', value: Math.min(10, Math.max(0.1, value))}); }
    save(name) { if (this.mayControl) this.ask({type: 'save', name}, `Saved “${name}”`); }
    restore(name) { if (this.mayControl) this.ask({type: 'restore', name}, `Restored “${name}”`); }
    restoreLast() { this.restore(this.state.restore_points.at(-1)?.name ?? 'start'); }
    part(what) { this.ask({type: 'part', wire: this.scene.wires[what.wire].id, s: what.share}); }

    command(name) {
        const nudge = steps => { this.levers.nudge(steps, 'button'); this.levers.letGo(this.levers.active, 'button'); };
        const run = {play: () => this.play(), step: () => this.step(), neutral: () => this.levers.neutral(), next: () => this.levers.next(1), less: () => nudge(-1), more: () => nudge(1), release: () => this.levers.release(), acknowledge: () => this.alarms.all(),
            previous: () => this.levers.next(-1), camera: () => this.camera(kModes[(kModes.indexOf(this.stage.rig.mode) + 1) % kModes.length])};
        if (kMoves[name]) this.levers.movePosition(...kMoves[name].map(v => v * kMove));
        run[name]?.();
    }

    camera(mode) {
        if (!this.stage.setMode(mode)) toast('Nothing here that a camera could go with');
        this.paintCamera();
    }

    followBody(body) {
        this.stage.follow(body);
        if (['free', 'top'].includes(this.stage.rig.mode)) this.stage.rig.setMode('follow', this.stage.subject);
        else this.stage.rig.setMode(this.stage.rig.mode, this.stage.subject);
        $('subject').value = body.id;
        this.paintCamera();
    }

    nextSubject() {
        const all = this.stage.subjects(), at = all.indexOf(this.stage.subjectBody);
        if (all.length) this.followBody(all[(at + 1) % all.length]);
    }

    paintCamera() {
        for (const b of $('cameras').children) {
            b.setAttribute('aria-checked', String(b.dataset.mode === this.stage.rig.mode));
            b.tabIndex = b.dataset.mode === this.stage.rig.mode ? 0 : -1;
        }
    }

    async screenshot() {
        this.stage.draw(performance.now());
        const blob = await this.stage.screenshot(), url = URL.createObjectURL(blob);
        const a = el('a', {href: url, download: `${this.scene?.name ?? 'hawser'}_${(this.frame?.time ?? 0).toFixed(1)}s.png`});
        a.click();
        setTimeout(() => URL.revokeObjectURL(url), 5000);
        toast('Picture saved');
    }

    useSi(si) {
        this.instruments.useSi(si);
        for (const lever of this.levers.levers) this.levers.paint(lever);
    }

    /// Set the colours of tension and of limits. @param name  Of colour.js.
    usePalette(name) {
        const {stops} = kPalettes[name] ?? kPalettes.standard;
        document.body.dataset.palette = name;
        this.stage.wires.palette(stops);
        $('legend-ramp').style.background = gradient(stops);
    }

    /// Open or close the menu of tools, on narrow pages.
    menu(on = !document.body.classList.contains('menu-open')) {
        document.body.classList.toggle('menu-open', on);
        $('menu').setAttribute('aria-expanded', String(on));
    }

    /// Show the picture alone, without panels, or all again.
    clean(on = !document.body.classList.contains('clean')) {
        document.body.classList.toggle('clean', on);
        this.resize();
    }

    dials() {
        this.instruments.toggle();
        $('dials').setAttribute('aria-pressed', String(this.instruments.open));
    }

    panel(id) {
        const box = $(id), open = box.hidden;
        for (const b of document.querySelectorAll('[data-panel]')) {
            const other = b.dataset.panel;
            if (other !== id && other !== 'plots') this.setPanel(other, false);
        }
        this.setPanel(id, open);
        if (open && id === 'keys') this.paintKeys();
        if (open && id === 'restore') this.paintRestore();
    }

    setPanel(id, open) {
        if (id === 'plots') {
            showPlots(open);
            this.inset();
        } else $(id).hidden = !open;
        document.querySelector(`[data-panel="${id}"]`).setAttribute('aria-expanded', String(open));
    }

    // --- The page ---------------------------------------------------------------------------
    bind() {
        $('play').addEventListener('click', () => this.play());
        $('step').addEventListener('click', () => this.step());
        $('rate').addEventListener('input', () => this.rate(10 ** Number($('rate').value)));
        $('rate').addEventListener('dblclick', () => this.rate(1));
        $('dials').addEventListener('click', () => this.dials());
        $('menu').addEventListener('click', () => this.menu());
        $('tools').addEventListener('click', () => this.menu(false));
        $('debrief').addEventListener('click', () => this.debriefing.toggle());
        $('shot').addEventListener('click', () => this.screenshot());
        $('pull').addEventListener('click', () => this.drag.mode(!this.drag.on));
        $('lost-retry').addEventListener('click', () => this.link.retry());
        $('failure-close').addEventListener('click', () => { $('failure').hidden = true; this.closedFailure = this.failure?.time; });
        $('failure-restore').addEventListener('click', () => { this.restore(this.failure.restore_point); $('failure').hidden = true; });
        $('subject').addEventListener('change', () => this.followBody(this.stage.bodies.byId.get(Number($('subject').value))));
        for (const b of document.querySelectorAll('[data-panel]')) b.addEventListener('click', () => this.panel(b.dataset.panel));
        $('cameras').append(...kModes.map((mode, i) => el('button', {role: 'radio', textContent: t(kCameraNames[mode]), title: `${t('Camera')}: ${t(kCameraNames[mode])} (${i + 1})`, onclick: () => this.camera(mode)})));
        [...$('cameras').children].forEach((b, i) => { b.dataset.mode = kModes[i]; });
        this.usePalette(memory.get('palette', 'standard'));
        $('legend-range').addEventListener('click', () => this.nextRange());
        let down = null;
        $('canvas').addEventListener('pointerdown', e => { down = {x: e.clientX, y: e.clientY, at: e.timeStamp}; });
        $('canvas').addEventListener('pointerup', e => {
            if (down && !this.drag.on && e.button === 0 && Math.hypot(e.clientX - down.x, e.clientY - down.y) < 6 && e.timeStamp - down.at < 700) this.pick(e.clientX, e.clientY);
            down = null;
        });
        bindKeys(this);
    }

    nextRange() {
        this.stage.full = kRanges[(kRanges.indexOf(this.stage.full) + 1) % kRanges.length];
        if (this.frame) this.stage.wires.fill(this.frame, this.stage.full);
        this.paintLegend();
    }

    paintLegend() {
        const {full} = this.stage, n = 5;
        $('legend-ticks').replaceChildren(...Array.from({length: n}, (_, i) => el('span', {textContent: `${i === n - 1 ? '≥ ' : ''}${+(100 * full * i / (n - 1)).toFixed(1)} %`})));
        $('legend').hidden = !this.scene?.wires.length;
    }

    pick(x, y) {
        const what = this.stage.pick(x, y);
        this.stage.choose(what);
        if (!what) return this.inspector.clear();
        this.inspector.show(what);
        if ($('plots').hidden) this.panel('plots');
    }

    resize() {
        const v = $('view'), ratio = Math.min(2, window.devicePixelRatio || 1);
        this.stage.resize(Math.max(1, v.clientWidth), Math.max(1, v.clientHeight), ratio);
        this.inset();
    }

    /// Centre the picture in the area without panels.
    inset() {
        const wide = $('view').clientWidth, of = box => box.offsetParent !== null || !box.hidden && getComputedStyle(box).display !== 'none' ? box.getBoundingClientRect() : null;
        const left = of($('levers')), right = of($('plots')) ?? of($('exercise'));
        this.stage.inset(left && left.width < 0.5 * wide ? left.right : 0, right && right.width < 0.5 * wide ? wide - right.left : 0);
    }

    tick(now) {
        requestAnimationFrame(t => this.tick(t));
        const begin = performance.now(), dt = Math.min(0.1, (now - (this.was ?? now)) / 1000);
        this.was = now;
        this.pads.poll();
        if (this.fresh && this.link.frame) {
            this.fresh = false;
            this.frame = this.link.frame;
            this.stage.take(this.frame);
            this.plots.take(this.frame, this.stage.bodies);
            this.timeline.update(this.frame.time);
            this.levers.keepsRequests = this.exercise.on;
            this.exercise.update(this.frame, now);
            this.instruments.update(this.frame, now);
            this.debriefing.update(this.frame);
            this.alarms.paint();
            if (!this.framed) this.briefing.paint(this.framed = true);
            $('time').textContent = clock(this.frame.time);
        }
        this.levers.update(now, dt, this.frame);
        this.drag.update(now);
        const before = performance.now();
        this.stage.draw(now);
        const drawn = performance.now();
        if (!$('plots').hidden) {
            this.inspector.update(now);
            this.plots.draw(now);
        }
        this.corner();
        const end = performance.now();
        this.script.ms += end - begin;
        this.script.draw = (this.script.draw ?? 0) + drawn - before;
        ++this.script.n;
        this.stage.quality.shown(now, end - begin);
    }

    /// Update compass, scale and pictures per second.
    corner() {
        const {stage} = this;
        $('needle').setAttribute('transform', `rotate(${(stage.rig.bearing() * 180 / Math.PI - 90).toFixed(1)})`);
        const per = stage.rig.perPixel(), want = 110 * per, unit = 10 ** Math.floor(Math.log10(want));
        const length = [5, 2, 1].map(k => k * unit).find(v => v <= want) ?? unit, aboard = stage.rig.aboardShip;
        $('scale').hidden = aboard;
        if (!aboard) {
            $('scale').firstElementChild.style.width = `${(length / per).toFixed(0)}px`;
            const words = quantity(length, 'm');
            if ($('scale').lastElementChild.textContent !== words) $('scale').lastElementChild.textContent = words;
        }
        if (this.was < (this.cornerDue ?? 0)) return;
        this.cornerDue = this.was + 500;
        $('frames').textContent = `${stage.quality.fps.toFixed(0)} ${t('pictures/s')} · ${t(stage.wires.asTubes ? 'tubes' : 'lines')}`;
    }
}

language.code = memory.get('language', null) ?? chooseLanguage(navigator.languages ?? []);
translatePage(document.body);
window.hawser = new App();
