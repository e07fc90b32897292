// SPDX-License-Identifier: Apache-2.0
/// Map of the instructor: the chart of the site with the last events at the things that they name, numbered,
/// and a list of them. A press on an entry moves the camera there.
import {siteChart} from './chart.js';
import {clock, el} from './dom.js';
import {eventText, ofSolver} from './event_words.js';
import {placeOf} from './places.js';
import {t} from './words.js';

const kMost = 6, kSpan = 600;   // events in the list, and their greatest age [s]
const kSilent = new Set(['slack', 'taut', 'more', 'layer']);
const kBad = /break|part|fail|overload|alarm|lost|slip|penalty|fault|weak_link|capsize|diverged/;

/// The last events that a map shows, newest first.
export class Recent {
    constructor() {
        this.events = [];
    }
    /// Add an event. Commands other than notes are left out.
    take(event) {
        if (kSilent.has(event.kind) || ofSolver(event.kind) || event.kind === 'command' && !/ note: /.test(event.words ?? '')) return false;
        this.events.unshift(event);
        this.events.length = Math.min(this.events.length, 40);
        return true;
    }
    /// Return the events to show at a time, and forget those that are later: a state was restored.
    list(time) {
        this.events = this.events.filter(e => e.time <= time + 1);
        return this.events.filter(e => e.time >= time - kSpan).slice(0, kMost);
    }
}

export class EventMap {
    constructor(app) {
        this.app = app;
        this.chart = el('div', {});
        this.list = el('ol', {className: 'map-events'});
        this.box = el('details', {className: 'map', id: 'map', open: true}, el('summary', {textContent: t('Map')}), this.chart, this.list);
    }

    /// Draw the map once a second.
    update(now) {
        const {app, box} = this, {frame, scene, stage} = app;
        if (!frame || !box.open || now < (this.due ?? 0) || !box.checkVisibility?.()) return;
        this.due = now + 1000;
        const bodies = stage.bodies.bodies, places = {scene, frame, bodies, faults: app.exercise.faults}, read = name => frame.outputs[scene.outputs.findIndex(o => o.name === name)];
        const marks = app.recent.list(frame.time).map((e, i) => ({label: String(i + 1), bad: kBad.test(e.kind), event: e, at: placeOf(e.name, places)}));
        const wind = Number.isFinite(read('sea.wind')) ? {speed: read('sea.wind'), to: read('sea.wind_direction') ?? 0} : null;
        this.chart.replaceChildren(siteChart(bodies, scene, frame, wind, marks.filter(m => m.at)));
        const text = marks.map(m => `${m.event.time} ${m.event.name} ${m.at ? 1 : 0}`).join();
        if (text === this.text) return;   // a repeated list must not take the focus
        this.text = text;
        this.list.replaceChildren(...marks.map(m => el('li', {className: m.bad ? 'bad' : ''}, el('b', {textContent: m.at ? m.label : '–'}),
            el('button', {disabled: !m.at, onclick: () => this.go(m.event), textContent: `${clock(m.event.time)} ${eventText(m.event, app.exercise.alarmNames)}`}))));
    }

    /// Move the camera to the thing that an event names, where it is now.
    go(event) {
        const {app} = this, at = placeOf(event.name, {scene: app.scene, frame: app.frame, bodies: app.stage.bodies.bodies, faults: app.exercise.faults});
        if (at) app.goTo(at);
    }
}
