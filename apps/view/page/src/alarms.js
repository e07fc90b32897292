// SPDX-License-Identifier: Apache-2.0
/// Alarms stay in the list until they are acknowledged, as on a ship's bridge. An alarm is raised when
/// its condition begins and cleared when it ends. An acknowledged one leaves the list when it is
/// cleared; a cleared one leaves it when it is acknowledged.
import {clock, el} from './dom.js';
import {t} from './words.js';

export const kPriority = {danger: 2, warning: 1};

/// Alarms by key, independent of the page.
export class AlarmBook {
    constructor() {
        this.entries = new Map();
    }
    raise(key, text, time, priority = 'warning') {
        const was = this.entries.get(key);
        if (was?.active && priority === was.priority) return false;
        this.entries.set(key, {key, text, time, priority, active: true, seen: false, times: (was?.times ?? 0) + 1});
        return true;
    }
    clear(key) {
        const entry = this.entries.get(key);
        if (!entry?.active) return false;
        entry.active = false;
        if (entry.seen) this.entries.delete(key);
        return true;
    }
    acknowledge(key) {
        const entry = this.entries.get(key);
        if (!entry || entry.seen) return false;
        entry.seen = true;
        if (!entry.active) this.entries.delete(key);
        return true;
    }
    acknowledgeAll() {
        for (const key of [...this.entries.keys()]) this.acknowledge(key);
    }
    reset() {
        this.entries.clear();
    }
    /// Not acknowledged before acknowledged, dangers before warnings, new before old.
    list() {
        return [...this.entries.values()].sort((a, b) => a.seen - b.seen || kPriority[b.priority] - kPriority[a.priority] || b.time - a.time);
    }
    get sounding() {
        return [...this.entries.values()].some(e => !e.seen);
    }
}

// Events that are dangers for people or gear; they have no end, so they count as cleared at once.
export const kDangers = {line_break: 'Wire parted', overload: 'Overload', capsize: 'Capsized', weak_link: 'Weak link parted', drum_empty: 'Drum empty', brake_slip: 'Brake slips', release: 'Emergency release', diverged: 'Simulation failed'};
const kMostRows = 3;

export class AlarmList {
    constructor(box) {
        this.box = box;
        this.book = new AlarmBook();
        this.dirty = true;
    }
    /// Take the alarms of an exercise: raise those that are active, clear the others.
    take(alarms, time, title) {
        for (const a of alarms) {
            if (a.active) this.dirty = this.book.raise(`a:${a.name}`, title(a), time) || this.dirty;
            else this.dirty = this.book.clear(`a:${a.name}`) || this.dirty;
        }
    }
    event(e) {
        const what = kDangers[e.kind];
        if (!what) return;
        const key = `e:${e.kind}:${e.name}`;
        this.book.raise(key, e.words || `${t(what)}: ${e.name}`, e.time, 'danger');
        this.book.clear(key);
        this.dirty = true;
    }
    acknowledge(key) {
        this.dirty = this.book.acknowledge(key) || this.dirty;
        this.paint();
    }
    all() {
        this.book.acknowledgeAll();
        this.dirty = true;
        this.paint();
    }
    reset() {
        this.book.reset();
        this.dirty = true;
    }
    paint() {
        if (!this.dirty) return;
        this.dirty = false;
        const list = this.book.list(), rows = list.slice(0, kMostRows), more = list.length - rows.length;
        this.box.hidden = !list.length;
        this.box.replaceChildren(el('ul', {}, ...rows.map(e => el('li', {className: `${e.priority}${e.seen ? ' seen' : ''}${e.active ? '' : ' over'}`},
            el('b', {textContent: e.priority === 'danger' ? '▲' : '●', 'aria-hidden': 'true'}),
            el('span', {textContent: `${clock(e.time)} ${e.text}${e.active ? '' : ` (${t('ended')})`}${e.times > 1 ? ` ×${e.times}` : ''}`}),
            e.seen ? el('i', {textContent: t('acknowledged')}) : el('button', {textContent: t('Acknowledge'), 'aria-label': `${t('Acknowledge')} ${e.text}`, onclick: () => this.acknowledge(e.key)})))),
            more > 0 || list.filter(e => !e.seen).length > 1 ? el('button', {className: 'all', textContent: more > 0 ? `${t('Acknowledge all')} (${list.length})` : t('Acknowledge all'), onclick: () => this.all()}) : '');
    }
}
