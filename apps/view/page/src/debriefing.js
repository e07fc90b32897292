// SPDX-License-Identifier: Apache-2.0
/// Debriefing: score, goals, displays, controls, notes and events of an exercise on one time line. A
/// recording has them from the program, which computes the score anew; a live run has those that this
/// page has received. Another run can be laid beside it, from a file that this panel has saved.
import {controlCurves, curvePath, kHigh, kMarks, kMostRows, kWide, rangeOf, valueAt} from './curves.js';
import {clock, el, svg, toast} from './dom.js';
import {printSheet, reportSheet} from './report_sheet.js';
import {readable} from './roles.js';
import {shown} from './units.js';
import {t} from './words.js';

/// Collects what a page of a live exercise receives, in the form of the message `debriefing`.
export class Collector {
    constructor() {
        this.reset();
    }
    reset(time = -Infinity) {
        const keep = list => (list ?? []).filter(e => e.time <= time);
        this.entries = keep(this.entries);
        const n = (this.times ?? []).filter(v => v <= time).length;
        this.times = (this.times ?? []).slice(0, n);
        this.values = (this.values ?? []).map(v => v.slice(0, n));
        this.controls = (this.controls ?? []).filter(c => c[0] <= time);
        this.last = new Map();
    }
    event(e) {
        const note = e.kind === 'command' && /note: /.test(e.words ?? '');
        if (kMarks[e.kind] && (e.kind !== 'command' || note)) this.entries.push({time: e.time, kind: note ? 'note' : e.kind, name: e.name, text: note ? e.words.replace(/^.*note: /, '') : (e.words ?? '').replace(/^[^:]*: /, ''), by: '', points: note ? 0 : e.value});
    }
    /// Sample displays once a second, and controls when they change.
    frame(scene, frame, displays) {
        if (this.times.length && frame.time < this.times.at(-1)) this.reset(frame.time);
        for (const [i, input] of scene.inputs.entries()) {
            if (input.kind !== 'lever' || this.last.get(i) === frame.inputs[i]) continue;
            this.last.set(i, frame.inputs[i]);
            if (this.controls.length < 20000) this.controls.push([frame.time, '', input.name, frame.inputs[i]]);
        }
        if (this.times.length && frame.time < this.times.at(-1) + 1) return;
        this.times.push(frame.time);
        displays.forEach((name, k) => (this.values[k] ??= []).push(frame.outputs[scene.outputs.findIndex(o => o.name === name)] ?? NaN));
    }
    message(exercise) {
        return {...exercise, type: 'debriefing', time: this.times.at(-1) ?? 0, entries: this.entries, times: this.times, values: this.values, controls: this.controls};
    }
}

export class Debriefing {
    constructor(box, app) {
        Object.assign(this, {box, app, data: null, other: null, people: ''});
        this.collector = new Collector();
    }

    /// Take a debriefing of the program, of a recording.
    set(data) {
        this.data = data;
        this.recorded = true;
        document.getElementById('debrief').hidden = false;
        this.open(true);
    }

    /// Show the debriefing of the live run.
    live() {
        this.data = this.collector.message(this.app.exercise.exercise);
        this.open(true);
    }

    /// Events of the recording's time line become entries: notes and commands.
    timeline(events) {
        this.extra = events.filter(e => e.kind === 'command' && /note: /.test(e.words)).map(e => ({time: e.time, kind: 'note', text: e.words.replace(/^.*note: /, ''), points: 0}));
        if (this.data && this.recorded) this.build();
    }

    open(on) {
        this.box.hidden = !on;
        document.body.classList.toggle('debriefing-open', on);
        document.getElementById('debrief').setAttribute('aria-expanded', String(on));
        if (on) this.build();
        else document.body.style.removeProperty('--console');
    }

    toggle() {
        if (this.box.hidden) {
            if (!this.recorded && this.app.exercise.on) this.live();
            else if (this.data) this.open(true);
        } else this.open(false);
    }

    unitOf(name) {
        const {scene} = this.app, all = [...(scene?.outputs ?? []), ...(scene?.inputs ?? [])], one = all.find(o => o.name === name);
        return [one?.unit === '1' || / or /.test(one?.unit ?? '') ? '' : one?.unit ?? '', one?.drives || name];
    }

    build() {
        const d = this.data, end = Math.max(d.time, d.times.at(-1) ?? 0, this.other?.time ?? 0);
        this.span = [Math.min(0, d.times[0] ?? 0), Math.max(1, end)];
        this.rows = [];
        const title = el('h2', {textContent: `${t('Debriefing')}: ${readable(d.name)}`}), entries = this.entries();
        const score = (one, label) => el('p', {className: 'debrief-score'}, label ? el('small', {textContent: `${label} `}) : null, el('output', {className: one.outcome, textContent: `${+one.points.toFixed(1)} ${t('of')} ${+one.possible.toFixed(1)} ${t('points')}`}),
            ` ${t(one.outcome === 'passed' ? 'Passed' : one.outcome === 'failed' ? 'Not passed' : 'running')}${one.end ? `: ${one.end}` : ''} (${clock(one.time)})`);
        const tables = el('div', {className: 'debrief-lists'}, title, score(d), this.other ? score(this.other, t('Other run')) : null, this.buttons(), this.tally('Goals', d.goals, this.other?.goals), this.tally('Penalties', d.penalties.filter(p => p.times > 0), this.other?.penalties),
            el('h3', {textContent: t('Events and notes')}), el('ol', {className: 'debrief-entries'}, ...entries.map(e => el('li', {}, el('button', {className: e.kind, onclick: () => this.seek(e.time)}, el('b', {textContent: `${clock(e.time)} ${kMarks[e.kind] ?? '·'}`}), ` ${e.text || readable(e.name ?? '')}${e.by ? ` (${e.by})` : ''}${e.points ? ` ${e.points > 0 ? '+' : '−'}${+Math.abs(e.points).toFixed(1)}` : ''}`)))));
        const tracks = el('div', {className: 'tracks'});
        this.marks(tracks, entries);
        d.displays.forEach((name, k) => this.curve(tracks, name, 'display', d.times, d.values[k] ?? [], this.other?.displays.indexOf(name)));
        for (const c of controlCurves(d.controls, this.span[1])) this.curve(tracks, c.name, 'control', c.times, c.values, -1, c.role);
        this.box.replaceChildren(tables, tracks);
        document.body.style.setProperty('--console', `${this.box.offsetHeight + 8}px`);
    }

    /// Return events and notes by time.
    entries() {
        return [...this.data.entries, ...(this.extra ?? [])].sort((a, b) => a.time - b.time);
    }

    /// Open the print dialog with the report as a page.
    print() {
        printSheet(reportSheet(this.data, this.entries(), {people: this.people.trim(), date: new Date(), span: this.span, other: this.other, unitOf: name => this.unitOf(name)}));
    }

    buttons() {
        const people = el('input', {type: 'text', className: 'text', maxLength: 120, placeholder: t('Names'), 'aria-label': t('Names for the report'), value: this.people, oninput: e => { this.people = e.target.value; }});
        const file = el('input', {type: 'file', accept: '.json', hidden: true, onchange: e => this.compare(e.target.files[0])});
        return el('div', {className: 'row'}, people, ...(this.recorded || this.app.mayControl ? [el('button', {id: 'report', textContent: t('Report'), onclick: () => this.report()})] : []), el('button', {id: 'print', textContent: t('Print, PDF'), onclick: () => this.print()}),
            el('button', {textContent: t('Save data'), onclick: () => this.save(`${this.data.name}.json`, JSON.stringify(this.data), 'application/json')}), el('button', {textContent: t('Compare'), onclick: () => file.click()}), file,
            el('button', {textContent: t('Close'), onclick: () => this.open(false)}));
    }

    save(name, text, type) {
        const url = URL.createObjectURL(new Blob([text], {type}));
        el('a', {href: url, download: name}).click();
        setTimeout(() => URL.revokeObjectURL(url), 5000);
    }

    async compare(file) {
        try {
            const other = JSON.parse(await file.text());
            if (other.type !== 'debriefing' || !Array.isArray(other.times) || other.name !== this.data.name) throw new Error(t('no debriefing of this exercise'));
            this.other = other;
            this.build();
        } catch (e) {
            toast(`${file.name}: ${e.message}`);
        }
    }

    async report() {
        const day = new Date().toISOString().slice(0, 10), people = [this.people.trim(), day].filter(Boolean).join(', ');
        const answer = await this.app.link.ask({type: 'report', people});
        if (answer.type === 'report') this.save(`${this.data.name}.html`, answer.html, 'text/html');
    }

    tally(title, list, other = []) {
        if (!list.length) return '';
        return el('section', {}, el('h3', {textContent: t(title)}), el('ul', {className: 'tally'}, ...list.map(g => {
            const also = other?.find(o => o.name === g.name), points = v => `${+v.points.toFixed(1)}`;
            return el('li', {className: g.possible > 0 && g.reached !== null ? 'done' : g.possible > 0 ? 'late' : ''}, el('b', {textContent: g.possible > 0 ? g.reached === null ? '✕' : '✓' : '−', 'aria-hidden': 'true'}),
                el('span', {textContent: `${g.text || readable(g.name)}${g.reached !== null && g.possible > 0 ? ` (${clock(g.reached)})` : ''}`}), el('i', {textContent: also ? `${points(g)} / ${points(also)}` : points(g)}));
        })));
    }

    x(time) {
        return kWide * (time - this.span[0]) / (this.span[1] - this.span[0]);
    }

    track(tracks, label, note, ...drawn) {
        const cursor = svg('line', {y1: 0, y2: kHigh, class: 'cursor'}), value = el('output', {}), picture = svg('svg', {viewBox: `0 0 ${kWide} ${kHigh}`, preserveAspectRatio: 'none', 'aria-hidden': 'true'}, ...drawn, cursor);
        const at = e => {
            const r = picture.getBoundingClientRect();
            this.seek(this.span[0] + (this.span[1] - this.span[0]) * Math.min(1, Math.max(0, (e.clientX - r.left) / r.width)));
        };
        picture.addEventListener('pointerdown', e => { picture.setPointerCapture(e.pointerId); at(e); });
        picture.addEventListener('pointermove', e => { if (picture.hasPointerCapture(e.pointerId)) at(e); });
        tracks.append(el('div', {className: `track ${note}`}, el('span', {textContent: label, title: label}), picture, value));
        const row = {cursor, value};
        this.rows.push(row);
        return row;
    }

    marks(tracks, entries) {
        const marks = entries.filter(e => e.kind !== 'alarm_end' && e.kind !== 'fault_end').map(e => svg('path', {d: `M${this.x(e.time).toFixed(1)} 2V${kHigh - 2}`, class: `mark ${e.kind}`}));
        const row = this.track(tracks, t('Events'), 'events', ...marks);
        row.words = time => clock(time);
    }

    curve(tracks, name, kind, times, values, also = -1, role = '') {
        if (this.rows.length > kMostRows || !times.length) return;
        const second = also >= 0 ? this.other.values[also] ?? [] : [], range = rangeOf([values, second]), [unit, signal] = this.unitOf(name);
        const drawn = [svg('path', {d: curvePath(times, values, this.span, range), class: `curve ${kind}`})];
        if (second.length) drawn.unshift(svg('path', {d: curvePath(this.other.times, second, this.span, range), class: 'curve other'}));
        const row = this.track(tracks, `${t(readable(name))}${role ? ` (${t(readable(role))})` : ''}`, kind, ...drawn);
        row.words = time => {
            const v = valueAt(times, values, time);
            return Number.isFinite(v) ? shown(v, unit, signal) : '–';
        };
    }

    seek(time) {
        if (this.app.scene?.mode === 'recording') this.app.timeline.want(time);
    }

    /// Move the cursor to the time of a frame; a live run collects it.
    update(frame) {
        const {app} = this;
        if (app.scene.mode === 'live' && app.exercise.on) this.collector.frame(app.scene, frame, app.exercise.exercise.displays);
        if (this.box.hidden || !this.rows || frame.time === this.time) return;
        this.time = frame.time;
        const x = this.x(frame.time).toFixed(1);
        for (const row of this.rows) {
            row.cursor.setAttribute('x1', x);
            row.cursor.setAttribute('x2', x);
            row.value.textContent = row.words(frame.time);
        }
    }
}
