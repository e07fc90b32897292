// SPDX-License-Identifier: Apache-2.0
/// The debriefing on paper: names, date, score, goals, penalties, alarms, events and curves, for the print dialog
/// of the browser, which also writes PDF. The style sheet prints this sheet alone.
import {controlCurves, curvePath, kHigh, kMarks, kMostRows, kWide, rangeOf} from './curves.js';
import {clock, el, svg} from './dom.js';
import {readable} from './roles.js';
import {shown} from './units.js';
import {t} from './words.js';

const points = v => `${+v.toFixed(1)}`;

/// Return the date and time of a report, as "2026-03-01 09:05".
export function stampOf(date) {
    const two = v => String(v).padStart(2, '0');
    return `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())} ${two(date.getHours())}:${two(date.getMinutes())}`;
}

/// Return the rows of a table of goals or penalties: [mark, text, time or number, points].
export const tallyRows = list => list.map(g => g.possible > 0 ? [g.reached === null ? '✕' : '✓', g.text || readable(g.name), g.reached === null ? '–' : clock(g.reached), `${points(g.points)} / ${points(g.possible)}`]
    : ['−', g.text || readable(g.name), `${g.times}×${g.seconds > 0 ? `, ${g.seconds.toFixed(1)} s` : ''}`, points(g.points ?? 0)]);

/// Return the rows of the events: [time, text, role, points].
export const entryRows = entries => entries.map(e => [clock(e.time), `${kMarks[e.kind] ?? '·'} ${e.text || readable(e.name ?? '')}`, e.by ? t(readable(e.by)) : '', e.points ? `${e.points > 0 ? '+' : '−'}${points(Math.abs(e.points))}` : '']);

/// Return the curves of a debriefing: displays, then controls, as on the panel.
export const curvesOf = (data, end) => [...data.displays.map((name, k) => ({name, role: '', kind: 'display', times: data.times, values: data.values[k] ?? []})), ...controlCurves(data.controls, end).map(c => ({...c, kind: 'control'}))].filter(c => c.times.length).slice(0, kMostRows);

function table(title, heads, rows) {
    if (!rows.length) return null;
    const cells = (tag, row) => el('tr', {}, ...row.map(text => el(tag, {textContent: text})));
    return el('section', {}, el('h2', {textContent: t(title)}), el('table', {}, el('thead', {}, cells('th', heads.map(h => h && t(h)))), el('tbody', {}, ...rows.map(r => cells('td', r)))));
}

function curve(c, span, other, unitOf) {
    const [unit, signal] = unitOf(c.name), also = c.kind === 'display' ? other?.values[other.displays.indexOf(c.name)] ?? [] : [], range = rangeOf([c.values, also]), text = v => shown(v, unit, signal);
    const lines = [svg('path', {d: `M0 ${kHigh}H${kWide}`, class: 'axis'}), ...also.length ? [svg('path', {d: curvePath(other.times, also, span, range), class: 'curve other'})] : [], svg('path', {d: curvePath(c.times, c.values, span, range), class: `curve ${c.kind}`})];
    return el('figure', {}, el('figcaption', {}, el('b', {textContent: `${t(readable(c.name))}${c.role ? ` (${t(readable(c.role))})` : ''}`}), ` ${text(range[0])} … ${text(range[1])}`),
        svg('svg', {viewBox: `0 0 ${kWide} ${kHigh}`, preserveAspectRatio: 'none'}, ...lines));
}

/// Return the sheet. @param d  Debriefing. @param entries  Events and notes by time. @param more  {people, date, span,
/// other: another run or null, unitOf(name): [unit, signal]}.
export function reportSheet(d, entries, {people, date, span, other, unitOf}) {
    const score = one => `${points(one.points)} ${t('of')} ${points(one.possible)} ${t('points')}, ${points(one.pass)} ${t('needed')}. ${t(one.outcome === 'passed' ? 'Passed' : one.outcome === 'failed' ? 'Not passed' : 'running')}${one.end ? `: ${one.end}` : ''} (${clock(one.time)})`;
    const heading = [people, stampOf(date)].filter(Boolean).join(', ');
    return el('article', {id: 'sheet'}, el('h1', {textContent: `${t('Debriefing')}: ${readable(d.name)}`}), el('p', {className: 'people', textContent: heading}), el('p', {textContent: d.description ?? ''}),
        el('p', {className: 'result', textContent: score(d)}), other ? el('p', {textContent: `${t('Other run')}: ${score(other)}`}) : null,
        table('Goals', ['', 'Goal', 'Time', 'points'], tallyRows(d.goals)), table('Penalties', ['', 'Penalty', 'Duration', 'points'], tallyRows(d.penalties.filter(p => p.times > 0))),
        table('Alarms', ['', 'Alarm', 'Duration', ''], tallyRows((d.alarms ?? []).filter(a => a.times > 0)).map(r => [...r.slice(0, 3), ''])), table('Events and notes', ['Time', 'What', 'Station', 'points'], entryRows(entries)),
        el('section', {className: 'curves'}, el('h2', {textContent: `${t('Curves')}, ${clock(span[0])} … ${clock(span[1])}`}), ...curvesOf(d, span[1]).map(c => curve(c, span, other, unitOf))));
}

/// Print a sheet: the page shows it alone while the dialog is open.
export function printSheet(sheet) {
    document.getElementById('sheet')?.remove();
    document.body.append(sheet);
    const title = document.title;
    document.title = sheet.querySelector('h1').textContent.replace(/[:/]/g, '');   // browsers propose it as the name of the file
    addEventListener('afterprint', () => {
        sheet.remove();
        document.title = title;
    }, {once: true});
    print();
}
