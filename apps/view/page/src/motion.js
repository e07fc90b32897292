// SPDX-License-Identifier: Apache-2.0
/// Motion of a ship from its poses: heading, speed over ground, rate of turn, heel and trim. North is
/// +y, east +x, z up; the ship's x is forward, its y port.

/// Return heading, heel and trim [°] of a unit quaternion [w, x, y, z] from body to world. Heading
/// clockwise from north; heel positive to starboard; trim positive with the bow down.
export function attitude([w, x, y, z]) {
    const forward = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
    const port = 2 * (y * z + w * x), up = 1 - 2 * (x * x + y * y), deg = 180 / Math.PI;
    return {
        heading: (Math.atan2(forward[0], forward[1]) * deg + 360) % 360,
        heel: Math.atan2(port, up) * deg,
        trim: -Math.asin(Math.max(-1, Math.min(1, forward[2]))) * deg,
    };
}

const turn = (a, b) => ((b - a + 540) % 360) - 180;

/// Mean velocity and rate of turn over the last second or so, so that waves and rounding do not make
/// the digits flicker.
export class Motion {
    constructor(span = 1.0) {
        this.span = span;
        this.samples = [];
    }
    /// Take a pose. A time that goes back (a restore) begins anew.
    take(time, position, q) {
        const s = this.samples, last = s.at(-1);
        if (last && time < last.time) s.length = 0;
        if (last && time === last.time) s.pop();
        s.push({time, x: position[0], y: position[1], ...attitude(q)});
        while (s.length > 2 && s[1].time <= time - this.span) s.shift();
    }
    /// @return {heading, heel, trim [°], speed [m/s], course [°], rate [°/min]}, null before a pose
    read() {
        const b = this.samples.at(-1), a = this.samples[0];
        if (!b) return null;
        const dt = b.time - a.time, out = {heading: b.heading, heel: b.heel, trim: b.trim, speed: NaN, course: NaN, rate: NaN};
        if (dt > 0.2) {
            const dx = (b.x - a.x) / dt, dy = (b.y - a.y) / dt;
            out.speed = Math.hypot(dx, dy);
            out.course = (Math.atan2(dx, dy) * 180 / Math.PI + 360) % 360;
            out.rate = turn(a.heading, b.heading) / dt * 60;
        }
        return out;
    }
}
