// SPDX-License-Identifier: Apache-2.0
/// Sailors' units: knots, tonnes, degrees, metres a minute; or SI. A quantity's name decides between
/// units of the same dimension: a ship has knots, a wire metres a minute.
import {quantity} from './lever_logic.js';

const kTonne = 9806.65;                 // N, the weight of 1000 kg
const kKnot = 1852 / 3600;              // m/s
const kDegree = Math.PI / 180;          // rad
const afloat = /wind|gust|current|ground|through|ship|drift|surge|sway|speed_order|(^|[._ /])speed$/i;
const clockwise = /(^|\.)heading(_order)?$/;      // from the world's x axis, which is east
const anticlockwise = /(^|[._])(course|yaw)$/;     // of a pose

const ofWire = /winch|drum|wire|hoist|haul|tow|work|anchor|chain|windlass|luff|fold|knuckle|pay|slip/i;
const turning = /turn|yaw|heading|slew/i;
const shaft = /shaft|propeller|engine|drum|rpm/i;

export const units = {si: false};

/// Convert a value of an SI unit. @return [value, unit]
export function convert(value, unit, name = '', si = units.si) {
    if (si) return [value, unit];
    switch (unit) {
    case 'N': return [value / kTonne, 't'];
    case 'N m': return [value / kTonne, 't m'];
    case 'm/s': return ofWire.test(name) || !afloat.test(name) ? [value * 60, 'm/min'] : [value / kKnot, 'kn'];
    case 'rad': return [value / kDegree, '°'];
    case 'rad/s':
        if (shaft.test(name)) return [value * 30 / Math.PI, 'rpm'];
        return turning.test(name) ? [value / kDegree * 60, '°/min'] : [value / kDegree, '°/s'];
    default: return [value, unit];
    }
}

const kFine = 0.005;  // smallest amount that an instrument shows, in its unit
const ofInstruments = new Set(['kn', 'm', 'm/min', 'm/s', 't', 't m', '°', '°/s', '°/min', 'rpm']);

/// Format a quantity in the units of the page: "12.4 t", "8.1 kn". Less than an instrument shows is 0.
export function shown(value, unit, name = '', digits = 3, si = units.si) {
    if (unit === 'rad' && !si && Number.isFinite(value)) {
        if (clockwise.test(name)) return bearing(90 + value / kDegree);
        if (anticlockwise.test(name)) return bearing(90 - value / kDegree);
    }
    const [v, u] = convert(value, unit, name, si);
    return quantity(Math.abs(v) < kFine && ofInstruments.has(u) ? 0 : v, u, digits);
}

/// Format a heading or direction in degrees as on a compass: 0 to 359, three digits.
export const bearing = degrees => `${String(Math.round(((degrees % 360) + 360) % 360) % 360).padStart(3, '0')}°`;

/// Format a heel or another angle with its side: "3.2° S" for starboard; within 0.05° no side.
export const sided = (degrees, plus, minus) => `${Math.abs(degrees).toFixed(1)}°${Math.abs(degrees) < 0.05 ? '' : ` ${degrees > 0 ? plus : minus}`}`;
