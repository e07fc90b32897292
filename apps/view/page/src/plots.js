// SPDX-License-Identifier: Apache-2.0
/// Plots over time (uPlot): outputs, tensions, step time by stage with deadline, residuals, motions
/// of a body.
import uPlot from 'uplot';
import {$, el, memory} from './dom.js';
import {History} from './history.js';
import {quantity} from './lever_logic.js';
import {largestTensions} from './protocol.js';
import {readable} from './roles.js';
import {t} from './words.js';

/// Colours that are distinct also with colour blindness (M. Okabe, K. Ito, 2008), light on dark.
export const SERIES = ['#56b4e9', '#e69f00', '#2fc99b', '#f0e442', '#e2884f', '#d993bd', '#ffffff', '#9db4c0'];
const kSpan = 60;

export class Plots {
    constructor(panel) {
        this.panel = panel;
        this.cards = [];
        this.due = 0;
        this.list = el('div', {});
        this.add = el('select', {'aria-label': t('Add a plot')});
        this.add.addEventListener('change', () => {
            if (this.add.value) this.open(JSON.parse(this.add.value));
            this.add.value = '';
        });
    }

    /// Add the plots below the other contents of the panel.
    mount() {
        this.panel.append(el('h2', {textContent: t('Plots')}), el('div', {className: 'row'}, this.add), this.list);
    }

    setScene(scene) {
        this.scene = scene;
        const names = [...scene.outputs.map(o => `o:${o.name}`), ...scene.wires.map(w => `w:${w.name}`), ...scene.stats.map(s => `s:${s}`)];
        const kept = this.cards.map(c => c.what);
        if (names.join() !== this.history?.names.join()) this.history = new History(names);
        this.tensions = new Float32Array(scene.wires.length);
        this.bodySeries = [];
        this.list.replaceChildren();
        this.cards = [];
        this.offer();
        const first = kept.length ? kept : memory.get(`plots.${scene.name}`, null) ?? this.usual();
        for (const what of first) this.open(what, false);
    }

    usual() {
        const out = [{kind: 'stages'}, {kind: 'residual'}];
        if (this.scene.wires.length) out.unshift({kind: 'tensions'});
        if (this.scene.outputs.length) out.unshift({kind: 'output', name: this.scene.outputs[0].name});
        return out;
    }

    offer() {
        const option = (text, what) => el('option', {textContent: text, value: JSON.stringify(what)});
        const group = (label, options) => options.length ? el('optgroup', {label}, ...options) : null;
        this.add.replaceChildren(...[el('option', {value: '', textContent: 'Add a plot …'}),
            group('Run', [option('Step time by stage', {kind: 'stages'}), option('Residuals', {kind: 'residual'}), option(t('Largest tensions'), {kind: 'tensions'})]),
            group(t('Outputs'), this.scene.outputs.map(o => option(readable(o.name), {kind: 'output', name: o.name}))),
            group(t('Tensions'), this.scene.wires.filter(w => w.kind !== 'rod').map(w => option(readable(w.name), {kind: 'wire', name: w.name})))].filter(Boolean));
    }

    /// Return the series of a plot: [{label, unit, index in the history or body}], and a heading.
    describe(what) {
        const at = name => this.history.names.indexOf(name), {scene} = this;
        if (what.kind === 'output') {
            const o = scene.outputs.find(x => x.name === what.name);
            return o && {title: readable(o.name), unit: o.unit, series: [{label: readable(o.name), index: at(`o:${o.name}`)}]};
        }
        if (what.kind === 'wire') return {title: `${t('Tension')}: ${readable(what.name)}`, unit: 'N', series: [{label: readable(what.name), index: at(`w:${what.name}`)}]};
        if (what.kind === 'tensions') {
            const wires = scene.wires.filter(w => w.kind !== 'rod').slice(0, 40), most = w => -(this.tensions[scene.wires.indexOf(w)] || 0);
            return {title: t('Largest tensions'), unit: 'N', series: [...wires].sort((a, b) => most(a) - most(b)).slice(0, 6).map(w => ({label: readable(w.name), index: at(`w:${w.name}`)}))};
        }
        if (what.kind === 'stages') {
            const series = scene.stages.map(s => ({label: s, index: Math.max(at(`s:stage_${s}_ms`), at(`s:stage_${s}`))})).filter(s => s.index >= 0);
            return {title: 'Step time by stage', unit: 'ms', stacked: true, series, deadline: at('s:deadline_ms')};
        }
        if (what.kind === 'residual')
            return {title: 'Residuals', unit: '', log: true, series: ['momentum_residual', 'constraint_residual', 'violation_m', 'natural_map'].map(n => ({label: n.replace('_m', ' [m]').replaceAll('_', ' '), index: at(`s:${n}`)})).filter(s => s.index >= 0)};
        if (what.kind === 'body') return {title: `${readable(what.name)}: ${what.of}`, unit: {height: 'm', speed: 'm/s', roll: '°', pitch: '°', heading: '°'}[what.of], series: [{label: what.of, body: what}]};
        return null;
    }

    open(what, keep = true) {
        if (this.cards.some(c => JSON.stringify(c.what) === JSON.stringify(what))) return;
        const plan = this.describe(what);
        if (!plan || !plan.series.length || plan.series.some(s => s.index < 0)) return;
        const close = el('button', {textContent: '×', 'aria-label': `Close ${plan.title}`});
        const note = el('span', {className: 'note'}), body = el('div', {});
        const card = {what, plan, body, note, own: what.kind === 'body' ? new History([what.of]) : null};
        card.element = el('section', {className: 'plot', 'aria-label': plan.title}, el('header', {}, el('strong', {textContent: plan.title}), note, close), body);
        close.addEventListener('click', () => {
            card.chart?.destroy();
            card.element.remove();
            this.cards = this.cards.filter(c => c !== card);
            this.store();
        });
        this.list.append(card.element);
        this.cards.push(card);
        if (keep) {
            this.store();
            card.element.scrollIntoView({block: 'nearest'});
        }
    }

    store() {
        memory.set(`plots.${this.scene.name}`, this.cards.map(c => c.what).filter(w => w.kind !== 'body'));
    }

    chart(card) {
        const {plan} = card, values = (u, ticks) => ticks.map(v => v === null ? '' : quantity(v, plan.unit === 'ms' || plan.unit === '°' ? '' : plan.unit, 3));
        const axis = {stroke: '#b6c5d0', grid: {stroke: 'rgb(255 255 255 / 9%)', width: 1}, ticks: {stroke: 'rgb(255 255 255 / 15%)', width: 1}, font: '11px system-ui, sans-serif'};
        const fills = plan.stacked;
        const series = plan.series.map((s, i) => ({label: s.label, stroke: SERIES[i % SERIES.length], width: fills ? 1 : 1.6, fill: fills ? SERIES[i % SERIES.length] + 'aa' : undefined,
            points: {show: false}, value: (u, v) => v === null || v === undefined ? '–' : plan.stacked ? '' : quantity(v, plan.unit)}));
        if (plan.deadline >= 0) series.push({label: 'deadline', stroke: '#ff8a65', width: 1.5, dash: [6, 4], points: {show: false}});
        card.chart = new uPlot({
            width: Math.max(200, this.list.clientWidth), height: plan.series.length > 2 ? 150 : 120, pxAlign: 0, legend: {live: false, show: plan.series.length > 1 || plan.deadline >= 0},
            bands: fills ? plan.series.slice(1).map((_, i) => ({series: [i + 2, i + 1]})) : undefined,
            cursor: {y: false}, scales: {x: {time: false}, y: plan.log ? {distr: 3} : {range: (u, lo, hi) => this.range(plan, lo, hi)}},
            series: [{}, ...series], axes: [{...axis, size: 28}, {...axis, size: 70, values: plan.log ? undefined : values}],
        }, [[]], card.body);
    }

    range(plan, lo, hi) {
        if (lo === null || hi === null) return [0, 1];
        if (plan.stacked) return [0, hi * 1.08 || 1];
        const middle = (lo + hi) / 2, least = 1e-3 * Math.abs(middle) || 1e-6, half = Math.max((hi - lo) / 2 * 1.1, least);
        return [middle - half, middle + half];
    }

    /// Record a frame.
    take(frame, bodies) {
        if (!this.history) return;
        const O = this.scene.outputs.length, W = this.scene.wires.length;
        largestTensions(frame, this.tensions);
        this.history.add(frame.time, i => i < O ? frame.outputs[i] : i < O + W ? this.tensions[i - O] : frame.stats[i - O - W]);
        for (const c of this.cards) if (c.own) c.own.add(frame.time, () => bodyValue(bodies.byId.get(c.what.id), c.what.of, frame, c));
    }

    /// Draw the visible plots, four times a second.
    draw(now) {
        if (this.panel.hidden || now < this.due) return;
        this.due = now + 250;
        for (const card of this.cards) {
            if (!card.chart) {
                card.plan = this.describe(card.what);   // the largest tensions are those of now
                this.chart(card);
            }
            const {plan} = card, source = card.own ?? this.history, wanted = card.own ? [0] : plan.series.map(s => s.index);
            const data = source.columns(plan.deadline >= 0 ? [...wanted, plan.deadline] : wanted, kSpan);
            if (plan.stacked) stack(data, plan.series.length);
            if (plan.log) for (let i = 1; i < data.length; ++i) data[i] = data[i].map(v => v > 0 ? v : null);
            card.note.textContent = this.latest(plan, data);
            card.chart.setData(data);
        }
    }

    latest(plan, data) {
        const n = data[0].length - 1;
        if (n < 0) return '';
        if (plan.stacked) return `${quantity(data[plan.series.length][n], 'ms')} of ${quantity(data.at(-1)[n], 'ms')}`;
        return plan.series.length === 1 && data[1][n] !== null ? quantity(data[1][n], plan.unit, 4) : '';
    }
}

function stack(data, n) {
    for (let k = 0; k < data[0].length; ++k)
        for (let i = 2; i <= n; ++i) data[i][k] = (data[i][k] ?? 0) + (data[i - 1][k] ?? 0);
}

function bodyValue(body, of, frame, card) {
    if (!body) return NaN;
    const q = body.quaternion, deg = 180 / Math.PI;
    if (of === 'height') return body.position.z;
    if (of === 'heading') return deg * Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
    if (of === 'roll') return deg * Math.atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y));
    if (of === 'pitch') return deg * Math.asin(Math.max(-1, Math.min(1, 2 * (q.w * q.y - q.z * q.x))));
    const was = card.was, dt = was ? frame.time - was.time : 0;
    const speed = dt > 0 ? body.position.distanceTo(was.at) / dt : was?.speed ?? 0;
    if (!was || dt > 0.2 || dt < 0) card.was = {time: frame.time, at: body.position.clone(), speed: dt > 0 ? speed : 0};
    return card.was.speed;
}

export const showPlots = on => {
    $('plots').hidden = !on;
    document.body.classList.toggle('plots-open', on);
};
