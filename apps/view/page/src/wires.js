// SPDX-License-Identifier: Apache-2.0
/// Wires: every element one instance, as a lit tube or as a line of constant width on the screen.
///
/// Points of all wires lie one after another in one buffer: the segment i goes from point i to
/// point i + 1, so that a frame is one upload of points and one of utilisations. A segment that is
/// none (between two wires, parted) has a share of −2 and is not drawn; −1 is drawn grey: its
/// breaking load is not known.
import {
    BufferAttribute, BufferGeometry, CylinderGeometry, DoubleSide, DynamicDrawUsage, InstancedBufferAttribute,
    InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial,
    UniformsLib, UniformsUtils, Vector2, Vector3,
} from 'three';
import {GREY, STOPS, toLinear} from './colour.js';
import {SUN} from './surroundings.js';

export const kNone = -2, kUnknown = -1;

const colourShader = `
vec3 tension(float s) {
    if (s < -0.5) return ${vec3(toLinear(GREY))};
    float x = clamp(s, 0.0, 1.0);
    vec3 c = ${vec3(toLinear(STOPS[0].slice(1)))};
${STOPS.slice(1).map(([x, ...rgb], i) => `    c = mix(c, ${vec3(toLinear(rgb))}, clamp((x - ${STOPS[i][0].toFixed(3)}) / ${(x - STOPS[i][0]).toFixed(3)}, 0.0, 1.0));`).join('\n')}
    return c;
}`;

function vec3(v) {
    return `vec3(${v.map(x => x.toFixed(5)).join(', ')})`;
}

const head = `
attribute vec3 a, b; attribute float share, radius, chosen;
uniform float pixel, least, level, murk; uniform vec2 screen;
varying vec3 hue; varying float wet;
${colourShader}
void paint(vec3 at) {
    hue = tension(share);
    if (chosen > 0.5) hue = mix(hue, vec3(1.0), 0.55);
    wet = murk * 0.22 * (1.0 - exp(-max(level - at.z, 0.0) / 60.0));
}`;

const tubeVertex = `${head}
varying vec3 normal_; varying float along;
#include <fog_pars_vertex>
void main() {
    vec3 axis = b - a; float l = length(axis);
    if (share < -1.5 || l < 1e-6) { gl_Position = vec4(2.0, 2.0, 2.0, 0.0); return; }
    axis /= l;
    vec3 e1 = normalize(cross(abs(axis.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0), axis)), e2 = cross(axis, e1);
    vec3 at = mix(a, b, position.y + 0.5);
    float depth = -(viewMatrix * vec4(at, 1.0)).z;
    float r = max(radius, least * pixel * depth) * (chosen > 0.5 ? 1.6 : 1.0);
    vec3 out_ = position.x * e1 + position.z * e2;
    normal_ = out_; along = (position.y + 0.5) * l / max(radius, 0.02);
    paint(at);
    vec4 mvPosition = viewMatrix * vec4(at + r * out_, 1.0);
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
}`;

const lineVertex = `${head}
#include <fog_pars_vertex>
void main() {
    if (share < -1.5) { gl_Position = vec4(2.0, 2.0, 2.0, 0.0); return; }
    vec4 p = viewMatrix * vec4(a, 1.0), q = viewMatrix * vec4(b, 1.0);
    float near = -0.05;                     // both ends before the eye
    if (p.z > near && q.z > near) { gl_Position = vec4(2.0, 2.0, 2.0, 0.0); return; }
    if (p.z > near) p = mix(q, p, (near - q.z) / (p.z - q.z));
    if (q.z > near) q = mix(p, q, (near - p.z) / (q.z - p.z));
    vec4 mvPosition = position.y < 0.0 ? p : q;
    vec4 P = projectionMatrix * p, Q = projectionMatrix * q, here = position.y < 0.0 ? P : Q;
    vec2 d = (Q.xy / Q.w - P.xy / P.w) * screen; float l = length(d);
    d = l > 1e-6 ? d / l : vec2(1, 0);
    float wide = max(2.0 * radius / (pixel * -mvPosition.z), 2.0 * least) * (chosen > 0.5 ? 1.8 : 1.0);
    here.xy += position.x * wide * vec2(-d.y, d.x) / screen * here.w;
    paint(position.y < 0.0 ? a : b);
    gl_Position = here;
    #include <fog_vertex>
}`;

const fragment = lit => `
uniform vec3 sun, deep; varying vec3 hue; varying float wet;
${lit ? 'varying vec3 normal_; varying float along;' : ''}
#include <fog_pars_fragment>
void main() {
    ${lit ? `vec3 n = normalize(normal_);
    float lay = 0.92 + 0.08 * sin(along * 2.0 + atan(n.x, n.y + 1e-4) * 3.0);
    float light = 0.62 + 0.25 * n.z + 0.38 * max(dot(n, sun), 0.0);
    vec3 c = hue * light * lay;` : 'vec3 c = hue;'}
    gl_FragColor = vec4(mix(c, deep, wet), 1.0);
    #include <colorspace_fragment>
    #include <fog_fragment>
}`;

export class Wires {
    constructor() {
        this.uniforms = UniformsUtils.merge([UniformsLib.fog, {
            pixel: {value: 0.001}, least: {value: 1.3}, level: {value: 0}, murk: {value: 0},
            screen: {value: new Vector2(1, 1)}, sun: {value: SUN}, deep: {value: new Vector3(0.02, 0.08, 0.13)},
        }]);
        this.tubes = this.make(tubeVertex, fragment(true));
        this.lines = this.make(lineVertex, fragment(false));
        this.base = {tubes: new CylinderGeometry(1, 1, 1, 8, 1, true), lines: ribbonGeometry()};
        this.reserve(256);
        this.asTubes = true;
        this.selected = -1;
    }

    make(vertexShader, fragmentShader) {
        const mesh = new Mesh(new BufferGeometry(), new ShaderMaterial(
            {uniforms: this.uniforms, vertexShader, fragmentShader, fog: true, side: DoubleSide}));
        mesh.frustumCulled = false;
        return mesh;
    }

    /// Room for this many points; what grows is made anew.
    reserve(points) {
        if (points <= this.capacity) return;
        this.capacity = Math.max(256, Math.ceil(points * 1.25));
        const n = this.capacity;
        this.place = new Float32Array(3 * (n + 1));
        [this.share, this.radius, this.chosen] = [new Float32Array(n), new Float32Array(n), new Float32Array(n)];
        this.buffer = new InstancedInterleavedBuffer(this.place, 3, 1).setUsage(DynamicDrawUsage);
        const instanced = array => new InstancedBufferAttribute(array, 1).setUsage(DynamicDrawUsage);
        this.attributes = {
            a: new InterleavedBufferAttribute(this.buffer, 3, 0), b: new InterleavedBufferAttribute(this.buffer, 3, 3),
            share: instanced(this.share), radius: instanced(this.radius), chosen: instanced(this.chosen),
        };
        for (const kind of ['tubes', 'lines']) {
            const g = new InstancedBufferGeometry();
            g.index = this.base[kind].index;
            g.setAttribute('position', this.base[kind].getAttribute('position'));
            for (const [name, attribute] of Object.entries(this.attributes)) g.setAttribute(name, attribute);
            this[kind].geometry.dispose();
            this[kind].geometry = g;
        }
        this.counts = null;
    }

    /// wires: those of the scene, with a radius each.
    setScene(wires) {
        this.wires = wires;
        this.counts = null;
        this.selected = -1;
    }

    /// Takes over what a frame says. full: the tension that has the hottest colour, as a share of
    /// the breaking load; where that is not known, of `reference` [N].
    fill(frame, full, reference) {
        this.reserve(frame.points);
        this.place.set(frame.wirePoints);
        let point = 0, piece = 0;
        const same = this.counts && frame.counts.every((n, i) => n === this.counts[i]);
        for (let w = 0; w < frame.counts.length; ++w) {
            const n = frame.counts[w], wire = this.wires[w], strength = full * (wire.breaking_load || 0) || reference;
            for (let k = 0; k + 1 < n; ++k) {
                const t = frame.tensions[piece++];
                this.share[point + k] = t < 0 ? kNone : strength > 0 ? t / strength : kUnknown;
            }
            if (n) this.share[point + n - 1] = kNone;
            if (!same) {
                this.radius.fill(wire.radius, point, point + n);
                this.chosen.fill(w === this.selected ? 1 : 0, point, point + n);
            }
            point += n;
        }
        this.buffer.needsUpdate = this.attributes.share.needsUpdate = true;
        if (!same) {
            this.attributes.radius.needsUpdate = this.attributes.chosen.needsUpdate = true;
            this.counts = frame.counts.slice();
        }
        for (const mesh of [this.tubes, this.lines]) mesh.geometry.instanceCount = Math.max(0, frame.points - 1);
    }

    set asTubes(on) {
        this.tubes.visible = on;
        this.lines.visible = !on;
    }
    get asTubes() {
        return this.tubes.visible;
    }

    choose(index) {
        this.selected = index;
        this.counts = null;   // the next frame marks it
    }

    /// pixel: size of a pixel at 1 m [m]; screen [pixels]; ratio: device pixels a pixel.
    view(pixel, width, height, ratio, level, murk) {
        const u = this.uniforms;
        u.pixel.value = pixel;
        u.least.value = 1.25 * Math.max(1, ratio);
        u.screen.value.set(width / 2, height / 2);
        u.level.value = level;
        u.murk.value = murk;
    }
}

function ribbonGeometry() {
    const g = new BufferGeometry();
    g.setAttribute('position', new BufferAttribute(new Float32Array([-0.5, -1, 0, 0.5, -1, 0, 0.5, 1, 0, -0.5, 1, 0]), 3));
    g.setIndex([0, 1, 2, 0, 2, 3]);
    return g;
}
