// SPDX-License-Identifier: Apache-2.0
/// Wires: lit tubes, or lines of constant width on the screen.
///
/// One texture contains the points of all wires (x, y, z, utilisation), so that a frame is one small
/// upload. The vertex shader computes the corners of the segment from point i to point i + 1 from the
/// number of the vertex. (Usually each segment would be an instance. If the processor draws, an
/// instance costs as much as a draw call.) A gap between two wires, or a broken segment, has a
/// utilisation of −2 and is not drawn. −1 is drawn grey: the breaking load is unknown.
import {
    BufferAttribute, BufferGeometry, DataTexture, DoubleSide, FloatType, Mesh, NearestFilter, RGBAFormat, ShaderMaterial,
    UniformsLib, UniformsUtils, Vector2, Vector3,
} from 'three';
import {GREY, STOPS, toLinear} from './colour.js';
import {SUN} from './air.js';
import {encode} from './surroundings.js';

const kWide = 512;  // points a row of the texture

export const kNone = -2, kUnknown = -1;

const colourShader = `
uniform vec3 ramp[${STOPS.length}];
vec3 tension(float s) {
    if (s < -0.5) return ${vec3(toLinear(GREY))};
    float x = clamp(s, 0.0, 1.0);
    vec3 c = ramp[0];
${STOPS.slice(1).map(([x], i) => `    c = mix(c, ramp[${i + 1}], clamp((x - ${STOPS[i][0].toFixed(3)}) / ${(x - STOPS[i][0]).toFixed(3)}, 0.0, 1.0));`).join('\n')}
    return c;
}`;

function vec3(v) {
    return `vec3(${v.map(x => x.toFixed(5)).join(', ')})`;
}

const head = `
uniform highp sampler2D points, looks;
uniform float pixel, least, level, murk; uniform vec2 screen;
varying vec3 hue; varying float wet;
vec3 a, b; float share, radius, chosen;
${colourShader}
vec4 fetch(highp sampler2D t, int i) { return texelFetch(t, ivec2(i % ${kWide}, i / ${kWide}), 0); }
int segment(int corners) {
    int i = gl_VertexID / corners;
    vec4 p = fetch(points, i), l = fetch(looks, i);
    a = p.xyz; b = fetch(points, i + 1).xyz; share = p.w; radius = l.x; chosen = l.y;
    return gl_VertexID % corners;
}
void paint(vec3 at) {
    hue = tension(share);
    if (chosen > 0.5) hue = mix(hue, vec3(1.0), 0.55);
    wet = murk * 0.22 * (1.0 - exp(-max(level - at.z, 0.0) / 60.0));
}`;

const tubeVertex = sides => `${head}
varying vec3 normal_; varying float along;
#include <fog_pars_vertex>
void main() {
    int corner = segment(${2 * sides});
    vec3 axis = b - a; float l = length(axis);
    if (share < -1.5 || l < 1e-6) { gl_Position = vec4(2.0, 2.0, 2.0, 0.0); return; }
    axis /= l;
    vec3 e1 = normalize(cross(abs(axis.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0), axis)), e2 = cross(axis, e1);
    float end = float(corner / ${sides}), turn = 6.2831853 * float(corner % ${sides}) / ${sides}.0;
    vec3 at = mix(a, b, end);
    float depth = -(viewMatrix * vec4(at, 1.0)).z;
    float r = max(radius, least * pixel * depth) * (chosen > 0.5 ? 1.6 : 1.0);
    vec3 out_ = cos(turn) * e1 + sin(turn) * e2;
    normal_ = out_; along = end * l / max(radius, 0.02);
    paint(at);
    vec4 mvPosition = viewMatrix * vec4(at + r * out_, 1.0);
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
}`;

const lineVertex = `${head}
#include <fog_pars_vertex>
void main() {
    int corner = segment(4);
    if (share < -1.5) { gl_Position = vec4(2.0, 2.0, 2.0, 0.0); return; }
    bool first = corner < 2; float side = corner % 2 == 0 ? -0.5 : 0.5;
    vec4 p = viewMatrix * vec4(a, 1.0), q = viewMatrix * vec4(b, 1.0);
    float near = -0.05;                     // both ends before the eye
    if (p.z > near && q.z > near) { gl_Position = vec4(2.0, 2.0, 2.0, 0.0); return; }
    if (p.z > near) p = mix(q, p, (near - q.z) / (p.z - q.z));
    if (q.z > near) q = mix(p, q, (near - p.z) / (q.z - p.z));
    vec4 mvPosition = first ? p : q;
    vec4 P = projectionMatrix * p, Q = projectionMatrix * q, here = first ? P : Q;
    vec2 d = (Q.xy / Q.w - P.xy / P.w) * screen; float l = length(d);
    d = l > 1e-6 ? d / l : vec2(1, 0);
    float wide = max(2.0 * radius / (pixel * -mvPosition.z), 2.0 * least) * (chosen > 0.5 ? 1.8 : 1.0);
    here.xy += side * wide * vec2(-d.y, d.x) / screen * here.w;
    paint(first ? a : b);
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
    ${encode}
    #include <fog_fragment>
}`;

const texture = data => {
    const t = new DataTexture(data, kWide, data.length / 4 / kWide, RGBAFormat, FloatType);
    t.minFilter = t.magFilter = NearestFilter;
    t.generateMipmaps = false;
    return t;
};

export class Wires {
    /// @param low  True: fewer sides, for processors that draw.
    constructor(low = false) {
        this.sides = low ? 5 : 8;
        this.defines = low ? {LOW: 1} : {};
        this.uniforms = UniformsUtils.merge([UniformsLib.fog, {
            pixel: {value: 0.001}, least: {value: 1.3}, level: {value: 0}, murk: {value: 0},
            screen: {value: new Vector2(1, 1)}, sun: {value: SUN}, deep: {value: new Vector3(0.02, 0.08, 0.13)},
        }]);
        this.uniforms.ramp = {value: STOPS.map(() => new Vector3())};
        this.palette(STOPS);
        this.uniforms.points = {value: null};
        this.uniforms.looks = {value: null};
        this.tubes = this.make(tubeVertex(this.sides), fragment(true));
        this.lines = this.make(lineVertex, fragment(false));
        this.reserve(256);
        this.asTubes = true;
        this.selected = -1;
    }

    /// Set the colours of tension. @param stops  As in colour.js.
    palette(stops) {
        stops.forEach(([, ...rgb], i) => this.uniforms.ramp.value[i].set(...toLinear(rgb)));
    }

    make(vertexShader, fragmentShader) {
        const mesh = new Mesh(new BufferGeometry(), new ShaderMaterial(
            {uniforms: this.uniforms, defines: this.defines, vertexShader, fragmentShader, fog: true, side: DoubleSide}));
        mesh.frustumCulled = false;
        return mesh;
    }

    /// Reserve capacity for this many points; buffers that grow are created again.
    reserve(points) {
        if (points <= this.capacity) return;
        const n = this.capacity = Math.ceil(Math.max(256, 1.25 * points + 1) / kWide) * kWide;
        this.uniforms.points.value?.dispose();
        this.uniforms.looks.value?.dispose();
        this.place = new Float32Array(4 * n);
        this.look = new Float32Array(4 * n);
        this.uniforms.points.value = texture(this.place);
        this.uniforms.looks.value = texture(this.look);
        const tube = [];
        for (let k = 0; k < this.sides; ++k) {
            const m = (k + 1) % this.sides, s = this.sides;
            tube.push(k, s + k, s + m, k, s + m, m);
        }
        for (const [mesh, corners, pattern] of [[this.tubes, 2 * this.sides, tube], [this.lines, 4, [0, 1, 3, 0, 3, 2]]]) {
            const index = new Uint32Array((n - 1) * pattern.length);
            for (let i = 0, at = 0; i < n - 1; ++i) for (const c of pattern) index[at++] = corners * i + c;
            mesh.geometry.dispose();
            mesh.geometry = new BufferGeometry();
            mesh.geometry.setIndex(new BufferAttribute(index, 1));
            mesh.userData.pattern = pattern.length;
        }
        this.counts = null;
    }

    /// @param wires  Wires of the scene, with a radius each.
    setScene(wires) {
        this.wires = wires;
        this.counts = null;
        this.selected = -1;
    }

    /// Read a frame. Wires without a known breaking load are grey.
    /// @param full  Tension of the hottest colour, as a fraction of the breaking load.
    fill(frame, full) {
        this.reserve(frame.points);
        const {place, look} = this, p = frame.wirePoints;
        const same = this.counts && frame.counts.every((n, i) => n === this.counts[i]);
        let point = 0, piece = 0;
        for (let w = 0; w < frame.counts.length; ++w) {
            const n = frame.counts[w], wire = this.wires[w], strength = full * (wire.breaking_load || 0);
            for (let k = 0; k < n; ++k, ++point) {
                const t = k + 1 < n ? frame.tensions[piece++] : -1, at = 4 * point;
                place[at] = p[3 * point];
                place[at + 1] = p[3 * point + 1];
                place[at + 2] = p[3 * point + 2];
                place[at + 3] = t < 0 ? kNone : strength > 0 && t === t ? t / strength : kUnknown;   // NaN: not known
                if (same) continue;
                look[at] = wire.radius;
                look[at + 1] = w === this.selected ? 1 : 0;
            }
        }
        this.uniforms.points.value.needsUpdate = true;
        if (!same) {
            this.uniforms.looks.value.needsUpdate = true;
            this.counts = frame.counts.slice();
        }
        for (const mesh of [this.tubes, this.lines]) mesh.geometry.setDrawRange(0, Math.max(0, frame.points - 1) * mesh.userData.pattern);
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
