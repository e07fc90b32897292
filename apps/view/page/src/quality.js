// SPDX-License-Identifier: Apache-2.0
/// Tubes or lines: measured in the page. Below 25 frames/s over half a second wires become lines;
/// tubes are tried again where lines leave so much time that tubes would fit, and after that only
/// when four times as long has passed. Below 18 frames/s with lines shadows go too.

export class Quality {
    constructor() {
        this.tubes = true;
        this.poor = false;
        this.wait = 5000;
        this.since = 0;
        this.times = [];
        this.fps = 60;
    }

    /// A frame was shown at `now` [ms]; `ms` of script and drawing were spent on it.
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
