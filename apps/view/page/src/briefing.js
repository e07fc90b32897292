// SPDX-License-Identifier: Apache-2.0
/// The briefing before a run: description, task, stations, number of clients; the instructor starts.
import {siteChart} from './chart.js';
import {$, clock, el} from './dom.js';
import {readable} from './roles.js';
import {t} from './words.js';

export class Briefing {
    constructor(box, app) {
        Object.assign(this, {box, app, done: false});
    }

    /// True while the run has not begun: live, paused, at its first time.
    waits() {
        const {app} = this;
        return app.scene?.mode === 'live' && app.state.paused && !app.state.failure && (app.state.time ?? 0) < 1.5 * app.scene.step && !this.done;
    }

    close() {
        this.done = true;
        this.paint();
    }

    paint() {
        const {box, app} = this, show = Boolean(this.waits());
        if (!show) {
            if (!box.hidden && box.contains(document.activeElement)) $('canvas').focus();
            box.hidden = true;
            return;
        }
        const e = app.exercise.exercise, role = app.scene.role, mine = e?.stations.find(s => s.name === role.name);
        const read = name => app.frame?.outputs[app.scene.outputs.findIndex(o => o.name === name)], wind = Number.isFinite(read('sea.wind')) ? {speed: read('sea.wind'), to: read('sea.wind_direction') ?? 0} : null;
        const parts = [el('h2', {id: 'briefing-title', textContent: readable(e?.name ?? app.scene.name)}), el('p', {textContent: (e?.description || app.scene.description) ?? ''})];
        if (mine) parts.push(el('p', {}, el('b', {textContent: `${t('Your station')}: ${t(readable(mine.name))}. `}), mine.text ?? ''));
        if (e?.goals.length) parts.push(el('h3', {textContent: t('Goals')}), el('ul', {}, ...e.goals.map(g => el('li', {textContent: `${g.text || readable(g.name)}: ${+g.possible.toFixed(1)} ${t('points')}${g.by === null ? '' : `, ${t('until')} ${clock(g.by)}`}`}))),
            el('p', {className: 'note', textContent: `${t('Pass mark')}: ${+e.pass.toFixed(1)} ${t('of')} ${+e.possible.toFixed(1)} ${t('points')}.${e.duration ? ` ${t('Duration')} ${clock(e.duration)}.` : ''}`}));
        if (e?.stations.length) parts.push(el('h3', {textContent: t('Stations')}), el('ul', {}, ...e.stations.map(s => el('li', {textContent: `${t(readable(s.name))}${s.text ? `: ${s.text}` : ''}`}))));
        const n = app.state.clients ?? 1;
        parts.push(el('p', {className: 'note', textContent: `${t('Pages that have joined')}: ${n}`}));
        const start = el('button', {id: 'start', className: 'primary', textContent: t('Start'), onclick: () => app.play()});
        parts.push(el('div', {className: 'row'}, ...(app.mayRun ? [start] : [el('b', {textContent: t('The instructor starts the run.')})]), el('button', {textContent: t('Look around first'), onclick: () => this.close()})));
        const text = `${parts.map(p => p.textContent).join('\n')}${app.frame ? 1 : 0}`;   // wires come with the first frame
        if (!box.hidden && text === this.text) return;  // a repeated state must not take the focus
        const focus = app.mayRun && (box.hidden || document.activeElement?.id === 'start');
        this.text = text;
        const [title, ...rest] = parts, buttons = rest.pop();
        box.replaceChildren(title, el('div', {className: 'brief-columns'}, el('div', {}, ...rest), app.stage.bodies.bodies.length ? siteChart(app.stage.bodies.bodies, app.scene, app.frame, wind) : ''), buttons);
        box.hidden = false;
        if (focus) start.focus();
    }
}
