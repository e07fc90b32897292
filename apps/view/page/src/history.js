// SPDX-License-Identifier: Apache-2.0
/// History for plots: a ring of samples of all series, by simulated time.

export class History {
    /// @param names  Names of series. @param length  Capacity. @param gap  Least time between two [s].
    constructor(names, length = 2400, gap = 1 / 30) {
        this.names = names;
        this.length = length;
        this.gap = gap;
        this.time = new Float64Array(length);
        this.rows = names.map(() => new Float32Array(length));
        this.clear();
    }

    clear() {
        this.count = 0;
        this.next = 0;
        this.last = -Infinity;
    }

    /// Add a sample; values(i) returns that of series i. An earlier time (restore, seek) removes all later
    /// samples. @return true if it was stored.
    add(time, values) {
        if (time < this.last) this.cutAfter(time);
        if (time < this.last + this.gap * 0.999) return false;
        this.time[this.next] = time;
        for (let i = 0; i < this.rows.length; ++i) this.rows[i][this.next] = values(i);
        this.next = (this.next + 1) % this.length;
        this.count = Math.min(this.length, this.count + 1);
        this.last = time;
        return true;
    }

    cutAfter(time) {
        while (this.count > 0) {
            const at = (this.next - 1 + this.length) % this.length;
            if (this.time[at] <= time) break;
            this.next = at;
            --this.count;
        }
        this.last = this.count ? this.time[(this.next - 1 + this.length) % this.length] : -Infinity;
    }

    /// Return columns for a plot: times, then the series of these indices, the last `span` seconds.
    columns(indices, span) {
        const from = this.last - span, time = [], out = indices.map(() => []);
        for (let k = 0; k < this.count; ++k) {
            const at = (this.next - this.count + k + this.length) % this.length;
            if (this.time[at] < from) continue;
            time.push(this.time[at]);
            indices.forEach((i, n) => {
                const v = this.rows[i][at];
                out[n].push(Number.isFinite(v) ? v : null);
            });
        }
        return [time, ...out];
    }
}
