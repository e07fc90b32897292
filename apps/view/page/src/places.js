// SPDX-License-Identifier: Apache-2.0
/// Positions of the things that events name, for the map of the instructor.
import {Vector3} from 'three';

/// Return the middle of a wire in a frame [x, y, z]; null: it is removed.
export function wireMiddle(frame, wire) {
    let at = 0;
    for (let i = 0; i < wire; ++i) at += frame.counts[i];
    const n = frame.counts[wire], k = 3 * (at + (n >> 1));
    return n > 0 ? [frame.wirePoints[k], frame.wirePoints[k + 1], frame.wirePoints[k + 2]] : null;
}

/// Return the name without its last part: "a/b.c" → "a/b", "tow/s39 (tow at 198 m)" → "tow/s39"; '' at the end.
export const shorter = name => name.slice(0, Math.max(0, name.lastIndexOf(' '), name.lastIndexOf('/'), name.lastIndexOf('.')));

/// Return the position of the thing that an event names [x, y, z]; null: not known. A name that nothing
/// has is shortened from its end, so that parts of a system have the position of the system.
/// @param faults  Of the exercise: {name, target}. @param bodies  Of the stage.
export function placeOf(name, {scene, frame, bodies, faults = []}, depth = 0) {
    const point = (id, local) => {
        const body = bodies.find(b => b.id === id);
        return body && Number.isFinite(body.position.x) ? (local ? new Vector3(...local).applyMatrix4(body.matrix) : body.position).toArray() : null;
    };
    const fault = depth < 3 && (faults.find(f => f.name === name)?.target || scene.inputs.find(i => i.name === name)?.drives);
    if (fault && fault !== name) return placeOf(fault, {scene, frame, bodies, faults}, depth + 1);
    for (let own = name; own; own = shorter(own)) {
        const wire = frame ? scene.wires.findIndex(w => w.name === own) : -1, drum = (scene.drums ?? []).find(d => d.name === own), joint = (scene.joints ?? []).find(j => j.name === own);
        const vessel = (scene.vessels ?? []).find(v => v.name === own) ?? (scene.gauges ?? []).find(g => g.name === own);
        const body = bodies.find(b => b.name === own && b.def.kind !== 'scalar') ?? bodies.find(b => b.name === `${own}/hull`);
        const part = () => bodies.find(b => b.name.startsWith(`${own}/`) && b.def.kind !== 'scalar');
        const drumOf = () => (scene.drums ?? []).find(d => scene.bodies.find(b => b.id === d.drum)?.name === `${own}/drum`);
        const at = wire >= 0 ? wireMiddle(frame, wire) : drum ? point(drum.body, drum.point) : body ? point(body.id) : vessel ? point(vessel.body) : joint ? point(joint.bodies[1], joint.point) : drumOf() ? point(drumOf().body, drumOf().point) : part() ? point(part().id) : null;
        if (at) return at;
    }
    return null;
}
