// SPDX-License-Identifier: Apache-2.0
/// Texts of events in the words of the trade, with sailors' units and three digits. The server's own words
/// (SI, names of the program) stay for commands, entries of an exercise and findings of the solver.
import {readable} from './roles.js';
import {shown} from './units.js';
import {t} from './words.js';

/// Unit of the value by kind; '': a plain number, null: the value is not shown.
const kUnits = {
    line_break: 'N', slack: null, taut: 'N', saturation: null, range: null, layer: '', brake_slip: 'N m', release: 'N', weak_link: 'N', drum_empty: 'N',
    cut: 'N', join: 'm', detach: 'N', chain_jump: 'N', render: 'N', alarm: '%', alarm_end: '%', overload: 'N', missed: 'm', hauled_in: 'N',
    lift_off: 'N', lay_on: 'N', shed: 'W', mode_refused: null, position_lost: 'm', failure_critical: '%',
};
/// Kinds that concern the solver: for the engineer, not for a station.
const kOfSolver = new Set(['warning', 'energy_created', 'joint_open', 'cable_law', 'uncertified', 'fast', 'no_node', 'node_limit', 'incomplete', 'input_clamped']);

export const ofSolver = kind => kOfSolver.has(kind);

/// Return the name of the source of an event; for a broken line with its position: "Towline at 198 m".
export function sourceOf(name) {
    const along = /^\S+ \((.+) at ([\d.]+) m\)$/.exec(name);
    if (along) return `${readable(along[1])} ${t('at')} ${Number(along[2]).toFixed(0)} m`;
    return readable(name.replace(/\/(hull|drum|hook)$/, '').replace(/ (node|cable_element|[a-z_]+) \d+$/, ''));
}

/// Return the text of an event. @param entries  Names of the alarms of an exercise: their events have words of
/// their own.
export function eventText(event, entries = []) {
    const unit = kUnits[event.kind], own = event.words ?? `${event.name} ${event.kind}`;
    if (unit === undefined || entries.includes(event.name) || !event.name || event.name === '-') return own;
    const share = / \((\d+) % of its breaking load\)/.exec(own), value = event.value;
    const amount = unit === null || !Number.isFinite(value) ? '' : unit === '%' ? `${Math.round(100 * value)} %` : unit === '' ? String(Math.round(value)) : shown(value, unit, event.name);
    return `${sourceOf(event.name)}: ${t(`event ${event.kind}`)}${amount ? ` ${amount}` : ''}${share ? ` (${share[1]} % ${t('of MBL')})` : ''}`;
}
