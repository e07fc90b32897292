// SPDX-License-Identifier: Apache-2.0
/// Logic of the displays of a vessel, independent of the page: names of its signals, the station's
/// ship, the ship's outline, footprint and stability gauge.

export const kVesselModes = ['off', 'joystick', 'heading', 'position', 'follow'];
export const kCriteria = ['', 'angle of heel', 'residual area', 'residual lever', 'freeboard at the stern'];

const systemOf = signal => signal.includes('.') ? signal.slice(0, signal.lastIndexOf('.')) : '';
/// Return the name of the signal that an input sets: "ahts/ship.mode" for the input "mode".
export const signalOf = input => input.drives || input.name;

/// Words for 0 and 1 of a switch, by the last part of its signal: hooks, shark jaw, guide pins.
const kSwitches = {take: ['hook open', 'hook takes'], close: ['jaw open', 'jaw closed'], up: ['pin down', 'pin up']};

/// Return the words for the values of an input; [] if it is no choice. A mode of a vessel has those of
/// docs/vessels.md, within the range of the input. Hooks, jaws and pins are switches.
export function choicesOf(input, vessels = []) {
    if (input.words?.length) return input.words;
    const signal = signalOf(input), between = input.min === 0 && input.max === 1 && signal.includes('.');
    if (between && kSwitches[signal.slice(signal.lastIndexOf('.') + 1)]) return kSwitches[signal.slice(signal.lastIndexOf('.') + 1)];
    if (!signal.endsWith('.mode') || !vessels.some(v => v.name === systemOf(signal))) return [];
    return kVesselModes.slice(0, Math.min(kVesselModes.length, (input.max ?? 4) + 1));
}

const kJawStates = ['open', 'closing', 'holds', 'opening', 'closed, empty', 'opened by overload'], kHookStates = ['empty', 'waits', 'holds', 'load too high', 'opened by overload'];

/// Return the words of an output that counts states: of a shark jaw or hook; '' for other outputs.
/// @param names  Set of the names of all outputs.
export function stateWord(name, value, names) {
    const cut = name.lastIndexOf('.'), system = name.slice(0, cut), last = name.slice(cut + 1);
    const jaw = names.has(`${system}.close`), hook = names.has(`${system}.take`);
    if (last === 'state' && (jaw || hook)) return (jaw ? kJawStates : kHookStates)[Math.round(value)] ?? '';
    if (last === 'held' && (jaw || hook)) return value > 0.5 ? 'yes' : 'no';
    return '';
}

/// Return the system of a drum's wire: its drum is the scalar body "SYSTEM/drum"; '' without one.
export function winchOfDrum(scene, drum) {
    const systems = new Set(scene.systems.map(s => s.name)), body = scene.bodies.find(b => b.id === drum.drum)?.name ?? '';
    for (const name of [body, drum.name])
        for (let cut = name.length; cut > 0; cut = name.lastIndexOf('/', cut - 1)) if (systems.has(name.slice(0, cut))) return name.slice(0, cut);
    return '';
}

/// Return the id of the body that a station works on: that of the vessel or winch of most of its
/// inputs; null: none. Cylinders and hoists of a crane do not count: they are on the crane.
export function stationBody(scene, names) {
    const count = new Map(), add = body => count.set(body, (count.get(body) ?? 0) + 1), winch = system => scene.outputs.some(o => o.name === `${system}.pull`);
    for (const input of scene.inputs) {
        if (!names.includes(input.name)) continue;
        const system = systemOf(signalOf(input)), vessel = scene.vessels?.find(v => v.name === system);
        const drum = scene.drums.find(d => winchOfDrum(scene, d) === system);
        if (vessel) add(vessel.body);
        else if (system && drum && winch(system)) add(drum.body);
    }
    return [...count].sort((a, b) => b[1] - a[1])[0]?.[0] ?? null;
}

/// Direction of the thrust of a propulsor in the ship's frame, x ahead, y to port, times its sign.
/// @param turned  Angle of an azimuth, clockwise from ahead [rad].
export function thrustDirection(kind, thrust, turned = 0) {
    const s = Math.sign(thrust);
    if (kind === 'tunnel') return [0, -s];   // positive: to starboard
    const a = kind === 'azimuth' || kind === 'cycloidal' ? turned : 0;
    return [s * Math.cos(a), -s * Math.sin(a)];
}

/// Return the smallest radius of the footprint plot [m] that contains all points, from a few.
export function plotRadius(points, least = 5) {
    const most = Math.max(least, ...points.map(([x, y]) => Math.hypot(x, y)));
    return [5, 10, 20, 50, 100, 200, 500, 1000].find(r => r >= most) ?? most;
}

/// Offsets of a ship over the last `span` seconds, one a second.
export class Trail {
    constructor(span = 180) {
        this.span = span;
        this.points = [];
    }
    take(time, x, y) {
        const last = this.points.at(-1);
        if (last && time < last.time) this.points.length = 0;
        if (!Number.isFinite(x) || !Number.isFinite(y) || last && time >= last.time && time < last.time + 1) return false;
        this.points.push({time, x, y});
        while (this.points[0].time < time - this.span) this.points.shift();
        return true;
    }
}

/// State of the stability gauge. @param warn  Utilisation of its warning.
/// @return {share: utilisation 0 to 1.2, percent, state}
export function gaugeState(tension, permissible, warn = 0.8) {
    if (!(permissible > 0)) return {share: 1.2, percent: NaN, state: 'danger'};
    const share = Math.max(0, tension) / permissible;
    return {share: Math.min(1.2, share), percent: Math.round(100 * share), state: share >= 1 ? 'danger' : share >= warn ? 'warn' : 'good'};
}

/// Corners of a ship's outline from above, ahead up, in units of the half sizes: x to starboard, y down.
export const kOutline = 'M-0.93 1 L-1 0.75 L-1 -0.3 C-1 -0.7 -0.45 -0.93 0 -1 C0.45 -0.93 1 -0.7 1 -0.3 L1 0.75 L0.93 1 Z';
