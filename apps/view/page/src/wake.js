// SPDX-License-Identifier: Apache-2.0
/// Foam that ships leave: the wake of the hull, the bow wave, and the wash of propellers along their
/// thrust, also of a ship at rest. All strips are one mesh, which follows the waves.
import {BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Mesh, ShaderMaterial, UniformsLib, UniformsUtils} from 'three';
import {AIR} from './air.js';
import {thrustDirection} from './vessel.js';

const kShips = 8, kTrail = 40, kRows = 7, kStrips = 8, kAcross = 5;   // rows of a trail and of another strip; strips a ship
const kLay = 0.08;         // [s] least time between two layouts of the strips
const kLife = 70;          // [s] after which the wake is not drawn
export const kWashReach = 55;    // [m] length of the wash at full thrust

/// Positions of a stern over the last seconds, with the strength of their foam.
export class Track {
    constructor() {
        this.points = [];
    }
    /// Add a position. Time that goes back clears the track.
    take(time, x, y, strength, step = 4) {
        const last = this.points.at(-1);
        if (last && time < last.time) this.points.length = 0;
        if (!Number.isFinite(x) || this.points.length && Math.hypot(x - this.points.at(-1).x, y - this.points.at(-1).y) < step) return false;
        this.points.push({time, x, y, strength});
        if (this.points.length > kTrail - 1) this.points.shift();
        while (this.points.length && this.points[0].time < time - kLife) this.points.shift();
        return true;
    }
}

/// Strength of a wake's foam, 0 to 1, by the speed through water [m/s] and the fraction of full thrust.
export const wakeStrength = (speed, thrust = 0) => Math.min(1, Math.max(0, (Math.abs(speed) - 0.4) / 4.5) + 0.5 * Math.min(1, Math.abs(thrust)) * Math.min(1, Math.abs(speed)));

const vertex = waves => `
${waves}
uniform vec3 eye; uniform float level;
attribute vec2 edge;
varying vec2 place; varying vec3 foam;
#include <common>
#include <fog_pars_vertex>
void main() {
    float z, crest; vec2 slope;
    waves(position.xy, 0.05 * length(position.xy - eye.xy) + 0.5, z, slope, crest);
    vec4 mvPosition = viewMatrix * vec4(position.xy, level + z + 0.05, 1.0);
    place = position.xy; foam = vec3(edge, position.z);
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
}`;

const fragment = encode => `
uniform sampler2D tile; uniform float bright, time;
varying vec2 place; varying vec3 foam;
#include <common>
#include <fog_pars_fragment>
void main() {
    float body = foam.z * (1.0 - foam.x * foam.x);
    float grain = texture2D(tile, place * 0.05 + foam.y * 0.02).b + texture2D(tile, place * 0.31).b - 1.0;
    float white = clamp(1.7 * (body - 0.28 + 0.9 * grain), 0.0, 1.0) * smoothstep(0.0, 0.12, body);
    vec3 colour = mix(vec3(0.12, 0.36, 0.4), vec3(0.86, 0.92, 0.93), white) * (0.08 + 0.92 * bright);
    gl_FragColor = vec4(colour, 0.85 * white + 0.3 * clamp(body, 0.0, 1.0));
    ${encode}
    #include <fog_fragment>
}`;

export class Wake {
    /// @param shader  {waves, encode, tile, defines} of the surface. @param uniforms  Of the water.
    constructor(shader, water) {
        const rows = kTrail + kStrips * kRows, n = kShips * rows * kAcross, index = [];
        this.rows = rows;
        this.position = new Float32Array(3 * n);
        this.edge = new Float32Array(2 * n);
        for (let s = 0; s < kShips; ++s)
            for (const [first, count] of [[0, kTrail], ...Array.from({length: kStrips}, (_, k) => [kTrail + k * kRows, kRows])])
                for (let i = first; i + 1 < first + count; ++i)
                    for (let k = 0; k + 1 < kAcross; ++k) {
                        const a = (s * rows + i) * kAcross + k, b = a + kAcross;
                        index.push(a, b, b + 1, a, b + 1, a + 1);
                    }
        const g = new BufferGeometry(), of = (array, size) => new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
        g.setAttribute('position', of(this.position, 3));
        g.setAttribute('edge', of(this.edge, 2));
        g.setIndex(new BufferAttribute(new Uint16Array(index), 1));
        this.perShip = index.length / kShips;
        const uniforms = Object.assign(UniformsUtils.merge([UniformsLib.fog]), AIR, {tile: shader.tile, level: {value: 0}, count: water.count, wave: water.wave, eye: water.eye, time: water.time});
        this.level = uniforms.level;
        this.mesh = new Mesh(g, new ShaderMaterial({uniforms, defines: shader.defines, fog: true, transparent: true, depthWrite: false, side: DoubleSide, vertexShader: vertex(shader.waves), fragmentShader: fragment(shader.encode)}));
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = 6;
        this.ships = [];
    }

    setScene(scene, bodies) {
        const places = new Map(scene.outputs.map((o, i) => [o.name, i]));
        this.ships = bodies.filter(b => (b.role === 'ship' || b.role === 'barge') && b.slot >= 0 && b.def.kind !== 'fixed').slice(0, kShips).map(body => {
            const vessel = (scene.vessels ?? []).find(v => v.body === body.id), at = name => places.get(`${vessel.name}.${name}`) ?? -1;
            const jets = (vessel?.propulsors ?? []).slice(0, kStrips - 2).map(p => ({...p, output: at(`${p.name}_thrust`), turn: at(`${p.name}_turned`)}));
            const half = body.stern ? [Math.abs(body.stern.x) * 0.5 + body.half[0] * 0.5, body.half[1]] : [body.half[0], body.half[1]];
            return {body, track: new Track(), half, stern: body.stern?.x ?? -body.half[0], bow: body.stern ? body.stern.x + 2 * body.half[0] : body.half[0], water: vessel ? at('speed') : -1, jets, was: null, speed: 0};
        });
        this.laid = NaN;
        this.mesh.geometry.setDrawRange(0, this.ships.length * this.perShip);
    }

    /// Read a frame: speeds, tracks.
    take(frame) {
        for (const ship of this.ships) {
            const {body, was} = ship, p = body.position, q = body.quaternion;
            ship.heading = Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
            if (was && frame.time > was.time + 0.2 || !was || frame.time < was.time) {
                const c = Math.cos(ship.heading), s = Math.sin(ship.heading);
                if (was && frame.time > was.time) ship.speed = ((p.x - was.x) * c + (p.y - was.y) * s) / (frame.time - was.time);
                ship.was = {time: frame.time, x: p.x, y: p.y};
            }
            const through = ship.water >= 0 ? frame.outputs[ship.water] : NaN, thrust = ship.jets.reduce((m, j) => j.kind === 'shaft' || j.kind === 'azimuth' ? Math.max(m, this.share(j, frame)) : m, 0);
            ship.through = Number.isFinite(through) ? through : ship.speed;
            const [x, y] = this.at(ship, ship.through >= 0 ? ship.stern : ship.bow, 0);
            ship.track.take(frame.time, x, y, wakeStrength(ship.through, thrust));
        }
        this.time = frame.time;
        if (Math.abs(frame.time - this.laid) < kLay) return;   // foam moves slowly: not each frame
        this.laid = frame.time;
        this.lay(frame);
    }

    share(jet, frame) {
        const v = jet.output >= 0 && jet.thrust > 0 ? Math.abs(frame.outputs[jet.output]) / jet.thrust : 0;
        return Number.isFinite(v) ? Math.min(1, v) : 0;
    }

    at({body, heading}, ahead, port) {
        const c = Math.cos(heading), s = Math.sin(heading);
        return [body.position.x + c * ahead - s * port, body.position.y + s * ahead + c * port];
    }

    /// Write the corners of all strips.
    lay(frame) {
        this.ships.forEach((ship, n) => {
            const base = n * this.rows, {points} = ship.track, beam = ship.half[1];
            const [sx, sy] = this.at(ship, ship.stern, 0), trail = [...points, {time: this.time, x: sx, y: sy, strength: points.at(-1)?.strength ?? 0}];
            for (let i = 0; i < kTrail; ++i) {
                const p = trail[Math.min(i, trail.length - 1)], q = trail[Math.min(i + 1, trail.length - 1)], o = trail[Math.max(0, Math.min(i, trail.length - 1) - 1)];
                const dx = q.x - o.x, dy = q.y - o.y, l = Math.hypot(dx, dy), age = this.time - p.time;
                const [ux, uy] = l > 1e-6 ? [dx / l, dy / l] : [Math.cos(ship.heading), Math.sin(ship.heading)];
                this.row(base + i, p.x, p.y, -uy, ux, beam * (0.6 + 0.13 * Math.sqrt(age)), p.strength * Math.exp(-age / 22) * (i ? 1 : 0), age);
            }
            ship.jets.forEach((jet, k) => this.jet(base + kTrail + k * kRows, ship, jet, frame));
            for (let k = ship.jets.length; k < kStrips - 2; ++k) this.none(base + kTrail + k * kRows, sx, sy);
            for (const [k, side] of [[kStrips - 2, 1], [kStrips - 1, -1]]) this.bowWave(base + kTrail + k * kRows, ship, side);
        });
        this.mesh.geometry.attributes.position.needsUpdate = this.mesh.geometry.attributes.edge.needsUpdate = true;
    }

    /// One row of corners across a strip, from (x, y) along the unit vector (nx, ny) on both sides.
    row(row, x, y, nx, ny, half, strength, age) {
        const {position, edge} = this;
        for (let k = 0, i = row * kAcross; k < kAcross; ++k, ++i) {
            const e = 2 * k / (kAcross - 1) - 1;
            position[3 * i] = x + e * half * nx;
            position[3 * i + 1] = y + e * half * ny;
            position[3 * i + 2] = strength;
            edge[2 * i] = e;
            edge[2 * i + 1] = age;
        }
    }

    none(first, x, y) {
        for (let i = 0; i < kRows; ++i) this.row(first + i, x, y, 0, 0, 0, 0, 0);
    }

    jet(first, ship, jet, frame) {
        const share = this.share(jet, frame), [x, y] = this.at(ship, jet.point[0], jet.point[1]);
        if (share < 0.03) return this.none(first, x, y);
        const turned = jet.turn >= 0 ? frame.outputs[jet.turn] : 0, [dx, dy] = thrustDirection(jet.kind, frame.outputs[jet.output], turned), c = Math.cos(ship.heading), s = Math.sin(ship.heading);
        const ux = -(c * dx - s * dy), uy = -(s * dx + c * dy), long = kWashReach * Math.sqrt(share) * (jet.kind === 'tunnel' ? 0.4 : 1), wide = 0.18 * ship.half[1] + 0.5;
        const start = jet.kind === 'tunnel' ? ship.half[1] * 0.6 : 0;
        for (let i = 0; i < kRows; ++i) {
            const f = i / (kRows - 1), d = start + f * long;
            this.row(first + i, x + ux * d, y + uy * d, -uy, ux, wide + 0.16 * f * long, (0.35 + 0.75 * share) * (1 - f) * Math.min(1, 0.4 + 3 * f), this.time % 100);
        }
    }

    bowWave(first, ship, side) {
        const strength = Math.min(0.95, Math.max(0, (ship.through - 1) / 4.5)), long = Math.min(1.1, 0.25 + 0.16 * Math.abs(ship.through)) * ship.half[0];
        const [x, y] = this.at(ship, 0.93 * ship.bow, 0);
        if (!(strength > 0.02)) return this.none(first, x, y);
        for (let i = 0; i < kRows; ++i) {
            const f = i / (kRows - 1), ahead = 0.93 * ship.bow - f * long, port = side * Math.min(ship.half[1] * 1.02 + 0.34 * Math.max(0, f * long - 1.1 * ship.half[1]), 0.85 * f * long + 0.4);
            const [px, py] = this.at(ship, ahead, port), c = Math.cos(ship.heading), s = Math.sin(ship.heading);
            this.row(first + i, px, py, -s, c, 0.8 + 0.09 * f * long, strength * (1 - 0.8 * f), 0);
        }
    }
}
