// SPDX-License-Identifier: Apache-2.0
/// Panels at the right: numbers of the picked object, display options, restore points, keys, gamepad.
import {kClear} from './air.js';
import {kPalettes} from './colour.js';
import {$, clock, el, memory} from './dom.js';
import {quantity} from './lever_logic.js';
import {leftOutWords} from './protocol.js';
import {readable} from './roles.js';
import {FORCE} from './stage.js';
import {kLanguages, language, t} from './words.js';

/// Return pairs of name and value from any notation.
const words = text => Array.isArray(text) ? text : Object.entries(text ?? {});

/// Numbers of the picked object, and of the run.
export class Inspector {
    constructor(panel, app) {
        this.app = app;
        this.box = el('section', {'aria-label': t('What was picked')});
        this.run = el('dl', {className: 'facts'});
        this.certificate = el('p', {className: 'row'});
        panel.append(this.box, el('h2', {textContent: t('Engineer: the run')}), this.certificate, this.run);
        this.due = 0;
        this.clear();
    }

    clear() {
        this.what = null;
        this.box.replaceChildren(el('h2', {textContent: t('Picked')}), el('p', {className: 'note', textContent: t('Click or tap a body or a wire for its numbers.')}));
    }

    show(what) {
        this.what = what;
        this.due = 0;
        const {app} = this, name = what.body ? what.body.name : app.scene.wires[what.wire].name;
        this.facts = el('dl', {className: 'facts', id: 'picked'});
        const tools = el('div', {className: 'row'});
        if (what.body) {
            tools.append(el('button', {textContent: t('Follow'), onclick: () => app.followBody(what.body)}));
            for (const of of ['height', 'speed', 'roll', 'pitch', 'heading'])
                tools.append(el('button', {textContent: `${t('Plot')}: ${t(`plot ${of}`)}`, onclick: () => app.plots.open({kind: 'body', id: what.body.id, name, of})}));
        } else {
            tools.append(el('button', {textContent: `${t('Plot')}: ${t('Tension')}`, onclick: () => app.plots.open({kind: 'wire', name})}));
            if (app.mayControl) tools.append(el('button', {id: 'part', textContent: t('Part here'), onclick: () => app.part(what)}));
        }
        this.box.replaceChildren(el('h2', {textContent: readable(name)}), this.facts, tools);
        this.box.tabIndex = -1;
    }

    async update(now) {
        if (now < this.due) return;
        this.due = now + 400;
        this.paintRun();
        if (!this.what || this.asking) return;
        const {what, app} = this;
        const message = what.body ? {type: 'pick', body: what.body.id} : {type: 'pick', wire: app.scene.wires[what.wire]?.id, s: what.share};
        this.asking = true;
        const answer = await app.link.ask(message);
        this.asking = false;
        if (this.what !== what || answer.type !== 'picked') return;
        this.facts.replaceChildren(...words(answer.text).flatMap(([key, value]) => [el('dt', {textContent: key}), el('dd', {textContent: value})]),
            ...answer.numbers.flatMap(([key, unit, value]) => [el('dt', {textContent: key}), el('dd', {textContent: quantity(value, unit, 4)})]));
    }

    paintRun() {
        const {frame, scene} = this.app;
        if (!frame) return;
        const stat = name => frame.stats[scene.stats.indexOf(name)];
        const out = leftOutWords(frame);
        this.certificate.hidden = scene.mode === 'recording';  // recordings have no certificates and no deadlines
        this.certificate.replaceChildren(
            el('span', {className: `chip ${frame.certified ? 'good' : 'wait'}`, textContent: frame.certified ? '✓ step certified' : '○ step without certificate'}),
            frame.late ? el('span', {className: 'chip bad', textContent: '! deadline missed'}) : el('span', {className: 'chip', textContent: 'in time'}));
        const facts = [['step', quantity(stat('step_ms'), 'ms')], ['its time', quantity(stat('deadline_ms'), 'ms')], ['steps', String(frame.steps)],
            ['left out by the budget', out || 'nothing'], ['contacts', String(frame.contactCount)], ['violation', quantity(stat('violation_m'), 'm')],
            ['momentum residual', quantity(stat('momentum_residual'))], ['contact residual', quantity(stat('natural_map'))]];
        this.run.replaceChildren(...facts.flatMap(([a, b]) => [el('dt', {textContent: a}), el('dd', {textContent: b})]));
    }
}

/// Check boxes of the display options, light and visibility, language, units, palette.
export function layersPanel(panel, app) {
    const {show} = app.stage, kept = memory.get('show', {});
    for (const key of Object.keys(kept)) if (key in show) show[key] = kept[key];
    const items = {names: 'Names (N)', contacts: 'Contact forces', joints: 'Joint forces', water: 'Sea surface', clear: 'Clear water', seabed: 'Seabed', shadows: 'Shadows'};
    panel.append(el('h2', {textContent: t('Shown')}));
    app.boxes = {};
    for (const [key, text] of Object.entries(items)) {
        const box = el('input', {type: 'checkbox', checked: show[key], id: `show-${key}`});
        box.addEventListener('change', () => {
            show[key] = box.checked;
            memory.set('show', show);
            paintForces(app);
        });
        app.boxes[key] = box;
        panel.append(el('label', {className: 'check'}, box, el('span', {textContent: t(text)})));
    }
    const list = (id, label, options, value, chosen) => {
        const box = el('select', {id}, ...options.map(([v, text]) => el('option', {value: v, textContent: text})));
        box.value = value;
        box.addEventListener('change', () => chosen(box.value));
        panel.append(el('label', {className: 'pair'}, el('span', {textContent: t(label)}), box));
        return box;
    };
    list('wires-as', 'Wires', [['auto', t('tubes or lines')], ['tubes', t('tubes')], ['lines', t('lines')]], show.tubes, v => {
        show.tubes = v;
        memory.set('show', show);
    });
    const air = () => app.scene && app.stage.airOf(app.scene, {...light.value && {light: light.value}, ...range.value && {visibility: Number(range.value)}});
    const light = list('light', 'Light', [['', t('of the scene')], ['day', t('Day')], ['dusk', t('Dusk')], ['night', t('Night')]], '', air);
    const range = list('visibility', 'Visibility', [['', t('of the scene')], [kClear, t('clear')], [4000, '2 M (4 km)'], [1000, `${t('Fog')}, 1 km`], [300, `${t('Fog')}, 300 m`]], '', air);
    list('palette', 'Colours of tension', Object.entries(kPalettes).map(([key, {label}]) => [key, t(label)]), memory.get('palette', 'standard'), v => {
        memory.set('palette', v);
        app.usePalette(v);
    });
    list('language', 'Language', Object.entries(kLanguages), language.code, v => {
        memory.set('language', v);
        location.reload();
    });
    const si = el('input', {type: 'checkbox', checked: memory.get('si', false), id: 'si'});
    si.addEventListener('change', () => app.useSi(si.checked));
    panel.append(el('label', {className: 'check'}, si, el('span', {textContent: t('SI units (N, m/s, rad)')})),
        el('p', {className: 'note', textContent: t('Ten times the length of an arrow is a thousand times the force.')}));
    paintForces(app);
}

export function paintForces(app) {
    const {show} = app.stage, at = $('legend-forces'), hex = c => `#${c.toString(16).padStart(6, '0')}`, parts = [];
    for (const [key, text] of [['contacts', t('contact force')], ['joints', t('joint force')]]) {
        if (!show[key]) continue;
        const swatch = el('span', {className: 'swatch'});
        swatch.style.background = hex(FORCE[key.slice(0, -1)]);
        parts.push(swatch, ` ${text} `);
    }
    at.replaceChildren(...parts);
}

/// Restore points: save, go back.
export function restorePanel(panel, app) {
    const name = el('input', {type: 'text', maxLength: 64, placeholder: t('name'), 'aria-label': t('Name of the restore point'), id: 'save-name'});
    const list = el('ul', {id: 'points'}), form = el('form', {className: 'row'}, name, el('button', {textContent: t('Save'), id: 'save'}));
    name.className = 'text';
    form.addEventListener('submit', e => {
        e.preventDefault();
        app.save(name.value.trim() || `at ${clock(app.frame?.time ?? 0)}`);
        name.value = '';
    });
    panel.append(el('h2', {textContent: t('Restore points')}), form, list);
    return () => {
        form.hidden = !app.mayControl;
        list.replaceChildren(...app.state.restore_points.map(p => el('li', {}, el('button', {className: 'line-button', disabled: !app.mayControl, onclick: () => app.restore(p.name)},
            el('span', {textContent: p.name}), el('span', {className: 'note', textContent: clock(p.time)})))));
    };
}

const kKeys = [['space', 'pause, go on'], ['.', 'one step'], ['[ and ]', 'control before, next'], ['↑ ↓', 'move the control'], ['0', 'control to neutral'],
    ['1 to 7', 'camera'], ['C', 'next camera'], ['B', 'next body for the camera'], ['P', 'pull bodies'], ['S', 'save a restore point'], ['R', 'restore the last one'], ['N', 'names'], ['G', 'plots'], ['I', 'instruments'],
    ['A', 'acknowledge all alarms'], ['D', 'debriefing'], ['M', 'menu'], ['K', 'picture'], ['H', 'hide all panels'], ['← →', 'recording: event before, next'], ['?', 'this panel'], ['Esc', 'close, let go']];

/// Words of the commands of a gamepad's buttons.
const kPadWords = {'': 'none', play: 'pause, go on', step: 'one step', neutral: 'control to neutral', previous: 'control before', next: 'next control', less: 'control down', more: 'control up', release: 'emergency release, press twice',
    camera: 'next camera', acknowledge: 'acknowledge all alarms', Ahead: 'ordered position ahead', Astern: 'ordered position astern', Port: 'ordered position to port', Starboard: 'ordered position to starboard'};
const kButtonNames = ['A', 'B', 'X', 'Y', 'LB', 'RB', 'LT', 'RT', 'Back', 'Start', 'L3', 'R3', '↑', '↓', '←', '→'];

/// Keys, and the mapping of a gamepad: a control and a direction for each axis, a command for each button.
export function keysPanel(panel, app) {
    const row = ([k, what]) => el('tr', {}, el('th', {scope: 'row'}, ...k.split(' ').map(x => x === 'and' || x === 'to' ? ` ${t(x)} ` : el('kbd', {textContent: x}))),
        el('td', {className: 'how', textContent: t(what)}));
    const box = el('section', {'aria-label': t('Gamepad')});
    panel.append(el('div', {className: 'key-columns'}, el('section', {'aria-label': t('Keyboard')}, el('h2', {textContent: t('Keyboard')}), el('table', {}, el('tbody', {}, ...kKeys.map(row))),
        el('p', {className: 'note', textContent: t('Drag turns the picture, two fingers or the right button move it, wheel or pinch come nearer.')})), box));
    return () => {
        const {pads, levers} = app, {mapping} = pads;
        const store = () => memory.set(`pad.${app.scene.name}`, mapping);
        const percent = () => `${Math.round(100 * mapping.zone)} %`, words = el('output', {textContent: percent()});
        const zone = el('input', {type: 'range', min: 0.02, max: 0.5, step: 0.01, value: mapping.zone, id: 'pad-zone'});
        zone.addEventListener('input', () => {
            mapping.zone = Number(zone.value);
            words.textContent = percent();
            store();
        });
        const list = (options, value, label, id, chosen) => {
            const choice = el('select', {'aria-label': label, id}, ...options.map(([v, text]) => el('option', {value: v, textContent: text})));
            choice.value = value;
            choice.addEventListener('change', () => { chosen(choice.value); store(); });
            return choice;
        };
        const controls = [['', t('none')], ...levers.levers.map(l => [l.def.name, t(readable(l.def.name))])];
        const axes = mapping.axes.map((m, i) => {
            const turn = el('input', {type: 'checkbox', checked: m.invert, 'aria-label': `${t('Axis')} ${i + 1}: ${t('reversed')}`});
            turn.addEventListener('change', () => { m.invert = turn.checked; store(); });
            return el('tr', {}, el('th', {textContent: `${t('Axis')} ${i + 1}`, scope: 'row'}), el('td', {}, list(controls, m.lever, `${t('Control of axis')} ${i + 1}`, `pad-axis-${i}`, v => { m.lever = v; })), el('td', {}, el('label', {className: 'check'}, turn, t('reversed'))));
        });
        const commands = Object.entries(kPadWords).map(([key, text]) => [key, t(text)]);
        const buttons = kButtonNames.map((name, i) => el('tr', {}, el('th', {scope: 'row'}, el('kbd', {textContent: name})),
            el('td', {colSpan: 2}, list(commands, mapping.buttons[i] ?? '', `${t('Command of button')} ${name}`, `pad-button-${i}`, v => { mapping.buttons[i] = v; }))));
        box.replaceChildren(el('h2', {textContent: t('Gamepad')}), el('p', {className: 'note', textContent: pads.connected || t('None is connected: press a button of it.')}),
            el('table', {className: 'pad-map'}, el('tbody', {}, ...axes, ...buttons)), el('label', {className: 'row', for: 'pad-zone'}, `${t('Dead zone')} `, words), zone);
    };
}
