// SPDX-License-Identifier: Apache-2.0
/// Forms of controls by the thing that they operate: heading dial, helm, telegraph, side thruster,
/// winch stick, joystick and azimuth lever. A form adds a drawing, words or a pad to the sliders of
/// its controls, which stay for keyboard, gamepad and screen readers.
import {el, svg} from './dom.js';
import {clampTo} from './lever_logic.js';
import {signalOf} from './vessel.js';
import {t} from './words.js';

const systemOf = signal => signal.slice(0, Math.max(0, signal.lastIndexOf('.')));
const lastOf = signal => signal.slice(signal.lastIndexOf('.') + 1);

/// Controls of a crane by stick: [to the right, away from the driver]. A hoist stick moved away lowers.
export const kCraneSticks = [['slew', 'luff'], ['knuckle', 'hoist'], ['fold', 'hoist']];

/// Return the form of an input: 'heading', 'position', 'helm', 'telegraph', 'side', 'winch', 'share', 'azimuth',
/// 'joystick', 'crane' or '' for a plain slider. @param scene  For vessels and winches.
export function formOf(input, scene) {
    const signal = signalOf(input), name = lastOf(signal), vessel = scene.vessels?.find(v => v.name === systemOf(signal));
    if (vessel) {
        if (name === 'heading_order') return 'heading';
        if (name === 'x_order' || name === 'y_order') return 'position';
        if (/^joystick_[xyn]$/.test(name)) return 'joystick';
        if (name === 'rudder' || vessel.rudders.some(r => r.name === name)) return 'helm';
        const p = vessel.propulsors.find(q => q.name === name || `${q.name}_angle` === name);
        if (p) return p.kind === 'tunnel' ? 'side' : p.kind === 'shaft' ? 'telegraph' : 'azimuth';
    }
    const crane = scene.outputs.some(o => o.name === `${systemOf(signal)}.utilisation`) && scene.outputs.some(o => o.name === `${systemOf(signal)}.rated`);
    if (crane && kCraneSticks.flat().includes(name)) return 'crane';
    const winch = scene.outputs.some(o => o.name === `${systemOf(signal)}.pull`);
    if (winch && name === 'speed') return 'winch';
    if (input.unit === '1' && input.min === 0 && input.max === 1) return 'share';
    return '';
}

/// Words at the ends of a slider and at its middle, by form; null: numbers.
export function endsOf(form, name = '') {
    if (form === 'telegraph') return ['Full astern', 'Stop', 'Full ahead'];
    if (form === 'side' || form === 'helm') return ['Port', form === 'helm' ? 'Midships' : '', 'Starboard'];
    if (form === 'winch') return ['Haul', '', 'Veer'];
    if (form === 'share') return ['Off', '', 'Full'];
    if (form === 'joystick') return /_x$/.test(name) ? ['Astern', '', 'Ahead'] : ['Port', '', 'Starboard'];
    return null;
}

/// Values shown in per cent: orders from −1 to 1 and fractions from 0 to 1.
export const inPercent = (form, unit, [min, max]) => (unit === '1' || unit === '') && form !== '' && (min === -1 || min === 0) && max === 1;

/// Smallest step by a key: a degree of a heading, 5° of the helm [rad], 1 m of a position; 0: a
/// twentieth of the range.
export const keyStep = form => form === 'heading' ? Math.PI / 180 : form === 'helm' ? Math.PI / 36 : form === 'position' ? 1 : 0;

/// Rate at which a stick moves a control that stays, by form: 10°/s of a heading, 2 m/s of a position;
/// otherwise the whole range in four seconds.
export const driftRate = (form, [min, max]) => form === 'heading' ? Math.PI / 18 : form === 'position' ? 2 : (max - min) / 4;

export const kMove = 5;  // metres of a press of the buttons that move the ordered position
/// Unit vectors of the buttons in axes of the ship, x ahead, y to port.
export const kMoves = {Ahead: [1, 0], Astern: [-1, 0], Port: [0, 1], Starboard: [0, -1]};

/// Buttons that move the ordered position by 5 m ahead, astern, to port, to starboard.
/// @param by  Called with the move in axes of the ship [m].
export function moveButtons(by) {
    const button = ([name, way]) => el('button', {type: 'button', textContent: `${t(name)} ${kMove} m`, 'data-move': name, onclick: () => by(...way.map(v => v * kMove))});
    return el('div', {className: 'move-form', role: 'group', 'aria-label': t('Move the ordered position')}, ...Object.entries(kMoves).map(button));
}

const deg = 180 / Math.PI;

/// Drag a pointer over an element: `to(x, y)` with coordinates −1 to 1 of its square, `done()`.
function dragged(e, to, done = () => {}) {
    const at = v => {
        const r = e.getBoundingClientRect(), size = Math.min(r.width, r.height) / 2;
        to((v.clientX - r.left - r.width / 2) / size, (v.clientY - r.top - r.height / 2) / size);
    };
    e.addEventListener('pointerdown', v => { e.setPointerCapture(v.pointerId); at(v); });
    e.addEventListener('pointermove', v => { if (e.hasPointerCapture(v.pointerId)) at(v); });
    for (const name of ['pointerup', 'pointercancel']) e.addEventListener(name, done);
}

/// Compass dial of an ordered heading: a drag sets it, four buttons change it by 1° and 10°.
/// @param set  Called with the new value [rad, clockwise from the world's x axis].
export function headingDial(lever, set) {
    const bug = svg('path', {d: 'M0-34-5-44H5z', class: 'bug'}), words = svg('text', {'text-anchor': 'middle', y: 6, class: 'figure'});
    const dial = svg('svg', {viewBox: '-50 -50 100 100', class: 'dial', 'aria-hidden': 'true'}, svg('circle', {r: 44}),
        ...Array.from({length: 36}, (_, i) => svg('path', {d: i % 3 ? 'M0-44V-41' : 'M0-44V-37', transform: `rotate(${10 * i})`, class: 'tick'})),
        ...[...'NESW'].map((c, i) => { const e = svg('text', {x: 27 * Math.sin(i * Math.PI / 2), y: -27 * Math.cos(i * Math.PI / 2) + 4, 'text-anchor': 'middle'}); e.textContent = c; return e; }), bug, words);
    const wrapped = v => Math.atan2(Math.sin(v), Math.cos(v));
    dragged(dial, (x, y) => { if (Math.hypot(x, y) > 0.25) set(wrapped(Math.round((Math.atan2(x, -y) - Math.PI / 2) * deg) / deg)); });
    const by = d => el('button', {type: 'button', textContent: `${d > 0 ? '+' : '−'}${Math.abs(d)}°`, 'aria-label': `${t('Heading')} ${d > 0 ? '+' : '−'}${Math.abs(d)}°`, onclick: () => set(wrapped(Math.round(lever.value * deg + d) / deg))});
    lever.drawn = (value, text) => {
        bug.setAttribute('transform', `rotate(${(90 + value * deg).toFixed(1)})`);
        words.textContent = text;
    };
    return el('div', {className: 'heading-form'}, el('div', {}, by(-1), by(-10)), dial, el('div', {}, by(1), by(10)));
}

/// A wheel that turns with the helm.
export function helmWheel(lever) {
    const wheel = svg('g', {}, svg('circle', {r: 30}), svg('circle', {r: 8}), ...Array.from({length: 8}, (_, i) => svg('path', {d: 'M0-8V-42', transform: `rotate(${45 * i})`, class: i ? '' : 'king'})));
    lever.drawn = value => wheel.setAttribute('transform', `rotate(${(value * deg * 3).toFixed(1)})`);
    return el('div', {className: 'wheel-form'}, svg('svg', {viewBox: '-46 -46 92 92', class: 'wheel', 'aria-hidden': 'true'}, wheel));
}

/// A pad for two controls: `across` for x to the right, `along` for y up, both with deflections −1 to 1.
/// A release by pointer lets go of both, so that springs return.
export function stickPad(across, along, hold, move, letGo) {
    const knob = svg('circle', {r: 11, class: 'knob'}), stem = svg('path', {class: 'stem'});
    const pad = svg('svg', {viewBox: '-50 -50 100 100', class: 'pad', 'aria-hidden': 'true'}, svg('rect', {x: -46, y: -46, width: 92, height: 92, rx: 12}), svg('path', {d: 'M-46 0H46M0-46V46', class: 'tick'}), stem, knob);
    dragged(pad, (x, y) => {
        hold();
        move(across, clampTo([-1, 1], x / 0.8));
        move(along, clampTo([-1, 1], -y / 0.8));
    }, letGo);
    const at = {x: 0, y: 0}, paint = () => {
        knob.setAttribute('transform', `translate(${at.x * 36} ${-at.y * 36})`);
        stem.setAttribute('d', `M0 0L${at.x * 36} ${-at.y * 36}`);
    };
    paint();
    return {box: el('div', {className: 'pad-form'}, pad), set: (key, d) => { at[key] = d; paint(); }};
}

/// An azimuth lever: the direction of the knob is the angle, clockwise from ahead, its distance the
/// order.
export function azimuthLever(turn) {
    const knob = svg('path', {d: 'M-5 0H5L0-12z', class: 'knob'}), stem = svg('path', {class: 'stem'});
    const dial = svg('svg', {viewBox: '-50 -50 100 100', class: 'pad', 'aria-hidden': 'true'}, svg('circle', {r: 44}), ...Array.from({length: 12}, (_, i) => svg('path', {d: 'M0-44V-39', transform: `rotate(${30 * i})`, class: 'tick'})), stem, knob);
    dragged(dial, (x, y) => turn(Math.atan2(x, -y), Math.min(1, Math.hypot(x, y) / 0.8)));
    const at = {angle: 0, order: 0};
    const set = (key, v) => {
        at[key] = v;
        const r = 38 * at.order, x = r * Math.sin(at.angle), y = -r * Math.cos(at.angle);
        knob.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${(at.angle * deg).toFixed(1)})`);
        stem.setAttribute('d', `M0 0L${x.toFixed(1)} ${y.toFixed(1)}`);
    };
    set('order', 0);
    return {box: el('div', {className: 'pad-form'}, dial), set};
}
