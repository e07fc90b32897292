// SPDX-License-Identifier: Apache-2.0
/// Choose tubes or lines by measurements in the page. Below 25 frames/s over half a second wires
/// become lines. Tubes are tried again if lines leave enough time for them; each further try waits
/// four times as long. Below 18 frames/s with lines, shadows are removed, too.

export class Quality {
    constructor() {
        this.tubes = true;
        this.poor = false;
        this.wait = 5000;
        this.since = 0;
        this.times = [];
        this.fps = 60;
    }

    /// Record a frame shown at `now` [ms] that needed `ms` of script and drawing.
    shown(now, ms) {
        if (this.last !== undefined && now - this.last < 4000) this.times.push([now - this.last, ms]);
        this.last = globalThis.document?.hidden ? undefined : now;
        const total = this.times.reduce((s, [gap]) => s + gap, 0);
        if (total < 600 || this.times.length < 4) return;
        this.fps = 1000 * this.times.length / total;
        this.cost = this.times.reduce((s, [, c]) => s + c, 0) / this.times.length;
        this.times = [];
        this.decide(now);
    }

    decide(now) {
        if (this.tubes && this.fps < 25) {
            this.tubes = false;
            this.since = now;
            this.wait = Math.min(240000, 4 * this.wait);
        } else if (!this.tubes) {
            if (this.fps < 18) this.poor = true;
            if (this.fps > 50 && now - this.since > this.wait) {
                this.tubes = true;
                this.poor = false;
                this.since = now;
            }
        }
    }
}
