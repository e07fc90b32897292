// SPDX-License-Identifier: Apache-2.0
/// A gamepad drives levers: each axis has a lever, a sense, and a dead zone for all; buttons do what
/// keys do. The mapping is kept by scene.
import {deadZone} from './lever_logic.js';

export const kButtons = {0: 'play', 1: 'neutral', 2: 'step', 3: 'camera', 4: 'previous', 5: 'next', 9: 'play'};

/// To begin with: the first levers in their order, upward sticks positive.
export const defaultMapping = levers => ({
    zone: 0.12,
    axes: [0, 1, 2, 3].map(axis => ({lever: levers[axis] ?? '', invert: axis % 2 === 1})),
});

/// What a pad asks for: [{lever name, deflection, holding}], and names of buttons newly pressed.
/// `before` is what this function returned for the pad the last time.
export function readPad(pad, mapping, before = {axes: [], pressed: []}) {
    const moves = [];
    const axes = mapping.axes.map((m, i) => {
        const d = deadZone(pad.axes[i] ?? 0, mapping.zone) * (m.invert ? -1 : 1);
        const was = before.axes[i] ?? 0;
        if (m.lever && (d !== 0 || was !== 0)) moves.push({lever: m.lever, deflection: d, holding: d !== 0});
        return d;
    });
    const pressed = pad.buttons.map(b => b.pressed);
    const commands = pressed.flatMap((p, i) => p && !before.pressed[i] && kButtons[i] ? [kButtons[i]] : []);
    return {axes, pressed, moves, commands};
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
        this.mapping = mapping;
    }

    /// Each picture.
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
                this.levers.activate(at);
                this.levers.deflect(at, move.deflection, move.holding);
            }
            for (const command of read.commands) this.run(command);
        }
        this.connected = name;
    }
}
