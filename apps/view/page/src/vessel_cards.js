// SPDX-License-Identifier: Apache-2.0
/// Displays of a vessel at bridge and winch stations: propulsion in plan (thrust, azimuth, rudders), DP
/// desk with footprint, stability gauge, switchboards. Each has build() in its constructor and
/// paint(read, frame), where read(name) returns an output.
import {el, svg} from './dom.js';
import {t} from './words.js';
import {gaugeState, kCriteria, kOutline, kVesselModes, plotRadius, thrustDirection, Trail} from './vessel.js';
import {readable} from './roles.js';
import {bearing, shown, sided} from './units.js';

const deg = 180 / Math.PI;
export const fromX = radians => bearing(90 + radians * deg);   // clockwise from the world's x axis, which is east

/// Set text that has changed.
const put = (e, words) => { if (e.textContent !== words) e.textContent = words; };

class Row {
    constructor(label, cells = 1) {
        this.cells = Array.from({length: cells}, () => el('td', {textContent: '–'}));
        this.box = el('tr', {}, el('th', {scope: 'row', textContent: label}), ...this.cells);
    }
    set(...words) {
        words.forEach((w, i) => put(this.cells[i], w));
    }
}

const card = (label, className, ...children) => el('section', {className: `instrument ${className}`, 'aria-label': label}, ...children);

/// Plan of the ship, bow up: an arrow from each propulsor in the direction of its thrust, rudders at
/// their angle, and a table of thrusts, azimuths and angles.
export class PropulsionCard {
    constructor(vessel, half) {
        this.vessel = vessel;
        const wide = 30, long = 66;
        this.scale = ([x, y]) => [-y / half[1] * wide * 0.86, -(x - vessel.origin[0]) / half[0] * long * 0.94];
        this.parts = vessel.propulsors.map(p => {
            const [u, v] = this.scale(p.point), arrow = svg('path', {class: 'thrust'});
            return {...p, u, v, arrow, row: new Row(t(readable(p.name)), 2), mark: svg('circle', {cx: u, cy: v, r: 3.2, class: 'hub'})};
        });
        this.rudders = vessel.rudders.map(r => {
            const [u, v] = this.scale(r.point), blade = svg('line', {x1: 0, y1: 0, x2: 0, y2: 11, class: 'rudder'});
            return {...r, u, v, blade, row: new Row(t(readable(r.name)), 2)};
        });
        const plan = svg('svg', {viewBox: '-48 -76 96 152', class: 'plan', 'aria-hidden': 'true'}, svg('path', {d: kOutline, transform: `scale(${wide} ${long})`, class: 'outline'}),
            ...this.rudders.map(r => r.blade), ...this.parts.flatMap(p => [p.arrow, p.mark]));
        this.box = card(t('Propulsion'), 'propulsion', plan, el('table', {}, el('caption', {textContent: t('Thrust and azimuth')}), el('tbody', {}, ...this.parts.map(p => p.row.box), ...this.rudders.map(r => r.row.box))));
    }

    paint(read) {
        const {name} = this.vessel;
        for (const p of this.parts) {
            const thrust = read(`${name}.${p.name}_thrust`), turned = read(`${name}.${p.name}_turned`), failed = read(`${name}.${p.name}_failed`) > 0.5;
            const rotates = p.kind === 'azimuth' || p.kind === 'cycloidal', side = p.kind === 'tunnel' && Math.abs(thrust) >= 500 ? thrust > 0 ? ' S' : ' P' : '';
            p.row.set(shown(Math.round((p.kind === 'tunnel' ? Math.abs(thrust) : thrust) / 981) * 981, 'N', 'thrust') + side, failed ? t('failed') : rotates ? bearing(turned * deg) : '');
            p.row.box.className = failed ? 'failed' : '';
            this.arrow(p, thrust, turned);
        }
        for (const r of this.rudders) {
            const angle = read(`${name}.${r.name}_at`), failed = read(`${name}.${r.name}_failed`) > 0.5;
            r.row.set(sided(angle * deg, 'S', 'P'), failed ? t('failed') : '');
            r.row.box.className = failed ? 'failed' : '';
            // A positive angle turns the ship to starboard: the trailing edge goes to starboard.
            r.blade.setAttribute('transform', `translate(${r.u} ${r.v}) rotate(${(-(angle || 0) * deg).toFixed(1)})`);
        }
    }

    /// Draw an arrow of at most 24 units for full thrust.
    arrow(p, thrust, turned) {
        const size = Math.min(1, Math.abs(thrust || 0) / (p.thrust || 1)), long = 24 * Math.sqrt(size);
        if (long < 2) return p.arrow.setAttribute('d', '');
        const [x, y] = thrustDirection(p.kind, thrust, turned || 0), [a, b] = [-y, -x], tip = [p.u + a * long, p.v + b * long], w = 3.4;
        p.arrow.setAttribute('d', `M${p.u} ${p.v}L${tip[0].toFixed(1)} ${tip[1].toFixed(1)}M${(tip[0] - 5 * a - w * b).toFixed(1)} ${(tip[1] - 5 * b + w * a).toFixed(1)}L${tip[0].toFixed(1)} ${tip[1].toFixed(1)}L${(tip[0] - 5 * a + w * b).toFixed(1)} ${(tip[1] - 5 * b - w * a).toFixed(1)}`);
    }
}

/// DP desk: footprint of the last three minutes about the ordered position, heading up. In other modes
/// the track of the ship, north up, about its present position.
export class DpCard {
    constructor(vessel) {
        this.vessel = vessel;
        this.offsets = new Trail();
        this.track = new Trail();
        this.path = svg('path', {class: 'trail'});
        this.rings = [svg('circle', {class: 'ring'}), svg('circle', {class: 'ring'})];
        this.limit = svg('circle', {class: 'alarm-ring'});
        this.ship = svg('path', {d: 'M0-7 4 4 0 2-4 4z', class: 'ship'});
        this.north = svg('text', {'text-anchor': 'middle', y: -39});
        this.scale = svg('text', {'text-anchor': 'end', x: 46, y: 46});
        this.title = el('h3', {textContent: 'DP'});
        this.rows = {a: new Row(''), b: new Row(''), c: new Row('')};
        this.box = card(t('DP desk'), 'dp', svg('svg', {viewBox: '-50 -50 100 100', class: 'footprint', role: 'img', 'aria-label': t('Footprint')}, ...this.rings, this.limit,
            svg('path', {d: 'M-46 0H46M0-46V46', class: 'ring'}), this.path, this.ship, this.north, this.scale),
            el('div', {}, this.title, el('table', {}, el('tbody', {}, ...Object.values(this.rows).map(r => r.box)))));
    }

    /// Take a frame into the trails. @param pose  Position [x, y] of the ship in the world.
    take(read, frame, pose) {
        const {name} = this.vessel;
        if (pose) this.track.take(frame.time, pose[0], pose[1]);
        if (read(`${name}.mode_now`) >= 2.5) this.offsets.take(frame.time, read(`${name}.offset_x`), read(`${name}.offset_y`));
        else this.offsets.points.length = 0;
    }

    paint(read) {
        const {name} = this.vessel, mode = Math.round(read(`${name}.mode_now`)), onDp = mode >= 3;
        put(this.title, t(`mode ${kVesselModes[mode] ?? 'off'}`));
        const own = onDp ? this.offsets.points : this.track.points, last = own.at(-1) ?? {x: 0, y: 0};
        // Offsets are in axes of the ship (x ahead, y to starboard); the track is in those of the world.
        const at = p => onDp ? [p.y, -p.x] : [p.x - last.x, -(p.y - last.y)], points = own.map(at), r = plotRadius(points), k = 42 / r;
        this.rings.forEach((ring, i) => ring.setAttribute('r', 42 / (i + 1)));
        this.limit.setAttribute('r', onDp ? Math.min(48, this.vessel.position_alarm * k) : 0);
        this.path.setAttribute('d', points.length > 1 ? `M${points.map(([x, y]) => `${(x * k).toFixed(1)} ${(y * k).toFixed(1)}`).join('L')}` : '');
        const [x, y] = points.at(-1) ?? [0, 0], heading = 90 + read(`${name}.heading`) * deg;
        this.ship.setAttribute('transform', `translate(${(x * k).toFixed(1)} ${(y * k).toFixed(1)}) rotate(${onDp ? 0 : (heading || 0).toFixed(1)})`);
        put(this.north, onDp ? '' : 'N');
        put(this.scale, `${r} m`);
        this.facts(read, onDp, mode);
    }

    facts(read, onDp, mode) {
        const {name} = this.vessel, {a, b, c} = this.rows, label = (row, words) => put(row.box.firstElementChild, words);
        const order = read(`${name}.heading_order`), off = ((order - read(`${name}.heading`)) * deg % 360 + 540) % 360 - 180;
        label(a, onDp ? t('Off position') : t('Ordered heading'));
        a.set(onDp ? shown(Math.hypot(read(`${name}.offset_x`), read(`${name}.offset_y`)), 'm') : mode >= 2 ? fromX(order) : '–');
        label(b, t('Off heading'));
        b.set(mode >= 2 ? sided(-off, 'S', 'P') : '–');
        label(c, onDp ? t('Worst failure') : t('Ordered speed'));
        const short = read(`${name}.consequence`);
        c.set(onDp ? Number.isFinite(short) ? short > 0.02 ? `−${Math.round(100 * short)} %` : t('held') : '–' : mode === 2 ? shown(read(`${name}.speed_order`), 'm/s', 'ship.speed') : '–');
    }
}

const arc = (from, to, r) => {
    const p = a => [(-Math.cos(a * Math.PI) * r).toFixed(2), (-Math.sin(a * Math.PI) * r).toFixed(2)];
    return `M${p(from).join(' ')}A${r} ${r} 0 0 1 ${p(to).join(' ')}`;
};

/// Stability gauge: tension of the towline over the permissible one at its present direction, with the
/// criterion that limits it, the direction and the heel.
export class StabilityCard {
    constructor(name) {
        this.name = name;
        this.needle = svg('path', {d: 'M-1.6 0 0-37 1.6 0z', class: 'needle'});
        this.percent = svg('text', {x: 0, y: -12, 'text-anchor': 'middle', class: 'figure'});
        const end = s => s / 1.2;
        this.rows = {tension: new Row(t('Tension')), permissible: new Row(t('Permissible')), limit: new Row(t('Limited by')), lead: new Row(t('Lead')), heel: new Row(t('Heel'))};
        this.box = card(t('Stability gauge'), 'stability', el('div', {}, el('h3', {textContent: t('Stability')}),
            svg('svg', {viewBox: '-50 -48 100 54', class: 'gauge', role: 'img', 'aria-label': t('Tension over permissible tension')}, svg('path', {d: arc(0, end(0.8), 42), class: 'arc good'}), svg('path', {d: arc(end(0.8), end(1), 42), class: 'arc warn'}),
                svg('path', {d: arc(end(1), 1, 42), class: 'arc danger'}), this.needle, this.percent)),
            el('table', {}, el('tbody', {}, ...Object.values(this.rows).map(r => r.box))));
    }

    paint(read) {
        const of = s => read(`${this.name}.${s}`), tension = of('tension'), permissible = of('permissible'), begun = permissible > 0 || of('criterion') > 0, g = gaugeState(tension, permissible);
        this.needle.setAttribute('transform', `rotate(${(g.share / 1.2 * 180 - 90).toFixed(1)})`);
        put(this.percent, Number.isFinite(g.percent) ? `${g.percent} %` : '–');
        this.box.dataset.state = of('alarm') >= 2 ? 'danger' : of('alarm') >= 1 ? 'warn' : begun ? g.state : 'good';   // before the first step all is 0
        this.rows.tension.set(shown(tension, 'N', 'tension'));
        this.rows.permissible.set(shown(permissible, 'N', 'tension'));
        this.rows.limit.set(t(kCriteria[Math.round(of('criterion'))] || '–'));
        // α is from the centreline: 0 is dead astern.
        const lead = of('alpha') * deg;
        this.rows.lead.set(Number.isFinite(lead) ? Math.abs(lead) < 0.5 ? t('dead astern') : sided(lead, 'S', 'P') : '–');
        this.rows.heel.set(sided(of('heel') * deg, 'S', 'P'));
    }
}

/// Switchboards: load over the power of their generators.
export class PowerCard {
    constructor(vessel) {
        this.vessel = vessel;
        this.boards = vessel.boards.map(b => ({...b, bar: el('div', {className: 'bar'}, el('i', {})), value: el('b', {textContent: '–'}), spare: el('small', {}), lamps: b.generators.map(g => ({...g, lamp: el('span', {className: 'lamp', textContent: t(readable(g.name.replace(`${b.name}_`, 'G')))})}))}));
        this.box = card(t('Power'), 'power', el('h3', {textContent: t('Switchboards')}), ...this.boards.map(b => el('div', {className: 'board'},
            el('div', {className: 'fact'}, el('span', {textContent: t(readable(b.name))}), b.value), b.bar, el('div', {className: 'lamps'}, ...b.lamps.map(g => g.lamp), b.spare))));
    }

    paint(read) {
        const {name} = this.vessel;
        for (const b of this.boards) {
            const load = read(`${name}.${b.name}_load`), spare = read(`${name}.${b.name}_spare`), running = load + spare, share = running > 0 ? load / running : 1;
            put(b.value, `${(load / 1e6).toFixed(2)} MW`);
            put(b.spare, `${t('spare')} ${(spare / 1e6).toFixed(2)} MW`);
            b.bar.className = `bar ${share >= 0.98 ? 'danger' : share >= 0.85 ? 'warn' : 'good'}`;
            b.bar.firstElementChild.style.width = `${100 * Math.min(1, Math.max(0, share || 0))}%`;
            for (const g of b.lamps) g.lamp.classList.toggle('off', read(`${name}.${g.name}_failed`) > 0.5 || read(`${name}.${b.name}_failed`) > 0.5);
        }
    }
}
