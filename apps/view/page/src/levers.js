// SPDX-License-Identifier: Apache-2.0
/// The controls, by group: buttons for a choice, a switch for two values, otherwise a slider with
/// range and unit. A control with a spring returns to neutral after its release by pointer, touch, keys
/// or gamepad. A control shows the request; a line below it shows another value in force.
import {el, memory} from './dom.js';
import {groupLevers, leverRange, neutral, nudge, springHome, toDeflection, valueWords, fromDeflection, Throttle} from './lever_logic.js';
import {readable} from './roles.js';
import {shown} from './units.js';

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
        if (def.words?.length) return this.makeChoice(def, range, rest, own, at, id);
        const slider = el('input', {type: 'range', id, min: range[0], max: range[1], step: 'any', value: def.value ?? rest});
        const output = el('output', {htmlFor: id});
        const ends = el('div', {className: 'ends', 'aria-hidden': 'true'}, el('span', {textContent: shown(range[0], unit, def.name)}),
            el('span', {className: 'home', textContent: def.spring === null || def.spring === undefined ? vague ? def.unit : '' : `springs to ${shown(def.spring, unit, def.name)}`}),
            el('span', {textContent: shown(range[1], unit, def.name)}));
        const element = el('div', {className: 'lever'}, el('div', {className: 'head'}, el('label', {for: id, textContent: readable(own), title: def.name}), output), slider, ends, el('small', {className: 'force', hidden: true}));
        const lever = {def, unit, range, rest, slider, output, element, force: element.lastElementChild, value: Number(slider.value), held: new Set(), sent: null, until: 0};
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

    /// A radio group of buttons, or a switch if there are two values.
    makeChoice(def, range, rest, own, at, id) {
        const label = el('span', {id: `${id}-label`, textContent: readable(own), title: def.name});
        const lever = {def, unit: '', range, rest, slider: null, value: def.value ?? rest, held: new Set(), sent: null, until: 0};
        this.levers.push(lever);
        const pick = value => {
            this.activate(at);
            this.move(at, value);
        };
        const two = def.words.length === 2;
        lever.buttons = two ? [el('button', {role: 'switch', id, onclick: () => pick(lever.value > 0.5 ? 0 : 1)})]
            : def.words.map((word, i) => el('button', {role: 'radio', textContent: readable(word), onclick: () => pick(i)}));
        for (const b of lever.buttons) {
            b.dataset.input = def.name;
            b.addEventListener('focus', () => this.activate(at));
            b.addEventListener('keydown', e => this.key(e, at));
        }
        lever.force = el('small', {className: 'force', hidden: true});
        lever.element = el('div', {className: 'lever choice'}, el('div', {className: 'head'}, label),
            el('div', {className: 'choices', role: two ? 'group' : 'radiogroup', 'aria-labelledby': label.id}, ...lever.buttons), lever.force);
        this.paint(lever);
        return lever.element;
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
        if (lever.buttons?.length > 1) lever.buttons[Math.round(lever.value)]?.focus();
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
        lever.asked = true;
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
            } else if (frame && now > lever.until) {
                const value = frame.inputs[lever.def.index], span = lever.range[1] - lever.range[0];
                const differs = Number.isFinite(value) && Math.abs(value - lever.value) > 1e-6 * span;
                // In an exercise a fault may change the value in force; it never moves the control.
                const keeps = this.keepsRequests && lever.asked;
                if (differs && !keeps && !lever.held.size) {
                    lever.value = value;
                    this.paint(lever);
                }
                this.paintForce(lever, differs && keeps && Math.abs(value - lever.value) > 0.01 * span ? value : null);
            }
        }
        this.throttle.flush(now);
    }

    /// Show a value in force that differs from the request; null: none.
    paintForce(lever, value) {
        const words = value === null ? '' : `in force: ${lever.def.words?.length ? readable(valueWords(lever.def, value)) : shown(value, lever.unit, lever.def.name)}`;
        if (lever.force.textContent === words) return;
        lever.force.textContent = words;
        lever.force.hidden = !words;
    }

    /// Forget requests, after a restore: controls follow the values in force.
    forget() {
        for (const lever of this.levers) lever.asked = false;
    }

    paint(lever) {
        if (lever.buttons) return this.paintChoice(lever);
        const {slider, range, value, def} = lever, of = v => 100 * (v - range[0]) / (range[1] - range[0]);
        const words = shown(value, lever.unit, def.name);
        slider.value = value;
        lever.output.textContent = words;
        slider.setAttribute('aria-valuetext', words);
        const a = Math.min(of(lever.rest), of(value)), b = Math.max(of(lever.rest), of(value)), grey = 'rgb(255 255 255 / 22%)';
        slider.style.setProperty('--fill', `linear-gradient(to right, ${grey} ${a}%, #7cc0e8 ${a}%, #7cc0e8 ${b}%, ${grey} ${b}%)`);
    }

    paintChoice(lever) {
        const at = Math.round(lever.value);
        if (lever.buttons.length === 1) {
            const [b] = lever.buttons, words = readable(lever.def.words[at] ?? '');
            b.setAttribute('aria-checked', String(at === 1));
            b.textContent = words;
            return;
        }
        lever.buttons.forEach((b, i) => {
            b.setAttribute('aria-checked', String(i === at));
            b.tabIndex = i === at ? 0 : -1;
        });
    }

    deflection(at) {
        return toDeflection(this.levers[at].range, this.levers[at].value);
    }
}
