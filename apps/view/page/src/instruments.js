// SPDX-License-Identifier: Apache-2.0
/// Instruments of a station: ship (heading, speed, turn, heel, depth, wind), propulsion, a card for each
/// winch (wire, tension against its limits, layer) and crane (radius, load, load moment), and the
/// displays of the exercise. They show values in force; controls show requests.
import {el, memory} from './dom.js';
import {Motion} from './motion.js';
import {largestTensions} from './protocol.js';
import {readable} from './roles.js';
import {bearing, shown, sided, units} from './units.js';

export const kWorkingShare = 0.5;   // of the breaking load: the working load that the mark shows
const kMostWinches = 4;
const kSvg = 'http://www.w3.org/2000/svg';

function svg(tag, props, ...children) {
    const e = document.createElementNS(kSvg, tag);
    for (const [key, value] of Object.entries(props)) e.setAttribute(key, value);
    e.append(...children);
    return e;
}

/// Return the prefix of names that belong to a station: that of most of its inputs, "" if none.
export function prefixOf(inputs) {
    const count = new Map();
    for (const name of inputs) {
        const cut = name.search(/[/.]/);
        if (cut > 0) count.set(name.slice(0, cut), (count.get(name.slice(0, cut)) ?? 0) + 1);
    }
    return [...count].sort((a, b) => b[1] - a[1])[0]?.[0] ?? '';
}

/// Return the winches to show: wires with a drum on the body, or systems with outputs `pull`.
/// @return [{name, wire: index or −1, system: name or ''}]
export function winchesOf(scene, body) {
    const found = scene.drums.filter(d => d.body === body).map(d => ({name: scene.wires[d.wire].name, wire: d.wire, system: ''}));
    const pulls = scene.outputs.filter(o => /\.pull$/.test(o.name)).map(o => o.name.slice(0, -5));
    for (const system of pulls) {
        const drum = scene.drums.find(d => d.name === system || d.name.startsWith(`${system}/`));
        const at = found.find(w => drum && w.wire === drum.wire);
        if (at) Object.assign(at, {system, name: system});
        else if (!drum || drum.body === body) found.push({name: system, wire: drum?.wire ?? -1, system});
    }
    for (const w of found)
        if (!w.system && scene.outputs.some(o => o.name === `${w.name}/feed.paid_out`)) w.feed = `${w.name}/feed`;
    return found.slice(0, kMostWinches);
}

/// Return the propulsors of a vessel from the names of outputs: "V.port_thrust" belongs to "port".
export function propulsorsOf(outputs, vessel) {
    const names = new Set(outputs.map(o => o.name)), own = [...names].filter(n => n.startsWith(`${vessel}.`) && n.endsWith('_thrust')).map(n => n.slice(vessel.length + 1, -7));
    return own.map(name => ({name, order: names.has(`${vessel}.${name}`), angle: names.has(`${vessel}.${name}_turned`) ? `${vessel}.${name}_turned` : names.has(`${vessel}.${name}_angle`) ? `${vessel}.${name}_angle` : ''}));
}

/// Return the cranes to show: systems with load and utilisation, of the ship if the prefix names one.
export function cranesOf(outputs, prefix) {
    const all = outputs.filter(o => /\.utilisation$/.test(o.name)).map(o => o.name.slice(0, -12)), own = all.filter(n => prefix && (n === prefix || n.startsWith(`${prefix}/`)));
    return (own.length ? own : all).slice(0, 2);
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

export class Instruments {
    constructor(box, app) {
        Object.assign(this, {box, app, due: 0, open: memory.get('instruments', true)});
        units.si = memory.get('si', false);
    }

    setScene(scene) {
        this.scene = scene;
        const names = scene.role.inputs === 'all' ? [] : scene.role.inputs;
        this.prefix = prefixOf(names);
        this.body = undefined;
        this.tensions = new Float32Array(scene.wires.length);
    }

    /// The ship of the station; without one that of the camera.
    ship() {
        const all = this.scene.bodies.filter(b => b.kind === 'rigid' && b.slot >= 0);
        return all.find(b => b.name === this.prefix) ?? all.find(b => this.prefix && b.name.startsWith(`${this.prefix}/hull`)) ?? this.app.stage.subjectBody ?? null;
    }

    build(ship) {
        const {scene} = this;
        this.body = ship?.id ?? null;
        this.slot = ship ? scene.bodies.find(b => b.id === ship.id)?.slot ?? -1 : -1;
        this.motion = new Motion();
        this.facts = {};
        const fact = (key, label) => (this.facts[key] = new Fact(label)).box;
        const parts = [];
        if (ship) {
            const needle = this.needle = svg('g', {}, svg('path', {d: 'M0-33 6 6 0 2-6 6z', class: 'ship'}));
            const rose = svg('svg', {viewBox: '-44 -44 88 88', class: 'rose', 'aria-hidden': 'true'}, svg('circle', {r: 41}),
                ...[...'NESW'].map((c, i) => { const t = svg('text', {x: 33 * Math.sin(i * Math.PI / 2), y: -33 * Math.cos(i * Math.PI / 2) + 3.5, 'text-anchor': 'middle'}); t.textContent = c; return t; }), needle);
            parts.push(el('section', {className: 'instrument ship', 'aria-label': `Ship ${readable(ship.name.replace(/\/hull$/, ''))}`}, rose,
                el('div', {className: 'facts2'}, fact('heading', 'Heading'), fact('speed', 'Speed (ground)'), fact('turn', 'Rate of turn'), fact('heel', 'Heel'), fact('course', 'Course'),
                    ...(scene.sea ? [fact('depth', 'Depth')] : []), ...(this.at('sea.wind') >= 0 ? [fact('wind', 'Wind')] : []), ...(this.water() >= 0 ? [fact('water', 'Speed (water)')] : []))));
        }
        if (ship) this.propulsors = this.propulsionCard(ship, parts);
        else this.propulsors = [];
        this.winches = ship ? winchesOf(scene, ship.id).map(w => this.winchCard(w, parts)) : [];
        this.cranes = cranesOf(scene.outputs, this.prefix).map(n => this.craneCard(n, parts));
        this.shownOutputs = this.exerciseCard(parts);
        this.box.replaceChildren(...parts);
        this.box.hidden = !parts.length || !this.open;
    }

    at(name) {
        return this.scene.outputs.findIndex(o => o.name === name);
    }
    /// Output of the speed through water of the ship: "NAME.speed" of a vessel.
    water() {
        const name = this.scene.bodies.find(b => b.id === this.body)?.name.split('/')[0];
        return name && this.at(`${name}.ground_speed`) >= 0 ? this.at(`${name}.speed`) : -1;
    }

    winchCard(w, parts) {
        const card = {...w, tension: new Fact('Tension'), out: new Fact(w.feed ? 'Paid out' : 'Wire out'), layer: w.system ? new Fact('Layer') : null, speed: new Fact('Speed')};
        const breaking = w.wire >= 0 ? this.scene.wires[w.wire].breaking_load : 0;
        card.bar = el('div', {className: 'bar'}, el('i', {}), el('u', {}));
        card.bar.hidden = !(breaking > 0);
        card.bar.lastElementChild.style.left = `${100 * kWorkingShare}%`;
        card.bar.title = breaking > 0 ? `Breaking load ${shown(breaking, 'N')}, working load ${shown(kWorkingShare * breaking, 'N')}` : '';
        card.breaking = breaking;
        parts.push(el('section', {className: 'instrument winch', 'aria-label': `Winch ${readable(w.name)}`}, el('h3', {textContent: readable(w.name)}), card.bar,
            el('div', {className: 'facts2'}, card.tension.box, card.out.box, card.speed.box, ...(card.layer ? [card.layer.box] : []))));
        return card;
    }

    propulsionCard(ship, parts) {
        const vessel = ship.name.split('/')[0], found = propulsorsOf(this.scene.outputs, vessel).slice(0, 8).map(p => ({...p, vessel, fact: new Fact(readable(p.name))}));
        if (found.length) parts.push(el('section', {className: 'instrument', 'aria-label': 'Propulsion'}, el('div', {className: 'facts2 one'}, ...found.map(p => p.fact.box))));
        return found;
    }

    craneCard(name, parts) {
        const card = {name, load: new Fact('Load'), rated: new Fact('Rated'), radius: new Fact('Radius'), bar: el('div', {className: 'bar', title: 'Load moment: load over rated load'}, el('i', {}))};
        parts.push(el('section', {className: 'instrument winch', 'aria-label': `Crane ${readable(name)}`}, el('h3', {textContent: readable(name)}), card.bar,
            el('div', {className: 'facts2'}, card.load.box, card.rated.box, card.radius.box)));
        return card;
    }

    paintCrane(c, frame) {
        const read = name => this.at(`${c.name}.${name}`) >= 0 ? frame.outputs[this.at(`${c.name}.${name}`)] : NaN, share = read('utilisation');
        c.load.set(shown(read('load'), 'kg'));
        c.rated.set(shown(read('rated'), 'kg'));
        c.radius.set(shown(read('radius'), 'm'));
        c.bar.className = `bar ${share >= 1 ? 'danger' : share >= 0.9 ? 'warn' : 'good'}`;
        c.bar.firstElementChild.style.width = `${100 * Math.min(1, Math.max(0, share || 0))}%`;
    }

    paintPropulsion(p, frame) {
        const read = name => this.at(name) >= 0 ? frame.outputs[this.at(name)] : NaN, order = p.order ? read(`${p.vessel}.${p.name}`) : NaN, angle = p.angle ? read(p.angle) : NaN;
        p.fact.set([Number.isFinite(order) ? `${Math.round(100 * order)} %` : '', shown(read(`${p.vessel}.${p.name}_thrust`), 'N', 'thrust'), Number.isFinite(angle) ? shown(angle, 'rad') : ''].filter(Boolean).join('  '));
    }

    exerciseCard(parts) {
        const names = (this.app.exercise?.exercise?.displays ?? []).filter(n => this.at(n) >= 0);
        if (!names.length) return [];
        const facts = names.map(n => ({fact: new Fact(readable(n)), at: this.at(n), name: n}));
        parts.push(el('section', {className: 'instrument', 'aria-label': 'Displays of the exercise'}, el('div', {className: 'facts2'}, ...facts.map(f => f.fact.box))));
        return facts;
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
        if (this.body === undefined || (ship?.id ?? null) !== this.body) this.build(ship);
        if (this.slot >= 0) this.motion.take(frame.time, frame.rigid.subarray(7 * this.slot, 7 * this.slot + 3), frame.rigid.subarray(7 * this.slot + 3, 7 * this.slot + 7));
        if (now < this.due || this.box.hidden) return;
        this.due = now + 250;
        this.paintShip(frame);
        largestTensions(frame, this.tensions);
        for (const w of this.winches) this.paintWinch(w, frame);
        for (const p of this.propulsors) this.paintPropulsion(p, frame);
        for (const c of this.cranes) this.paintCrane(c, frame);
        for (const d of this.shownOutputs) d.fact.set(shown(frame.outputs[d.at], this.scene.outputs[d.at].unit, d.name));
    }

    paintShip(frame) {
        const m = this.slot >= 0 ? this.motion.read() : null, {facts, scene} = this;
        if (!m) return;
        this.needle.setAttribute('transform', `rotate(${m.heading.toFixed(1)})`);
        facts.heading.set(bearing(m.heading));
        facts.speed.set(shown(m.speed, 'm/s', 'ground'));
        facts.turn.set(Number.isFinite(m.rate) ? `${sided(m.rate, 'S', 'P')}/min` : '–');
        facts.heel.set(sided(m.heel, 'S', 'P'));
        facts.course.set(m.speed > 0.05 ? bearing(m.course) : '–');
        facts.depth?.set(shown(scene.sea.depth, 'm'));
        facts.wind?.set(this.wind(frame));
        facts.water?.set(shown(frame.outputs[this.water()], 'm/s', 'through'));
    }

    /// Wind in force, gusts included, and the direction from which it comes.
    wind(frame) {
        const read = name => this.at(name) >= 0 ? frame.outputs[this.at(name)] : NaN;
        const gust = read('sea.gust'), speed = Number.isFinite(gust) && gust > 0 ? gust : read('sea.wind'), to = read('sea.wind_direction');
        return `${shown(speed, 'm/s', 'wind')}${Number.isFinite(to) ? ` ${bearing(270 - to * 180 / Math.PI)}` : ''}`;
    }

    paintWinch(w, frame) {
        const read = name => this.at(name) >= 0 ? frame.outputs[this.at(name)] : NaN;
        const pull = w.system ? read(`${w.system}.pull`) : NaN, tension = w.wire >= 0 ? this.tensions[w.wire] : NaN;
        const force = Number.isFinite(pull) ? Math.max(pull, Number.isFinite(tension) ? tension : -Infinity) : tension, bar = tensionBar(force, w.breaking);
        w.tension.set(force < 0 ? 'broken' : `${shown(force, 'N', 'tension')}${bar ? ` (${bar.percent} %)` : ''}`);
        if (bar) {
            w.bar.firstElementChild.style.width = `${100 * bar.share}%`;
            w.bar.className = `bar ${bar.state}`;
        }
        const out = w.system ? this.wireOut(w, frame) : read(`${w.feed}.paid_out`);
        w.out.set(shown(out, 'm'));
        if (Number.isFinite(w.before?.out) && frame.time > w.before.time) w.speed.set(shown((out - w.before.out) / (frame.time - w.before.time), 'm/s', 'wire'));
        w.before = {out, time: frame.time};
        w.layer?.set(Number.isFinite(read(`${w.system}.layer`)) ? String(read(`${w.system}.layer`)) : '–');
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
