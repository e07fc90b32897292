// SPDX-License-Identifier: Apache-2.0
/// A gamepad moves controls: each axis has a control and a direction, and all have one dead zone.
/// Buttons act like keys. The mapping is stored for each scene.
import {deadZone} from './lever_logic.js';

/// Commands of the buttons of a standard gamepad. `less` and `more` move the selected control: with
/// `previous` and `next` they reach every control and switch of a station.
export const kButtons = {0: 'play', 1: 'neutral', 2: 'step', 3: 'camera', 4: 'previous', 5: 'next', 6: 'less', 7: 'more', 8: 'acknowledge', 9: 'play', 10: 'release', 12: 'Ahead', 13: 'Astern', 14: 'Port', 15: 'Starboard'};
const kRepeat = {less: 6, more: 6};   // polls between repetitions of a button that is held

/// Return the default mapping: the first controls in their order, upward sticks positive.
export const defaultMapping = levers => ({
    zone: 0.12,
    axes: [0, 1, 2, 3].map(axis => ({lever: levers[axis] ?? '', invert: axis % 2 === 1})),
    buttons: {...kButtons},
});

/// Return the requests of a pad: [{lever name, deflection, holding}], and newly pressed buttons.
/// @param before  The last result for this pad.
export function readPad(pad, mapping, before = {axes: [], pressed: []}) {
    const moves = [];
    const axes = mapping.axes.map((m, i) => {
        const d = deadZone(pad.axes[i] ?? 0, mapping.zone) * (m.invert ? -1 : 1);
        const was = before.axes[i] ?? 0;
        if (m.lever && (d !== 0 || was !== 0)) moves.push({lever: m.lever, deflection: d, holding: d !== 0});
        return d;
    });
    const pressed = pad.buttons.map(b => b.pressed);
    const buttons = mapping.buttons ?? kButtons, held = pressed.map((p, i) => p ? (before.held?.[i] ?? 0) + 1 : 0);
    const commands = held.flatMap((n, i) => buttons[i] && (n === 1 || n > 18 && kRepeat[buttons[i]] && n % kRepeat[buttons[i]] === 0) ? [buttons[i]] : []);
    return {axes, pressed, held, moves, commands};
}

export class Gamepads {
    constructor(levers, run) {
        this.levers = levers;
        this.run = run;
        this.before = new Map();
        this.mapping = defaultMapping([]);
        this.connected = '';
    }

    setMapping(mapping) {
        this.mapping = {...mapping, buttons: mapping.buttons ?? {...kButtons}};   // stored by an earlier page
    }

    /// Update for each picture.
    poll(pads = navigator.getGamepads?.() ?? []) {
        let name = '';
        for (const pad of pads) {
            if (!pad || !pad.connected) continue;
            name = pad.id;
            const read = readPad(pad, this.mapping, this.before.get(pad.index));
            this.before.set(pad.index, read);
            for (const move of read.moves) {
                const at = this.levers.levers.findIndex(l => l.def.name === move.lever);
                if (at < 0) continue;
                if (move.holding) this.levers.activate(at);
                this.levers.deflect(at, move.deflection, move.holding);
            }
            for (const command of read.commands) this.run(command);
        }
        this.connected = name;
    }
}
