// SPDX-License-Identifier: Apache-2.0
/// The foot of the page: scrubbing of recordings with events on the line, and the last events.
import {$, clock, el} from './dom.js';
import {eventText, ofSolver} from './event_words.js';

const kShown = 12;
const often = ['slack', 'taut', 'more'];   // would cover the line
const bad = /break|fail|overload|alarm|part|diverg/;

export class Timeline {
    /// @param app  For the names of alarms and the role.
    constructor(seek, app) {
        this.seek = seek;
        this.app = app;
        this.scrub = $('scrub');
        this.marks = $('marks');
        this.range = null;
        this.pending = null;
        this.busy = false;
        this.scrub.addEventListener('input', () => this.want(Number(this.scrub.value)));
    }

    /// Return the first and last time of a recording; null: there is none.
    setRange(range) {
        this.range = range;
        $('track').hidden = !range;
        if (!range) return;
        this.scrub.min = range[0];
        this.scrub.max = range[1];
        this.paintMarks();
    }

    setEvents(events) {
        this.events = (events ?? []).filter(e => !often.includes(e.kind));
        this.paintMarks();
        $('events').replaceChildren();
    }

    paintMarks() {
        if (!this.range) return;
        const [a, b] = this.range;
        this.marks.replaceChildren(...(this.events ?? []).slice(0, 600).map(e => {
            const mark = el('i', {className: e.kind === 'command' ? 'command' : '', title: `${clock(e.time)} ${this.words(e)}`});
            mark.style.left = `${100 * (e.time - a) / Math.max(1e-9, b - a)}%`;
            return mark;
        }));
    }

    /// Seek. Only one seek is pending at a time; the newest waits.
    async want(time) {
        this.pending = time;
        this.held = performance.now() + 400;
        if (this.busy) return;
        this.busy = true;
        while (this.pending !== null) {
            const t = this.pending;
            this.pending = null;
            await this.seek(t);
        }
        this.busy = false;
    }

    /// Return the event on the line before or after a time.
    neighbour(time, way) {
        const times = (this.events ?? []).map(e => e.time).sort((a, b) => a - b);
        return way > 0 ? times.find(t => t > time + 1e-6) : times.reverse().find(t => t < time - 1e-6);
    }

    update(time) {
        if (!this.range || performance.now() < (this.held ?? 0)) return;
        this.scrub.value = time;
        this.scrub.setAttribute('aria-valuetext', `${clock(time)} of ${clock(this.range[1])}`);
    }

    words(event) {
        return eventText(event, this.app.exercise.alarmNames);
    }

    /// Show an event and announce it to screen readers. Findings of the solver are for the instructor.
    tell(event) {
        if (often.includes(event.kind) || ofSolver(event.kind) && this.app.exercise.on && !this.app.mayControl) return;
        const words = this.words(event);
        const item = el('li', {className: bad.test(event.kind) ? 'bad' : 'note', textContent: `${clock(event.time)} ${words}`});
        $('events').prepend(item);
        while ($('events').children.length > kShown) $('events').lastChild.remove();
        const said = $('said');
        said.append(el('p', {textContent: words}));
        while (said.children.length > 20) said.firstChild.remove();
    }
}
