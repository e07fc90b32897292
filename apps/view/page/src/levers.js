// SPDX-License-Identifier: Apache-2.0
/// The controls, by group: buttons for a choice, a switch for two values, otherwise a slider with
/// range and unit, with the form of the thing that it operates (forms.js). A control with a spring returns to neutral after its release by pointer, touch, keys
/// or gamepad. A control shows the request; a line below it shows another value in force.
import {el, memory} from './dom.js';
import {azimuthLever, driftRate, endsOf, kCraneSticks, formOf, headingDial, helmWheel, inPercent, keyStep, moveButtons, stickPad} from './forms.js';
import {clampTo, groupLevers, leverRange, neutral, nudge, springHome, toDeflection, fromDeflection, Throttle} from './lever_logic.js';
import {readable} from './roles.js';
import {shown} from './units.js';
import {choicesOf, signalOf} from './vessel.js';
import {t} from './words.js';

const kDangerous = new Set(['release']);   // a second press within 3 s confirms

/// Return the word of a choice in the words of the trade.
export function choiceWord(def, value) {
    const word = def.words[value] ?? '', key = signalOf(def).endsWith('.mode') ? `${word === 'off' || ['joystick', 'heading', 'position', 'follow'].includes(word) ? 'mode' : 'winch'} ${word}` : word, words = t(key);
    return words === key && key !== word ? readable(word) : words === word ? readable(word) : words;
}

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
        this.scene = scene;
        this.panel.replaceChildren(el('h2', {textContent: t('Controls')}));
        this.levers = [];
        this.place = null;
        const may = scene.role.inputs, mine = i => i.mine ?? (may === 'all' || may.includes(i.name));
        const shown = scene.inputs.map((def, index) => ({...def, index, words: choicesOf(def, scene.vessels)})).filter(i => i.kind !== 'inner' && mine(i));
        document.body.classList.toggle('levers-none', !shown.length || !live);
        if (!shown.length) return;
        const rank = ([g]) => first.includes(g) ? 0 : 1;
        const groups = [...groupLevers(shown)].sort((a, b) => rank(a) - rank(b));
        const closed = new Set(memory.get(`closed.${scene.name}`, shown.length > 14 ? groups.slice(2).map(([g]) => g) : []));
        for (const [group, members] of groups) {
            const box = el('details', {className: 'lever-group', open: !closed.has(group)}, el('summary', {textContent: t(readable(group))}));
            box.addEventListener('toggle', () => {
                if (box.open) closed.delete(group);
                else closed.add(group);
                memory.set(`closed.${scene.name}`, [...closed]);
            });
            const first = this.levers.length;
            for (const m of members) box.append(this.make(shown[m], group));
            this.joinPads(this.levers.slice(first));
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
        const form = formOf(def, this.scene), words = endsOf(form, signalOf(def)), percent = inPercent(form, def.unit, range);
        const text = v => percent ? `${Math.round(100 * v)} %` : shown(v, unit, signalOf(def));
        const home = def.spring === null || def.spring === undefined ? vague ? def.unit : '' : def.spring === 0 ? t('returns to centre') : `${t('returns to')} ${text(def.spring)}`;
        const ends = el('div', {className: 'ends', 'aria-hidden': 'true'}, el('span', {textContent: words ? t(words[0]) : text(range[0])}),
            el('span', {className: 'home', textContent: words?.[1] ? t(words[1]) : home}), el('span', {textContent: words ? t(words[2]) : text(range[1])}));
        if (form === 'heading') ends.hidden = true;
        const lever = {def, unit, range, rest, slider, output, value: Number(slider.value), held: new Set(), sent: null, until: 0, text, form, step: keyStep(form)};
        const picture = form === 'heading' ? headingDial(lever, v => { this.activate(at); this.move(at, v); }) : form === 'helm' ? helmWheel(lever) : null;
        // Orders of a vessel are taken over from its state until a station sets them.
        lever.order = form === 'position' || form === 'heading' ? this.scene.outputs.findIndex(o => o.name === signalOf(def)) : -1;
        const element = lever.element = el('div', {className: `lever ${form}`}, el('div', {className: 'head'}, el('label', {for: id, textContent: t(readable(own)), title: def.name}), output), picture, slider, ends, el('small', {className: 'force', hidden: true}));
        lever.force = element.lastElementChild;
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
        const label = el('span', {id: `${id}-label`, textContent: t(readable(own)), title: def.name});
        const lever = {def, unit: '', range, rest, slider: null, value: def.value ?? rest, held: new Set(), sent: null, until: 0};
        this.levers.push(lever);
        const pick = value => {
            this.activate(at);
            if (kDangerous.has(def.words[value]) && value !== Math.round(lever.value) && !(performance.now() < (lever.armed ?? 0))) return this.arm(lever, value);
            lever.armed = 0;
            this.move(at, value);
        };
        lever.wordOf = value => choiceWord(def, value);
        lever.pick = pick;
        const two = def.words.length === 2;
        lever.buttons = two ? [el('button', {role: 'switch', id, onclick: () => pick(lever.value > 0.5 ? 0 : 1)})]
            : def.words.map((word, i) => el('button', {role: 'radio', textContent: lever.wordOf(i), className: kDangerous.has(word) ? 'guarded' : '', onclick: () => pick(i)}));
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

    /// Press the dangerous choice of the selected control; the second press confirms.
    release() {
        const lever = this.levers[this.active], at = lever?.def.words?.findIndex(w => kDangerous.has(w)) ?? -1;
        if (at >= 0) lever.pick(at);
    }

    /// Ask for a second press of a dangerous choice.
    arm(lever, value) {
        lever.armed = performance.now() + 3000;
        const b = lever.buttons[value];
        b.textContent = t('Press again');
        b.classList.add('armed');
        setTimeout(() => { b.classList.remove('armed'); b.textContent = lever.wordOf(value); }, 3000);
    }

    /// Join controls of one thing to a pad: joystick of a vessel, order and angle of an azimuth.
    joinPads(levers) {
        const of = end => levers.find(l => l.form === 'joystick' && signalOf(l.def).endsWith(end)), x = of('_x'), y = of('_y'), index = l => this.levers.indexOf(l);
        const join = (across, along) => {
            if (!across || !along) return;
            const both = [across, along], pad = stickPad(across, along, () => both.forEach(l => this.hold(index(l), 'stick')), (l, d) => this.move(index(l), fromDeflection(l.range, d)), () => both.forEach(l => this.letGo(index(l), 'stick')));
            along.drawn = v => pad.set('y', toDeflection(along.range, v));
            across.drawn = v => pad.set('x', toDeflection(across.range, v));
            (index(across) < index(along) ? across : along).element.before(pad.box);
        };
        join(y, x);
        const east = levers.find(l => l.form === 'position' && signalOf(l.def).endsWith('.x_order')), north = levers.find(l => l.form === 'position' && signalOf(l.def).endsWith('.y_order'));
        if (east && north) {
            this.place = {east: index(east), north: index(north)};
            east.element.before(moveButtons((ahead, port) => this.movePosition(ahead, port)));
        }
        const crane = name => levers.find(l => l.form === 'crane' && signalOf(l.def).endsWith(`.${name}`));
        for (const [across, along] of kCraneSticks) join(crane(across), crane(along));
        for (const angle of levers.filter(l => l.form === 'azimuth' && signalOf(l.def).endsWith('_angle'))) {
            const order = levers.find(l => signalOf(l.def) === signalOf(angle.def).slice(0, -6));
            if (!order) continue;
            const dial = azimuthLever((a, r) => { this.move(index(angle), Math.min(angle.range[1], Math.max(angle.range[0], a))); this.move(index(order), order.range[1] * r); });
            angle.drawn = v => dial.set('angle', v);
            order.drawn = v => dial.set('order', v / order.range[1]);
            order.element.before(dial.box);
        }
        for (const l of levers) this.paint(l);
    }

    key(e, at) {
        const lever = this.levers[at], steps = {ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 5, PageDown: -5}[e.key];
        let to = null;
        if (steps) to = this.nudged(lever, steps);
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

    /// Move the ordered position of the vessel along its own axes [m].
    movePosition(ahead, port) {
        if (!this.place || !this.frame) return;
        const {east, north} = this.place, x = this.levers[east], y = this.levers[north], name = signalOf(x.def).replace(/x_order$/, 'heading');
        const clockwise = this.frame.outputs[this.scene.outputs.findIndex(o => o.name === name)], c = Math.cos(clockwise), s = -Math.sin(clockwise);
        if (!Number.isFinite(c)) return;
        this.move(east, clampTo(x.range, x.value + c * ahead - s * port));
        this.move(north, clampTo(y.range, y.value + s * ahead + c * port));
    }

    /// Return the value after presses of a key. Dangerous choices are skipped: they need two presses.
    nudged(lever, steps) {
        if (lever.step) return Math.min(lever.range[1], Math.max(lever.range[0], Math.round(lever.value / lever.step + steps * (Math.abs(steps) > 1 ? 2 : 1)) * lever.step));
        const to = nudge(lever.range, lever.value, steps, lever.def.words?.length > 0);
        return kDangerous.has(lever.def.words?.[to]) ? lever.value : to;
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
        this.move(this.active, this.nudged(lever, steps));
    }

    neutral() {
        if (this.levers[this.active]) this.move(this.active, this.levers[this.active].rest);
    }

    /// Move a control by a stick: deflection −1 to 1. A control with a spring follows the stick. Another
    /// one moves while the stick is held, at the rate of its form, and stays.
    deflect(at, d, holding) {
        const lever = this.levers[at];
        if (!lever) return;
        if (holding) this.hold(at, 'pad');
        else this.letGo(at, 'pad');
        if (lever.def.spring !== null && lever.def.spring !== undefined) return this.move(at, fromDeflection(lever.range, d));
        lever.drift = holding ? d : 0;
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
        this.frame = frame;
        for (const [at, lever] of this.levers.entries()) {
            if (lever.drift) this.move(at, clampTo(lever.range, lever.value + lever.drift * dt * driftRate(lever.form, lever.range)));
            const springs = lever.def.spring !== null && lever.def.spring !== undefined;
            if (springs && !lever.held.size && lever.until && lever.value !== lever.rest) {
                const about = lever.range.map(v => v - lever.rest);
                this.move(at, lever.rest + springHome(about, lever.value - lever.rest, dt));
            } else if (frame && now > lever.until) {
                const value = lever.order >= 0 && !lever.asked ? frame.outputs[lever.order] : frame.inputs[lever.def.index], span = lever.range[1] - lever.range[0];
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
        const words = value === null ? '' : `${t('in force')}: ${lever.wordOf ? lever.wordOf(Math.round(value)) : lever.text(value)}`;
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
        const {slider, range, value} = lever, of = v => 100 * (v - range[0]) / (range[1] - range[0]);
        const words = lever.text(value);
        lever.drawn?.(value, words);
        slider.value = value;
        lever.output.textContent = words;
        slider.setAttribute('aria-valuetext', words);
        const a = Math.min(of(lever.rest), of(value)), b = Math.max(of(lever.rest), of(value)), grey = 'rgb(255 255 255 / 22%)';
        slider.style.setProperty('--fill', `linear-gradient(to right, ${grey} ${a}%, #7cc0e8 ${a}%, #7cc0e8 ${b}%, ${grey} ${b}%)`);
    }

    paintChoice(lever) {
        const at = Math.round(lever.value);
        if (lever.buttons.length === 1) {
            const [b] = lever.buttons, words = lever.wordOf(at);
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
