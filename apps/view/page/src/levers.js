// SPDX-License-Identifier: Apache-2.0
/// The controls: one slider for each input, by group, with value, range and unit. A control with a
/// spring returns to neutral after its release by pointer, touch, keys or gamepad.
import {el, memory} from './dom.js';
import {groupLevers, leverRange, neutral, nudge, quantity, springHome, toDeflection, valueWords, fromDeflection, Throttle} from './lever_logic.js';
import {readable} from './roles.js';

export class Levers {
    constructor(panel, send) {
        this.panel = panel;
        this.throttle = new Throttle(send);
        this.levers = [];
        this.active = 0;
    }

    /// @param first  Groups at the top, such as ships.
    setScene(scene, live, first = []) {
        const kept = this.levers[this.active]?.def.name;
        this.panel.replaceChildren(el('h2', {textContent: 'Levers'}));
        this.levers = [];
        const may = scene.role.inputs, mine = i => i.mine ?? (may === 'all' || may.includes(i.name));
        const shown = scene.inputs.map((def, index) => ({...def, index})).filter(i => i.kind !== 'inner' && mine(i));
        document.body.classList.toggle('levers-none', !shown.length || !live);
        if (!shown.length) return;
        const rank = ([g]) => first.includes(g) ? 0 : 1;
        const groups = [...groupLevers(shown)].sort((a, b) => rank(a) - rank(b));
        const closed = new Set(memory.get(`closed.${scene.name}`, shown.length > 14 ? groups.slice(2).map(([g]) => g) : []));
        for (const [group, members] of groups) {
            const box = el('details', {className: 'lever-group', open: !closed.has(group)}, el('summary', {textContent: readable(group)}));
            box.addEventListener('toggle', () => {
                if (box.open) closed.delete(group);
                else closed.add(group);
                memory.set(`closed.${scene.name}`, [...closed]);
            });
            for (const m of members) box.append(this.make(shown[m], group));
            this.panel.append(box);
        }
        const again = this.levers.findIndex(l => l.def.name === kept);
        this.activate(Math.max(0, again));
    }

    make(def, group) {
        const range = leverRange(def), vague = / or /.test(def.unit ?? ''), unit = vague ? '' : def.unit === '1' ? '' : def.unit, at = this.levers.length, id = `lever-${at}`;
        const rest = def.spring ?? neutral(range), own = def.name.startsWith(`${group}/`) || def.name.startsWith(`${group}.`) ? def.name.slice(group.length + 1) : def.name;
        const slider = el('input', {type: 'range', id, min: range[0], max: range[1], step: def.words?.length ? 1 : 'any', value: def.value ?? rest});
        const output = el('output', {htmlFor: id});
        const ends = el('div', {className: 'ends', 'aria-hidden': 'true'}, el('span', {textContent: valueWords(def, range[0], unit)}),
            el('span', {className: 'home', textContent: def.spring === null || def.spring === undefined ? vague ? def.unit : '' : `springs to ${valueWords(def, def.spring, unit)}`}),
            el('span', {textContent: valueWords(def, range[1], unit)}));
        const element = el('div', {className: 'lever'}, el('div', {className: 'head'}, el('label', {for: id, textContent: readable(own), title: def.name}), output), slider, ends);
        const lever = {def, unit, range, rest, slider, output, element, value: Number(slider.value), held: new Set(), sent: null, until: 0};
        this.levers.push(lever);
        slider.dataset.input = def.name;
        slider.addEventListener('input', () => this.move(at, Number(slider.value)));
        slider.addEventListener('pointerdown', () => {
            this.activate(at);
            this.hold(at, 'pointer');
        });
        for (const name of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur'])
            slider.addEventListener(name, () => this.letGo(at, 'pointer'));
        slider.addEventListener('focus', () => this.activate(at));
        slider.addEventListener('keydown', e => this.key(e, at));
        slider.addEventListener('keyup', e => this.letGo(at, e.key));
        slider.addEventListener('dblclick', () => this.move(at, rest));
        this.paint(lever);
        return element;
    }

    key(e, at) {
        const lever = this.levers[at], steps = {ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 5, PageDown: -5}[e.key];
        let to = null;
        if (steps) to = nudge(lever.range, lever.value, steps, lever.def.words?.length > 0);
        else if (e.key === 'Home') to = lever.range[0];
        else if (e.key === 'End') to = lever.range[1];
        else if (e.key === '0' || e.key === 'Backspace') to = lever.rest;
        if (to === null || e.ctrlKey || e.altKey || e.metaKey) return;
        e.preventDefault();
        e.stopPropagation();
        if (steps) this.hold(at, e.key);
        this.move(at, to);
    }

    hold(at, by) {
        this.levers[at].held.add(by);
    }

    letGo(at, by) {
        this.levers[at]?.held.delete(by);
    }

    activate(at) {
        this.levers[this.active]?.element.classList.remove('active');
        this.active = at;
        this.levers[at]?.element.classList.add('active');
    }

    /// Move a control by keys outside its slider.
    next(by) {
        if (!this.levers.length) return;
        this.activate((this.active + by + this.levers.length) % this.levers.length);
        this.levers[this.active].element.scrollIntoView({block: 'nearest'});
        return this.levers[this.active];
    }

    nudge(steps, by) {
        const lever = this.levers[this.active];
        if (!lever) return;
        this.hold(this.active, by);
        this.move(this.active, nudge(lever.range, lever.value, steps, lever.def.words?.length > 0));
    }

    neutral() {
        if (this.levers[this.active]) this.move(this.active, this.levers[this.active].rest);
    }

    /// Move a control by a stick: deflection −1 to 1.
    deflect(at, d, holding) {
        const lever = this.levers[at];
        if (!lever) return;
        if (holding) this.hold(at, 'pad');
        else this.letGo(at, 'pad');
        this.move(at, fromDeflection(lever.range, d));
    }

    move(at, value) {
        const lever = this.levers[at];
        if (lever?.def.words?.length) value = Math.round(value);
        if (!lever || value === lever.value) return;
        lever.value = value;
        lever.until = performance.now() + 700;
        lever.slider.value = value;
        this.paint(lever);
        this.throttle.set(lever.def.name, value);
    }

    /// Update for each picture: springs, values that others have set, values to send.
    update(now, dt, frame) {
        for (const [at, lever] of this.levers.entries()) {
            const springs = lever.def.spring !== null && lever.def.spring !== undefined;
            if (springs && !lever.held.size && lever.until && lever.value !== lever.rest) {
                const about = lever.range.map(v => v - lever.rest);
                this.move(at, lever.rest + springHome(about, lever.value - lever.rest, dt));
            } else if (frame && !lever.held.size && now > lever.until) {
                const value = frame.inputs[lever.def.index];
                if (Number.isFinite(value) && Math.abs(value - lever.value) > 1e-6 * (lever.range[1] - lever.range[0])) {
                    lever.value = value;
                    lever.slider.value = value;
                    this.paint(lever);
                }
            }
        }
        this.throttle.flush(now);
    }

    paint(lever) {
        const {slider, range, value, def} = lever, of = v => 100 * (v - range[0]) / (range[1] - range[0]);
        const words = valueWords(lever.def, value, lever.unit);
        lever.output.textContent = words;
        slider.setAttribute('aria-valuetext', words);
        const a = Math.min(of(lever.rest), of(value)), b = Math.max(of(lever.rest), of(value)), grey = 'rgb(255 255 255 / 22%)';
        slider.style.setProperty('--fill', `linear-gradient(to right, ${grey} ${a}%, #7cc0e8 ${a}%, #7cc0e8 ${b}%, ${grey} ${b}%)`);
    }

    deflection(at) {
        return toDeflection(this.levers[at].range, this.levers[at].value);
    }
}
