// SPDX-License-Identifier: Apache-2.0
/// The exercise: score, goals, penalties, alarms and displays; for the instructor its faults and its
/// end. Decisions and alarms are announced to screen readers.
import {$, clock, el, memory} from './dom.js';
import {readable} from './roles.js';
import {shown} from './units.js';
import {stateWord} from './vessel.js';
import {t} from './words.js';

const points = v => `${v > 0 ? '+' : v < 0 ? '−' : ''}${+Math.abs(v).toFixed(1)}`;
const title = one => one.text || readable(one.name);
const kFaults = {line_parts: 'line parts', motor_loses_force: 'motor loses force', brake_slips: 'brake slips', input_stuck: 'input stuck', input_late: 'input late', output_frozen: 'display frozen'};

/// Return the mark and words of a goal: reached, too late, or open.
export function goalState(goal, time) {
    if (goal.reached !== null) return {mark: '✓', className: 'done', words: `${t('reached at')} ${clock(goal.reached)}`};
    if (goal.late) return {mark: '✕', className: 'late', words: `${t('too late: until')} ${clock(goal.by)}`};
    const left = goal.by === null ? '' : `${clock(Math.max(0, goal.by - time))} ${t('left')}`;
    return {mark: '○', className: '', words: left};
}

export class ExercisePanel {
    constructor(panel, app) {
        Object.assign(this, {panel, app, exercise: null, faults: [], displays: [], sound: memory.get('sound', false), closed: null});
        $('over-close').addEventListener('click', () => this.close());
        $('over-debrief').addEventListener('click', () => { this.close(); app.debriefing.live(); });
    }

    get on() {
        return this.exercise !== null;
    }

    setExercise(e) {
        const first = !this.exercise || this.exercise.name !== e.name;
        this.exercise = e;
        document.body.classList.add('has-exercise');
        if (first) this.build();
        this.app.alarms.take(e.alarms, this.app.frame?.time ?? 0, title);
        this.paint();
        this.paintEnd();
        this.app.briefing.paint();
    }

    setFaults(faults) {
        this.faults = faults;
        if (this.faultBox) this.paintFaults();
    }

    /// Create the lists once; changes of their contents are painted later.
    build() {
        const {exercise: e, panel} = this;
        const list = id => el('ul', {id, className: 'tally'});
        this.score = el('output', {id: 'score', 'aria-live': 'polite', 'aria-label': t('Score')});
        this.left = el('span', {className: 'note', id: 'time-left'});
        this.goals = list('goals');
        this.penalties = list('penalties');
        this.alarms = el('ul', {id: 'alarms', className: 'tally'});
        this.shown = el('dl', {className: 'facts', id: 'displays'});
        const sound = el('input', {type: 'checkbox', id: 'sound', checked: this.sound});
        sound.addEventListener('change', () => {
            this.sound = sound.checked;
            memory.set('sound', this.sound);
            if (this.sound) this.beep();
        });
        const mine = e.stations.find(s => s.name === this.app.scene?.role.name);
        const parts = [el('h2', {textContent: readable(e.name), title: e.description}), el('p', {className: 'row score'}, this.score, this.left)];
        if (mine?.text) parts.push(el('p', {className: 'note', textContent: mine.text}));
        parts.push(el('div', {role: 'alert', 'aria-label': t('Alarms')}, this.alarms), el('h3', {textContent: t('Goals')}), this.goals);
        this.penaltyTitle = el('h3', {textContent: t('Penalties')});
        parts.push(this.penaltyTitle, this.penalties);
        if (e.displays.length) parts.push(el('h3', {textContent: t('Displays')}), this.shown);
        if (e.alarms.length) parts.push(el('label', {className: 'check'}, sound, el('span', {textContent: t('Sound of alarms')})));
        this.faultBox = el('div', {id: 'faults', hidden: true});
        parts.push(this.faultBox);
        panel.replaceChildren(...parts);
        panel.hidden = false;
        $('debrief').hidden = false;
        this.app.inset();
        this.names = new Set(this.app.scene?.outputs.map(o => o.name));
        this.displays = e.displays.map(name => {
            const value = el('dd', {});
            this.shown.append(el('dt', {textContent: t(readable(name)), title: name}), value);
            return {name, value};
        });
        this.paintFaults();
    }

    paint() {
        const e = this.exercise, time = this.app.frame?.time ?? 0;
        const score = `${points(e.points) || 0} ${t('of')} ${+e.possible.toFixed(1)} ${t('points')}`;
        if (this.score.textContent !== score) this.score.textContent = score;
        this.score.title = `${e.pass} are needed`;
        this.score.className = e.points >= e.pass ? 'good' : '';
        this.goals.replaceChildren(...e.goals.map(g => {
            const s = goalState(g, time);
            return el('li', {className: s.className}, el('b', {textContent: s.mark, 'aria-hidden': 'true'}), el('span', {textContent: title(g)}),
                el('i', {textContent: `${+g.possible.toFixed(1)}`, title: 'points'}), s.words ? el('small', {textContent: s.words}) : null);
        }));
        const costly = e.penalties.filter(p => p.times > 0);
        this.penaltyTitle.hidden = !costly.length;
        this.penalties.replaceChildren(...costly.map(p => el('li', {className: p.active ? 'active' : ''}, el('b', {textContent: '−', 'aria-hidden': 'true'}),
            el('span', {textContent: title(p)}), el('i', {textContent: points(p.points)}),
            el('small', {textContent: p.seconds > 0 ? `${p.seconds.toFixed(1)} s` : `${p.times}×`}))));
        const sounding = e.alarms.filter(a => a.active), names = sounding.map(a => a.name).join();
        if (names !== this.sounding) {  // only then: each change is spoken
            this.sounding = names;
            this.alarms.replaceChildren(...sounding.map(a => el('li', {className: 'alarm'}, el('b', {textContent: '!', 'aria-hidden': 'true'}), el('span', {textContent: `${t('Alarm')}: ${title(a)}`}))));
        }
    }

    paintFaults() {
        const box = this.faultBox, may = this.app.mayControl;
        box.hidden = !may;
        if (!may) return;
        const send = (f, active) => this.app.ask({type: 'fault', name: f.name, active});
        box.replaceChildren(el('h3', {textContent: t('Faults')}), ...this.faults.map(f => el('div', {className: 'fault'},
            el('span', {textContent: title(f), title: `${kFaults[f.kind] ?? f.kind}: ${f.target}`}),
            el('button', {textContent: f.active ? f.ends ? t('End') : t('Done') : t('Begin'), 'aria-pressed': String(f.active), 'data-fault': f.name, 'aria-label': `${f.active ? t('End') : t('Begin')}: ${title(f)}`,
                disabled: f.active && !f.ends, onclick: () => send(f, !f.active)}),
            el('small', {textContent: [kFaults[f.kind] ?? f.kind, f.at === null ? '' : `${t('by itself at')} ${clock(f.at)}`].filter(Boolean).join(', ')}))),
            this.noteForm(), el('button', {id: 'end-exercise', textContent: t('End the exercise'), disabled: this.exercise.ended !== null, onclick: () => this.app.ask({type: 'end'})}));
    }

    /// A remark of the instructor for the time line.
    noteForm() {
        const text = el('input', {type: 'text', className: 'text', maxLength: 120, placeholder: t('Note'), 'aria-label': t('Note for the time line'), id: 'note-text'});
        const form = el('form', {className: 'row note-form'}, text, el('button', {textContent: t('Note')}));
        form.addEventListener('submit', e => {
            e.preventDefault();
            if (!text.value.trim()) return;
            this.app.ask({type: 'note', text: text.value.trim()}, t('Noted'));
            text.value = '';
        });
        return form;
    }

    /// Show passed or failed in the middle of the page, until it is closed or a state is restored.
    paintEnd() {
        const e = this.exercise, box = $('over'), key = e.ended === null ? null : `${e.ended} ${e.end}`;
        if (key === null) this.closed = null;
        const button = $('end-exercise');
        if (button) button.disabled = key !== null;
        if (key === null || this.closed === key) return void (box.hidden = true);
        this.key = key;
        box.className = `panel ${e.outcome}`;
        $('over-title').textContent = e.outcome === 'passed' ? t('Passed') : t('Not passed');
        $('over-text').textContent = `${points(e.points) || 0} ${t('of')} ${+e.possible.toFixed(1)} ${t('points')}, ${+e.pass.toFixed(1)} ${t('needed')}. ${clock(e.ended)}: ${e.end}.`;
        if (box.hidden) {
            box.hidden = false;
            $('over-close').focus();
        }
    }

    close() {
        this.closed = this.key;
        $('over').hidden = true;
        $('canvas').focus();
    }

    /// Update displays and the remaining time with each frame.
    update(frame, now) {
        if (!this.on || now < (this.due ?? 0)) return;
        this.due = now + 150;
        const {scene} = this.app, e = this.exercise;
        for (const d of this.displays) {
            const k = scene.outputs.findIndex(o => o.name === d.name), value = k < 0 ? NaN : frame.outputs[k];
            const unit = k < 0 || scene.outputs[k].unit === '1' ? '' : scene.outputs[k].unit, state = Number.isFinite(value) ? stateWord(d.name, value, this.names) : '';
            const share = unit === '' && /\.utilisation$/.test(d.name), words = state ? t(state) : !Number.isFinite(value) ? '–' : share ? `${Math.round(100 * value)} %` : shown(value, unit, d.name);
            if (d.value.textContent !== words) d.value.textContent = words;
        }
        this.left.textContent = e.ended !== null ? t('ended') : e.duration === null ? '' : `${clock(Math.max(0, e.duration - frame.time))} ${t('left')}`;
        if (e.goals.some(g => g.by !== null && g.reached === null)) this.paint();
        if (this.sound && this.app.alarms.book.sounding && now >= (this.beepDue ?? 0)) {
            this.beepDue = now + 1000;
            this.beep();
        }
    }

    beep() {
        const Audio = window.AudioContext;
        if (!Audio) return;
        this.audio ??= new Audio();
        const tone = this.audio.createOscillator(), gain = this.audio.createGain(), t = this.audio.currentTime;
        tone.frequency.value = 880;
        gain.gain.setValueAtTime(0.08, t);
        gain.gain.exponentialRampToValueAtTime(0.001, t + 0.4);
        tone.connect(gain).connect(this.audio.destination);
        tone.start(t);
        tone.stop(t + 0.4);
    }
}
