// SPDX-License-Identifier: Apache-2.0
/// Spray at the bows of ships: drops that the bow throws up when it meets the surface fast. All drops are points of
/// one mesh. The threshold is a fraction of the relative velocity at which a bow slams, 0.0935 √(g L) (M. K. Ochi,
/// Prediction of Occurrence and Severity of Ship Slamming at Sea, 1964).
import {BufferAttribute, BufferGeometry, DynamicDrawUsage, Points, ShaderMaterial, UniformsLib, UniformsUtils} from 'three';
import {AIR} from './air.js';

export const kDrops = 1600;      // at most
const kShips = 4, kG = 9.81;
const kRate = 1400;              // drops a second of a ship at full strength
const kLeast = 0.08;             // [s] between two samples of the relative velocity
const kLife = 2.2;               // [s] of a drop, at most
const kDrag = 0.8;               // [1/s] rate at which the wind takes drops along

/// Strength of the spray, 0 to 1, by the relative velocity of the surface at the bow [m/s], upward, and the
/// length of the ship [m]: from half of the velocity of slamming to 1.2 times.
export const sprayStrength = (velocity, length) => Math.min(1, Math.max(0, (velocity / (0.0935 * Math.sqrt(kG * length)) - 0.5) / 0.7));

const vertex = `
attribute vec2 drop;
uniform float pixel, ratio;
varying vec2 fade;
#include <common>
#include <fog_pars_vertex>
void main() {
    vec4 mvPosition = viewMatrix * vec4(position, 1.0);
    fade = vec2(drop.x, drop.y);
    gl_PointSize = clamp(ratio * (0.35 + 1.1 * drop.x) * drop.y / (pixel * max(1.0, -mvPosition.z)), 1.0, 96.0);
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
}`;

const fragment = encode => `
uniform float bright;
varying vec2 fade;
#include <common>
#include <fog_pars_fragment>
void main() {
    float r = 2.0 * length(gl_PointCoord - 0.5);
    float alpha = (1.0 - smoothstep(0.0, 1.0, r)) * 0.3 * (1.0 - fade.x) * smoothstep(0.0, 0.08, fade.x);
    if (alpha < 0.01) discard;
    gl_FragColor = vec4(vec3(0.9, 0.94, 0.96) * (0.08 + 0.92 * bright), alpha);
    ${encode}
    #include <fog_fragment>
}`;

export class Spray {
    /// @param shader  {encode, defines} of the surface.
    constructor(shader = {encode: '', defines: {}}) {
        const g = new BufferGeometry(), of = size => new BufferAttribute(new Float32Array(size * kDrops), size).setUsage(DynamicDrawUsage);
        this.position = of(3);
        this.drop = of(2);          // age over life, size
        g.setAttribute('position', this.position);
        g.setAttribute('drop', this.drop);
        const uniforms = Object.assign(UniformsUtils.merge([UniformsLib.fog]), AIR, {pixel: {value: 0.001}, ratio: {value: 1}});
        this.uniforms = uniforms;
        this.mesh = new Points(g, new ShaderMaterial({uniforms, defines: shader.defines, fog: true, transparent: true, depthWrite: false, vertexShader: vertex, fragmentShader: fragment(shader.encode)}));
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = 7;
        this.velocity = new Float32Array(3 * kDrops);
        this.life = new Float32Array(kDrops);
        this.age = new Float32Array(kDrops);
        this.size = new Float32Array(kDrops);
        this.ships = [];
        this.clear();
    }

    clear() {
        this.count = 0;
        this.seed = 1;
        this.time = NaN;
        for (const ship of this.ships) ship.was = null;
        this.mesh.visible = false;
    }

    setScene(bodies) {
        this.ships = bodies.filter(b => b.role === 'ship' && b.slot >= 0 && b.def.kind !== 'fixed').slice(0, kShips).map(body => {
            const bow = body.stern ? body.stern.x + 2 * body.half[0] : body.half[0];
            return {body, bow, length: 2 * body.half[0], beam: body.stern?.half ?? body.half[1], was: null, strength: 0, due: 0};
        });
        this.clear();
    }

    /// Return the next number of a fixed sequence, 0 to 1.
    random() {
        this.seed = (this.seed * 1664525 + 1013904223) >>> 0;
        return this.seed / 4294967296;
    }

    /// Advance to the time of a frame. @param height  Function of x, y: the surface [m]. @param wind  [x, y] [m/s].
    take(time, height, wind = [0, 0]) {
        const dt = time - this.time;
        if (!(dt >= 0 && dt < 3)) this.clear();   // first frame, seek, restore
        this.time = time;
        if (!(dt > 0)) return;
        this.move(Math.min(dt, kLife), height, wind);
        for (const ship of this.ships) this.throwUp(ship, time, dt, height);
        this.mesh.visible = this.count > 0;
    }

    /// Return the stem of a ship at the still waterline, in the world.
    stem({body, bow}) {
        const e = body.matrix.elements, z = body.water;
        return [e[0] * bow + e[8] * z + e[12], e[1] * bow + e[9] * z + e[13], e[2] * bow + e[10] * z + e[14]];
    }

    throwUp(ship, time, dt, height) {
        const [x, y, z] = this.stem(ship), above = height(x, y) - z, {was} = ship;
        if (!was || time >= was.time + kLeast) {
            if (was) {
                const span = time - was.time;
                ship.strength = above > -0.5 * ship.beam ? sprayStrength((above - was.above) / span, ship.length) : 0;
                ship.vx = (x - was.x) / span;
                ship.vy = (y - was.y) / span;
            }
            ship.was = {time, above, x, y};
        }
        ship.due += ship.strength * kRate * Math.min(dt, 0.25);
        for (; ship.due >= 1; --ship.due) this.add(ship);
        if (!ship.strength) ship.due = 0;
    }

    /// Throw up a drop at the flare of the bow.
    add({body, bow, length, beam, strength, vx, vy, was}) {
        if (this.count >= kDrops) return;
        const r = () => this.random(), i = this.count++, e = body.matrix.elements, side = r() < 0.5 ? 1 : -1, back = 0.13 * length * r() ** 1.5;
        const ahead = bow - back, out = side * Math.min(0.95 * beam, 0.3 + 0.75 * back), z = body.water + Math.max(-1, was.above) * 0.8 + 0.6 * r();
        const fling = 1.5 + 3.5 * r() * (0.5 + strength), rise = (2 + 5.5 * r()) * (0.6 + 0.6 * strength), across = Math.hypot(e[4], e[5]) || 1;
        for (let k = 0; k < 3; ++k) this.position.array[3 * i + k] = e[k] * ahead + e[4 + k] * out + e[8 + k] * z + e[12 + k];
        this.velocity.set([0.8 * vx + side * fling * e[4] / across, 0.8 * vy + side * fling * e[5] / across, rise], 3 * i);
        this.life[i] = kLife * (0.5 + 0.5 * r());
        this.age[i] = 0;
        this.size[i] = 0.35 + 0.9 * r() * (0.6 + 0.5 * strength);
        this.drop.array.set([0, this.size[i]], 2 * i);
    }

    /// Move all drops by their velocity, weight and the wind; remove those that are old or below the surface.
    move(dt, height, wind) {
        const p = this.position.array, v = this.velocity, drag = Math.min(1, kDrag * dt);
        for (let i = 0; i < this.count; ++i) {
            const k = 3 * i;
            v[k] += drag * (wind[0] - v[k]);
            v[k + 1] += drag * (wind[1] - v[k + 1]);
            p[k + 2] += v[k + 2] * dt - 0.5 * kG * dt * dt;
            v[k + 2] -= kG * dt;
            p[k] += v[k] * dt;
            p[k + 1] += v[k + 1] * dt;
            this.age[i] += dt;
            if (this.age[i] < this.life[i] && (v[k + 2] > 0 || p[k + 2] > height(p[k], p[k + 1]) - 0.3)) this.drop.array[2 * i] = this.age[i] / this.life[i];
            else this.remove(i--);
        }
    }

    /// Replace a drop by the last one.
    remove(i) {
        const last = --this.count;
        for (const [array, n] of [[this.position.array, 3], [this.velocity, 3], [this.drop.array, 2], [this.life, 1], [this.age, 1], [this.size, 1]])
            for (let k = 0; k < n; ++k) array[n * i + k] = array[n * last + k];
    }

    /// Send the drops to the graphics card. @param pixel  Size of a pixel at 1 m [m]. @param ratio  Pixels of the
    /// screen for one of the page.
    draw(pixel, ratio) {
        if (!this.mesh.visible) return;
        this.uniforms.pixel.value = pixel;
        this.uniforms.ratio.value = ratio;
        this.mesh.geometry.setDrawRange(0, this.count);
        this.position.needsUpdate = this.drop.needsUpdate = true;
    }
}
