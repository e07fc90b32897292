// SPDX-License-Identifier: Apache-2.0
/// Panels at the right: numbers of the picked object, display options, restore points, keys, gamepad.
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
        this.box = el('section', {'aria-label': 'What was picked'});
        this.run = el('dl', {className: 'facts'});
        this.certificate = el('p', {className: 'row'});
        panel.append(this.box, el('h2', {textContent: 'Run'}), this.certificate, this.run);
        this.due = 0;
        this.clear();
    }

    clear() {
        this.what = null;
        this.box.replaceChildren(el('h2', {textContent: 'Picked'}), el('p', {className: 'note', textContent: 'Click or tap a body or a wire for its numbers.'}));
    }

    show(what) {
        this.what = what;
        this.due = 0;
        const {app} = this, name = what.body ? what.body.name : app.scene.wires[what.wire].name;
        this.facts = el('dl', {className: 'facts', id: 'picked'});
        const tools = el('div', {className: 'row'});
        if (what.body) {
            tools.append(el('button', {textContent: 'Follow', onclick: () => app.followBody(what.body)}));
            for (const of of ['height', 'speed', 'roll', 'pitch', 'heading'])
                tools.append(el('button', {textContent: `Plot ${of}`, onclick: () => app.plots.open({kind: 'body', id: what.body.id, name, of})}));
        } else {
            tools.append(el('button', {textContent: 'Plot tension', onclick: () => app.plots.open({kind: 'wire', name})}));
            if (app.mayControl) tools.append(el('button', {id: 'part', textContent: 'Part here', onclick: () => app.part(what)}));
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

/// Check boxes of the display options.
export function layersPanel(panel, app) {
    const {show} = app.stage, kept = memory.get('show', {});
    for (const key of Object.keys(kept)) if (key in show) show[key] = kept[key];
    const items = {names: 'Names (N)', contacts: 'Contact forces', joints: 'Joint forces', water: 'Sea surface', clear: 'Clear water', seabed: 'Seabed', shadows: 'Shadows'};
    panel.append(el('h2', {textContent: 'Shown'}));
    app.boxes = {};
    for (const [key, text] of Object.entries(items)) {
        const box = el('input', {type: 'checkbox', checked: show[key], id: `show-${key}`});
        box.addEventListener('change', () => {
            show[key] = box.checked;
            memory.set('show', show);
            paintForces(app);
        });
        app.boxes[key] = box;
        panel.append(el('label', {className: 'check'}, box, el('span', {textContent: text})));
    }
    const how = el('select', {id: 'wires-as', 'aria-label': 'Wires are drawn as'},
        ...[['auto', 'tubes, lines where pictures are slow'], ['tubes', 'tubes'], ['lines', 'lines']].map(([value, textContent]) => el('option', {value, textContent})));
    how.value = show.tubes;
    how.addEventListener('change', () => {
        show.tubes = how.value;
        memory.set('show', show);
    });
    panel.append(el('h2', {textContent: 'Wires'}), how,
        el('p', {className: 'note', textContent: 'Lengths of force arrows go with the cube root of the force: ten times the length is a thousand times the force.'}));
    const si = el('input', {type: 'checkbox', checked: memory.get('si', false), id: 'si'});
    si.addEventListener('change', () => app.useSi(si.checked));
    const speech = el('select', {id: 'language', 'aria-label': t('Language')}, ...Object.entries(kLanguages).map(([value, textContent]) => el('option', {value, textContent})));
    speech.value = language.code;
    speech.addEventListener('change', () => {
        memory.set('language', speech.value);
        location.reload();
    });
    panel.append(el('h2', {textContent: t('Language')}), speech, el('h2', {textContent: t('Units')}), el('label', {className: 'check'}, si, el('span', {textContent: 'SI units (N, m/s, rad)'})));
    paintForces(app);
}

export function paintForces(app) {
    const {show} = app.stage, at = $('legend-forces'), hex = c => `#${c.toString(16).padStart(6, '0')}`, parts = [];
    for (const [key, text] of [['contacts', 'contact force'], ['joints', 'joint force']]) {
        if (!show[key]) continue;
        const swatch = el('span', {className: 'swatch'});
        swatch.style.background = hex(FORCE[key.slice(0, -1)]);
        parts.push(swatch, ` ${text} `);
    }
    at.replaceChildren(...parts);
}

/// Restore points: save, go back.
export function restorePanel(panel, app) {
    const name = el('input', {type: 'text', maxLength: 64, placeholder: 'name', 'aria-label': 'Name of the restore point', id: 'save-name'});
    const list = el('ul', {id: 'points'}), form = el('form', {className: 'row'}, name, el('button', {textContent: 'Save', id: 'save'}));
    name.className = 'text';
    form.addEventListener('submit', e => {
        e.preventDefault();
        app.save(name.value.trim() || `at ${clock(app.frame?.time ?? 0)}`);
        name.value = '';
    });
    panel.append(el('h2', {textContent: 'Restore points'}), form, list);
    return () => {
        form.hidden = !app.mayControl;
        list.replaceChildren(...app.state.restore_points.map(p => el('li', {}, el('button', {className: 'line-button', disabled: !app.mayControl, onclick: () => app.restore(p.name)},
            el('span', {textContent: p.name}), el('span', {className: 'note', textContent: clock(p.time)})))));
    };
}

const kKeys = [['space', 'pause, go on'], ['.', 'one step'], ['[ and ]', 'lever before, next'], ['↑ ↓', 'move the lever'], ['0', 'lever to neutral'],
    ['1 to 7', 'camera'], ['C', 'next camera'], ['B', 'next body for the camera'], ['P', 'pull bodies'], ['S', 'save a restore point'], ['R', 'restore the last one'],
    ['N', 'names'], ['G', 'plots'], ['I', 'instruments'], ['A', 'acknowledge all alarms'], ['K', 'picture'], ['H', 'hide all panels'], ['← →', 'recording: event before, next'], ['?', 'this panel'], ['Esc', 'close, let go']];

/// Keys, and the mapping of a gamepad.
export function keysPanel(panel, app) {
    const row = ([k, what]) => el('tr', {}, el('th', {scope: 'row'}, ...k.split(' ').map(x => x === 'and' || x === 'to' ? ` ${x} ` : el('kbd', {textContent: x}))),
        el('td', {className: 'how', textContent: what}));
    panel.append(el('h2', {textContent: 'Keyboard'}), el('table', {}, el('tbody', {}, ...kKeys.map(row))),
        el('p', {className: 'note', textContent: 'Drag turns the picture, two fingers or the right button move it, wheel or pinch come nearer.'}));
    const box = el('div', {});
    panel.append(el('h2', {textContent: 'Gamepad'}), box);
    return () => {
        const {pads, levers} = app, names = levers.levers.map(l => l.def.name);
        const store = () => memory.set(`pad.${app.scene.name}`, pads.mapping);
        const zone = el('input', {type: 'range', min: 0.02, max: 0.5, step: 0.01, value: pads.mapping.zone, id: 'pad-zone'});
        const words = el('output', {textContent: `${Math.round(100 * pads.mapping.zone)} %`});
        zone.addEventListener('input', () => {
            pads.mapping.zone = Number(zone.value);
            words.textContent = `${Math.round(100 * pads.mapping.zone)} %`;
            store();
        });
        const rows = pads.mapping.axes.map((m, i) => {
            const choice = el('select', {'aria-label': `Lever of axis ${i + 1}`, id: `pad-axis-${i}`}, el('option', {value: '', textContent: 'none'}), ...names.map(n => el('option', {value: n, textContent: readable(n)})));
            choice.value = m.lever;
            choice.addEventListener('change', () => { m.lever = choice.value; store(); });
            const turn = el('input', {type: 'checkbox', checked: m.invert, 'aria-label': `Axis ${i + 1} the other way`});
            turn.addEventListener('change', () => { m.invert = turn.checked; store(); });
            return el('tr', {}, el('th', {textContent: `axis ${i + 1}`, scope: 'row'}), el('td', {}, choice), el('td', {}, el('label', {className: 'check'}, turn, 'turn')));
        });
        box.replaceChildren(el('p', {className: 'note', textContent: pads.connected || 'None is connected: press a button of it.'}), el('table', {}, el('tbody', {}, ...rows)),
            el('label', {className: 'row', for: 'pad-zone'}, 'Dead zone ', words), zone);
    };
}
