// SPDX-License-Identifier: Apache-2.0
/// Instruments of a station: ship (heading, speed, turn, heel, depth, wind), propulsion, a card for each
/// winch (wire, tension against its limits, layer) and crane (radius, load, load moment), DP desk,
/// stability gauge, switchboards. They show values in force; controls show requests.
import {el, memory, svg} from './dom.js';
import {Motion} from './motion.js';
import {largestTensions} from './protocol.js';
import {readable} from './roles.js';
import {bearing, shown, sided, units} from './units.js';
import {stationBody, winchOfDrum} from './vessel.js';
import {DpCard, PowerCard, PropulsionCard, StabilityCard} from './vessel_cards.js';
import {t} from './words.js';

export const kWorkingShare = 0.5;   // of the breaking load: the working load that the mark shows
const kMostWinches = 4;
/// Return the prefix of names that belong to a station: that of most of its inputs, "" if none.
export function prefixOf(inputs) {
    const count = new Map();
    for (const name of inputs) {
        const cut = name.search(/[/.]/);
        if (cut > 0) count.set(name.slice(0, cut), (count.get(name.slice(0, cut)) ?? 0) + 1);
    }
    return [...count].sort((a, b) => b[1] - a[1])[0]?.[0] ?? '';
}

/// True if the wire of a drum stands for a hydraulic cylinder.
export const isCylinder = drum => /\/cylinder$/.test(drum.name);

/// Return the winches to show: wires with a drum on the body, or systems with outputs `pull`.
/// @return [{name, wire: index or −1, system: name or ''}]
export function winchesOf(scene, body) {
    const found = scene.drums.filter(d => d.body === body && !isCylinder(d)).map(d => ({name: scene.wires[d.wire].name, wire: d.wire, system: winchOfDrum(scene, d)}));
    const pulls = scene.outputs.filter(o => /\.pull$/.test(o.name)).map(o => o.name.slice(0, -5));
    for (const system of pulls) {
        if (found.some(w => w.system === system)) continue;
        const drum = scene.drums.find(d => d.name === system || d.name.startsWith(`${system}/`) || winchOfDrum(scene, d) === system);
        const at = found.find(w => drum && w.wire === drum.wire);
        if (at) Object.assign(at, {system, name: system});
        else if (!drum || drum.body === body) found.push({name: system, wire: drum?.wire ?? -1, system});
    }
    for (const w of found)
        if (!w.system && scene.outputs.some(o => o.name === `${w.name}/feed.paid_out`)) w.feed = `${w.name}/feed`;
    return found.slice(0, kMostWinches);
}

/// Return the cranes to show: systems with load and utilisation, of the ship if the prefix names one.
export function cranesOf(outputs, prefix) {
    const names = new Set(outputs.map(o => o.name)), all = outputs.filter(o => /\.utilisation$/.test(o.name)).map(o => o.name.slice(0, -12)).filter(n => !names.has(`${n}.permissible`) && !names.has(`${n}.capacity`)), own = all.filter(n => prefix && (n === prefix || n.startsWith(`${prefix}/`)));
    return (own.length ? own : all).slice(0, 2);
}

/// Return the stability gauges to show: those of the ship, or all of a scene that does not name their ships.
export function gaugesOf(scene, body) {
    const all = scene.outputs.filter(o => o.name.endsWith('.permissible')).map(o => o.name.slice(0, -12));
    return all.filter(name => (scene.gauges?.find(g => g.name === name)?.body ?? body) === body);
}

/// Return the body that carries a crane: its bodies are jointed to it; undefined: not known.
export function craneHost(scene, name) {
    const own = new Set(scene.bodies.filter(b => b.name.startsWith(`${name}/`)).map(b => b.id));
    const joint = (scene.joints ?? []).find(j => own.has(j.bodies[0]) !== own.has(j.bodies[1]));
    return joint?.bodies.find(b => !own.has(b));
}

/// Fractions of a tension bar: value and working load of the breaking load; null without one.
export function tensionBar(tension, breaking) {
    if (!(breaking > 0)) return null;
    const share = Math.max(0, tension) / breaking;
    return {share: Math.min(1, share), percent: Math.round(100 * share), state: share >= 0.9 ? 'danger' : share >= kWorkingShare ? 'warn' : 'good'};
}

class Fact {
    constructor(label) {
        this.value = el('b', {textContent: '–'});
        this.box = el('div', {className: 'fact'}, el('span', {textContent: label}), this.value);
    }
    set(words) {
        if (this.value.textContent !== words) this.value.textContent = words;
    }
}

/// Order of the cards by layout of the station.
export const kOrder = {
    bridge: ['ship', 'propulsion', 'dp', 'winch', 'stability', 'crane', 'power'],
    winch: ['winch', 'stability', 'ship', 'propulsion', 'dp', 'crane'],
    crane: ['crane', 'ship', 'winch', 'stability'],
    engine_room: ['power', 'propulsion', 'ship'],
    instructor: ['ship', 'propulsion', 'dp', 'winch', 'stability', 'crane', 'power'],
    '': ['ship', 'winch', 'crane', 'propulsion', 'dp', 'stability', 'power'],
};
const kWinchModes = ['speed', 'tension', 'render', 'brake', 'free', 'release', 'heave'];

export class Instruments {
    constructor(box, app) {
        Object.assign(this, {box, app, due: 0, open: memory.get('instruments', true)});
        units.si = memory.get('si', false);
        new ResizeObserver(() => document.body.style.setProperty('--console', `${this.box.hidden ? 0 : this.box.offsetHeight + 8}px`)).observe(box);
    }

    setScene(scene) {
        this.scene = scene;
        const names = scene.role.inputs === 'all' ? [] : scene.role.inputs;
        this.prefix = prefixOf(names);
        this.home = stationBody(scene, names);
        this.body = undefined;
        this.places = new Map(scene.outputs.map((o, i) => [o.name, i]));
        this.tensions = new Float32Array(scene.wires.length);
    }

    /// Layout of the role: that of its station in the exercise, "instructor", or "".
    get layout() {
        const role = this.scene.role, station = this.app.exercise.exercise?.stations.find(s => s.name === role.name);
        return station?.layout || (role.name === 'instructor' && this.app.exercise.on ? 'instructor' : '');
    }

    /// The ship of the station; without one that of the camera.
    ship() {
        const all = this.scene.bodies.filter(b => b.kind === 'rigid' && b.slot >= 0);
        return all.find(b => b.id === this.home) ?? all.find(b => b.name === this.prefix) ?? all.find(b => this.prefix && b.name.startsWith(`${this.prefix}/hull`)) ?? this.app.stage.subjectBody ?? null;
    }

    build(ship) {
        const {scene} = this;
        this.body = ship?.id ?? null;
        const body = scene.bodies.find(b => b.id === ship?.id);
        this.slot = body?.slot ?? -1;
        this.vessel = scene.vessels?.find(v => v.body === this.body) ?? null;
        this.motion = new Motion();
        this.facts = {};
        const cards = {ship: ship ? [this.shipCard(ship)] : [], propulsion: [], dp: [], stability: [], power: []}, drawn = this.drawn = [];
        const add = (key, card) => { cards[key].push(card.box); drawn.push(card); };
        const half = body?.half_size?.some(v => v > 0) ? body.half_size : [40, 9, 4];
        if (this.vessel?.propulsors.length) add('propulsion', new PropulsionCard(this.vessel, half));
        if (this.vessel && this.at(`${this.vessel.name}.mode_now`) >= 0) add('dp', this.dp = new DpCard(this.vessel));
        else this.dp = null;
        for (const name of gaugesOf(scene, this.body)) add('stability', new StabilityCard(name));
        if (this.vessel?.boards.length) add('power', new PowerCard(this.vessel));
        cards.winch = [];
        cards.crane = [];
        this.winches = ship ? winchesOf(scene, ship.id).map(w => this.winchCard(w, cards.winch)) : [];
        const aboard = name => !['bridge', 'winch', 'engine_room'].includes(this.layout) || (craneHost(scene, name) ?? this.body) === this.body;
        this.cranes = cranesOf(scene.outputs, this.prefix).filter(aboard).map(n => this.craneCard(n, cards.crane));
        this.laid = this.layout;
        const parts = (kOrder[this.laid] ?? kOrder['']).flatMap(key => cards[key] ?? []);
        this.box.className = this.laid ? `console ${this.laid}` : 'console';
        this.box.replaceChildren(...parts);
        this.box.hidden = !parts.length || !this.open;
    }

    at(name) {
        return this.places.get(name) ?? -1;
    }
    /// Output of the speed through water of the ship: "NAME.speed" of a vessel.
    water() {
        return this.vessel && this.at(`${this.vessel.name}.ground_speed`) >= 0 ? this.at(`${this.vessel.name}.speed`) : -1;
    }

    shipCard(ship) {
        const {scene} = this, fact = (key, label) => (this.facts[key] = new Fact(t(label))).box;
        const needle = this.needle = svg('path', {d: 'M0-33 7 8 0 3-7 8z', class: 'ship'}), order = this.order = svg('path', {d: 'M0-36-4-43H4z', class: 'bug', display: 'none'});
        const rose = svg('svg', {viewBox: '-46 -46 92 92', class: 'rose', 'aria-hidden': 'true'}, svg('circle', {r: 42}),
            ...Array.from({length: 12}, (_, i) => svg('path', {d: 'M0-42V-38', transform: `rotate(${30 * i})`, class: 'tick'})),
            ...[...'NESW'].map((c, i) => { const e = svg('text', {x: 31 * Math.sin(i * Math.PI / 2), y: -31 * Math.cos(i * Math.PI / 2) + 3.5, 'text-anchor': 'middle'}); e.textContent = c; return e; }), needle, order);
        return el('section', {className: 'instrument ship', 'aria-label': `${t('Ship')} ${readable(ship.name.replace(/\/hull$/, ''))}`},
            el('div', {className: 'heading'}, rose, el('small', {textContent: t('Heading')}), this.big = el('output', {className: 'big', textContent: '–'})),
            el('div', {className: 'facts2 one'}, fact('speed', 'Speed (ground)'), ...(this.water() >= 0 ? [fact('water', 'Speed (water)')] : []), fact('course', 'Course (ground)'), fact('turn', 'Rate of turn'), fact('heel', 'Heel'),
                ...(scene.sea ? [fact('depth', 'Depth')] : []), ...(this.at('sea.wind') >= 0 ? [fact('wind', 'Wind')] : [])));
    }

    winchCard(w, parts) {
        const facts = {tension: 'Tension', out: w.feed ? 'Paid out' : 'Wire out', speed: 'Wire speed', ...(w.system ? {layer: 'Drum layer', left: 'Left on drum', mode: 'Mode', brake: 'Brake'} : {})};
        const card = {...w, facts: Object.fromEntries(Object.entries(facts).filter(([key]) => !w.system || key !== 'left' || this.at(`${w.system}.wire_left`) >= 0).map(([key, label]) => [key, new Fact(t(label))]))};
        const breaking = card.breaking = w.wire >= 0 ? this.scene.wires[w.wire].breaking_load : 0;
        card.bar = el('div', {className: 'bar'}, el('i', {}), el('u', {}));
        card.bar.lastElementChild.style.left = `${100 * kWorkingShare}%`;
        card.bar.title = breaking > 0 ? `${t('Breaking load')} ${shown(breaking, 'N')}, ${t('working load')} ${shown(kWorkingShare * breaking, 'N')}` : '';
        card.limits = el('div', {className: 'limits'}, el('span', {textContent: '0'}), el('span', {textContent: `WLL ${shown(kWorkingShare * breaking, 'N', 'tension')}`}), el('span', {textContent: `MBL ${shown(breaking, 'N', 'tension')}`}));
        card.bar.hidden = card.limits.hidden = !(breaking > 0);
        parts.push(el('section', {className: 'instrument winch', 'aria-label': `${t('Winch')} ${t(readable(w.system || w.name))}`}, el('h3', {textContent: t(readable(w.system || w.name))}), card.bar, card.limits,
            el('div', {className: 'facts2 one'}, ...Object.values(card.facts).map(f => f.box))));
        return card;
    }

    craneCard(name, parts) {
        const card = {name, load: new Fact(t('Load')), rated: new Fact(t('Rated load')), radius: new Fact(t('Radius')), share: new Fact(t('Load moment')), bar: el('div', {className: 'bar', title: t('Load over rated load')}, el('i', {}))};
        parts.push(el('section', {className: 'instrument winch', 'aria-label': `${t('Crane')} ${readable(name)}`}, el('h3', {textContent: t(readable(name))}), card.bar,
            el('div', {className: 'facts2 one'}, card.load.box, card.rated.box, card.radius.box, card.share.box)));
        return card;
    }

    paintCrane(c, read) {
        const of = name => read(`${c.name}.${name}`), share = of('utilisation');
        c.load.set(shown(of('load'), 'kg'));
        c.rated.set(shown(of('rated'), 'kg'));
        c.radius.set(shown(of('radius'), 'm'));
        c.share.set(Number.isFinite(share) ? `${Math.round(100 * share)} %` : '–');
        c.bar.className = `bar ${share >= 1 ? 'danger' : share >= 0.9 ? 'warn' : 'good'}`;
        c.bar.firstElementChild.style.width = `${100 * Math.min(1, Math.max(0, share || 0))}%`;
    }

    toggle(on = !this.open) {
        this.open = on;
        memory.set('instruments', on);
        this.box.hidden = !on || !this.box.children.length;
    }

    useSi(si) {
        units.si = si;
        memory.set('si', si);
        this.body = undefined;
    }

    /// Update with a frame; digits change four times a second.
    update(frame, now) {
        if (!this.scene || !frame) return;
        const ship = this.ship();
        if (this.body === undefined || (ship?.id ?? null) !== this.body || this.laid !== this.layout) this.build(ship);
        const read = name => this.at(name) >= 0 ? frame.outputs[this.at(name)] : NaN, k = 7 * this.slot;
        if (this.slot >= 0) this.motion.take(frame.time, frame.rigid.subarray(k, k + 3), frame.rigid.subarray(k + 3, k + 7));
        this.dp?.take(read, frame, this.slot >= 0 ? frame.rigid.subarray(k, k + 2) : null);
        if (now < this.due || this.box.hidden) return;
        this.due = now + 250;
        this.paintShip(frame, read);
        largestTensions(frame, this.tensions);
        for (const w of this.winches) this.paintWinch(w, frame, read);
        for (const card of this.drawn) card.paint(read, frame);
        for (const c of this.cranes) this.paintCrane(c, read);
    }

    paintShip(frame, read) {
        const m = this.slot >= 0 ? this.motion.read() : null, {facts, scene} = this;
        if (!m) return;
        this.needle.setAttribute('transform', `rotate(${m.heading.toFixed(1)})`);
        const ordered = this.vessel ? 90 + read(`${this.vessel.name}.heading_order`) * 180 / Math.PI : NaN, mode = this.vessel ? read(`${this.vessel.name}.mode_now`) : 0;
        if (mode >= 1.5 && Number.isFinite(ordered)) this.order.setAttribute('transform', `rotate(${ordered.toFixed(1)})`);
        this.order.setAttribute('display', mode >= 1.5 && Number.isFinite(ordered) ? 'inline' : 'none');
        if (this.big.textContent !== bearing(m.heading)) this.big.textContent = bearing(m.heading);
        facts.speed.set(shown(m.speed, 'm/s', 'ground'));
        facts.turn.set(Number.isFinite(m.rate) ? `${sided(m.rate, 'S', 'P')}/min` : '–');
        facts.heel.set(sided(m.heel, 'S', 'P'));
        facts.course.set(m.speed > 0.05 ? bearing(m.course) : '–');
        facts.depth?.set(shown(scene.sea.depth, 'm'));
        facts.wind?.set(this.wind(read));
        facts.water?.set(shown(read(scene.outputs[this.water()].name), 'm/s', 'through'));
    }

    /// Wind in force, the mean and its gust, and the direction from which it comes.
    wind(read) {
        const gust = read('sea.gust'), speed = Math.max(0, read('sea.wind') + (Number.isFinite(gust) ? gust : 0)), to = read('sea.wind_direction');
        return `${shown(speed, 'm/s', 'wind')}${Number.isFinite(to) ? ` ${bearing(270 - to * 180 / Math.PI)}` : ''}`;
    }

    paintWinch(w, frame, read) {
        const of = name => w.system ? read(`${w.system}.${name}`) : NaN, {facts} = w;
        const pull = of('pull'), tension = w.wire >= 0 ? this.tensions[w.wire] : NaN;
        const force = Number.isFinite(pull) ? Math.max(pull, Number.isFinite(tension) ? tension : -Infinity) : tension, bar = tensionBar(force, w.breaking);
        facts.tension.set(force < 0 ? t('broken') : `${shown(force, 'N', 'tension')}${bar ? ` (${bar.percent} %)` : ''}`);
        if (bar) {
            w.bar.firstElementChild.style.width = `${100 * bar.share}%`;
            w.bar.className = `bar ${bar.state}`;
        }
        const own = of('wire_out'), out = Number.isFinite(own) ? own : w.system ? this.wireOut(w, frame) : read(`${w.feed}.paid_out`);
        facts.out.set(shown(out, 'm'));
        const speed = of('wire_speed');
        if (Number.isFinite(speed)) facts.speed.set(shown(speed, 'm/s', 'wire'));
        else if (Number.isFinite(w.before?.out) && frame.time > w.before.time) facts.speed.set(shown((out - w.before.out) / (frame.time - w.before.time), 'm/s', 'wire'));
        w.before = {out, time: frame.time};
        facts.layer?.set(Number.isFinite(of('layer')) ? String(of('layer')) : '–');
        facts.left?.set(shown(of('wire_left'), 'm'));
        facts.mode?.set(kWinchModes[Math.round(of('mode'))] ? t(`winch ${kWinchModes[Math.round(of('mode'))]}`) : '–');
        facts.brake?.set(Number.isFinite(of('brake')) ? Math.round(of('mode')) === 3 ? `${t('on')} ${Math.round(100 * of('brake'))} %` : t('off') : '–');
    }

    /// Length of a winch's wire that is out: between its points in the picture.
    wireOut(w, frame) {
        if (w.wire < 0) return NaN;
        let at = 0;
        for (let i = 0; i < w.wire; ++i) at += frame.counts[i];
        let length = 0;
        for (let k = at + 1; k < at + frame.counts[w.wire]; ++k) length += Math.hypot(...[0, 1, 2].map(c => frame.wirePoints[3 * k + c] - frame.wirePoints[3 * k - 3 + c]));
        return length;
    }
}
